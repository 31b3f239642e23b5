"""The side of ROSS (3.1): warm calls of its plain journal bearing with heat, on its default mesh."""

from __future__ import annotations

import sys
import warnings
from functools import partial
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "two_lands"))

from case import CLEARANCE, DIAMETER, LAND, LOAD, SPEED, WIDTH, answer, row, timed

warnings.simplefilter("ignore")

import ross  # noqa: E402
from ross.bearings.plain_journal import PlainJournal  # noqa: E402


def bearing(thermal: str) -> PlainJournal:
    """The bearing of the case, solved by its constructor."""
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
        lubricant="ISOVG32",
        thermal_type=thermal,
        speed=[SPEED],
    )


def main() -> None:
    rows = []
    for thermal in ("adiabatic", "full"):
        times = timed(partial(bearing, thermal), 3.0, least=3)
        one = bearing(thermal)
        eccentricity = float(one.equilibrium_pos[0])
        rows.append(row("ROSS", thermal, "default", times, eccentricity=eccentricity))
    answer({"version": ross.__version__, "rows": rows})


if __name__ == "__main__":
    main()
