"""What the procedure of the standard does not know, and the film method does."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.cases.film_rules import SURFACE_FIELDS
from babbitt.cases.part import Complaint, is_given, rule

if TYPE_CHECKING:
    from babbitt.cases.journal import JournalBearing


@rule
def standard_knows_the_bearing(bearing: JournalBearing) -> Iterator[Complaint]:
    """Complain about what the standard does not know."""
    if bearing.method == "film":
        return
    if bearing.bore is not None and bearing.bore.kind != "round":
        yield Complaint(("bore",), f"ISO 7902 knows round bores only, not {bearing.bore.kind}", "method: film")
    if bearing.misalignment is not None:
        yield Complaint(("misalignment",), "ISO 7902 knows no misaligned journal", "method: film")
    if bearing.turbulence != "laminar":
        yield Complaint(("turbulence",), "ISO 7902 knows laminar films only", "method: film")
    if bearing.pressure_viscosity is not None:
        yield Complaint(("pressure_viscosity",), "ISO 7902 knows no viscosity under pressure", "method: film")
    for name in SURFACE_FIELDS:
        if is_given(bearing, name):
            says = f"ISO 7902 knows no {name.replace('_', ' ')}"
            yield Complaint((name,), says, "method: film, or leave it out")
    for path, duty in bearing.duties():
        if duty.attitude_angle is not None:
            says = "ISO 7902 finds the attitude angle itself"
            yield Complaint((*path, "attitude_angle"), says, "method: film, or leave it out")
        if duty.position is not None:
            says = "ISO 7902 finds the attitude angle itself and takes no position"
            yield Complaint((*path, "position"), says, "method: film, or eccentricity_ratio")
    if bearing.dynamic_load is not None:
        yield Complaint(("dynamic_load",), "ISO 7902 knows steady loads only", "method: film")
