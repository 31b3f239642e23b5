"""What an engineer reads: values with names, checks with verdicts, warnings, and how the iteration ended."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import Any

from babbitt.core.notices import Effect, Notice, Subject, explanations
from babbitt.core.quantities import QUANTITIES

Matrix = tuple[tuple[float, ...], ...]
"""Rows of numbers in SI."""


class Outcome(Enum):
    """How a calculation ended, in the words the engineer reads."""

    CONVERGED = "converged"
    OVERLOADED = "no film can carry this load"
    THERMAL_RUNAWAY = "no thermal equilibrium up to 300 °C"
    NO_CLEARANCE = "the clearance closes at operating temperature"
    NO_LUBRICANT_DATA = "the lubricant data do not reach the temperature of the film"
    NO_STEADY_STATE = "no steady state exists"
    LIFTED_OFF = "the load is too light: the supply lifts it off"
    UNSTABLE_NETWORK = "the flow network of the recesses has no stable state"
    STARVED_RECESS = "a recess is starved of oil"
    PAD_AT_LIMIT = "a pad would have to carry less than it can: no static equilibrium exists"
    NOT_CONVERGED = "the iteration ended without meeting its tolerance"
    WORK_BOUND = "the search used up the work that is allowed for its grid"
    OUTSIDE_CLEARANCE = "the prescribed position lies outside the clearance"
    SQUEEZED_OUT = "the changing load squeezes the film out"
    NOT_PERIODIC = "the journal does not come back to its place from cycle to cycle"

    @property
    def solved(self) -> bool:
        """Whether the values of the result are an operating point."""
        return self is Outcome.CONVERGED

    @property
    def code(self) -> str:
        """Code of the explanation in `babbitt.core.notices`; empty for a solution."""
        return _OUTCOME_CODES.get(self.name, "")

    @classmethod
    def of(cls, failure: Notice | None) -> Outcome:
        """The outcome of which a failure speaks; convergence where there is none."""
        if failure is None:
            return cls.CONVERGED
        for outcome in cls:
            if outcome.code == failure.code:
                return outcome
        raise ValueError(f"no outcome has the code {failure.code}; allowed: {', '.join(_OUTCOME_CODES.values())}")


_OUTCOME_CODES = {
    "OVERLOADED": "S001",
    "THERMAL_RUNAWAY": "S002",
    "NO_CLEARANCE": "S003",
    "NOT_CONVERGED": "S004",
    "NO_LUBRICANT_DATA": "S005",
    "OUTSIDE_CLEARANCE": "S006",
    "SQUEEZED_OUT": "S007",
    "NOT_PERIODIC": "S008",
    "WORK_BOUND": "S009",
    "NO_STEADY_STATE": "S020",
    "UNSTABLE_NETWORK": "S301",
    "STARVED_RECESS": "S302",
    "LIFTED_OFF": "S303",
    "PAD_AT_LIMIT": "S401",
}


class Verdict(Enum):
    """The judgement of one bearing, readable without colour, the gravest last."""

    PASS = "pass"
    REMARKS = "pass with remarks"
    FAIL = "fail"
    NO_VERDICT = "no verdict"
    NO_SOLUTION = "no solution"

    @property
    def key(self) -> str:
        """The word for programs: ``pass``, ``remarks``, ``fail``, ``no_verdict``, ``no_solution``."""
        return self.name.lower()


class Bound(Enum):
    """Which side of its limit a checked value must stay on."""

    AT_MOST = "<="
    AT_LEAST = ">="


ROUND_OFF = 1e-9
"""Share of a limit by which a value may miss it: the load of a film is that of the case to some digits less."""


@dataclass(frozen=True)
class Check:
    """One comparison of a value with what is permissible.

    Attributes
    ----------
    code : str
        Stable identifier such as ``C101``.
    quantity : str
        Name of the quantity checked, a key of `babbitt.core.quantities.QUANTITIES`.
    value, limit : float
        In SI.
    bound : Bound
        Whether `limit` is the largest or the smallest permissible value.
    source : str
        Where the limit comes from.
    advisory : bool
        A recommendation or a screening indicator: a miss is listed and changes no verdict.
    general : tuple of float and str, optional
        Of a limit that the case sets: what would hold without it, in SI, and where that comes from.
    """

    code: str
    quantity: str
    value: float
    limit: float
    bound: Bound
    source: str
    advisory: bool = False
    general: tuple[float, str] | None = None

    @property
    def ok(self) -> bool:
        """Whether the value keeps its limit, to the round-off of its computation."""
        return bool(self.kept)

    @property
    def kept(self) -> Any:
        """`ok`, element by element where value or limit is an array."""
        slack = ROUND_OFF * abs(self.limit)
        most = self.bound is Bound.AT_MOST
        return self.value <= self.limit + slack if most else self.value >= self.limit - slack

    @property
    def gap(self) -> float:
        """Distance to the limit in SI, positive when it is kept."""
        return self.limit - self.value if self.bound is Bound.AT_MOST else self.value - self.limit

    @property
    def margin(self) -> float:
        """Distance to the limit relative to the limit, positive when it is kept; temperatures count in °C.

        A limit of zero gives the distance itself.
        """
        known = QUANTITIES.get(self.quantity)
        size = abs(self.limit + known.metric.offset) if known is not None else abs(self.limit)
        return self.gap / size if size else self.gap

    @property
    def is_in_kelvin(self) -> bool:
        """Whether its distance reads in K: that of temperatures and of differences of them."""
        known = QUANTITIES.get(self.quantity)
        return known is not None and known.unit == "K"


@dataclass(frozen=True)
class Result:
    """The answer for one bearing by one method.

    Attributes
    ----------
    name, kind, method : str
        Which bearing, and how it was computed.
    outcome : Outcome
        Values of an unsolved result describe the last state reached, never an operating point.
    values : Mapping[str, float]
        Named quantities in SI; names and units in `babbitt.core.quantities.QUANTITIES`.
    checks, warnings : tuple
        Verdicts and warnings, each warning once.
    not_checked : tuple of Notice
        Checks that could not be made for want of data, by their code, each with what is missing.
    assumptions : tuple of str
        What was assumed because neither the case nor a published source says it.
    settings : Mapping[str, str]
        Choices that the numbers depend on.
    arrays : Mapping[str, Matrix]
        Named quantities of several numbers, in SI: ``stiffness`` and ``damping`` as [[xx, xy], [yx, yy]].
    missing : Mapping[str, str]
        Quantities that belong among the values and could not be found, each with the reason.
    failure : Notice or None
        For an unsolved result: how far it came and what to try.
    """

    name: str
    kind: str
    method: str
    outcome: Outcome
    values: Mapping[str, float]
    checks: tuple[Check, ...] = ()
    warnings: tuple[Notice, ...] = ()
    not_checked: tuple[Notice, ...] = ()
    assumptions: tuple[str, ...] = ()
    settings: Mapping[str, str] = field(default_factory=dict)
    arrays: Mapping[str, Matrix] = field(default_factory=dict)
    missing: Mapping[str, str] = field(default_factory=dict)
    failure: Notice | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "warnings", tuple(dict.fromkeys(self.warnings)))

    @property
    def message(self) -> str:
        """How far an unsolved result came and what to try, in English; empty for a solution."""
        return "" if self.failure is None else self.failure.message

    @property
    def verdict(self) -> Verdict:
        """The judgement in one word.

        ``no solution`` without an operating point; ``fail`` where a limit is missed; ``no verdict`` outside the
        validity of the model, or where film thickness, temperature (of a probe with a limit, too) or specific load
        could not be checked (`lacking`); ``pass with remarks`` where a warning questions the result.
        Recommendations and screening indicators change nothing.
        """
        if not self.outcome.solved:
            return Verdict.NO_SOLUTION
        if not all(check.ok for check in self.limits):
            return Verdict.FAIL
        effects = {warning.effect for warning in self.warnings}
        if Effect.NO_VERDICT in effects or self.lacking or not self.limits:
            return Verdict.NO_VERDICT
        return Verdict.REMARKS if Effect.QUESTIONS_RESULT in effects else Verdict.PASS

    @property
    def within_limits(self) -> bool:
        """Whether the bearing passes: solved, within the validity of its model, every limit kept."""
        return self.verdict in (Verdict.PASS, Verdict.REMARKS)

    @property
    def limits(self) -> tuple[Check, ...]:
        """The checks that decide: all but recommendations and screening indicators."""
        return tuple(check for check in self.checks if not check.advisory)

    @property
    def keeps_all_limits(self) -> bool:
        """Whether it is solved and misses none of the limits that were checked, whatever questions it."""
        return self.outcome.solved and all(one.ok for one in self.limits)

    @property
    def governing_check(self) -> Check | None:
        """The limit with the least margin; None where nothing was held against a limit, or nothing was found."""
        if not self.outcome.solved:
            return None
        return min(
            self.limits, key=lambda one: one.margin if math.isfinite(one.margin) else -math.inf, default=None
        )

    @property
    def margin(self) -> float:
        """Margin of the governing check; NaN where there is none."""
        governing = self.governing_check
        return math.nan if governing is None else governing.margin

    @property
    def questioning_codes(self) -> tuple[str, ...]:
        """Codes of the warnings that question the result or leave it without a verdict, each once."""
        return tuple(dict.fromkeys(one.code for one in self.warnings if one.effect is not Effect.INFORMATION))

    @property
    def invalidating_codes(self) -> tuple[str, ...]:
        """Codes of the warnings that leave the result without a verdict, each once."""
        return tuple(dict.fromkeys(one.code for one in self.warnings if one.effect is Effect.NO_VERDICT))

    @property
    def lacking(self) -> tuple[Subject, ...]:
        """Of the subjects those that should have been checked and were not.

        A kind lists its checks that could not be made under `not_checked`; one check of a subject is enough, but a
        recommendation is none.
        """
        codes = [one.code for one in self.not_checked] + [one.code for one in self.checks if one.advisory]
        missing = {explanations()[code].subject for code in codes}
        made = {explanations()[check.code].subject for check in self.limits}
        return tuple(one for one in Subject if one in missing - made)

    @property
    def stiffness(self) -> Matrix:
        """Film stiffness in N/m, [[xx, xy], [yx, yy]]."""
        return self._array("stiffness")

    @property
    def damping(self) -> Matrix:
        """Film damping in N s/m, [[xx, xy], [yx, yy]]."""
        return self._array("damping")

    def _array(self, name: str) -> Matrix:
        if name in self.arrays:
            return self.arrays[name]
        raise AttributeError  # leads to __getattr__, which tells what there is

    def __getattr__(self, name: str) -> Any:
        """Give the named quantities as attributes: ``result.minimum_film_thickness``, ``result.supply_fill``."""
        values: Mapping[str, float] = self.__dict__.get("values", {})
        arrays: Mapping[str, Matrix] = self.__dict__.get("arrays", {})
        for named in (values, arrays):
            if name in named:
                return named[name]
        there = ", ".join((*values, *arrays))
        raise AttributeError(f"{name!r} is not among the results: {there}")
