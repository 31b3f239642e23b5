"""What shakes the line: harmonics of thrust at the propeller and of runout at the collar."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.runout import RunoutHarmonic

__all__ = ["WITHOUT_WOBBLE", "WOBBLE_LEFT_OUT", "RunoutHarmonic", "ThrustHarmonic"]

WOBBLE_LEFT_OUT = (
    "a line pivot holds the tilt along the radius against a collar face that leans, which the nonlinear motion "
    "leaves out and the linear answer counts"
)
"""Why runout of one lobe and pads with a held tilt have no nonlinear motion."""
WITHOUT_WOBBLE = "a point pivot, or runout of 2 lobes or more"
"""What has one."""


@dataclass(frozen=True)
class ThrustHarmonic:
    """Thrust ripple Q = amplitude cos(order omega t + phase) (D7).

    Attributes
    ----------
    order : float
        Frequency over the frequency of the shaft: the number of blades, twice that, a gear ratio.
    amplitude : float
        Q_m, N.
    phase : float
        gamma, rad.
    """

    order: float
    amplitude: float
    phase: float = 0.0

    def __post_init__(self) -> None:
        _require(self)

    def scaled(self, factor: float) -> ThrustHarmonic:
        """With another amplitude."""
        return replace(self, amplitude=self.amplitude * factor)


def _require(harmonic: ThrustHarmonic) -> None:
    if not (math.isfinite(harmonic.order) and harmonic.order > 0.0):
        raise InputError("E203", f"order of the thrust ripple is {harmonic.order:g}; it must be positive.")
    if not (math.isfinite(harmonic.amplitude) and harmonic.amplitude >= 0.0):
        raise InputError(
            "E203", f"amplitude of the thrust ripple is {harmonic.amplitude:g} N; it must be 0 or more."
        )
