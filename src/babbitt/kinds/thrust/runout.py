"""Runout and waves of the face of a collar."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from babbitt.core.notices import InputError

__all__ = ["RunoutHarmonic"]


@dataclass(frozen=True)
class RunoutHarmonic:
    """Waviness of the face in ``order`` lobes: xi_i = amplitude cos(order (omega t - gamma_i) + phase) (D6).

    Order 1 is face runout; ``amplitude`` (m) at the pivot radius is half the indicator reading.
    """

    order: float
    amplitude: float
    phase: float = 0.0

    def __post_init__(self) -> None:
        if not self.order > 0.0 or self.order != round(self.order):
            raise InputError("E203", f"order of the runout is {self.order:g}; a face has whole lobes: 1, 2, 3 ...")
        if not (math.isfinite(self.amplitude) and self.amplitude >= 0.0):
            raise InputError("E203", f"amplitude of the runout is {self.amplitude:g} m; it must be 0 or more.")

    @property
    def leans(self) -> bool:
        """Whether the face leans under the pads: one high spot is a plane; of waves only the height counts."""
        return self.order == 1.0

    def scaled(self, factor: float) -> RunoutHarmonic:
        """With another amplitude."""
        return replace(self, amplitude=self.amplitude * factor)
