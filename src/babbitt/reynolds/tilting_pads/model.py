"""A bearing of tilting pads, in SI.

Angles are counter-clockwise from +x. A pad leads where the journal enters it: at its smaller angle if the
journal turns counter-clockwise, at its larger one otherwise. In the frame of a pad n points from the centre of
the bearing to the pivot and tau a quarter turn further. A tilt delta turns the pad counter-clockwise about its
pivot: the bore before it moves outward, the bore behind it inward, as if the journal had moved along tau by
s = (R + c_p + t) delta. A pivot that gives way by u moves the bore outward, as if the journal had moved back along
n. The film knows only

    xi = (x, y) n - u,      eta = (x, y) tau - v + s,
    h = c_p - (c_p - c_b + xi) cos(phi) - eta sin(phi) + w(phi),      phi = theta - theta_p.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.oil.turbulence import FilmTurbulence
from babbitt.reynolds.tilting_pads.pivots import Pivot, RigidPivot

if TYPE_CHECKING:
    from babbitt.reynolds.tilting_pads._structs import Pads
    from babbitt.reynolds.tilting_pads.kernel_pads import PadScales

__all__ = ["TiltingPad", "TiltingPadBearing"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class TiltingPad:
    """A pad on its pivot.

    Attributes
    ----------
    pivot_angle : float
        rad.
    extent : float
        Angle from edge to edge, rad.
    clearance : float
        Radius of the pad's bore less that of the journal (machined), m.
    assembled_clearance : float
        Gap at the pivot when the journal is centred, m.
    thickness : float
        From the bore to the contact of the pivot, m.
    pivot_fraction : float
        Angle from the leading edge to the pivot over ``extent``.
    width : float or None
        m; None: that of the bearing.
    viscosity : float or None
        Pa s; None: that of the bearing.
    pivot : Pivot
        How far it gives way under load.
    rotational_stiffness : float
        Of a flexure, N m/rad; 0: free to tilt.
    rest_tilt : float
        Of the flexure without moment, rad, counter-clockwise.
    tangential_stiffness : float
        Of the pivot along the journal's way, N/m; infinite: rigid.
    pivot_damping, rotational_damping, tangential_damping : float
        In parallel with the stiffness of the pivot, N s/m, N m s/rad, N s/m.
    mass : float
        kg.
    inertia : float
        About the pivot, kg m2.
    mass_offset, mass_inset : float
        Distances of the centre of gravity from the contact of the pivot, m: in the sense of rotation, and towards
        the centre of the bearing.
    bending_stiffness : float
        Against bending along its one mode (`bending_mode.BendingMode`), N/m; infinite: it does not bend. Its part
        of the mass moves with it.
    probe_fraction : float
        Angle from the leading edge to a probe of the temperature of the bore, over ``extent``.
    profile : tuple of float
        Departure of the bore from its circle, m, outward positive, at equally spaced angles from the smaller to
        the larger (bending, wear). Empty: none.
    """

    pivot_angle: float
    extent: float
    clearance: float
    assembled_clearance: float
    thickness: float
    pivot_fraction: float = 0.5
    width: float | None = None
    viscosity: float | None = None
    pivot: Pivot = field(default_factory=RigidPivot)
    rotational_stiffness: float = 0.0
    rest_tilt: float = 0.0
    tangential_stiffness: float = math.inf
    pivot_damping: float = 0.0
    rotational_damping: float = 0.0
    tangential_damping: float = 0.0
    mass: float = 0.0
    inertia: float = 0.0
    mass_offset: float = 0.0
    mass_inset: float = 0.0
    bending_stiffness: float = math.inf
    probe_fraction: float = 0.75
    profile: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        for name in ("pivot_angle", "rest_tilt", "mass_offset", "mass_inset"):
            if not math.isfinite(getattr(self, name)):
                raise InputError("E101", f"{name} of a pad is {getattr(self, name)}; it must be a finite number.")
        for name in ("extent", "clearance", "thickness", "tangential_stiffness", "bending_stiffness"):
            if not getattr(self, name) > 0.0:
                raise InputError(
                    "E101", f"{name} of a pad is {getattr(self, name)}; it must be a positive number."
                )
        for name in ("mass", "inertia", "rotational_stiffness", "pivot_damping", "rotational_damping",
                     "tangential_damping"):  # fmt: skip
            if not getattr(self, name) >= 0.0:
                raise InputError("E101", f"{name} of a pad is {getattr(self, name)}; it must not be negative.")
        least = self.mass * (self.mass_offset**2 + self.mass_inset**2)
        if not self.inertia >= least * (1.0 - 1e-12):
            raise InputError(
                "E101",
                f"inertia of a pad is {self.inertia} kg m2 about its pivot; its mass at its mass_offset and "
                f"mass_inset alone has {least:.6g}. Give that or more.",
            )
        if not self.assembled_clearance > 0.0:
            raise InputError("E101", f"assembled_clearance of a pad is {self.assembled_clearance} m; it must be "
                             "positive (preload below 1).")  # fmt: skip
        if not all(math.isfinite(place) for place in self.profile):
            raise InputError("E101", "profile of a pad has entries that are not finite; give lengths in m.")
        if not 0.0 <= self.probe_fraction <= 1.0:
            raise InputError("E101", f"probe_fraction of a pad is {self.probe_fraction}; the probe must stand in "
                             "the pad, 0 to 1.")  # fmt: skip
        if not 0.0 < self.pivot_fraction < 1.0:
            raise InputError("E101", f"pivot_fraction of a pad is {self.pivot_fraction}; the pivot must stand "
                             "between the edges of the pad, 0 to 1.")  # fmt: skip

    @property
    def preload(self) -> float:
        """Preload 1 - c_b/c_p."""
        return 1.0 - self.assembled_clearance / self.clearance

    @property
    def bends(self) -> bool:
        """Whether it bends under the pressure of its film."""
        return math.isfinite(self.bending_stiffness)

    @property
    def is_rigid(self) -> bool:
        """Whether its pivot gives way in neither direction."""
        return isinstance(self.pivot, RigidPivot) and math.isinf(self.tangential_stiffness)

    def normal(self) -> Array:
        """Unit vector n from the centre of the bearing to the pivot, shape (2,)."""
        return np.array([math.cos(self.pivot_angle), math.sin(self.pivot_angle)])

    def tangent(self) -> Array:
        """Unit vector tau a quarter turn counter-clockwise of n, shape (2,)."""
        return np.array([-math.sin(self.pivot_angle), math.cos(self.pivot_angle)])


@dataclass(frozen=True)
class TiltingPadBearing:
    """Pads around a journal.

    Attributes
    ----------
    diameter, width : float
        Of the journal, and of the pads, m.
    viscosity : float
        Pa s.
    angular_speed : float
        rad/s, positive counter-clockwise.
    pads : tuple of TiltingPad
    groove_pressure : float
        Gauge pressure of the oil between the pads, Pa: over the full width of the gaps between them, and at both
        edges of every loaded pad. An unloaded pad is taken to carry nothing, though the same pressure at its edges
        would push.
    turbulence : FilmTurbulence or None
        Of all films; None: laminar.
    """

    diameter: float
    width: float
    viscosity: float
    angular_speed: float
    pads: tuple[TiltingPad, ...]
    groove_pressure: float = 0.0
    turbulence: FilmTurbulence | None = None

    def __post_init__(self) -> None:
        for name in ("diameter", "width", "viscosity"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0.0):
                raise InputError("E101", f"{name} is {value}; it must be a positive number (SI units).")
        if not (math.isfinite(self.angular_speed) and self.angular_speed != 0.0):
            raise InputError(
                "E101", f"angular_speed is {self.angular_speed} rad/s; it must be finite and not zero."
            )
        if not self.groove_pressure >= 0.0:
            raise InputError("E101", f"groove_pressure is {self.groove_pressure} Pa; it must be zero or more.")
        if not self.pads:
            raise InputError("E101", "pads is empty; a bearing needs at least one pad.")
        check_overlap(self)

    @cached_property
    def prepared(self) -> tuple[PadScales, Pads]:
        """Units, and pads in them as the kernels take them: made once for all solutions of a bearing."""
        from babbitt.reynolds.tilting_pads.kernel_pads import PadScales, kernel_pads

        scales = PadScales(self)
        return scales, kernel_pads(self, scales)

    @property
    def radius(self) -> float:
        """Of the journal, m."""
        return 0.5 * self.diameter

    @property
    def sense(self) -> float:
        """Sense of rotation: 1 counter-clockwise, -1 clockwise."""
        return math.copysign(1.0, self.angular_speed)

    @property
    def assembled_clearance(self) -> float:
        """Smallest assembled clearance of the pads, m."""
        return min(pad.assembled_clearance for pad in self.pads)

    def edges(self, pad: TiltingPad) -> tuple[float, float]:
        """Angles of both edges of a pad, the smaller first, rad."""
        before = pad.pivot_fraction if self.sense > 0.0 else 1.0 - pad.pivot_fraction
        start = pad.pivot_angle - before * pad.extent
        return start, start + pad.extent

    def width_of(self, pad: TiltingPad) -> float:
        """Width of a pad, m."""
        return self.width if pad.width is None else pad.width

    def lever(self, pad: TiltingPad) -> float:
        """Radius R + c_p + t of the contact of the pivot: a tilt times this moves the bore, m."""
        return self.radius + pad.clearance + pad.thickness


def check_overlap(bearing: TiltingPadBearing) -> None:
    """Refuse pads that overlap, naming both by their numbers from 1."""
    turn = 2.0 * math.pi
    count = len(bearing.pads)
    starts = [bearing.edges(pad)[0] % turn for pad in bearing.pads]
    order = sorted(range(count), key=starts.__getitem__)
    for place, number in enumerate(order):
        following = order[(place + 1) % count]
        room = (starts[following] - starts[number]) % turn or turn
        if bearing.pads[number].extent > room * (1.0 + 1e-12):
            raise InputError("E101", f"pad {number + 1} covers {math.degrees(bearing.pads[number].extent):.6g} "
                             f"degrees, but pad {following + 1} begins {math.degrees(room):.6g} degrees behind "
                             "its start; pads must not overlap.")  # fmt: skip
