"""A plain journal bearing with jacking pockets, in SI: what the calculation gets."""

from __future__ import annotations

import math
from dataclasses import dataclass

from babbitt.core.notices import InputError, Notice
from babbitt.kinds.hydrostatic.geometry import RecessedJournal, positive

__all__ = ["JackingCase"]


LEAST_SHARE = 1e-3
"""Projected area of all pockets over length times radius of one, below which they lift nothing."""


@dataclass(frozen=True)
class JackingCase:
    """A plain bearing with jacking pockets.

    Attributes
    ----------
    name, method : str
    bearing : RecessedJournal
    viscosity : float
        Pa s, cold oil.
    load : float
        N, downwards (-y).
    lift_gap : float or None
        Wanted smallest gap, m: a limit beside a pump flow, without one the gap that is solved for.
    pump_flow : float or None
        All pockets together, m3/s; it says how far the shaft is lifted.
    relief_pressure : float or None
        Pa.
    roughness : float
        Composite roughness height: the gap at which the shaft lies, m.
    pump_efficiency : float
    accuracy : str
    own_restrictors : bool
        Whether every pocket has a restrictor or its stage of a flow divider.
    given, assumptions, warnings : tuple
    """

    name: str
    method: str
    bearing: RecessedJournal
    viscosity: float
    load: float
    lift_gap: float | None = None
    pump_flow: float | None = None
    relief_pressure: float | None = None
    roughness: float = 1e-6
    pump_efficiency: float = 0.8
    accuracy: str = "engineering"
    own_restrictors: bool = True
    given: tuple[tuple[str, str], ...] = ()
    assumptions: tuple[str, ...] = ()
    warnings: tuple[Notice, ...] = ()
    kind: str = "jacking_pocket"

    def __post_init__(self) -> None:
        positive(viscosity=self.viscosity, load=self.load, roughness=self.roughness)
        if self.lift_gap is None and self.pump_flow is None:
            raise InputError("E101", "neither lift_gap nor pump_flow is given; one of them says how far to lift.")
        for name in ("lift_gap", "roughness"):
            value = getattr(self, name)
            if value is not None and not 0.0 < value < self.bearing.clearance:
                raise InputError("E101", f"{name} is {1e6 * value:.6g} µm; it must be above zero and less than "
                                 f"the radial clearance, {1e6 * self.bearing.clearance:.6g} µm.")  # fmt: skip
        if self.lift_gap is not None and not self.lift_gap > self.roughness:
            raise InputError(
                "E101",
                f"lift_gap is {1e6 * self.lift_gap:.6g} µm; it must be more than the "
                f"composite roughness, {1e6 * self.roughness:.6g} µm, on which the shaft lies.",
            )
        if not any(math.sin(angle) < 0.0 for angle in self.bearing.recess_angles):
            raise InputError("E101", "no pocket lies in the lower half; the load acts downwards (-90 deg).")
        if not self.projected_area > LEAST_SHARE * self.bearing.recess_length * self.bearing.radius:
            raise InputError("E101", "those above push the shaft down as much as those below lift it; place all "
                             "of them in the lower half by `angles`.")  # fmt: skip

    @property
    def projected_area(self) -> float:
        """Of all pockets, seen along the load, m2."""
        half = 0.5 * self.bearing.recess_extent
        arcs = [-math.cos(angle + half) + math.cos(angle - half) for angle in self.bearing.recess_angles]
        return -self.bearing.recess_length * self.bearing.radius * sum(arcs)
