"""The front door: ``solve(case)``."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING

from babbitt import __version__
from babbitt.case import case_hash, design_cases
from babbitt.case.case_file import CaseFile
from babbitt.case.grouped_digits import about_grouped_digits
from babbitt.core.notices import InputError
from babbitt.core.progress import Watch, unwatched
from babbitt.core.result import Outcome, Result
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.iso7902 import check as iso7902_check
from babbitt.kinds.journal.iso7902.model import DesignCase

if TYPE_CHECKING:
    from babbitt.case import Case
    from babbitt.case.designs import AnyDesign, EveryDesign
    from babbitt.kinds.hydrostatic.jacking_model import JackingCase
    from babbitt.kinds.hydrostatic.model import HydrostaticCase
    from babbitt.kinds.shaft_line.design import LineDesign
    from babbitt.kinds.thrust.design import ThrustDesign


@dataclass(frozen=True)
class MachineResult:
    """The answers for all bearings of one case file.

    Attributes
    ----------
    name : str
    results : tuple of Result
        One per bearing, operating point and clearance.
    design_cases : tuple of EveryDesign
        What each result was computed from, in the same order; empty for kinds without a film.
    case_hash : str
        SHA-256 of the validated case.
    version : str
        Of Babbitt.
    case_text : str
        The case file as it was read; empty where there was none.
    source, notes : str
        What the case says of itself.
    """

    name: str
    results: tuple[Result, ...]
    design_cases: tuple[EveryDesign, ...]
    case_hash: str
    version: str = __version__
    case_text: str = ""
    source: str = ""
    notes: str = ""

    @property
    def solved(self) -> bool:
        """Whether every bearing has an operating point."""
        return all(result.outcome.solved for result in self.results)

    @property
    def within_limits(self) -> bool:
        """Whether every bearing passes, with or without remarks."""
        return all(result.within_limits for result in self.results)

    def __getitem__(self, name: str) -> Result:
        """The result of a bearing by its name."""
        for result in self.results:
            if result.name == name:
                return result
        raise KeyError(f"no bearing {name!r}; there are: {', '.join(result.name for result in self.results)}")


def solve(case: Case, watch: Watch = unwatched) -> MachineResult:
    """Solve every bearing of a case.

    Parameters
    ----------
    case : Case
        From `babbitt.load_case` or `babbitt.parse_case`.
    watch : callable
        Hands on the numbers of the cycles of an orbit, which takes long, and may show how far it is.

    Returns
    -------
    MachineResult

    Raises
    ------
    TypeError
        If `case` is not a case, such as the path of its file.
    """
    if not isinstance(case, CaseFile):
        given = type(case).__name__
        raise TypeError(
            f"solve takes a case, not {given}; read one with babbitt.load_case(path) or parse_case(text)"
        )
    designs = design_cases(case)
    if designs:
        pairs = [(design, result) for design in designs for result in solve_every(design, watch)]
        designs, results = tuple(design for design, _ in pairs), tuple(result for _, result in pairs)
    else:
        results = (_shaft_result(case),)
    return MachineResult(
        case.name,
        results,
        designs,
        case_hash(case),
        case_text=getattr(case, "text", ""),
        source=case.source,
        notes=case.notes,
    )


def refusal_of(case: Case) -> InputError | None:
    """What `solve` would refuse of a case that was read; None where it would solve or say why it cannot.

    The rules of the case have been asked; what is left shows when its designs are made, or when a first film is
    found: pads that do not balance, a motion without bound.

    Parameters
    ----------
    case : Case

    Returns
    -------
    InputError or None
    """
    try:
        designs = design_cases(case)
        for design in designs:
            _require_solvable(design)
        if not designs:
            _shaft_result(case)
    except InputError as error:
        return error
    return None


def _require_solvable(design: EveryDesign) -> None:
    """Make what a refusal of a design needs: at most one film, not the answer."""
    if isinstance(design, FilmCase | DesignCase | LongFilmCase | SegmentCase):
        return
    from babbitt.kinds.hydrostatic.model import HydrostaticCase

    if isinstance(design, HydrostaticCase):
        from babbitt.kinds.hydrostatic.check import refuse_contact, refuse_short_recess

        refuse_contact(design)
        refuse_short_recess(design)
        return
    from babbitt.kinds.shaft_line.design import LineDesign
    from babbitt.kinds.thrust.design import ThrustDesign, operating_state
    from babbitt.kinds.thrust.failures import NoPadFilmError

    if isinstance(design, ThrustDesign | LineDesign):
        with suppress(NoPadFilmError):  # told as no solution
            static = operating_state(design.thrust if isinstance(design, LineDesign) else design)
            if isinstance(design, LineDesign):
                from babbitt.kinds.shaft_line.model import state_of

                state_of(design.duty, static.films, static.share)


def solve_every(design: EveryDesign, watch: Watch = unwatched) -> tuple[Result, ...]:
    """Solve one design case and give every answer: a heel may have several steady states.

    Parameters
    ----------
    design : EveryDesign
    watch : callable
        Follows the cycles of an orbit.

    Returns
    -------
    tuple of Result
    """
    if isinstance(design, FilmCase | DesignCase | LongFilmCase | SegmentCase):
        return (solve_design(design, watch),)
    from babbitt.kinds.footstep.model_case import HeelCase

    if isinstance(design, HeelCase):
        from babbitt.kinds.footstep.check import heel_results

        return heel_results(design)
    return (solve_design(design, watch),)


def solve_design(design: AnyDesign, watch: Watch = unwatched) -> Result:
    """Solve one design case that has one answer.

    Parameters
    ----------
    design : AnyDesign
    watch : callable
        Follows the cycles of an orbit.

    Returns
    -------
    Result
    """
    if isinstance(design, FilmCase):
        from babbitt.kinds.journal.film.check import film_check  # numba is imported when the first film is solved

        return film_check(design, watch)
    if isinstance(design, LongFilmCase):
        from babbitt.kinds.journal.infinitely_long_bearing.check import (
            long_film_check,  # numpy and scipy are imported with the first film
        )

        return long_film_check(design)
    if isinstance(design, SegmentCase):
        from babbitt.kinds.journal.grooved_long_bearing.check import segments_check

        return segments_check(design)
    if isinstance(design, DesignCase):
        return iso7902_check(design)
    return _carried_axially_or_by_pressure(design)


def _carried_axially_or_by_pressure(design: HydrostaticCase | JackingCase | ThrustDesign | LineDesign) -> Result:
    from babbitt.kinds.hydrostatic.jacking_model import JackingCase
    from babbitt.kinds.hydrostatic.model import HydrostaticCase
    from babbitt.kinds.thrust.design import ThrustDesign

    if isinstance(design, JackingCase):
        from babbitt.kinds.hydrostatic.jacking import jacking_check

        return jacking_check(design)
    if isinstance(design, HydrostaticCase):
        from babbitt.kinds.hydrostatic.check import hydrostatic_check

        return hydrostatic_check(design)
    if isinstance(design, ThrustDesign):
        from babbitt.kinds.thrust.check import thrust_check

        return thrust_check(design)
    from babbitt.kinds.shaft_line.check import line_check

    return line_check(design)


def _shaft_result(case: Case) -> Result:
    from babbitt.case import OverhungCouplingCase
    from babbitt.kinds.coupling import bearing_loads

    if not isinstance(case, OverhungCouplingCase):
        raise TypeError(f"a case of kind {case.kind} holds nothing to compute")
    shaft = case.shaft()
    loads = bearing_loads(shaft)
    values = {
        "reaction_1": loads.reaction_1,
        "reaction_2": loads.reaction_2,
        "reaction_without_coupling": loads.reaction_without_coupling,
        "reaction_angle_1": loads.angle_1,
        "reaction_angle_2": loads.angle_2,
        "coupling_arm": shaft.coupling_arm,
    }
    return Result(
        case.name, case.kind, "statics", Outcome.CONVERGED, values,
        warnings=tuple(about_grouped_digits(case)), assumptions=case.assumptions,
    )  # fmt: skip
