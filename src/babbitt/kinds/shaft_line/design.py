"""A shaft line with all choices made: thrust bearing, line, excitations, what else is wanted."""

from __future__ import annotations

from dataclasses import dataclass

from babbitt.core.notices import Notice
from babbitt.kinds.shaft_line.excitation import RunoutHarmonic, ThrustHarmonic
from babbitt.kinds.shaft_line.line import ShaftLine
from babbitt.kinds.shaft_line.model import LineOperation
from babbitt.kinds.thrust.design import PrescribedThrust, ThrustDesign, films_in_oil
from babbitt.kinds.thrust.load_curve import LoadCurve
from babbitt.properties.lubricants import Lubricant

__all__ = ["LineDesign"]


@dataclass(frozen=True)
class LineDesign:
    """One shaft line.

    Attributes
    ----------
    thrust : ThrustDesign
        Bearing, thrust, speed and oil.
    line : ShaftLine
    thrusts : tuple of ThrustHarmonic
    runouts : tuple of RunoutHarmonic
    loss_limit : float
        Of L1.
    axial_limit : float or None
        Admissible amplitude of axial vibration anywhere along the shaft, m.
    speeds : tuple of float
        Of the sweep, rad/s; empty for none.
    nonlinear : bool
        Whether the nonlinear motion is solved, too.
    """

    thrust: ThrustDesign
    line: ShaftLine
    thrusts: tuple[ThrustHarmonic, ...]
    runouts: tuple[RunoutHarmonic, ...]
    loss_limit: float = 0.5
    loss_limit_source: str = ""
    axial_limit: float | None = None
    speeds: tuple[float, ...] = ()
    nonlinear: bool = False
    kind: str = "thrust_line"

    @property
    def name(self) -> str:
        """Of the line."""
        return self.thrust.name

    @property
    def lubricant(self) -> Lubricant:
        """Of the bearing."""
        return self.thrust.lubricant

    @property
    def given(self) -> tuple[tuple[str, str], ...]:
        """How the case gave its numbers."""
        return self.thrust.given

    @property
    def warnings(self) -> tuple[Notice, ...]:
        """Warnings that arose while the case was made."""
        return self.thrust.warnings

    @property
    def duty(self) -> LineOperation:
        """What is solved."""
        assert isinstance(self.thrust.duty, PrescribedThrust)
        return LineOperation(
            self.line, self.thrust.bearing, self.thrust.duty.thrust, self.thrust.speed, self.thrusts, self.runouts
        )

    def films_at(self, duty: LineOperation) -> LoadCurve:
        """Films of one pad at the speed and thrust of a duty."""
        return films_in_oil(self.thrust, duty.bearing, duty.speed, PrescribedThrust(duty.thrust))[0]
