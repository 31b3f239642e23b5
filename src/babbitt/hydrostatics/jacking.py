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

from babbitt.film.recess import RecessFilm
from babbitt.hydrostatics.answer import GRIDS
from babbitt.hydrostatics.jacking_model import JackingCase
from babbitt.hydrostatics.surfaces import FilmOil, journal_surface
from babbitt.notices import Notice
from babbitt.results import Bound, Check, Outcome, Result

__all__ = ["LiftPoint", "gap_for_flow", "jacking_check", "lift_at", "lift_curve"]

UNIT = 1e7  # Pa
CURVE = (0.005, 0.01, 0.02, 0.04, 0.07, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5)
"""Gaps of the curve of lift, over the clearance."""


@dataclass(frozen=True)
class LiftPoint:
    """The shaft at one smallest gap; SI."""

    gap: float
    pressure: float
    flow: float
    effective_area: float


def lift_at(case: JackingCase, gap: float) -> LiftPoint:
    """Pressure and flow that hold the shaft at a smallest gap, all pockets at one pressure.

    Parameters
    ----------
    case : JackingCase
    gap : float
        m.

    Returns
    -------
    LiftPoint
    """
    if case.method == "quick":
        return quick_lift(case, gap)
    bearing = case.bearing
    oil = FilmOil(case.viscosity, 0.0, UNIT)
    film = RecessFilm.on(journal_surface(bearing, oil, GRIDS[case.accuracy], thinnest=gap / bearing.clearance))
    response = film.evaluate(np.array([0.0, gap - bearing.clearance]), np.full(bearing.count, UNIT))
    area, flow = float(response.force[1]) / UNIT, float(response.outflow.sum()) / UNIT
    pressure = case.load / area
    return LiftPoint(gap, pressure, flow * pressure, area)


def quick_lift(case: JackingCase, gap: float) -> LiftPoint:
    """Pocket edges as strips with the local gap: flow over both axial lands and both ends, load of half the lands.

    Rough: the pressure in a wide land does not fall along straight strips.
    """
    bearing = case.bearing
    nodes, weights = np.polynomial.legendre.leggauss(24)
    e = bearing.clearance - gap
    area, conductance = 0.0, 0.0
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
    pressure = case.load / area
    return LiftPoint(gap, pressure, conductance * pressure, area)


def gap_for_flow(case: JackingCase, flow: float) -> float:
    """Smallest gap that a pump flow holds open, m; nan beyond half the clearance.

    Flow grows with the gap.
    """
    from babbitt.design.roots import bracketed_root

    def excess(log_gap: float) -> float:
        return math.log(lift_at(case, math.exp(log_gap)).flow / flow)

    low, high = math.log(1e-3 * case.bearing.clearance), math.log(0.9 * case.bearing.clearance)
    if excess(low) > 0.0 or excess(high) < 0.0:
        return math.nan
    return math.exp(bracketed_root(excess, low, high, 1e-5))


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
    lying = lift_at(case, case.roughness)
    upper = case.load / case.projected_area
    gap = case.lift_gap
    if gap is None:
        gap = gap_for_flow(case, case.pump_flow or 0.0)
    settings = {"method": case.method}
    if math.isnan(gap):
        return Result(
            case.name, case.kind, case.method, Outcome.NOT_CONVERGED,
            {"breakaway_pressure": upper, "lying_pressure": lying.pressure}, assumptions=case.assumptions,
            message=f"a pump flow of {6e4 * (case.pump_flow or 0.0):.3g} L/min lifts by less than a thousandth "
                    "or by "
            "more than nine tenths of the clearance; give another flow", settings=settings,
        )  # fmt: skip
    lifted = lift_at(case, gap)
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
        "pump_power": lifted.pressure * (case.pump_flow or lifted.flow) / case.pump_efficiency,
        "effective_viscosity": case.viscosity,
        "wall_time": time.perf_counter() - begun,
    }
    found = []
    if case.relief_pressure is not None:
        limit = case.relief_pressure
        found = [
            Check("C304", "breakaway_pressure", upper, limit, Bound.AT_MOST, "relief valve of the pump"),
            Check("C304", "pocket_pressure", lifted.pressure, limit, Bound.AT_MOST, "relief valve of the pump"),
        ]
    return Result(
        case.name, case.kind, case.method, Outcome.CONVERGED, named, checks=tuple(found),
        warnings=(*case.doubts, *jacking_doubts(case, upper)), assumptions=case.assumptions, settings=settings,
    )  # fmt: skip


def jacking_doubts(case: JackingCase, upper: float) -> Iterator[Notice]:
    """Breakaway above the relief valve; several pockets on one pump without restrictors; rough closed forms."""
    if case.relief_pressure is not None and upper > case.relief_pressure:
        yield Notice("W314", f"up to {1e-6 * upper:.4g} MPa to break away, the relief valve opens at "
                     f"{1e-6 * case.relief_pressure:.4g} MPa")  # fmt: skip
    if case.bearing.count > 1 and not case.own_restrictors:
        yield Notice("W320", f"{case.bearing.count} pockets on one pump without restrictors or flow divider")
    if case.method == "quick":
        yield Notice("W321", "pressure on the pocket and half of its axial lands, none around the bore: less "
                     "area, more pressure and flow than by the film")  # fmt: skip
