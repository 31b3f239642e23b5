"""The film engine: pressure, flow, friction, equilibrium and dynamic coefficients of one film between two surfaces.

``model`` says what the film sees, ``solve`` finds its answer, ``solution`` holds it; kernels (leading
underscore) import numba and are loaded by ``solve``. See ``docs/film.md`` for equations and discretisation.
"""
