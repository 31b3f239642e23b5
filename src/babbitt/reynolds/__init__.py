"""The film engines: pressure, flow, friction, equilibrium, dynamic coefficients and heat of a film.

``model`` says what a film sees, ``solution`` holds its answer in SI; equations and discretisation stand in the
docstrings of the kernels (leading underscore), drawings and accuracy in ``docs/theory/film.md``. Kernels import
numba and are loaded by the doors, so that a design check without a film never does.

- ``lands``: films between grooves, aligned and alike along the width; many bearings over all cores.
- ``surface``: films that differ across the width: pockets, holes, misalignment, closed rings.
- ``equilibrium``: the doors of both: the place where a film carries its load, or the film at a place.
- ``heat``: films with their own temperatures, and bushes that grow by heat.
- ``deformation``: bores that give way to pressure.
- ``sector``: films of thrust pads. ``recess``: films between the recesses of hydrostatic bearings.
- ``oil``: turbulent flow, viscosity under pressure.
- ``stability``: rotors in their films; coefficients held against the slope of the load.
- ``frame``, ``scales``: the frame in which a film is solved, and its units.
- ``_structs``, ``_compiling``: what kernels hand to each other, and where their machine code is kept.
"""
