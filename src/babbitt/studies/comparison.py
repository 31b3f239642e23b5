"""The same bearing by every method and option that applies, side by side."""

from __future__ import annotations

from dataclasses import dataclass, replace

from babbitt.cases import Case, design_cases
from babbitt.notices import InputError
from babbitt.results import Result
from babbitt.standards.iso7902 import DesignCase, check
from babbitt.standards.iso7902.model import Curves, Friction


@dataclass(frozen=True)
class Variant:
    """One way to compute a bearing, and what it assumes or neglects."""

    label: str
    remark: str
    result: Result


@dataclass(frozen=True)
class Comparison:
    """All ways to compute one bearing; the first is the one the case asks for."""

    name: str
    variants: tuple[Variant, ...]


FRICTION_LABELS = {
    Friction.FULL: ("film all around", "neglects that the film ruptures outside the loaded arc"),
    Friction.ARC: ("film on the arc", "neglects friction of the oil outside the loaded arc"),
    Friction.CURVE360: ("360° friction curve", "neglects the influence of the span on friction"),
}


def compare_methods(case: Case) -> tuple[Comparison, ...]:
    """Solve every bearing of a case by every variant of the ISO 7902 procedure that applies to it.

    Parameters
    ----------
    case : Case

    Raises
    ------
    InputError
        E004 when the case has no bearing with a film.
    """
    designs = design_cases(case)
    if not designs:
        raise InputError(
            "E004", f"{case.name}: a case of kind {case.kind!r} has no film; there is nothing to compare"
        )
    return tuple(Comparison(design.name, _variants(design)) for design in designs)


def _variants(design: DesignCase) -> tuple[Variant, ...]:
    common = "assumes one temperature for the whole film; rupture as on a centred arc; rigid parallel surfaces"
    found = [Variant("as given", common, check(design))]
    if design.bearing.span < 360:  # all friction models agree on a full bearing
        for model, (label, remark) in FRICTION_LABELS.items():
            plain = replace(design, friction=model, friction_factor=1.0)
            if plain != design:
                found.append(Variant(label, remark, check(plain)))
    elif design.curves is Curves.COMPUTED:
        closed = replace(design, curves=Curves.CLOSED_FORM)
        found.append(Variant("closed forms", "deviates by up to 7 % in So (DIN 31652 fits)", check(closed)))
    return tuple(found)
