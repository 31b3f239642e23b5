"""The film engine: pressure, flow, friction, equilibrium and dynamic coefficients of a film.

``model`` says what the film sees, ``solve`` finds its answer, ``solution`` holds it. Kernels (leading underscore)
import numba and are loaded by ``solve``; equations and discretisation stand in their docstrings. Drawings and
accuracy: ``docs/theory/film.md``.

Lands between grooves, aligned and alike along the width:

- ``solve``: the door; equilibrium for a load, film at a position, everything in SI.
- ``axial``, ``operators``: the pressure across the width, spectral; in the form the kernels take.
- ``scales``: units of the dimensionless film.
- ``_structs``: what kernels hand to each other.
- ``_grids``: lines graded where the film is thin, flux coefficients between them.
- ``_elimination``: pressure and adjoints from line to line, in modes and in nodes.
- ``_forces``: wet set; force, stiffness, damping.
- ``_endings``: where between two lines the film ends.
- ``_equilibrium``: the journal finds its place; ``_positions``: prescribed places, film from the widest gap.
- ``_integrals``: flows, friction, balance.
- ``batch``, ``_batch``: many bearings over all cores.
- ``half_sommerfeld``: suctions of the full film count as nothing.

Surfaces, where lines differ across the width (pockets, tilt, fields, closed rings, sectors):

- ``ring_mesh``, ``ring``: lines and elements on all edges; gap, viscosity, nodes held by supplies.
- ``_surface_film``: flux coefficients in a metric; ``_surface``: elimination with dense lines, closed ring.
- ``_surface_forces``: wet set, forces, stiffness, damping, balances.
- ``general``: the journal finds its place; ``ring_solution``: everything in SI.
- ``tilt``: moments, stiffness and damping of tilt.
- ``sector``: films of thrust pads.

What a film has besides:

- ``turbulence``, ``piezoviscosity``: laws of the oil.
- ``starved``: supplies that deliver a given flow.
- ``thermal``, ``warm_ring``: temperatures of their own; ``thermal_recovery``: films that the usual search loses;
  ``thermal_trail``: films that follow each other.
- ``stability``: critical mass and whirl.
- ``_compiling``: how kernels are compiled and where their machine code is kept.
"""
