"""What the film answers, in SI."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from babbitt.core.result import Outcome
from babbitt.reynolds.model import JournalFilm

__all__ = ["FilmSolution", "attitude_angle", "sommerfeld_number"]

NOTHING = 1e-9
"""Share of a flow that is round-off."""

Array = NDArray[np.float64]


def attitude_angle(film: JournalFilm, position: ArrayLike, load_angle: float) -> Array:
    """From the load to the line of centres in the sense of rotation, rad, within (-pi, pi].

    Parameters
    ----------
    film : JournalFilm
        Says the sense.
    position : array_like, shape (..., 2)
        Of the journal centre, m.
    load_angle : float
        Direction of the load, rad.

    Returns
    -------
    ndarray, shape (...)
    """
    x, y = np.moveaxis(np.asarray(position, dtype=np.float64), -1, 0)
    turn = math.copysign(1.0, film.angular_speed) * (np.arctan2(y, x) - load_angle)
    return np.asarray(math.pi - (math.pi - turn) % (2.0 * math.pi))


def sommerfeld_number(film: JournalFilm, load: ArrayLike, speed: ArrayLike) -> Array:
    """So = F psi^2 / (B D eta omega), psi = 2 c / D (ISO 7902), under loads in N at speeds in rad/s."""
    psi = 2.0 * film.clearance / film.diameter
    unit = film.width * film.diameter * film.viscosity / psi**2
    return np.asarray(np.asarray(load) / (unit * np.abs(speed)))


@dataclass(frozen=True, eq=False)
class FilmSolution:
    """A journal film at rest in its equilibrium, or at a prescribed position.

    Attributes
    ----------
    film : JournalFilm
    outcome : Outcome
        Read this first; the values of an unsolved film are where the search ended.
    position : ndarray, shape (2,)
        Journal centre from the bearing centre, m.
    force : ndarray, shape (2,)
        Of film and grooves on the journal, N.
    stiffness, damping : ndarray, shape (2, 2)
        dF = -(K dx + C dx'), N/m and N s/m; the void is transported, not stored (quasi-static).
    angles : ndarray, shape (lands, n + 1)
        Lines of the film, rad, in the sense of rotation.
    axial_positions : ndarray, shape (m + 1,)
        From the mid-plane to the side edge, m.
    pressure : ndarray, shape (lands, n + 1, m + 1)
        Gauge, Pa.
    void : ndarray, same shape
        1 - liquid fraction.
    supply_flow : ndarray, shape (supplies,)
        What every supply adds, m3/s: what leaves it into the film less what the film brings. Grooves between lands
        come first, counter-clockwise from that behind the land of least start angle within a turn, then pockets in
        their own order. A film that starts at the widest gap is supplied there.
    inflow, outflow : ndarray, shape (lands,)
        What crosses the edge at which the journal enters each land, and that at which it leaves it, m3/s.
    side_flow : ndarray, shape (lands,) or (1,)
        What leaves by both sides, m3/s: from every land, or from a surface as a whole (``film.is_surface``).
    end_flows : ndarray, shape (2,)
        What leaves by the sides z = -B/2 and z = B/2 less what they draw in, m3/s.
    side_inflow : float
        What the sides draw in, m3/s: nothing where their pressure is that of the cavity.
    friction_torque, bearing_torque : float
        On the journal and by shear on the bore, N m, against and with the rotation. They differ by the couple of
        load and reaction in a round bore; where its arcs have other centres, pressure turns it, too.
    streamer_torque : float
        Part of both by shear of the oil that the ruptured film carries, N m.
    mass_balance_error : float
        Over the flow that enters the lands. Under the Reynolds condition the film itself does not conserve oil.
    iterations : int
    wall_time : float
        s.
    axial_breaks : tuple of int
        Positions at which one polynomial of the pressure across the width ends and the next begins, both ends
        included. Empty: a single even polynomial.
    """

    film: JournalFilm
    outcome: Outcome
    position: Array
    force: Array
    stiffness: Array
    damping: Array
    minimum_film_thickness: float
    angles: Array
    axial_positions: Array
    pressure: Array
    void: Array
    supply_flow: Array
    inflow: Array
    outflow: Array
    side_flow: Array
    end_flows: Array
    side_inflow: float
    friction_torque: float
    bearing_torque: float
    streamer_torque: float
    mass_balance_error: float
    iterations: int
    wall_time: float
    axial_breaks: tuple[int, ...] = ()

    @property
    def eccentricity_ratio(self) -> float:
        """Eccentricity over radial clearance of the assembled bearing."""
        return math.hypot(*self.position) / self.film.clearance

    @property
    def attitude_angle(self) -> float:
        """From the load to the line of centres in the sense of rotation, rad, within (-pi, pi]."""
        load_angle = math.atan2(-self.force[1], -self.force[0])
        return float(attitude_angle(self.film, self.position, load_angle))

    @property
    def load(self) -> float:
        """Force of the film, N."""
        return math.hypot(*self.force)

    @property
    def sommerfeld_number(self) -> float:
        """So of ISO 7902 (`sommerfeld_number`)."""
        return float(sommerfeld_number(self.film, self.load, self.film.angular_speed))

    @property
    def leaving_flow(self) -> float:
        """What leaves by the sides, and through supplies that take more than they give, m3/s.

        Oil that the sides draw in at other places is not taken off: it enters cold and leaves warm.
        """
        by_sides = float(self.end_flows.sum()) + self.side_inflow
        draws = self.side_inflow > NOTHING * by_sides
        return by_sides + (max(-float(self.supply_flow.sum()), 0.0) if draws else 0.0)

    @property
    def maximum_pressure(self) -> float:
        """Highest gauge pressure on the lines, Pa."""
        return float(self.pressure.max())

    @property
    def pressure_torque(self) -> float:
        """Part of the friction torque by the pressure on the journal, ``F e sin(β)/2``, N m."""
        (x, y), (fx, fy) = self.position, self.force
        return 0.5 * math.copysign(1.0, self.film.angular_speed) * float(x * fy - y * fx)

    @property
    def friction_power(self) -> float:
        """W, on the journal."""
        return self.friction_torque * abs(self.film.angular_speed)
