"""Jacking pockets of a plain journal bearing at rest: what lifts the shaft, and how far.

At rest the film cannot cavitate and is linear in the pocket pressure: one film for every gap gives

    W = A_e(h_min) p,    Q = G(h_min) p.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check, Outcome, Result
from babbitt.kinds.hydrostatic.answer import GRIDS
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.surfaces import FilmOil, journal_surface
from babbitt.reynolds.recess.recess_film import RecessFilm

__all__ = ["LiftPoint", "gap_for_flow", "jacking_check", "lift_at", "lift_curve"]

UNIT = 1e7  # Pa
BOTTOM = -0.5 * math.pi
ASIDE = tuple(map(math.radians, (1.0, 3.0, 8.0, 20.0, 45.0)))
"""From the bottom to either side, rad: where a place is sought to which the shaft rolls."""
NEARBY = math.radians(0.5)
"""By how much it is displaced to see whether it comes back, rad."""
STRAIGHT = 1e-7
"""Sideward over whole force that is round-off of the grid."""
CURVE = (0.005, 0.01, 0.02, 0.04, 0.07, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5)
"""Gaps of the curve of lift, over the clearance."""


@dataclass(frozen=True)
class LiftPoint:
    """The shaft at one smallest gap; SI.

    Attributes
    ----------
    gap : float
    pressure, flow : float
        Of the pocket with the highest pressure; of all pockets.
    effective_area : float
        Load over that pressure.
    angle : float
        Where the smallest gap lies, rad.
    side_force : float
        To the right, that nothing balances, N; zero at a place where the pockets push straight up.
    mass_balance_error : float
        Of the film, relative.
    """

    gap: float
    pressure: float
    flow: float
    effective_area: float
    angle: float = BOTTOM
    side_force: float = 0.0
    mass_balance_error: float = 0.0

    @property
    def is_balanced(self) -> bool:
        """Whether the pockets push straight up."""
        return self.side_force == 0.0


def lift_at(case: JackingCase, gap: float) -> LiftPoint:
    """Pressure and flow that hold the shaft at a smallest gap, where the pockets push straight up.

    The shaft rolls aside until the sideward force vanishes. Pockets with a restrictor or a stage of a flow
    divider of their own get equal flows (an assumption), others one pressure.

    Parameters
    ----------
    case : JackingCase
    gap : float
        m.

    Returns
    -------
    LiftPoint
        At the bottom of the bore where no such place is found within 45 deg of it.
    """
    if case.method == "quick":
        return quick_lift(case, gap)
    pockets = Pockets.of(case, gap)
    return point_at(pockets, gap, pockets.straight_up())


def lying_at(case: JackingCase) -> LiftPoint:
    """The shaft on its roughness at the bottom of the bore, about to lift."""
    gap = case.roughness
    return quick_lift(case, gap) if case.method == "quick" else point_at(Pockets.of(case, gap), gap, None)


def point_at(pockets: Pockets, gap: float, found: float | None) -> LiftPoint:
    """What holds the shaft at an angle, or at the bottom of the bore where none was found."""
    case, lifted = pockets.case, pockets.at(BOTTOM if found is None else found)
    pressure = UNIT * case.load / lifted.up
    flow = lifted.flow * pressure / UNIT
    side = 0.0 if found is not None else lifted.aside * pressure / UNIT
    area = case.load / pressure
    return LiftPoint(gap, pressure, flow, area, lifted.angle, side, pockets.mass_balance_error(lifted.flow))


@dataclass(frozen=True)
class Pushed:
    """Force to the right and upwards, N, and flow of all pockets, m3/s, the highest pressure being the unit."""

    angle: float
    aside: float
    up: float
    flow: float

    @property
    def leaning(self) -> float:
        """Force to the right over the whole force."""
        return self.aside / math.hypot(self.aside, self.up)


@dataclass(frozen=True, eq=False)
class Pockets:
    """Film of the pockets at an eccentricity, its place to be found."""

    case: JackingCase
    film: RecessFilm
    eccentricity: float

    @classmethod
    def of(cls, case: JackingCase, gap: float) -> Pockets:
        """Of a case at a smallest gap, m."""
        bearing = case.bearing
        oil, thinnest = FilmOil(case.viscosity, 0.0, UNIT), gap / bearing.clearance
        surface = journal_surface(bearing, oil, GRIDS[case.accuracy], thinnest=thinnest)
        return cls(case, RecessFilm.on(surface), bearing.clearance - gap)

    def at(self, angle: float) -> Pushed:
        """Forces and flow with the smallest gap at an angle, rad."""
        place = self.eccentricity * np.array([math.cos(angle), math.sin(angle)])
        pressures = np.full(self.case.bearing.count, UNIT)
        response = self.film.evaluate(place, pressures)
        if self.case.own_restrictors and pressures.size > 1:
            pressures = np.linalg.solve(response.conductance, np.ones(pressures.size))
            response = self.film.evaluate(place, pressures * UNIT / pressures.max())
        return Pushed(angle, float(response.force[0]), float(response.force[1]), float(response.outflow.sum()))

    def straight_up(self) -> float | None:
        """Angle nearest to the bottom at which the shaft rolls neither way and comes back; None without one."""
        bottom = self.at(BOTTOM)
        if abs(bottom.leaning) < STRAIGHT:
            return BOTTOM
        left = right = bottom
        for aside in ASIDE:
            farther = self.at(BOTTOM - aside), self.at(BOTTOM + aside)
            places = [
                self._between(first.angle, second.angle)
                for first, second in ((farther[0], left), (right, farther[1]))
                if first.leaning > 0.0 >= second.leaning
            ]
            if places:
                return min(places, key=lambda angle: abs(angle - BOTTOM))
            left, right = farther
        return None

    def _between(self, left: float, right: float) -> float:
        from babbitt.numerics.roots import bracketed_root

        return bracketed_root(lambda angle: self.at(angle).leaning, left, right, 1e-9)

    def mass_balance_error(self, flow: float) -> float:
        """Oil of the last film that is not accounted for over the flow of all pockets."""
        work = self.film.work
        free = work.counts & work.wet
        return abs(float(work.row[free].sum())) * self.film.of.scales.flow / flow

    def rolls_aside(self) -> bool:
        """Whether the film pushes a shaft at the bottom away to the side to which it is displaced."""
        left, right = self.at(BOTTOM - NEARBY), self.at(BOTTOM + NEARBY)
        return right.leaning > left.leaning


def quick_lift(case: JackingCase, gap: float) -> LiftPoint:
    """Pocket edges as strips with the local gap: flow over both axial lands and both ends, load of half the lands.

    Rough: the pressure in a wide land does not fall along straight strips.
    """
    bearing = case.bearing
    nodes, weights = np.polynomial.legendre.leggauss(24)
    e = bearing.clearance - gap
    area, conductance, side = 0.0, 0.0, 0.0
    half, land = 0.5 * bearing.recess_extent, bearing.axial_land
    for middle in bearing.recess_angles:
        angle = middle + half * nodes
        h = bearing.clearance + e * np.sin(angle)
        conductance += half * float(weights @ h**3) * bearing.radius / (6.0 * case.viscosity * land)
        # around: the gap opens; a quarter turn of land on either side
        for first, last in ((middle + half, middle + half + 0.5 * math.pi),
                            (middle - half - 0.5 * math.pi, middle - half)):  # fmt: skip
            beside = 0.5 * (first + last) + 0.25 * math.pi * nodes
            resist = 0.25 * math.pi * float(weights @ (bearing.clearance + e * np.sin(beside)) ** -3.0)
            conductance += bearing.recess_length / (12.0 * case.viscosity * bearing.radius * resist)
        chord = 2.0 * bearing.radius * math.sin(half) * -math.sin(middle)
        area += chord * 0.5 * (bearing.width + bearing.recess_length)
        side += -2.0 * bearing.radius * math.sin(half) * math.cos(middle)
    pressure = case.load / area
    side *= 0.5 * (bearing.width + bearing.recess_length) * pressure
    if abs(side) < STRAIGHT * case.load:
        side = 0.0
    return LiftPoint(gap, pressure, conductance * pressure, area, side_force=side)


def gap_for_flow(case: JackingCase, flow: float) -> float:
    """Smallest gap that a pump flow holds open, m; nan beyond nine tenths of the clearance.

    Flow grows with the gap.
    """
    from babbitt.numerics.roots import bracketed_root

    def excess(log_gap: float) -> float:
        return math.log(lift_at(case, math.exp(log_gap)).flow / flow)

    least = min(1e-3 * case.bearing.clearance, case.roughness)
    low, high = math.log(least), math.log(0.9 * case.bearing.clearance)
    if excess(low) > 0.0 or excess(high) < 0.0:
        return math.nan
    return math.exp(bracketed_root(excess, low, high, 1e-11))


def lift_curve(case: JackingCase) -> tuple[LiftPoint, ...]:
    """Pressure and flow over the smallest gap, from lying to half the clearance."""
    gaps = sorted({case.roughness, *(share * case.bearing.clearance for share in CURVE)})
    return tuple(lift_at(case, gap) for gap in gaps if gap >= case.roughness)


def jacking_check(case: JackingCase) -> Result:
    """Breakaway pressures, and the state after lift.

    Parameters
    ----------
    case : JackingCase

    Returns
    -------
    Result
    """
    begun = time.perf_counter()
    lying = lying_at(case)
    upper = case.load / case.projected_area
    gap = lifted_gap(case)
    lifted = lying if math.isnan(gap) else lift_at(case, gap)
    settings = {"method": case.method}
    failed = failure(case, lifted, gap)
    if failed is not None:
        return Result(
            case.name, case.kind, case.method, Outcome.of(failed),
            {"breakaway_pressure": upper, "lying_pressure": lying.pressure}, assumptions=assumptions(case),
            failure=failed, settings=settings,
        )  # fmt: skip
    named = {
        "load": case.load,
        "breakaway_pressure": upper,
        "lying_pressure": lying.pressure,
        "minimum_film_thickness": gap,
        "lift": gap - case.roughness,
        "eccentricity_ratio": 1.0 - gap / case.bearing.clearance,
        "pocket_pressure": lifted.pressure,
        "total_flow": lifted.flow,
        "effective_area": lifted.effective_area,
        "pumping_power": lifted.pressure * lifted.flow,
        "pump_power": lifted.pressure * lifted.flow / case.pump_efficiency,
        "effective_viscosity": case.viscosity,
        "attitude_angle": lifted.angle - BOTTOM,
        "mass_balance_error": lifted.mass_balance_error,
        "wall_time": time.perf_counter() - begun,
    }
    return Result(
        case.name, case.kind, case.method, Outcome.CONVERGED, named, checks=tuple(checks(case, named)),
        not_checked=tuple(not_checked(case)),
        warnings=(*case.warnings, *jacking_warnings(case, upper, gap)), assumptions=assumptions(case),
        settings=settings,
    )  # fmt: skip


def lifted_gap(case: JackingCase) -> float:
    """Smallest gap that the pump holds open, m, or where no flow is given the one that is wanted."""
    if case.pump_flow is not None:
        return gap_for_flow(case, case.pump_flow)
    assert case.lift_gap is not None  # a case has one of them
    return case.lift_gap


def checks(case: JackingCase, named: dict[str, float]) -> Iterator[Check]:
    """The lift that is wanted against that of the pump's flow, pressures against the relief valve."""
    if case.pump_flow is not None and case.lift_gap is not None:
        reached = named["minimum_film_thickness"]
        yield Check("C301", "minimum_film_thickness", reached, case.lift_gap, Bound.AT_LEAST, "wanted lift_gap")
    if case.relief_pressure is not None:
        for name in ("breakaway_pressure", "pocket_pressure"):
            yield Check("C304", name, named[name], case.relief_pressure, Bound.AT_MOST, "relief valve of the pump")


def not_checked(case: JackingCase) -> Iterator[Notice]:
    """Limits that were held against nothing, and why; a gap that is given needs no limit."""
    if case.lift_gap is None:
        yield Notice("C301", "no_lift_gap")
    if case.relief_pressure is None:
        yield Notice("C304")


def assumptions(case: JackingCase) -> tuple[str, ...]:
    """What is assumed."""
    if case.bearing.count == 1 or not case.own_restrictors or case.method == "quick":
        return case.assumptions
    return (*case.assumptions, "Every pocket gets the same flow, by its restrictor or stage of a flow divider.")


def failure(case: JackingCase, lifted: LiftPoint, gap: float) -> Notice | None:
    """Why the shaft is not held, if it is not."""
    flow = case.pump_flow or 0.0
    least = lift_at(case, case.roughness).flow if case.pump_flow is not None else 0.0
    if gap <= case.roughness or (math.isnan(gap) and flow < least):
        return Notice("S001", "pump", {"flow": flow, "roughness": case.roughness, "least": least})
    if math.isnan(gap):
        return Notice("S004", "most_lift", {"flow": flow})
    if not lifted.pressure > 0.0:
        return Notice("S004", "pressed_down", {"gap": gap})
    if lifted.is_balanced:
        return None
    several = case.bearing.count > 1 and not case.own_restrictors
    force = abs(lifted.side_force)
    return Notice("S004", "aside", {
        "side": Notice("S004", "right" if lifted.side_force > 0.0 else "left"),
        "force": force,
        "share": force / case.load,
        "gap": gap,
        "advice": Notice("S004", "roll" if case.method == "quick" else "divide" if several else "evenly"),
    })  # fmt: skip


def jacking_warnings(case: JackingCase, upper: float, gap: float) -> Iterator[Notice]:
    """Breakaway above the relief valve; several pockets on one pump without restrictors; rough closed forms."""
    if case.relief_pressure is not None and upper > case.relief_pressure:
        yield Notice("W314", values={"breakaway_pressure": upper, "relief": case.relief_pressure})
    if case.bearing.count > 1 and not case.own_restrictors:
        yield Notice("W320", values={"pockets": case.bearing.count})
        if case.method == "film" and Pockets.of(case, gap).rolls_aside():
            yield Notice("W328")
    if case.method == "quick":
        yield Notice("W321")
