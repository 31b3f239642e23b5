"""The film at one assumed temperature: clearance, viscosity, position, friction and flow.

Everything the heat balance needs is a function of the effective temperature; `film_at_temperature` is that
function, and `operating_film` is the film where it is in equilibrium.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, partial
from typing import TYPE_CHECKING

from babbitt.core.result import Outcome
from babbitt.design.conditions import PrescribedEccentricity, PrescribedLoad, PrescribedPosition
from babbitt.design.feeding import Arrival, arrival
from babbitt.design.heat_balance import (
    COARSE_SEARCH,
    Equilibrium,
    NoFilmError,
    at_prescribed_temperature,
    find_equilibrium,
)
from babbitt.design.oil import properties_at
from babbitt.design.values import friction_between
from babbitt.kinds.journal.film.closed_pockets import ClosedPressures, closed_film
from babbitt.kinds.journal.film.layout import (
    closed_pockets,
    film_of,
    given_flows,
    load_vector,
    pressed_flow,
)
from babbitt.kinds.journal.film.model import FilmCase, Search
from babbitt.kinds.journal.film.stable_equilibrium import converged_film, held_place, is_saddle
from babbitt.numerics.roots import bracketed_root
from babbitt.properties.fits import operating_relative_clearance
from babbitt.reynolds.model import JournalFilm, Resolution

if TYPE_CHECKING:
    from babbitt.kinds.journal.film.elastic_film import KnownBore
    from babbitt.reynolds.equilibrium.starved import FedFilm, PrescribedFlow
    from babbitt.reynolds.heat.thermal_solution import ThermalFilm
    from babbitt.reynolds.solution import FilmSolution

LOAD_TOLERANCE = 1e-9
"""Of the film force over the load; small, so that the heat balance closes to 1e-8."""

ELASTIC_CLOSENESS = 1e-7
"""Share of the least gap to which film and displacement of the bore agree; small, for the heat balance sees it."""


Settle = Callable[["JournalFilm"], "FilmSolution"]
"""Solves a film, at its load or position."""


@dataclass(frozen=True, eq=False)
class FilmState:
    """State of the film at one effective temperature, SI; `left_saddle` where the place found first was one."""

    temperature: float
    relative_clearance: float
    density: float
    viscosity: float
    volumetric_heat_capacity: float
    load: float
    friction_power: float
    total_flow: float
    feed: Arrival | None
    solution: FilmSolution
    fed: FedFilm | None = None
    thermal: ThermalFilm | None = None
    left_saddle: bool = False


EXPENSIVE_GRID = 1500
"""Grid points of a film that is solved node by node, beyond which sweeps and orbits take a draft grid."""


def is_expensive(state: FilmState) -> bool:
    """Whether a film takes so long that sweeps and orbits see it on a draft grid."""
    return bool(state.solution.film.is_surface and state.solution.pressure.size > EXPENSIVE_GRID)


def load_found(state: FilmState) -> tuple[float, float]:
    """Load in N against the direction of the force found."""
    share = -state.load / math.hypot(*state.solution.force)
    return share * float(state.solution.force[0]), share * float(state.solution.force[1])


def operating_film(case: FilmCase) -> Equilibrium[FilmState]:
    """Film at the temperature at which its heat balance closes, or at the one that the case prescribes.

    Always ends with a status; see `babbitt.design.heat_balance.find_equilibrium`. Where the journal leaves by
    itself the place found first (a saddle), the balance is closed again at a place where it stays.
    """
    found = _balanced(case, None)
    if found.film is None or not found.outcome.solved or case.search is Search.FIRST:
        return found
    if not isinstance(case.duty, PrescribedLoad) or not is_saddle(found.film.solution):
        return found
    near = held_place(found.film.solution, load_vector(case, case.duty.load), resolution_of(case))
    if near is None:
        return found
    again = _balanced(case, near)
    if again.film is None or not again.outcome.solved:
        return found
    return replace(again, film=replace(again.film, left_saddle=True))


def _balanced(case: FilmCase, near: tuple[float, float] | None) -> Equilibrium[FilmState]:
    film_at = partial(film_at_temperature, case=case, near=near, bore=known_bore(case))
    if case.effective_temperature is not None:
        return at_prescribed_temperature(case.effective_temperature, film_at)
    return find_equilibrium(case, film_at, COARSE_SEARCH)


SEARCHED = 10
"""Films of one elastic bore that are sought in all its clearance."""


def resolution_of(case: FilmCase) -> Resolution:
    """Grid of a case, with the tolerance that its heat balance needs."""
    return replace(case.accuracy.resolution, tolerance=LOAD_TOLERANCE)


def known_bore(case: FilmCase) -> KnownBore | None:
    """What is known of the bore of a case before its first film; None where it is rigid."""
    if not case.bearing.compliance:
        return None
    from babbitt.kinds.journal.film.elastic_film import KnownBore

    return KnownBore()


def film_at_temperature(
    temperature: float, case: FilmCase, near: tuple[float, float] | None = None, bore: KnownBore | None = None
) -> FilmState:
    """Film at an effective temperature in K; `near` is a place for `converged_film`, `bore` what films at other
    temperatures tell of one that gives way.

    Raises
    ------
    NoFilmError
        When the relative clearance is not positive at this temperature, no film carries the load, the film engine
        ends without an answer, or a law of the lubricant has no usable value.
    """
    bearing, oil = case.bearing, case.lubricant
    psi = operating_relative_clearance(
        bearing.relative_clearance, bearing.expansion_bearing, bearing.expansion_journal, temperature
    )
    if psi <= 0.0:
        raise NoFilmError(Outcome.NO_CLEARANCE)
    density, viscosity, heat_capacity = properties_at(oil, temperature)

    @cache  # the balance of the supply ends at a pressure that it has looked at
    def solved(pressure: float) -> tuple[FilmSolution, FedFilm | None]:
        film = film_of(case, psi, viscosity, pressure, density)
        flows = given_flows(case, film)
        if not flows:
            return equilibrium_film(case, film, near, bore), None
        fed = starved_film(case, film, flows, near, bore)
        return fed.solution, fed

    feed = None
    if case.oil_supply is not None and case.oil_supply.flow is None:
        feed = arrival(case.oil_supply, oil, pressed_flow(case, lambda pressure: solved(pressure)[0]))
    solution, fed = solved(feed.element_pressure if feed else 0.0)
    return FilmState(
        temperature=temperature,
        relative_clearance=psi,
        density=density,
        viscosity=viscosity,
        volumetric_heat_capacity=heat_capacity,
        load=solution.load,
        friction_power=case.friction_factor * friction_of(case, solution)[1],
        total_flow=solution.leaving_flow,
        feed=feed,
        solution=solution,
        fed=fed,
    )


def friction_of(case: FilmCase, solution: FilmSolution) -> tuple[float, float]:
    """Torque on the journal in N m and power in W of a film of one temperature, without the factor of the case."""
    pressure = solution.pressure_torque
    return friction_between(case, solution.friction_torque - pressure, pressure)


def equilibrium_film(
    case: FilmCase, film: JournalFilm, near: tuple[float, float] | None = None, bore: KnownBore | None = None
) -> FilmSolution:
    """Film that carries the load of the case, or that stands at its prescribed position."""
    return _accepted(_settled(case, partial(_in_given_bore, case, near), film, bore))


def equilibrium_near_position(case: FilmCase, state: FilmState, place: tuple[float, float]) -> FilmSolution | None:
    """Equilibrium close to a place in m under the load of the case, None where none is found.

    Bore, closed pockets and starved supplies converge with that film, not with that of the operating point.
    """
    from babbitt.reynolds.equilibrium.nearby import equilibrium_near
    from babbitt.reynolds.equilibrium.position import film_at_position
    from babbitt.reynolds.equilibrium.starved import feed_film

    assert isinstance(case.duty, PrescribedLoad)
    load, grid = load_vector(case, case.duty.load), resolution_of(case)

    def settle(film: JournalFilm) -> FilmSolution:
        found = equilibrium_near(film, load, place, grid)
        if found is None:
            return replace(film_at_position(film, place, resolution=grid), outcome=Outcome.NOT_CONVERGED)
        return found

    pressure = state.feed.element_pressure if state.feed else 0.0
    film = film_of(case, state.relative_clearance, state.viscosity, pressure, state.density)
    flows = given_flows(case, film)
    try:
        if flows:
            found = feed_film(film, flows, partial(_settled, case, settle)).solution
        else:
            found = _settled(case, settle, film)
    except NoFilmError:
        return None
    return found if found.outcome.solved else None


def starved_film(
    case: FilmCase,
    film: JournalFilm,
    flows: tuple[PrescribedFlow, ...],
    near: tuple[float, float] | None = None,
    bore: KnownBore | None = None,
) -> FedFilm:
    """Film whose supplies deliver given flows.

    Raises
    ------
    NoFilmError
        As overloaded, with the least flow that will do, where the oil is too little for the load.
    """
    from babbitt.reynolds.equilibrium.starved import feed_film

    fed = feed_film(film, flows, partial(_settled, case, partial(_in_given_bore, case, near), bore=bore))
    if fed.solution.outcome is Outcome.OVERLOADED:
        raise NoFilmError(Outcome.OVERLOADED, least_flow=fed.least_flow)
    _accepted(fed.solution)
    return fed


def _settled(
    case: FilmCase,
    in_given_bore: Callable[[JournalFilm], FilmSolution],
    film: JournalFilm,
    bore: KnownBore | None = None,
) -> FilmSolution:
    """Film at its load or position, in a bore that gives way where the case has one, with its closed pockets."""
    settle = partial(_closed, case, in_given_bore, ClosedPressures()) if closed_pockets(case) else in_given_bore
    if not case.bearing.compliance:
        return settle(film)
    if isinstance(case.duty, PrescribedLoad) and not closed_pockets(case):
        settle = following(load_vector(case, case.duty.load), resolution_of(case), in_given_bore, SEARCHED)
    from babbitt.kinds.journal.film.elastic_film import elastic_film

    found = elastic_film(film, case.bearing.compliance, settle, ELASTIC_CLOSENESS, known=bore)
    return replace(found.solution, outcome=found.outcome)


def _closed(case: FilmCase, in_given_bore: Settle, known: ClosedPressures, film: JournalFilm) -> FilmSolution:
    """Film whose closed pockets pass on as much oil as reaches them."""
    return closed_film(
        film, closed_pockets(case), in_given_bore, lambda found: found,
        lambda found, outcome: replace(found, outcome=outcome), known, in_given_bore,
    )  # fmt: skip


def following(load: tuple[float, float], grid: Resolution, far_and_wide: Settle, searches: int) -> Settle:
    """Solve films that differ little, each from the place of the one before it.

    A film that is not found from there is sought far and wide, for the first `searches` films only: a load beside
    a groove under pressure can be near the edge of what is carried, and every such search takes a second.
    """
    films = 0
    last: FilmSolution | None = None

    def solve(film: JournalFilm) -> FilmSolution:
        from babbitt.reynolds.equilibrium.solve import solve_journal_from

        nonlocal last, films
        films += 1
        found = None
        if last is not None:
            found = solve_journal_from(film, load, (float(last.position[0]), float(last.position[1])), grid)
        if found is None or not (found.outcome.solved or films > searches):
            found = far_and_wide(film)
        last = found if found.outcome.solved else last
        return found

    return solve


def _in_given_bore(case: FilmCase, near: tuple[float, float] | None, film: JournalFilm) -> FilmSolution:
    if isinstance(case.duty, PrescribedEccentricity):
        return _at_eccentricity(case, case.duty, film)
    if isinstance(case.duty, PrescribedPosition):
        return film_at(case, film, (case.duty.x, case.duty.y))
    return converged_film(film, load_vector(case, case.duty.load), resolution_of(case), near)


def film_at_angle(case: FilmCase, film: JournalFilm, eccentricity_ratio: float, attitude: float) -> FilmSolution:
    """Film with the journal at an eccentricity and an attitude angle in rad."""
    eccentricity = eccentricity_ratio * film.clearance
    angle = case.load_angle + case.rotation.sense * attitude
    return film_at(case, film, (eccentricity * math.cos(angle), eccentricity * math.sin(angle)))


def film_at(case: FilmCase, film: JournalFilm, position: tuple[float, float]) -> FilmSolution:
    """Film with the journal centre at a position in m.

    Raises
    ------
    NoFilmError
        When the position lies outside the clearance, among others.
    """
    from babbitt.reynolds.equilibrium.position import film_at_position

    found = film_at_position(film, position, resolution=resolution_of(case))
    if found.outcome is Outcome.OVERLOADED:
        raise NoFilmError(Outcome.OUTSIDE_CLEARANCE)
    return _accepted(found)


def under_found_load(case: FilmCase, state: FilmState) -> FilmCase:
    """The case with the load in the direction that was found, where the position was prescribed."""
    if isinstance(case.duty, PrescribedLoad):
        return case
    fx, fy = state.solution.force
    return replace(case, load_angle=math.atan2(-fy, -fx))


def _at_eccentricity(case: FilmCase, duty: PrescribedEccentricity, film: JournalFilm) -> FilmSolution:
    """At the given attitude, or at the one for which the film force opposes the direction of the load."""
    if duty.attitude_angle is not None:
        return film_at_angle(case, film, duty.eccentricity_ratio, duty.attitude_angle)

    def aside(attitude: float) -> float:
        fx, fy = film_at_angle(case, film, duty.eccentricity_ratio, attitude).force
        away = math.atan2(-fy, -fx) - case.load_angle
        return math.pi - (math.pi - away) % (2.0 * math.pi)

    steps = [math.radians(degrees) for degrees in range(0, 181, 12)]
    offs = [aside(step) for step in steps]
    for low, high, before, behind in zip(steps, steps[1:], offs, offs[1:], strict=False):
        if before * behind <= 0.0 and abs(before - behind) < math.pi:
            attitude = bracketed_root(aside, low, high, absolute=1e-13)
            return film_at_angle(case, film, duty.eccentricity_ratio, attitude)
    raise NoFilmError(Outcome.NOT_CONVERGED)


def _accepted(solution: FilmSolution) -> FilmSolution:
    if solution.outcome in (Outcome.OVERLOADED, Outcome.STARVED_RECESS, Outcome.WORK_BOUND):
        raise NoFilmError(solution.outcome)
    if not solution.outcome.solved:
        raise NoFilmError(Outcome.NOT_CONVERGED)
    return solution
