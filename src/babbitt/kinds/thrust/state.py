"""The film of one pad at rest: pressure, flows, coefficients in the frame of the pivot."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from babbitt.design.pad_heat import PadTemperatures
from babbitt.kinds.thrust.pad import ThrustPad

if TYPE_CHECKING:
    from babbitt.reynolds.sector.sector import SectorFilm
    from babbitt.reynolds.sector.thermal_sector import SectorHeat

__all__ = ["PadState", "TiltInertia", "condensed", "tilt_answer", "face_runout_response"]

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]

CONTACT = 1e-6
"""Film that counts as contact, m: surfaces of a good finish touch there."""


@dataclass(frozen=True)
class TiltInertia:
    """Moments of inertia of a pad about the two tilt axes, kg m2: of alpha_x (radial) and of alpha_y (along)."""

    radial: float = 0.0
    along: float = 0.0


@dataclass(frozen=True, eq=False)
class PadState:
    """A pad at rest: moments about the axes of its free tilts vanish.

    Motions are (h_p, alpha_x, alpha_y), h = h_p + alpha_x X + alpha_y Y (`ThrustPad.from_pivot`).

    Attributes
    ----------
    pad : ThrustPad
    film : SectorFilm
        The film solved; of a similar film where the state was scaled, see ``scale``.
    scale : tuple of float
        Film thickness, viscosity and speed of this state over those of ``film``.
    height, slope_x, slope_y : float
        At the pivot m, and alpha_x, alpha_y.
    viscosity, angular_speed : float
        Pa s, rad/s.
    load : float
        N.
    moments : tuple of float
        About the pivot, of p X and of p Y, N m; zero for free tilts.
    stiffness, damping : ndarray, shape (3, 3)
        Forces on the motions change by -(K a + C a').
    minimum_film_thickness : float
        Over all edges and the face, m.
    maximum_pressure : float
        Pa.
    leading_flow, trailing_flow, inner_flow, outer_flow : float
        Into the pad over its leading edge, out over the others, m3/s.
    friction_torque : float
        On the runner, N m.
    heat : SectorHeat or None
        Temperatures of a film that has its own; its coefficients hold for frozen ones.
    balance : PadTemperatures or None
        Temperatures of a film that has one, of its own heat balance.
    """

    pad: ThrustPad
    film: SectorFilm
    scale: tuple[float, float, float]
    height: float
    slope_x: float
    slope_y: float
    viscosity: float
    angular_speed: float
    load: float
    moments: tuple[float, float]
    stiffness: Array
    damping: Array
    minimum_film_thickness: float
    maximum_pressure: float
    leading_flow: float
    trailing_flow: float
    inner_flow: float
    outer_flow: float
    friction_torque: float
    heat: SectorHeat | None = None
    balance: PadTemperatures | None = None

    @property
    def friction_power(self) -> float:
        """Of the runner, W."""
        return self.friction_torque * self.angular_speed

    @property
    def side_flow(self) -> float:
        """Out over the inner and outer edge, m3/s."""
        return self.inner_flow + self.outer_flow

    @property
    def mass_balance_error(self) -> float:
        """Oil that enters over all edges less what leaves, over half of all that passes them."""
        net = self.leading_flow - self.trailing_flow - self.side_flow
        passing = sum(
            abs(flow) for flow in (self.leading_flow, self.trailing_flow, self.inner_flow, self.outer_flow)
        )
        return abs(net) / (0.5 * passing)

    @property
    def motion(self) -> Array:
        """(h_p, alpha_x, alpha_y), m and 1."""
        return np.array([self.height, self.slope_x, self.slope_y])

    def pressure(self) -> Array:
        """Pressure on the nodes of ``film``, Pa."""
        thickness, viscosity, speed = self.scale
        return self.film.pressure * (viscosity * speed / thickness**2)

    def similar(self, height: float, viscosity: float, angular_speed: float) -> PadState:
        """The same film shape at another thickness, viscosity and speed.

        W ~ mu omega/h^2, K ~ mu omega/h^3, C ~ mu/h^3, flows ~ omega h, friction ~ mu omega/h.

        Parameters
        ----------
        height : float
            At the pivot, m; only a plane pad may have another height.
        viscosity, angular_speed : float
            Pa s, rad/s; of a turbulent film neither may change.
        """
        h, mu, omega = height / self.height, viscosity / self.viscosity, angular_speed / self.angular_speed
        flow = omega * h
        return replace(
            self,
            scale=(self.scale[0] * h, self.scale[1] * mu, self.scale[2] * omega),
            height=height,
            slope_x=self.slope_x * h,
            slope_y=self.slope_y * h,
            viscosity=viscosity,
            angular_speed=angular_speed,
            load=self.load * mu * omega / h**2,
            moments=(self.moments[0] * mu * omega / h**2, self.moments[1] * mu * omega / h**2),
            stiffness=self.stiffness * mu * omega / h**3,
            damping=self.damping * mu / h**3,
            minimum_film_thickness=self.minimum_film_thickness * h,
            maximum_pressure=self.maximum_pressure * mu * omega / h**2,
            leading_flow=self.leading_flow * flow,
            trailing_flow=self.trailing_flow * flow,
            inner_flow=self.inner_flow * flow,
            outer_flow=self.outer_flow * flow,
            friction_torque=self.friction_torque * mu * omega / h,
        )


def tilt_answer(state: PadState, frequency: float, inertia: TiltInertia) -> ComplexArray:
    """Tilts of a pad over the amplitude of its height, t = -(K_tt + j nu C_tt - nu^2 J)^-1 (K_t1 + j nu C_t1).

    Returns
    -------
    ndarray, shape (2,)
        alpha_x and alpha_y, 1/m; zero for those that the pivot holds.
    """
    free = list(state.pad.free_tilts)
    answer = np.zeros(2, dtype=complex)
    if free:
        moving = state.stiffness + 1j * frequency * state.damping
        moving = moving - frequency**2 * np.diag([0.0, inertia.radial, inertia.along])
        answer[np.array(free) - 1] = -_driven(moving[np.ix_(free, free)], moving[free, 0])
    return answer


def face_runout_response(state: PadState, frequency: float, inertia: TiltInertia) -> ComplexArray:
    """Slopes of the gap over the runout under the pivot, where the face of the collar is a plane that wobbles.

    Under a pad the face stands out by xi (1 + X/r_p - j Y/r_p), the wave of a plane that leans. A free tilt
    follows it but for its inertia; what the pivot holds does not:
    g = w + t, w = -(1, -j)/r_p, t = -(K_tt + j nu C_tt - nu^2 J)^-1 (K + j nu C)_t w.

    Returns
    -------
    ndarray, shape (2,)
        1/m.
    """
    driven: ComplexArray = np.array([-1.0, 1.0j], dtype=np.complex128) / state.pad.pivot_radius
    free = list(state.pad.free_tilts)
    if not free:
        return driven
    film: ComplexArray = state.stiffness + 1j * frequency * state.damping
    moving = film - frequency**2 * np.diag([0.0, inertia.radial, inertia.along])
    answer = driven.copy()
    answer[np.array(free) - 1] -= _driven(moving[np.ix_(free, free)], film[free, 1:] @ driven)
    return answer


def _driven(matrix: ComplexArray, moment: ComplexArray) -> ComplexArray:
    """Tilts under a moment; none without one, for a pad whose film carries nothing does not hold them either."""
    return np.asarray(np.linalg.solve(matrix, moment)) if moment.any() else np.zeros_like(moment)


def condensed(state: PadState, frequency: float, inertia: TiltInertia = TiltInertia()) -> complex:
    """Complex stiffness k + j nu d of the height with the tilts free, N/m.

    At zero frequency k = 2 W/h_p of a plane pad, whatever its shape: W ~ 1/h_p^2.
    """
    row = (state.stiffness + 1j * frequency * state.damping)[0]
    return complex(row[0] + row[1:] @ tilt_answer(state, frequency, inertia))
