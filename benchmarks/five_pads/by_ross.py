"""The side of ROSS (3.1): warm calls of its tilting-pad bearing with rigid pivots, isoviscous, synchronous."""

from __future__ import annotations

import warnings
from functools import partial
from math import radians
from time import process_time

from five_pads import (
    ANGLES,
    ARC,
    ASSEMBLED,
    DIAMETER,
    LOAD,
    PRELOAD,
    SPEED,
    THICKNESS,
    VISCOSITY,
    WIDTH,
    answer,
    processor_times,
    row,
)

warnings.simplefilter("ignore")

import ross  # noqa: E402
from ross.bearings.lubricants import lubricants_dict  # noqa: E402
from ross.bearings.tilting_pad import TiltingPad  # noqa: E402

OIL = {**lubricants_dict["ISOVG32"], "liquid_viscosity1": VISCOSITY, "liquid_viscosity2": VISCOSITY}
MESHES = {"default 30x30": (), "20 x 10": (20, 10)}
CALLS = 3


def bearing(mesh: tuple[int, ...]) -> TiltingPad:
    """The bearing of the case, solved by its constructor."""
    count = len(ANGLES)
    return TiltingPad(
        n=0,
        journal_diameter=DIAMETER,
        radial_clearance=ASSEMBLED,
        pad_thickness=THICKNESS,
        pivot_angle=[radians(one) for one in ANGLES],
        pad_arc=[radians(ARC)] * count,
        pad_axial_length=[WIDTH] * count,
        preload=[PRELOAD] * count,
        offset=[0.5] * count,
        lubricant=OIL,
        oil_supply_temperature=323.15,
        oil_flow_v=1e-2,
        fys_load=-LOAD,
        equilibrium_type="match_load",
        thermal_type=None,
        eccentricity=0.6,
        speed=[SPEED],
        **dict(zip(("total_ex_film", "total_ez_film"), mesh, strict=False)),
    )


def main() -> None:
    begun = process_time()
    bearing(next(iter(MESHES.values())))
    first = process_time() - begun
    rows = []
    for name, mesh in MESHES.items():
        times = processor_times(partial(bearing, mesh), 0.0, CALLS)
        one = bearing(mesh)
        found = {label: float(getattr(one, label)[0]) for label in ("kxx", "kyy", "cxx", "cyy")}
        rows.append(row("ROSS", "own", name, times, **found))
    answer({"version": ross.__version__, "first": first, "rows": rows})


if __name__ == "__main__":
    main()
