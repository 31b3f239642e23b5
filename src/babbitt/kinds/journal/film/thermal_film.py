"""The film with its own temperatures: clearance by thermal growth, supply, position, heat.

Clearance and heat capacity follow from temperatures that only the film tells; `thermal_operating_film` lets them
settle around the thermal film.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from typing import TYPE_CHECKING

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.design.conditions import PrescribedEccentricity, PrescribedLoad, PrescribedPosition
from babbitt.design.feeding import Arrival, arrival
from babbitt.design.heat_balance import CEILING, Equilibrium, NoFilmError
from babbitt.design.oil import bounded_viscosity, highest_usable, properties_at
from babbitt.kinds.journal.film.closed_pockets import ClosedPressures, closed_film
from babbitt.kinds.journal.film.heat_model import AxialTemperature
from babbitt.kinds.journal.film.isothermal import FilmState, operating_film
from babbitt.kinds.journal.film.layout import (
    closed_pockets,
    film_of,
    load_vector,
    pressed_flow,
    with_flow_of_ducts,
)
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.thermal_failure import last_film, what_gave_way
from babbitt.kinds.journal.film.thermal_search import EXACT, ThermalSearch
from babbitt.numerics.roots import bracketed_root
from babbitt.properties.fits import operating_relative_clearance
from babbitt.properties.lubricants import Lubricant
from babbitt.reynolds.model import DRAFT, ENGINEERING, REFERENCE, JournalFilm, Resolution

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from babbitt.reynolds.heat.following_clearance import FollowingClearance, WarmClearance
    from babbitt.reynolds.heat.heat_model import FilmHeat
    from babbitt.reynolds.heat.thermal_film_state import ThermalFilmState
    from babbitt.reynolds.heat.thermal_solution import ThermalFilm
    from babbitt.reynolds.solution import FilmSolution

    Array = NDArray[np.float64]

__all__ = ["film_heat", "film_within_ducts", "following_stiffness", "thermal_operating_film", "thermal_resolution"]

MOST_ROUNDS = 25
SAME_CLEARANCE = 1e-5
"""Share of the clearance by which thermal growth may still change it when the film counts as converged."""
JUMPED = 5e-4
"""Share of the clearance by which its growth may miss it where the film jumps at it from one state to another.

A film whose nodes fill and empty with the clearance has two states there, and the growth of neither meets it. An
assumption, below the error of the grid: films on both sides of a jump of 1e-4 differ by 0.2 % in thickness."""
SAME_TEMPERATURE = 0.05
"""Change of the effective temperature in K at which the heat capacity counts as converged."""
HOT = 473.15
"""Highest temperature in K from which a film is sought at one clearance after the other: whether one runs away is
told by all of them, on lines that a film draws that has come so far. An assumption, far from the ceiling."""
KNOWN_TEMPERATURES = 257
"""At which the viscosity of an oil is known while its effective temperature follows the film: some 1 K apart."""
SAME_OIL = 1e-3
"""Change of the effective temperature in K up to which the oil of a film that is sought keeps its properties."""
GROWING = (0.5, 0.65, 0.8, 0.9, 0.95, 1.0)
"""Shares of the load under which a film is sought, one after the other."""
ENDED_HOT = (Outcome.THERMAL_RUNAWAY, Outcome.NO_LUBRICANT_DATA, Outcome.NOT_CONVERGED)
CLOSER_FROM = 5
"""Round from which on films at a given place settle closer."""
PUSH, FOLLOWED = 0.02, 1e-4
"""Share of the least gap by which the journal is moved to see the stiffness while temperatures follow, and the
change of temperatures in a pass, K, at which they have: a difference of two films wants them closely settled."""


def thermal_operating_film(case: FilmCase) -> Equilibrium[FilmState]:
    """Film in thermal equilibrium with its walls, its supply and the growth of its clearance.

    Parameters
    ----------
    case : FilmCase
        With a heat model and an oil supply.

    Returns
    -------
    Equilibrium
        Always with a status; the film of an unsolved one is that of the largest load that has one, if a load is
        given, else the last one that converged.
    """
    if case.oil_supply is None:
        raise InputError("E101", "a film with its own temperatures needs a supply: the temperature of fresh oil.")
    cold = case.oil_supply.temperature
    bearing = case.bearing
    psi = operating_relative_clearance(
        bearing.relative_clearance, bearing.expansion_bearing, bearing.expansion_journal, cold
    )
    reached = _Reached(psi, cold)
    try:
        return _settled_clearance(case, reached, ThermalSearch())
    except NoFilmError as failure:
        outcome = failure.outcome
        if outcome in ENDED_HOT and isinstance(case.duty, PrescribedLoad):
            found = _under_growing_load(case, case.duty.load, _Reached(psi, cold))
            if found is not None:
                return found
        psi, at, state = reached.relative_clearance, reached.temperature, reached.state
        if psi > 0.0:
            starved = outcome is Outcome.STARVED_RECESS  # no matter of load
            last = (
                None
                if starved
                else last_film(case, lambda lighter, search: _thermal_state(lighter, psi, at, search))
            )
            state, outcome = last or state, what_gave_way(case, outcome, last)
        warmth = state.temperature if state else cold
        return Equilibrium(outcome, state, 0, warmth, failure)


@dataclass
class _Reached:
    """Clearance and temperature (K) of the round that a search is in, and the last film that converged."""

    relative_clearance: float
    temperature: float
    state: FilmState | None = None


def _settled_clearance(case: FilmCase, reached: _Reached, sought: ThermalSearch) -> Equilibrium[FilmState]:
    """Film whose clearance is that of its own temperatures; raises `NoFilmError` where a round has no film."""
    before = None
    if sought.is_fresh and _may_follow(case):
        sought.growth = _growth(case, reached.relative_clearance, reached.temperature)
    for rounds in range(1, MOST_ROUNDS + 1):
        psi, at = reached.relative_clearance, reached.temperature
        if psi <= 0.0:
            raise NoFilmError(Outcome.NO_CLEARANCE)
        if rounds == CLOSER_FROM:
            sought.closer = True
        state = reached.state = _thermal_state(case, psi, at, sought)
        if sought.growth is not None:
            psi, at, sought.growth = state.relative_clearance, sought.growth.now.temperature, None
            reached.relative_clearance, reached.temperature = psi, at
        sought.climbs = False
        grown = _grown_clearance(case, state)
        here = (psi, grown - psi)
        slack = JUMPED if _jumps(before, here) else SAME_CLEARANCE
        if abs(grown - psi) <= slack * psi and abs(state.temperature - at) <= SAME_TEMPERATURE:
            return Equilibrium(Outcome.CONVERGED, state, rounds, state.temperature)
        reached.temperature = state.temperature
        reached.relative_clearance = _secant(before, here)
        before = here
    return Equilibrium(Outcome.NOT_CONVERGED, reached.state, MOST_ROUNDS, reached.temperature)


def _under_growing_load(case: FilmCase, load: float, reached: _Reached) -> Equilibrium[FilmState] | None:
    """Film under a load that grows, clearance and film from step to step; None where a step has none.

    A round that ends hot is no proof: its clearance is that of another temperature, and a search that loses its
    way ends hot, too.
    """
    sought, found = ThermalSearch(), None
    for share in GROWING:
        try:
            found = _settled_clearance(replace(case, duty=PrescribedLoad(share * load)), reached, sought)
        except NoFilmError:
            return None
        if not found.outcome.solved:
            return None
        sought = sought.climbing()
    return found


def film_within_ducts(case: FilmCase) -> tuple[FilmCase, Equilibrium[FilmState], Arrival | None]:
    """Film of a case in equilibrium that gets no more oil than tubes and holes pass at the whole supply pressure.

    Returns
    -------
    case : FilmCase
        That of the film found: where tubes and holes pass less than it would draw, fed with their flow in place of
        the pressure, if such a film can be starved (`with_flow_of_ducts`).
    found : Equilibrium
    arrival : Arrival or None
        What the unlimited film would draw, and the limit; None where the supply passes that.
    """
    found = operating_film(case) if case.heat is None else thermal_operating_film(case)
    feed = found.film.feed if found.film is not None and found.outcome.solved else None
    if feed is None or feed.limit is None:
        return case, found, None
    limited = with_flow_of_ducts(case, feed.limit)
    return (case, found, feed) if limited is None else (limited, operating_film(limited), feed)


def _jumps(last: tuple[float, float] | None, here: tuple[float, float]) -> bool:
    """Whether growth changes its sign between two clearances that are the same: the film jumps there."""
    if last is None:
        return False
    psi, growth = here
    return abs(psi - last[0]) <= SAME_CLEARANCE * psi and growth * last[1] < 0.0


def _secant(last: tuple[float, float] | None, here: tuple[float, float]) -> float:
    """Clearance at which its growth would be nought, from two; the grown one where the secant leads astray."""
    psi, growth = here
    if last is None or last[1] == growth:
        return psi + growth
    step = -growth * (psi - last[0]) / (growth - last[1])
    return psi + step if 0.0 < step / growth < 4.0 and psi + step > 0.0 else psi + growth


def _grown_clearance(case: FilmCase, state: FilmState) -> float:
    thermal = state.thermal
    if thermal is None:
        raise ValueError("a film without temperatures of its own")
    return _clearance_at(case, thermal.mean_bush_temperature, thermal.journal_temperature)


def _clearance_at(case: FilmCase, bush: float, journal: float) -> float:
    """Relative clearance with bush and journal at their temperatures in K."""
    bearing = case.bearing
    return operating_relative_clearance(
        bearing.relative_clearance, bearing.expansion_bearing, bearing.expansion_journal, bush, journal
    )


def _may_follow(case: FilmCase) -> bool:
    """Whether the clearance may follow the film while it is sought: under a load in a rigid bore, whose supplies
    stand at given pressures."""
    supply = case.oil_supply
    assert supply is not None
    assert case.heat is not None
    rigid = not case.bearing.compliance and case.heat.growth is None
    ducts = bool(supply.tubes or supply.holes or closed_pockets(case))
    return isinstance(case.duty, PrescribedLoad) and rigid and not ducts


def _growth(case: FilmCase, psi: float, temperature: float) -> FollowingClearance:
    """Clearance of a bearing, and heat capacity and conductivity of its oil, by the temperatures of its film."""
    import numpy as np

    from babbitt.reynolds.heat.following_clearance import FollowingClearance, WarmClearance

    oil, radius, hottest = case.lubricant, 0.5 * case.bearing.diameter, highest_usable(case.lubricant)
    warmths = np.linspace(min(temperature, hottest), hottest, KNOWN_TEMPERATURES)  # from that of fresh oil
    thinner = -np.log(oil.dynamic_viscosity(warmths))

    def warm(grown: float, at: float) -> WarmClearance:
        return WarmClearance(radius * grown, at, properties_at(oil, at)[2], oil.conductivity(at))

    last = warm(psi, temperature)

    def law(thermal: ThermalFilmState) -> WarmClearance | None:
        nonlocal last
        bush, journal = thermal.wall_temperatures()
        width, viscosity = thermal.walls.width, thermal.reference_viscosity * thermal.effective_viscosity
        grown = _clearance_at(case, float(bush @ width / width.sum()), journal)
        warmth = float(np.interp(-math.log(viscosity), thinner, warmths))
        if not grown > 0.0:
            return None
        if abs(warmth - last.temperature) < SAME_OIL:
            return replace(last, clearance=radius * grown)
        try:
            last = warm(grown, warmth)
        except NoFilmError:
            return None
        return last

    return FollowingClearance(law, last)


def _thermal_state(case: FilmCase, psi: float, temperature: float, search: ThermalSearch) -> FilmState:
    """Thermal film at a clearance; heat capacity and density at a temperature in K.

    Raises
    ------
    NoFilmError
        When there is no film, or none below 300 °C.
    """
    oil, supply = case.lubricant, case.oil_supply
    assert supply is not None
    density, _, heat_capacity = properties_at(oil, temperature)
    _, cold_viscosity, _ = properties_at(oil, supply.temperature)
    heat = film_heat(case, heat_capacity, temperature)

    @cache  # the balance of the supply ends at a pressure that it has looked at
    def solved(pressure: float) -> ThermalFilm:
        film = film_of(case, psi, cold_viscosity, pressure, density)
        return _accepted(_in_its_bore(case, film, heat, search), oil)

    feed = arrival(supply, oil, pressed_flow(case, lambda pressure: solved(pressure).film))
    thermal = solved(feed.element_pressure)
    viscosity = thermal.effective_viscosity
    solution = replace(thermal.film, film=replace(thermal.film.film, viscosity=viscosity))
    settled = _temperature_of(oil, thermal)
    if search.growth is not None:
        psi = 2.0 * search.growth.now.clearance / case.bearing.diameter
        heat_capacity = search.growth.now.volumetric_heat_capacity
    return FilmState(
        temperature=settled,
        relative_clearance=psi,
        density=oil.density(settled),
        viscosity=viscosity,
        volumetric_heat_capacity=heat_capacity,
        load=solution.load,
        friction_power=solution.friction_torque * abs(case.journal_speed),
        total_flow=solution.leaving_flow,
        feed=feed,
        solution=solution,
        thermal=thermal,
    )


def _in_its_bore(case: FilmCase, film: JournalFilm, heat: FilmHeat, search: ThermalSearch) -> ThermalFilm:
    """Film at its load or position, in a bore that gives way or is distorted by heat where the case has one."""
    assert case.heat is not None
    compliance, growth = case.bearing.compliance, case.heat.growth
    if not compliance and growth is None:
        return _closed(case, film, heat, search)
    from babbitt.kinds.journal.film.elastic_film import elastic_thermal_film

    found = elastic_thermal_film(film, compliance, lambda one: _closed(case, one, heat, search), growth)
    return replace(found.solution, film=replace(found.solution.film, outcome=found.outcome))


def _closed(case: FilmCase, film: JournalFilm, heat: FilmHeat, search: ThermalSearch) -> ThermalFilm:
    """Film whose closed pockets, if it has any, pass on as much oil as reaches them."""
    closed = closed_pockets(case)
    if not closed:
        return _settled(case, film, heat, search)
    search.exact = True
    return closed_film(
        film, closed, lambda one: _settled(case, one, heat, search), lambda found: found.film,
        lambda found, outcome: replace(found, film=replace(found.film, outcome=outcome)), search.closed,
        lambda one: _settled(case, one, heat, ThermalSearch()).film,
    )  # fmt: skip


def film_heat(case: FilmCase, heat_capacity: float, temperature: float) -> FilmHeat:
    """Heat model of the film engine; properties of the oil but viscosity at a temperature in K."""
    from babbitt.reynolds.heat.heat_model import FilmHeat, HeatGrid

    assert case.heat is not None
    assert case.oil_supply is not None
    return FilmHeat(
        viscosity=bounded_viscosity(case.lubricant),
        volumetric_heat_capacity=heat_capacity,
        conductivity=case.lubricant.conductivity(temperature),
        supply_temperature=case.oil_supply.temperature,
        walls=case.heat.walls,
        grid=HeatGrid(resolved=case.heat.axial_temperature is AxialTemperature.RESOLVED),
        carry_over=case.heat.carry_over,
    )


def thermal_resolution(case: FilmCase) -> Resolution:
    """Grid of a thermal film by the accuracy of the case."""
    from babbitt.reynolds.heat.heat_model import THERMAL_DRAFT, THERMAL_ENGINEERING, THERMAL_REFERENCE

    grids = {DRAFT: THERMAL_DRAFT, ENGINEERING: THERMAL_ENGINEERING, REFERENCE: THERMAL_REFERENCE}
    return grids[case.accuracy.resolution]


def _settled(case: FilmCase, film: JournalFilm, heat: FilmHeat, search: ThermalSearch) -> ThermalFilm:
    from babbitt.reynolds.heat.following_clearance import keeps_its_ring
    from babbitt.reynolds.heat.thermal_equilibrium import thermal_film_at

    grid = thermal_resolution(case)
    if isinstance(case.duty, PrescribedPosition):
        return _inside(thermal_film_at(film, heat, (case.duty.x, case.duty.y), grid, search.settled))
    if isinstance(case.duty, PrescribedEccentricity):
        return _at_eccentricity(case, case.duty, film, heat, search)
    load = load_vector(case, case.duty.load)
    if search.growth is not None and keeps_its_ring(film):
        found = search.trail.solve_growing(film, heat, load, grid, search.growth)
        if found.maximum_temperature < HOT:
            return found
        search.growth.begin()
        search.trail.last = None
    find = search.trail.climb if search.climbs else search.trail.solve
    return find(film, heat, load, grid)


def _at_eccentricity(
    case: FilmCase, duty: PrescribedEccentricity, film: JournalFilm, heat: FilmHeat, search: ThermalSearch
) -> ThermalFilm:
    """At the given attitude, or at the one for which the film force opposes the direction of the load."""
    from babbitt.reynolds.heat.thermal_equilibrium import thermal_film_at

    eccentricity = duty.eccentricity_ratio * film.clearance

    @cache
    def at(attitude: float) -> ThermalFilm:
        angle = case.load_angle + case.rotation.sense * attitude
        position = (eccentricity * math.cos(angle), eccentricity * math.sin(angle))
        return _inside(thermal_film_at(film, heat, position, thermal_resolution(case), search.settled))

    if duty.attitude_angle is not None:
        return at(duty.attitude_angle)

    def aside(attitude: float) -> float:
        fx, fy = at(attitude).film.force
        away = math.atan2(-fy, -fx) - case.load_angle
        return math.pi - (math.pi - away) % (2.0 * math.pi)

    wide = [math.radians(degrees) for degrees in range(0, 181, 15)]
    near = [] if search.attitude is None else [search.attitude - 0.02, search.attitude + 0.02]
    for steps in (near, wide):
        for low, high in pairwise(steps):
            if aside(low) * aside(high) <= 0.0 and abs(aside(low) - aside(high)) < math.pi:
                search.attitude = bracketed_root(aside, low, high, absolute=1e-7)
                return at(search.attitude)
    raise NoFilmError(Outcome.NOT_CONVERGED)


def _inside(thermal: ThermalFilm) -> ThermalFilm:
    if thermal.film.outcome is Outcome.OVERLOADED:
        raise NoFilmError(Outcome.OUTSIDE_CLEARANCE)
    return thermal


def _accepted(thermal: ThermalFilm, oil: Lubricant) -> ThermalFilm:
    """The film if it stays below the temperatures at which the laws of the oil end."""
    hottest = thermal.maximum_temperature
    if not math.isfinite(hottest + thermal.effective_viscosity):
        raise NoFilmError(Outcome.NOT_CONVERGED)
    if hottest >= (usable := highest_usable(oil)):
        raise NoFilmError(Outcome.THERMAL_RUNAWAY if usable >= CEILING else Outcome.NO_LUBRICANT_DATA)
    if not thermal.film.outcome.solved:
        raise NoFilmError(thermal.film.outcome)
    return thermal


def _temperature_of(oil: Lubricant, thermal: ThermalFilm) -> float:
    """Temperature at which the oil has the effective viscosity; the mean of the film if it has it everywhere."""
    low, high = float(thermal.temperature.min()), thermal.maximum_temperature

    def surplus(temperature: float) -> float:
        return oil.dynamic_viscosity(temperature) - thermal.effective_viscosity

    if surplus(low) > 0.0 > surplus(high):
        return bracketed_root(surplus, low, high, absolute=1e-9)
    return float(thermal.temperature.mean())


def following_stiffness(case: FilmCase, state: FilmState) -> Array | None:
    """Stiffness in N/m, shape (2, 2), while all temperatures follow the journal: central differences of the force.

    None where a displaced film does not converge.
    """
    import numpy as np

    assert state.thermal is not None
    film = state.thermal.film
    heat = film_heat(case, state.volumetric_heat_capacity, state.temperature)
    push, columns = PUSH * film.minimum_film_thickness, []
    for direction in ((1.0, 0.0), (0.0, 1.0)):
        forces = []
        for sign in (1.0, -1.0):
            x, y = film.position + sign * push * np.asarray(direction)
            found = _settled_at(case, film.film, heat, (float(x), float(y)))
            if not found.outcome.solved:
                return None
            forces.append(found.force)
        columns.append(-(forces[0] - forces[1]) / (2.0 * push))
    return np.array(columns).T


def _settled_at(case: FilmCase, film: JournalFilm, heat: FilmHeat, place: tuple[float, float]) -> FilmSolution:
    """Closely settled film at a place, whose closed pockets, if it has any, are so there, too."""
    from babbitt.reynolds.heat.thermal_equilibrium import thermal_film_at

    grid, closed = thermal_resolution(case), closed_pockets(case)
    if not closed:
        return thermal_film_at(film, heat, place, grid, FOLLOWED).film

    def settle(one: JournalFilm) -> FilmSolution:
        return thermal_film_at(one, heat, place, grid, EXACT).film

    return closed_film(
        film, closed, settle, lambda found: found, lambda found, outcome: replace(found, outcome=outcome),
        ClosedPressures(), settle,
    )  # fmt: skip
