"""Clearances and grooves in one call each; every clearance says of which kind it is."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from babbitt.api.common_parts import DiametralClearance, Fit, RadialClearance, RelativeClearance
from babbitt.api.journal_parts import Groove
from babbitt.case.problems import CaseError, Problem

__all__ = ["diametral_clearance", "fit", "grooves", "radial_clearance", "relative_clearance"]


def relative_clearance(mean: Any, *, minimum: Any = None, maximum: Any = None) -> RelativeClearance:
    """Clearance over diameter, psi = C/D, at 20 degC.

    Parameters
    ----------
    mean : float or str
        Such as 1.5e-3, or "1.5 permille".
    minimum, maximum : float or str, optional
        Limits by the tolerances, both or none.

    >>> relative_clearance("1.5 permille").mean
    0.0015
    """
    return RelativeClearance(**_values(mean, minimum, maximum))


def diametral_clearance(mean: Any, *, minimum: Any = None, maximum: Any = None) -> DiametralClearance:
    """Clearance on the diameter C, bore minus journal, at 20 degC; lengths in m or text with a unit.

    >>> diametral_clearance("130 um").mean
    0.00013
    """
    return DiametralClearance(**_values(mean, minimum, maximum))


def radial_clearance(mean: Any, *, minimum: Any = None, maximum: Any = None) -> RadialClearance:
    """Clearance on the radius, C/2, at 20 degC; lengths in m or text with a unit.

    >>> radial_clearance("65 um").mean
    6.5e-05
    """
    return RadialClearance(**_values(mean, minimum, maximum))


def fit(classes: str) -> Fit:
    """Clearance of an ISO 286 fit.

    Parameters
    ----------
    classes : str
        Tolerance classes of bore and journal, such as "H7/e8".

    >>> fit("H7/e8")
    Fit(bore='H7', journal='e8')
    """
    bore, stroke, journal = str(classes).partition("/")
    if not stroke:
        says = f"'{classes}' is no fit"
        raise CaseError([Problem("fit", 0, "", says, allowed="classes of bore and journal, such as H7/e8")])
    given: dict[str, Any] = {"bore": bore.strip(), "journal": journal.strip()}
    return Fit(**given)


def grooves(angles: Iterable[Any], *, extent: Any, pressure: Any = None) -> tuple[Groove, ...]:
    """Axial grooves as wide as the bearing, at several angles.

    Parameters
    ----------
    angles : iterable of float or str
        Directions of their centres, counter-clockwise from the x axis; rad, or text with a unit.
    extent : float or str
        Angle that each takes around the bore.
    pressure : float or str, optional
        Gauge pressure in each, if not that of the supply.

    >>> [round(one.angle, 4) for one in grooves(["0 deg", "180 deg"], extent="20 deg")]
    [0.0, 3.1416]
    """
    return tuple(Groove(angle=angle, extent=extent, pressure=pressure) for angle in angles)


def _values(mean: Any, minimum: Any, maximum: Any) -> dict[str, Any]:
    values = {"mean": mean, "minimum": minimum, "maximum": maximum}
    return {name: value for name, value in values.items() if value is not None}
