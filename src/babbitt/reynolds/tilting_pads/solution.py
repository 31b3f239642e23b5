"""The state of tilting pads and of the journal among them, in SI; axes as of ``model``."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Outcome
from babbitt.reynolds.lands.axial import even_axial_operator
from babbitt.reynolds.tilting_pads.model import TiltingPadBearing

__all__ = ["LightPad", "PadBend", "PadPosition", "PadState", "PadStatus", "TiltingPadSolution"]

Array = NDArray[np.float64]


ALIKE = 1e-6
"""Share by which the loads of pads that mirror each other may differ by how a search ends."""


class PadStatus(Enum):
    """Whether a pad carries load."""

    LOADED = "loaded"
    AT_LIMIT = "at its limit"
    UNLOADED = "unloaded"


@dataclass(frozen=True)
class PadPosition:
    """Where a pad stands.

    Attributes
    ----------
    tilt : float
        rad, counter-clockwise; nan for a pad that does not carry.
    pivot_displacement : float
        Outward, m.
    tangential_displacement : float
        Of the pivot along tau, m.
    """

    tilt: float = 0.0
    pivot_displacement: float = 0.0
    tangential_displacement: float = 0.0


@dataclass(frozen=True, eq=False)
class PadBend:
    """A pad bent along its mode (`bending_mode.BendingMode`).

    Attributes
    ----------
    deflection : float
        q, m: the bore moves outward by q times the shape of the mode.
    stiffness, damping : ndarray, shape (3, 3)
        Of the film in (xi, eta, q), N/m and N s/m, the force along q being the pressure times the shape.
    """

    deflection: float
    stiffness: Array
    damping: Array


@dataclass(frozen=True, eq=False)
class FilmLines:
    """Films of all pads on their lines, in the units of the kernels: `PadState` gives those of a pad in SI.

    Attributes
    ----------
    bearing : TiltingPadBearing
    angles : ndarray, shape (pads, n + 1)
        From the pivot in the sense of rotation, rad.
    pressure, void : ndarray, shape (pads, n + 1, m + 1)
        Gauge, in `units`, and 1 - liquid fraction.
    units : tuple of float
        Of the pressure of every pad, Pa.
    """

    bearing: TiltingPadBearing
    angles: Array
    pressure: Array
    void: Array
    units: tuple[float, ...]


@dataclass(eq=False)  # a frozen one takes three microseconds longer to make, a hundredth of a bearing
class PadState:
    """A pad in its bearing.

    Attributes
    ----------
    number : int
        From 0.
    status : PadStatus
        An unloaded pad has no tilt of its own; its film stands for the pad concentric with its bore (eta = 0).
    position : PadPosition
        ``tilt`` is nan where the pad is unloaded or at its limit.
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
        dP/du at the load, N/m; infinite where rigid, nan where the load is beyond the law of the pivot.
    minimum_film_thickness : float
        m, on the lines of the film.
    inflow, outflow, side_flow : float
        Over the leading edge, the trailing edge and both sides, m3/s.
    friction_torque : float
        On the journal, N m, against its rotation.
    shear_torque : float
        By shear on the bore of the pad, about the centre of the bearing, N m, with the rotation.
    lines : FilmLines
        Of all pads; those of this one are computed as they are read.
    bend : PadBend or None
        Of a loaded pad that bends.
    """

    number: int
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
    inflow: float
    outflow: float
    side_flow: float
    friction_torque: float
    shear_torque: float
    lines: FilmLines
    bend: PadBend | None = None

    @property
    def angles(self) -> Array:
        """Lines of the film, rad, in the sense of rotation, shape (n + 1,)."""
        bearing = self.lines.bearing
        return np.asarray(bearing.sense * self.lines.angles[self.number] + bearing.pads[self.number].pivot_angle)

    @property
    def axial_positions(self) -> Array:
        """Nodes of a line from the mid-plane to the side edge, m, shape (m + 1,)."""
        bearing, unknowns = self.lines.bearing, self.void.shape[1] - 1
        return 0.5 * bearing.width_of(bearing.pads[self.number]) * even_axial_operator(unknowns).nodes

    @property
    def pressure(self) -> Array:
        """Gauge, Pa, shape (n + 1, m + 1)."""
        return np.asarray(self.lines.pressure[self.number] * self.lines.units[self.number])

    @property
    def maximum_pressure(self) -> float:
        """On the lines of the film, Pa."""
        return float(self.pressure.max())

    @property
    def void(self) -> Array:
        """1 - liquid fraction, shape (n + 1, m + 1)."""
        return np.asarray(self.lines.void[self.number])


@dataclass(frozen=True)
class LightPad:
    """A pad left without load that would have to carry more than nothing and less than it can.

    Attributes
    ----------
    number : int
        From 0.
    need, least : float
        What it would have to carry, and the least that it can, N. ``least`` is nan where the pad does carry
        ``need`` at the temperatures of the state without it, but at no others.
    returning : float
        What it carries as soon as it comes back, where the journal stands without it, N; nan where that was not
        found.
    """

    number: int
    need: float
    least: float
    returning: float = math.nan


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
    light : tuple of LightPad
        Pads without equilibrium about their folds, here left without load.
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
    light: tuple[LightPad, ...] = field(default=(), kw_only=True)

    @property
    def loaded(self) -> tuple[int, ...]:
        """Numbers of the pads that carry load."""
        return tuple(number for number, pad in enumerate(self.pads) if pad.status is PadStatus.LOADED)

    @property
    def most_loaded(self) -> int:
        """Number of the pad that carries most, from 0; of those whose loads are `ALIKE` the first."""
        loads = [pad.load for pad in self.pads]
        largest = max(loads)
        return next(number for number, load in enumerate(loads) if load >= largest - ALIKE * abs(largest))

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
