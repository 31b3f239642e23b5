"""Which temperatures the coefficients of a film hold for, beside their names."""

from __future__ import annotations

from babbitt.core.language import translated
from babbitt.core.quantities import AXES
from babbitt.core.result import Result

__all__ = ["temperature_remark"]

HELD = {
    **{f"{name}_{axes}": name for name in ("stiffness", "damping") for axes in AXES},
    "critical_mass": "stability",
    "least_stable_mass": "stability",
    "critical_mass_elastic": "stability",
}
"""Results, and of what in the settings they have their temperatures."""


def temperature_remark(name: str, result: Result) -> str:
    """Whether temperatures are frozen or follow the motion; empty but for coefficients of a film with its own.

    Examples
    --------
    >>> from babbitt.core.result import Outcome, Result
    >>> settings = {"damping_temperatures": "frozen"}
    >>> own = Result("a", "journal_bearing", "film", Outcome.CONVERGED, {}, settings=settings)
    >>> temperature_remark("damping_xx", own), temperature_remark("load", own)
    (', temperatures frozen', '')
    """
    held = result.settings.get(f"{HELD.get(name, '')}_temperatures", "")
    return f", {translated(f'temperatures {held}')}" if held else ""
