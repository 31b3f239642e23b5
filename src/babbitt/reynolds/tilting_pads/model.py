"""A bearing of tilting pads, the state of its pads, and the equilibrium of both, in SI.

Angles are counter-clockwise from +x. A pad leads where the journal enters it: at its smaller angle if the
journal turns counter-clockwise, at its larger one otherwise. In the frame of a pad n points from the centre of
the bearing to the pivot and tau a quarter turn further; a tilt delta turns the pad counter-clockwise about its
pivot and moves its bore by s = (R + c_p + t) delta along tau as if the journal had moved back, and a pivot that
gives way by u moves it outward along n. The film knows only

    xi = (x, y) n - u,      eta = (x, y) tau - v + s,
    h = c_p - (c_p - c_b + xi) cos(phi) - eta sin(phi) + w(phi),      phi = theta - theta_p.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds.model import Cavitation, JournalFilm, Land
from babbitt.reynolds.tilting_pads.pivots import Pivot, RigidPivot

__all__ = [
    "PadMaterial",
    "PadPosition",
    "PadState",
    "PadStatus",
    "TiltingPad",
    "TiltingPadBearing",
    "TiltingPadSolution",
    "film_of",
    "standing",
    "tilted_land",
    "tilted_lands",
]

Array = NDArray[np.float64]
Vector = tuple[float, float]


class PadStatus(Enum):
    """Whether a pad carries load."""

    LOADED = "loaded"
    AT_LIMIT = "at its limit"
    UNLOADED = "unloaded"


@dataclass(frozen=True)
class PadMaterial:
    """Material of a pad.

    Attributes
    ----------
    elastic_modulus : float
        Pa; E/(1 - nu^2) for a pad that bends as a plate.
    thermal_expansion : float
        1/K.
    conductivity : float
        W/(m K).
    density : float
        kg/m3.
    """

    elastic_modulus: float
    thermal_expansion: float = 0.0
    conductivity: float = math.nan
    density: float = 0.0


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
        Of the flexure without moment, rad.
    tangential_stiffness : float
        Of the pivot along the journal's way, N/m; infinite: rigid.
    pivot_damping, rotational_damping, tangential_damping : float
        Beside the stiffness of the pivot, N s/m, N m s/rad, N s/m.
    mass : float
        kg.
    inertia : float
        About the pivot, kg m2.
    mass_offset : float
        Distance of the centre of gravity from the pivot along tau in the sense of rotation, m.
    material : PadMaterial or None
        For bending and growth.
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
    material: PadMaterial | None = None
    profile: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        for name in ("extent", "clearance", "thickness", "tangential_stiffness"):
            if not getattr(self, name) > 0.0:
                raise InputError(
                    "E101", f"{name} of a pad is {getattr(self, name)}; it must be a positive number."
                )
        for name in ("mass", "inertia", "rotational_stiffness", "pivot_damping", "rotational_damping",
                     "tangential_damping"):  # fmt: skip
            if not getattr(self, name) >= 0.0:
                raise InputError("E101", f"{name} of a pad is {getattr(self, name)}; it must not be negative.")
        if not self.assembled_clearance > 0.0:
            raise InputError("E101", f"assembled_clearance of a pad is {self.assembled_clearance} m; it must be "
                             "positive (preload below 1).")  # fmt: skip
        if not 0.0 < self.pivot_fraction < 1.0:
            raise InputError("E101", f"pivot_fraction of a pad is {self.pivot_fraction}; the pivot must stand "
                             "between the edges of the pad, 0 to 1.")  # fmt: skip

    @property
    def preload(self) -> float:
        """Preload 1 - c_b/c_p."""
        return 1.0 - self.assembled_clearance / self.clearance

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
        Gauge pressure of the oil between the pads, Pa.
    """

    diameter: float
    width: float
    viscosity: float
    angular_speed: float
    pads: tuple[TiltingPad, ...]
    groove_pressure: float = 0.0

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

    def lever(self, pad: TiltingPad) -> float:
        """Radius R + c_p + t of the contact of the pivot: a tilt times this moves the bore, m."""
        return self.radius + pad.clearance + pad.thickness


@dataclass(frozen=True)
class PadPosition:
    """Where a pad stands.

    Attributes
    ----------
    tilt : float
        rad, counter-clockwise.
    pivot_displacement : float
        Outward, m.
    tangential_displacement : float
        Of the pivot along tau, m.
    """

    tilt: float = 0.0
    pivot_displacement: float = 0.0
    tangential_displacement: float = 0.0


@dataclass(frozen=True, eq=False)
class PadState:
    """A pad in its bearing.

    Attributes
    ----------
    status : PadStatus
        An unloaded pad has no tilt of its own; its film stands for the pad concentric with its bore (eta = 0).
    position : PadPosition
        ``tilt`` is nan where the pad is unloaded.
    radial, tangential : float
        xi and eta of the module, m.
    eccentricity_ratio : float
        eps_p = preload + xi/c_p, at the pivot.
    load : float
        On the pivot, N.
    force : ndarray, shape (2,)
        Of the film on the journal along n and tau, N.
    stiffness, damping : ndarray, shape (2, 2)
        Of the film in (xi, eta): d(force) = -(K d(xi, eta) + C d(xi, eta)'), N/m and N s/m.
    pivot_stiffness : float
        dP/du at the load, N/m; infinite where rigid.
    minimum_film_thickness, maximum_pressure : float
        m and Pa, on the lines of the film.
    inflow, outflow, side_flow : float
        Over the leading edge, the trailing edge and both sides, m3/s.
    friction_torque : float
        On the journal, N m, against its rotation.
    shear_torque : float
        By shear on the bore of the pad, about the centre of the bearing, N m, with the rotation.
    angles : ndarray, shape (n + 1,)
        Lines of the film, rad, in the sense of rotation.
    axial_positions : ndarray, shape (m + 1,)
        From the mid-plane to the side edge, m.
    pressure, void : ndarray, shape (n + 1, m + 1)
        Gauge, Pa, and 1 - liquid fraction.
    """

    status: PadStatus
    position: PadPosition
    radial: float
    tangential: float
    eccentricity_ratio: float
    load: float
    force: Array
    stiffness: Array
    damping: Array
    pivot_stiffness: float
    minimum_film_thickness: float
    maximum_pressure: float
    inflow: float
    outflow: float
    side_flow: float
    friction_torque: float
    shear_torque: float
    angles: Array
    axial_positions: Array
    pressure: Array
    void: Array


@dataclass(frozen=True, eq=False)
class TiltingPadSolution:
    """A journal among its pads, in equilibrium or at a prescribed position.

    Attributes
    ----------
    bearing : TiltingPadBearing
    outcome : Outcome
        Read this first; the values of an unsolved bearing are where the search ended.
    position : ndarray, shape (2,)
        Journal centre from the bearing centre, m.
    force : ndarray, shape (2,)
        Of all films on the journal, N.
    pads : tuple of PadState
        In the order of the bearing.
    residual : float
        Force left over, N.
    indifferent : bool
        Whether one direction of the position is that of the start, for no loaded pad stiffens it.
    limit_pad : int or None
        The pad that would have to carry less than it can: no equilibrium exists (`Outcome.PAD_AT_LIMIT`). Two may
        be at their limits together (``status``); this is the first.
    limit_loads : tuple of float
        What that pad would have to carry, and the least that it can, N; empty otherwise.
    iterations : int
        Newton steps of the journal.
    films : int
        Solutions of the film of a pad.
    wall_time : float
        s.
    """

    bearing: TiltingPadBearing
    outcome: Outcome
    position: Array
    force: Array
    pads: tuple[PadState, ...]
    residual: float
    indifferent: bool
    limit_pad: int | None
    limit_loads: tuple[float, ...]
    iterations: int
    films: int
    wall_time: float

    @property
    def loaded(self) -> tuple[int, ...]:
        """Numbers of the pads that carry load."""
        return tuple(number for number, pad in enumerate(self.pads) if pad.status is PadStatus.LOADED)

    @property
    def load(self) -> float:
        """Force of the films, N."""
        return math.hypot(*self.force)

    @property
    def eccentricity_ratio(self) -> float:
        """Eccentricity over the smallest assembled clearance."""
        return math.hypot(*self.position) / self.bearing.assembled_clearance

    @property
    def minimum_film_thickness(self) -> float:
        """Of the loaded pads, or of all where none is loaded, m."""
        chosen = [self.pads[number] for number in self.loaded] or list(self.pads)
        return min(pad.minimum_film_thickness for pad in chosen)

    @property
    def maximum_pressure(self) -> float:
        """Gauge, Pa."""
        return max(pad.maximum_pressure for pad in self.pads)

    @property
    def friction_torque(self) -> float:
        """On the journal, N m, against its rotation."""
        return sum(pad.friction_torque for pad in self.pads)

    @property
    def friction_power(self) -> float:
        """W, on the journal."""
        return self.friction_torque * abs(self.bearing.angular_speed)

    @property
    def side_flow(self) -> float:
        """What leaves by the sides of all pads, m3/s."""
        return sum(pad.side_flow for pad in self.pads)


def tilted_land(bearing: TiltingPadBearing, pad: TiltingPad, position: PadPosition) -> Land:
    """The land that a pad makes: its bore about a centre moved by preload, pivot and tilt.

    Parameters
    ----------
    bearing : TiltingPadBearing
    pad : TiltingPad
    position : PadPosition

    Returns
    -------
    Land
        ``clearance`` c_p and ``centre`` (u - (c_p - c_b)) n + (v - s) tau, so that the gap of a journal at (x,
        y) is c_p - (x - x_c) cos(theta) - (y - y_c) sin(theta).
    """
    outward = position.pivot_displacement - (pad.clearance - pad.assembled_clearance)
    along = position.tangential_displacement - bearing.lever(pad) * position.tilt
    centre = outward * pad.normal() + along * pad.tangent()
    start, end = bearing.edges(pad)
    return Land(
        start, end, pad.clearance, (float(centre[0]), float(centre[1])), bearing.groove_pressure,
        bearing.groove_pressure, pad.profile,
    )  # fmt: skip


def tilted_lands(bearing: TiltingPadBearing, positions: tuple[PadPosition, ...]) -> tuple[Land, ...]:
    """The lands of all pads, in their order."""
    return tuple(tilted_land(bearing, pad, at) for pad, at in zip(bearing.pads, positions, strict=True))


def film_of(
    bearing: TiltingPadBearing, positions: tuple[PadPosition, ...], cavitation: Cavitation = Cavitation.REYNOLDS
) -> JournalFilm:
    """The film between a journal and pads that stand where they are (a bearing of fixed lobes).

    Raises
    ------
    InputError
        E101 if pads differ in width or viscosity, which one film has not.
    """
    if any(pad.width not in (None, bearing.width) for pad in bearing.pads):
        raise InputError("E101", "pads of different widths have no common film; give all pads one width.")
    if any(pad.viscosity not in (None, bearing.viscosity) for pad in bearing.pads):
        raise InputError("E101", "pads of different viscosities have no common film; give all pads one viscosity.")
    return JournalFilm(
        bearing.diameter, bearing.width, bearing.assembled_clearance, bearing.viscosity, bearing.angular_speed,
        tilted_lands(bearing, positions), cavitation,
    )  # fmt: skip


def standing(solution: TiltingPadSolution) -> tuple[PadPosition, ...]:
    """Where the pads of a solution stand; unloaded ones concentric with their bores (eta = 0)."""
    places = []
    for pad, state in zip(solution.bearing.pads, solution.pads, strict=True):
        at = state.position
        if math.isnan(at.tilt):
            along = float(solution.position @ pad.tangent())
            at = replace(at, tilt=-along / solution.bearing.lever(pad))
        places.append(at)
    return tuple(places)


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
