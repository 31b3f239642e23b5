"""Stiffness and damping of pads over speed and frequency, each at the equilibrium of its speed."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome, Result
from babbitt.core.solution import Solution
from babbitt.export import CoefficientTable, Frame, OverFrequency, Rotation, SystemMatrices
from babbitt.export.frame import load_direction
from babbitt.kinds.tilting_pad_journal.check import judged
from babbitt.kinds.tilting_pad_journal.model import PadCase, Thermal
from babbitt.reynolds.tilting_pads.dynamics import PadCoefficients, condensed_over

__all__ = ["PadSpeedRun", "run_over_speed", "table_of"]

APART = 0.01
"""Frequencies nearer than this share of the highest count as one."""

SAME_DIRECTION = 1e-4
"""Angle in rad by which the direction of the load may differ from speed to speed."""

RAMP = "W420"
"""Of coefficients in the assumed transition to turbulence: what informs of a result questions a table."""

STATIC = (
    "load",
    "eccentricity_ratio",
    "attitude_angle",
    "minimum_film_thickness",
    "effective_temperature",
    "effective_viscosity",
    "total_flow",
    "friction_power",
)
"""What is carried along of each equilibrium."""


@dataclass(frozen=True, eq=False)
class PadSpeedRun:
    """One bearing at several speeds, ascending; everything else stays as in the case."""

    case: PadCase
    solutions: tuple[Solution, ...]
    unfollowed: tuple[float, ...] = ()
    """Of bearings with following temperatures, which this one has not."""

    @property
    def unsolved(self) -> tuple[tuple[float, Outcome], ...]:
        """Speeds in rad/s without an equilibrium, and how the search ended there."""
        return tuple(
            (abs(one.problem.journal_speed), one.result.outcome)
            for one in self.solutions
            if not one.result.outcome.solved
        )

    def table(self) -> CoefficientTable:
        """Give the coefficients over speed and frequency, with the equilibria and heat balances they belong to.

        Speeds without an equilibrium (`unsolved`) are left out, as the `unsolved_speeds` of the table.

        Raises
        ------
        InputError
            E003 when no speed has an equilibrium, E004 when the direction of the load changes with the speed.
        """
        kept = [one for one in self.solutions if one.result.outcome.solved]
        if not kept:
            raise InputError("E003", f"{self.case.name}: no equilibrium at any of the speeds")
        table = table_of([one.result for one in kept], [one.problem for one in kept])
        return replace(table, unsolved_speeds=tuple(speed for speed, _ in self.unsolved))


def run_over_speed(case: PadCase, speeds: Iterable[float]) -> PadSpeedRun:
    """Solve a bearing at several speeds, its heat balance anew at each.

    Parameters
    ----------
    case : PadCase
        Load, oil and supply hold at every speed; the sense of rotation is that of the case.
    speeds : iterable of float
        Of the journal, rad/s, positive.

    Raises
    ------
    InputError
        E003 for a speed that is not positive.
    """
    taken = tuple(sorted(set(speeds)))
    if not taken or not all(math.isfinite(speed) and speed > 0.0 for speed in taken):
        raise InputError("E003", f"{case.name}: give one speed or more, each positive, in rad/s")
    return PadSpeedRun(case, tuple(judged(replace(case, journal_speed=case.sense * speed)) for speed in taken))


def table_of(results: Sequence[Result], cases: Sequence[PadCase]) -> CoefficientTable:
    """The coefficients of one bearing, solved at several speeds that ascend.

    Frequencies are those of the whirl ratios at the lowest and the highest speed, and all speeds themselves.

    Raises
    ------
    InputError
        E004 when sense of rotation or direction of the load differ.
    """
    first = cases[0]
    angles = np.array([one.values["load_angle"] for one in results])
    apart = np.abs(np.sin(0.5 * (angles - angles[0]))).max()
    if len({case.sense for case in cases}) > 1 or apart > SAME_DIRECTION:
        raise InputError("E004", f"{first.name}: rotation sense or load direction differ; make one table for each")
    speeds = np.array([abs(case.journal_speed) for case in cases])
    full = [system_of(one, speed) for one, speed in zip(results, speeds, strict=True)]
    rotation = Rotation.CLOCKWISE if first.sense < 0.0 else Rotation.COUNTER_CLOCKWISE
    return CoefficientTable(
        name=str(first.name),
        speeds=speeds,
        stiffness=np.array([one.arrays["stiffness"] for one in results]),
        damping=np.array([one.arrays["damping"] for one in results]),
        frame=Frame(rotation=rotation, load_angle=load_direction(float(angles[0]))),
        static={name: np.array([one.values[name] for one in results]) for name in STATIC},
        method=method_of(first),
        temperatures="frozen",
        over_frequency=over_frequency(full, frequencies_of(first, speeds)),
        systems=tuple(SystemMatrices(one.labels, one.stiffness, one.damping, one.mass) for one in full),
        warnings=tuple(codes_about(one) for one in results),
    )


def codes_about(result: Result) -> tuple[str, ...]:
    """Codes of warnings that question a result, and of that about coefficients on the ramp to turbulence."""
    ramp = tuple(one.code for one in result.warnings if one.code == RAMP)
    return tuple(dict.fromkeys((*result.questioning_codes, *ramp)))


def system_of(result: Result, speed: float) -> PadCoefficients:
    """Matrices of journal and pads of a result at a speed in rad/s."""
    labels = tuple(result.settings["motions"].split(", "))
    mass, stiffness, damping = (
        np.array(result.arrays[f"system_{name}"]) for name in ("mass", "stiffness", "damping")
    )
    return PadCoefficients(labels, mass, stiffness, damping, np.ones(len(labels)), float(speed))


def frequencies_of(case: PadCase, speeds: NDArray[np.float64]) -> NDArray[np.float64]:
    """Frequencies of a table, rad/s: all speeds, and others where none of these is near."""
    kept = list(speeds)
    for speed in (speeds[0], speeds[-1]):
        for ratio in case.whirl_ratios:
            if min(abs(ratio * speed - one) for one in kept) > APART * speeds[-1]:
                kept.append(ratio * speed)
    return np.sort(kept)


def over_frequency(full: Sequence[PadCoefficients], frequencies: NDArray[np.float64]) -> OverFrequency:
    """Coefficients at every speed and frequency."""
    found = [condensed_over(one, (frequencies / one.speed).tolist()) for one in full]
    return OverFrequency(
        frequencies,
        np.array([[one.stiffness for one in row] for row in found]),
        np.array([[one.damping for one in row] for row in found]),
    )


def method_of(case: PadCase) -> str:
    """How the coefficients of a case are obtained, in a line: the thermal model in front, for short titles."""
    heat = "one temperature" if case.thermal is Thermal.ISOTHERMAL else "heat balance at each speed"
    counted = (("conduct", case.heat.walls), ("bend", case.heat.bending), ("grow", case.heat.growth))
    words = " and ".join(name for name, given in counted if given is not None)
    parts = (f"thermal {case.thermal.value}", "synchronous", f"pads that {words}" if words else "",
             "reynolds cavitation", heat)  # fmt: skip
    return ", ".join(("Babbitt tilting pads", *filter(None, parts)))
