"""From a duty to first designs, in Python."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from babbitt.api.bearings import public_case
from babbitt.api.studies import Study, run
from babbitt.case.with_units import quantity_text
from babbitt.core.units import KINDS
from babbitt.study.design import duty_study
from babbitt.study.plan import plan

__all__ = ["design_bearing"]

UNITS = {"diameter": "m", "load": "N", "speed": "rad/s", "supply_temperature": "K", "supply_pressure": "Pa"}


def design_bearing(
    diameter: float | str,
    load: float | str,
    speed: float | str,
    *,
    lubricants: Sequence[str] = (),
    fits: Sequence[str] = (),
    kind: str = "journal",
    supply_temperature: float | str | None = None,
    supply_pressure: float | str | None = None,
    metal: str | None = None,
    name: str | None = None,
    reserve: float = 0.1,
    proposals: int = 5,
    out: str | Path | None = None,
    workers: int = 1,
) -> Study:
    """Propose bearings for a duty: width, fit, oil and feed, ranked, each confirmed by its film.

    Parameters
    ----------
    diameter, load, speed : float or str
        In SI, or with a unit.
    lubricants, fits : sequence of str
        Those that may be used. All viscosity grades of the catalogue, and the fits whose clearance is near the one
        recommended for the speed, without them.
    kind : str
        Of bearing.
    supply_temperature, supply_pressure : float or str, optional
        45 °C and 0.2 MPa are assumed without them.
    metal : str, optional
        Bearing metal of the catalogue.
    name : str, optional
        Of the bearing; what the duty says without it.
    reserve : float
        Margin to every limit from which designs are ranked by their friction power.
    proposals : int
        How many are made.
    out : str or Path, optional
        Folder ``name.study`` in which finished rows are kept.
    workers : int
        Processes.

    Returns
    -------
    Study
        Its `answer` has the proposals; ``study.case(row)`` is the bearing of one.

    Raises
    ------
    CaseError, InputError
        For a duty that no bearing has, or a kind without rules for first designs.
    """
    numbers: dict[str, Any] = {
        "diameter": diameter,
        "load": load,
        "speed": speed,
        "supply_temperature": supply_temperature,
        "supply_pressure": supply_pressure,
    }
    given = {
        name: quantity_text(float(value), KINDS[UNITS[name]]) if isinstance(value, int | float) else value
        for name, value in numbers.items()
    }
    duty = {**given, "metal": metal, "name": name}
    case, block = duty_study(kind, duty, lubricants, fits, reserve=reserve, proposals=proposals)
    return run(case, plan(case, block), out, workers, public_case)
