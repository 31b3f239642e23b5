"""What shakes the line: harmonics of thrust at the propeller and of runout at the collar."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from babbitt.notices import InputError

__all__ = ["RunoutHarmonic", "ThrustHarmonic"]


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
        _require(self, "thrust ripple", "N")

    def scaled(self, factor: float) -> ThrustHarmonic:
        """With another amplitude."""
        return replace(self, amplitude=self.amplitude * factor)


@dataclass(frozen=True)
class RunoutHarmonic:
    """Waviness of the face in ``order`` lobes: xi_i = amplitude cos(order (omega t - gamma_i) + phase) (D6).

    Order 1 is face runout; ``amplitude`` (m) at the pivot radius is half the indicator reading.
    """

    order: float
    amplitude: float
    phase: float = 0.0

    def __post_init__(self) -> None:
        _require(self, "runout", "m")
        if self.order != round(self.order):
            raise InputError("E203", f"order of the runout is {self.order:g}; a face has whole lobes: 1, 2, 3 ...")

    @property
    def leans(self) -> bool:
        """Whether the face leans under the pads: one high spot is a plane; of waves only the height counts."""
        return self.order == 1.0

    def scaled(self, factor: float) -> RunoutHarmonic:
        """With another amplitude."""
        return replace(self, amplitude=self.amplitude * factor)


def _require(harmonic: ThrustHarmonic | RunoutHarmonic, what: str, unit: str) -> None:
    if not (math.isfinite(harmonic.order) and harmonic.order > 0.0):
        raise InputError("E203", f"order of the {what} is {harmonic.order:g}; it must be positive.")
    if not (math.isfinite(harmonic.amplitude) and harmonic.amplitude >= 0.0):
        raise InputError(
            "E203", f"amplitude of the {what} is {harmonic.amplitude:g} {unit}; it must be 0 or more."
        )
