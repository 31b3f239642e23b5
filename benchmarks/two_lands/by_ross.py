"""The side of ROSS: import, first call, and warm calls of its plain journal bearing with constant viscosity.

Written against the constructors of versions 2.3 (thermal solution only, here with an oil whose viscosity does not
depend on temperature; no default mesh, so the one of its documentation and a finer one) and 3.1, where
``thermal_type=None`` is isoviscous and the mesh 40 x 20 unless told otherwise. Versions between differ from 3.1 in
the name of the speed axis.
"""

from __future__ import annotations

import inspect
import math
import warnings
from functools import partial
from time import perf_counter

from case import CLEARANCE, DIAMETER, LAND, LOAD, SPEED, VISCOSITY, WIDTH, answer, row, timed

warnings.simplefilter("ignore")
begun = perf_counter()

import ross  # noqa: E402
from ross.bearings.lubricants import lubricants_dict  # noqa: E402
from ross.bearings.plain_journal import PlainJournal  # noqa: E402

imported = perf_counter()

OIL = {**lubricants_dict["ISOVG32"], "liquid_viscosity1": VISCOSITY, "liquid_viscosity2": VISCOSITY}
PARAMETERS = inspect.signature(PlainJournal.__init__).parameters
THERMAL_ONLY = "elements_circumferential" in PARAMETERS
MESHES = {"11 x 3": (11, 3), "22 x 12": (22, 12)} if THERMAL_ONLY else {"default": (), "80 x 32": (80, 32)}


def bearing(mesh: tuple[int, ...]) -> PlainJournal:
    """The bearing of the case, solved by its constructor."""
    if THERMAL_ONLY:
        return PlainJournal(
            n=0,
            axial_length=WIDTH,
            journal_radius=0.5 * DIAMETER,
            radial_clearance=CLEARANCE,
            elements_circumferential=mesh[0],
            elements_axial=mesh[1],
            n_pad=2,
            pad_arc_length=math.degrees(LAND),
            preload=0,
            geometry="circular",
            reference_temperature=50,
            frequency=[SPEED],
            fxs_load=0,
            fys_load=-LOAD,
            lubricant=OIL,
            groove_factor=[0.5, 0.5],
        )
    axis = "speed" if "speed" in PARAMETERS else "frequency"
    counts = dict(zip(("total_ex_film", "total_ez_film"), mesh, strict=False))
    return PlainJournal(
        n=0,
        pad_axial_length=WIDTH,
        journal_diameter=DIAMETER,
        radial_clearance=CLEARANCE,
        n_pads=2,
        pad_arc=LAND,
        oil_supply_temperature=323.15,
        oil_flow_v=1e-2,
        fys_load=-LOAD,
        lubricant=OIL,
        thermal_type=None,
        **{axis: [SPEED]},
        **counts,
    )


def solved(one: PlainJournal) -> dict[str, list[float] | list[list[float]]]:
    """Its answer in the frame of Babbitt: K and C are in it already, the angle is counted differently."""
    eccentricity, angle = (float(value) for value in one.equilibrium_pos)
    direction = angle if THERMAL_ONLY else angle - 0.5 * math.pi  # from +x, or from -y
    matrices = [
        [[float(getattr(one, letter + name)[0]) for name in names] for names in (("xx", "xy"), ("yx", "yy"))]
        for letter in "kc"
    ]
    return {
        "position": [eccentricity * math.cos(direction), eccentricity * math.sin(direction)],
        "stiffness": matrices[0],
        "damping": matrices[1],
    }


def main() -> None:
    begun_first = perf_counter()
    bearing(next(iter(MESHES.values())))
    first = perf_counter() - begun_first
    rows = []
    for name, mesh in MESHES.items():
        times = timed(partial(bearing, mesh), 4.0)
        rows.append(row("ROSS", "own", name, times, **solved(bearing(mesh))))
    answer({"version": ross.__version__, "import": imported - begun, "first": first, "rows": rows})


if __name__ == "__main__":
    main()
