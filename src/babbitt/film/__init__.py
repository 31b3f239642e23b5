"""The film engine: pressure, flow, friction, equilibrium and dynamic coefficients of a film.

``model`` says what the film sees, ``solve`` finds its answer, ``solution`` holds it; kernels (leading
underscore) import numba and are loaded by ``solve``; equations and discretisation stand in their docstrings.
"""
