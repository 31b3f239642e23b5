"""Round films of one given temperature for many bearings at once: kernels for the films, `Lanes` for the answer.

What is said of one film in `film.check` is said here of many by the same functions. Taken are plain round bores
with axial grooves at ambient pressure, whose temperature is prescribed; whatever else a case asks for, and films
that need more than one search, are left to be solved one by one.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import MISSING, Field, dataclass, fields, replace
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from babbitt.core.quantities import AXES
from babbitt.core.result import Check, Outcome, Result, Verdict
from babbitt.design.checks import checks_not_made, clearance_check, pressure_not_checked
from babbitt.design.conditions import PrescribedLoad, contact_film
from babbitt.design.feeding import Arrival
from babbitt.design.oil import properties_at
from babbitt.design.screening import recommended_relative_clearance
from babbitt.design.values import cooling_values, duty_values, heat_values, limit_values, oil_values, supply_values
from babbitt.design.verdict_lanes import by_verdict
from babbitt.kinds.journal.film.bore import RoundBore
from babbitt.kinds.journal.film.check import METHOD, film_limits
from babbitt.kinds.journal.film.isothermal import FilmState, friction_of, resolution_of
from babbitt.kinds.journal.film.layout import feeds_itself, film_of, load_vector
from babbitt.kinds.journal.film.model import WHOLE_TURN, FilmCase, Search
from babbitt.kinds.journal.film.values import OF_THE_SUPPLY
from babbitt.kinds.journal.film.warnings import film_warnings
from babbitt.kinds.journal.film.whirl import mass_of_rotor
from babbitt.kinds.journal.limits_of_clearance import many_held_at_limits
from babbitt.numerics.lanes import chooser, holds_lanes, in_branches, lanes_of
from babbitt.properties.fits import operating_relative_clearance
from babbitt.reynolds.frame import LoadFrame, rounded
from babbitt.reynolds.lands.batch import BatchSolution, solve_batch
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land
from babbitt.reynolds.solution import NOTHING
from babbitt.reynolds.stability.routh import stable_masses, whirl_frequency
from babbitt.reynolds.stability.whirl_checks import whirl_checks, whirl_values, without_critical_mass
from babbitt.reynolds.stability.whirl_limits import Threshold, Whirl

__all__ = ["PRODUCED", "films_many"]

Index = NDArray[np.intp]
Array = NDArray[np.float64]
Pair = tuple[Any, Any]

OF_ONE = ("name", "kind", "cavitation", "accuracy", "load_angle", "search", "given", "assumptions", "warnings")
"""Fields of a case that are the same for all bearings."""

OF_EACH = ("bearing", "duty", "journal_speed", "lubricant", "oil_supply", "cooling", "effective_temperature",
           "friction_factor", "rotor_mass", "limits", "clearance_limits")  # fmt: skip
"""Fields of a case that may differ; all others must be as if they had not been given."""

BORE_OF_ONE = ("feeds", "bore", "film_start", "metal", "load_character")
BORE_OF_EACH = ("diameter", "width", "relative_clearance", "expansion_bearing", "expansion_journal",
                "clearance_tolerance", "mean_clearance")  # fmt: skip
"""The same for the fields of its bearing."""

PRODUCED = frozenset((
    "diameter", "width", "width_ratio", "relative_clearance", "operating_relative_clearance", "load",
    "specific_load", "angular_speed", "hydrodynamic_speed", "surface_speed", "pressure_speed_product",
    "film_reynolds_number", "critical_reynolds_number", "effective_viscosity", "effective_kinematic_viscosity",
    "density", "volumetric_heat_capacity", "effective_temperature", "eccentricity_ratio",
    "minimum_film_thickness", "maximum_pressure", "friction_number", "friction_coefficient", "friction_torque",
    "friction_power", "side_flow", "supply_flow", "total_flow", "side_inflow", "inlet_flow",
    "recommended_relative_clearance", "empirical_film_limit", "mass_balance_error", "supply_temperature",
    "critical_mass", "least_stable_mass", "rotor_mass", "whirl_frequency_ratio", "stable_at_any_mass",
    *(f"{matrix}_{axes}" for matrix in ("stiffness", "damping") for axes in AXES),
))  # fmt: skip
"""Results that are given; a study that keeps others has its films solved one by one."""


@dataclass(frozen=True)
class ManyFilms:
    """Films that carry their loads, as far as `FilmSolution` says the same of one; numbers in lanes, SI."""

    film: JournalFilm
    clearance: Any
    position: Pair
    force: Pair
    stiffness: tuple[Pair, Pair]
    damping: tuple[Pair, Pair]
    minimum_film_thickness: Any
    maximum_pressure: Any
    friction_torque: Any
    leaving_flow: Any
    side_inflow: Any
    inlet_flow: Any
    mass_balance_error: Any

    @property
    def load(self) -> Any:
        """Force of the film, N."""
        return np.hypot(*self.force)

    @property
    def eccentricity_ratio(self) -> Any:
        """Eccentricity over radial clearance."""
        return np.hypot(*self.position) / self.clearance

    @property
    def pressure_torque(self) -> Any:
        """Part of the friction torque by the pressure on the journal, N m; it turns counter-clockwise."""
        (x, y), (fx, fy) = self.position, self.force
        return 0.5 * (x * fy - y * fx)


@dataclass(frozen=True)
class _Judged:
    """Films with what they come to."""

    case: FilmCase
    state: FilmState
    values: dict[str, Any]
    checks: tuple[Check, ...]
    whirl: Whirl


def films_many(case: FilmCase, count: int) -> Iterator[tuple[Index, Result, Verdict]]:
    """Solve the films of many bearings.

    Parameters
    ----------
    case : FilmCase
        Its numbers that differ from bearing to bearing are `Lanes`.
    count : int
        Bearings.

    Yields
    ------
    index : ndarray of int
        Bearings whose checks are the same. Those that are left out are for `film.check.film_solution`.
    result : Result
        Its numbers in lanes; remarks only as far as the verdict depends on them.
    verdict : Verdict
    """
    if _is_plain(case):
        yield from many_held_at_limits(case, count, _films_many)


def _films_many(case: FilmCase, count: int) -> Iterator[tuple[Index, Result, Verdict]]:
    """The films at the clearance of the case."""
    own = chooser(case)
    for index, conditions in in_branches(lambda lanes: _conditions(own(lanes)), np.arange(count)):
        if conditions is None:
            continue
        found = _solved(own(index), conditions, index.size)
        held = np.flatnonzero(_is_simple(found))
        if held.size:
            judged = _judged(own(index[held]), chooser(conditions)(held), _chosen(found, held))
            for lanes, result, verdict in judged:
                yield index[held[lanes]], result, verdict


def _is_plain(case: FilmCase) -> bool:
    """Whether a case asks for no more than a round film of one given temperature between grooves."""
    bearing, supply = case.bearing, case.oil_supply
    without_pressure = supply is None or (
        not holds_lanes(supply.pressure)
        and supply.pressure == 0.0
        and not (supply.tubes or supply.holes)
        and supply.flow is None
    )
    return (
        _is_default(case, OF_ONE, OF_EACH)
        and _is_default(bearing, BORE_OF_ONE, BORE_OF_EACH)
        and case.effective_temperature is not None
        and isinstance(case.duty, PrescribedLoad)
        and case.cavitation is not Cavitation.HALF_SOMMERFELD
        and case.search is not Search.ALL
        and bearing.film_start is FilmStart.GROOVE
        and bearing.bore == RoundBore()
        and bool(bearing.feeds)
        and all(
            one.width is None and one.flow is None and not one.pressure and one.extent < WHOLE_TURN
            for one in bearing.feeds
        )
        and (without_pressure or feeds_itself(case))
        and contact_film(case) is None
    )


def _is_default(part: Any, of_one: tuple[str, ...], of_each: tuple[str, ...]) -> bool:
    for one in fields(part):
        value = getattr(part, one.name)
        if one.name in of_each:
            continue
        if holds_lanes(value) or (one.name not in of_one and value != _default(one)):
            return False
    return True


def _default(one: Field[Any]) -> Any:
    return one.default_factory() if one.default_factory is not MISSING else one.default


@dataclass(frozen=True)
class _Conditions:
    """Clearance and oil at the given temperature."""

    relative_clearance: Any
    density: Any
    viscosity: Any
    volumetric_heat_capacity: Any


def _conditions(case: FilmCase) -> _Conditions | None:
    """Clearance and oil of loaded bearings that have some, and whose journal turns counter-clockwise."""
    bearing, temperature = case.bearing, case.effective_temperature
    assert temperature is not None, "it was asked for"
    psi = operating_relative_clearance(
        bearing.relative_clearance, bearing.expansion_bearing, bearing.expansion_journal, temperature
    )
    if not (psi > 0.0 and case.journal_speed > 0.0 and cast(PrescribedLoad, case.duty).load > 0.0):
        return None
    return _Conditions(psi, *properties_at(case.lubricant, temperature))


def _solved(case: FilmCase, at: _Conditions, count: int) -> BatchSolution:
    """The films, by the kernel of one, from the same digits (`babbitt.reynolds.frame`)."""
    bearing, duty = case.bearing, cast(PrescribedLoad, case.duty)
    numbers = (
        bearing.diameter,
        bearing.width,
        0.5 * at.relative_clearance * bearing.diameter,
        at.viscosity,
        case.journal_speed,
        duty.load,
    )
    diameter, width, clearance, viscosity, speed, load = (
        np.broadcast_to(_rounded(one), (count,)) for one in numbers
    )
    first, conditions = chooser((case, at))(0)  # type: ignore[arg-type]
    film = _film_of(first, conditions)
    frame = LoadFrame.of(film, load_vector(first, cast(PrescribedLoad, first.duty).load))
    lands = tuple(Land(one.start_angle, one.end_angle) for one in frame.film.lands)  # all round, of one clearance
    down = np.outer(load, (0.0, -1.0))
    grid = resolution_of(case)
    found = solve_batch(
        diameter, width, clearance, viscosity, speed, down, lands, case.cavitation, grid, workers=1
    )
    return _turned(found, frame.angle)


def _rounded(values: Any) -> Array:
    """Numbers as films of one are solved from."""
    own = np.asarray(values, float)
    return np.array([rounded(one) for one in own.ravel().tolist()]).reshape(own.shape)


def _turned(found: BatchSolution, angle: float) -> BatchSolution:
    """Films that were solved in a frame turned by an angle in rad, in the frame of their case."""
    c, s = math.cos(angle), math.sin(angle)
    turn = np.array([[c, s], [-s, c]])
    return replace(
        found,
        position=found.position @ turn.T,
        force=found.force @ turn.T,
        stiffness=turn @ found.stiffness @ turn.T,
        damping=turn @ found.damping @ turn.T,
    )


def _film_of(case: FilmCase, at: _Conditions) -> JournalFilm:
    return film_of(case, float(at.relative_clearance), float(at.viscosity), 0.0)


def _is_simple(found: BatchSolution) -> NDArray[np.bool_]:
    """Films that one search found, at which the journal may stay, and whose sides draw nothing in."""
    (xx, xy), (yx, yy) = np.moveaxis(found.stiffness, 0, -1)
    leaving = found.side_flow + found.side_inflow
    finite = np.isfinite(found.stiffness).all(axis=(1, 2)) & np.isfinite(found.damping).all(axis=(1, 2))
    drawn: NDArray[np.bool_] = found.side_inflow > NOTHING * leaving
    stays: NDArray[np.bool_] = xx * yy - xy * yx >= 0.0
    return found.solved & finite & stays & ~drawn


def _chosen(found: BatchSolution, lanes: Index) -> BatchSolution:
    return BatchSolution(**{one.name: getattr(found, one.name)[lanes] for one in fields(found)})


def _judged(case: FilmCase, at: _Conditions, found: BatchSolution) -> Iterator[tuple[Index, Result, Verdict]]:
    """Bearings by their verdict."""
    films = _many(case, at, found)
    choose = chooser((case, at, films))
    for index, answer in in_branches(lambda lanes: _answered(*choose(lanes)), np.arange(found.solved.size)):
        if answer is None:
            continue
        for lanes, result, verdict in by_verdict(answer, answer.checks, index.size, _failed, _with_remarks):
            yield index[lanes], result, verdict


def _many(case: FilmCase, at: _Conditions, found: BatchSolution) -> ManyFilms:
    """The films of a batch in lanes."""

    def vector(values: Array) -> Pair:
        return lanes_of(values[:, 0]), lanes_of(values[:, 1])

    def matrix(values: Array) -> tuple[Pair, Pair]:
        return vector(values[:, 0]), vector(values[:, 1])

    return ManyFilms(
        _film_of(*chooser((case, at))(0)),  # type: ignore[arg-type]
        0.5 * at.relative_clearance * case.bearing.diameter,
        vector(found.position),
        vector(found.force),
        matrix(found.stiffness),
        matrix(found.damping),
        lanes_of(found.minimum_film_thickness),
        lanes_of(found.maximum_pressure),
        lanes_of(found.friction_torque),
        lanes_of(found.side_flow + found.side_inflow),
        lanes_of(found.side_inflow),
        lanes_of(found.inlet_flow),
        lanes_of(found.mass_balance_error),
    )


def _answered(case: FilmCase, at: _Conditions, films: ManyFilms) -> _Judged:
    """Values and checks, as `film.check.film_solution` has them of one film."""
    supply = case.oil_supply
    assert case.effective_temperature is not None, "it was asked for"
    state = FilmState(
        temperature=case.effective_temperature,
        relative_clearance=at.relative_clearance,
        density=at.density,
        viscosity=at.viscosity,
        volumetric_heat_capacity=at.volumetric_heat_capacity,
        load=films.load,
        friction_power=case.friction_factor * friction_of(case, cast(Any, films))[1],
        total_flow=films.leaving_flow,
        feed=None if supply is None else Arrival(0.0, 0.0, 0.0, films.leaving_flow),
        solution=cast(Any, films),
    )
    whirl = Whirl(
        stable_masses(cast(Any, films.stiffness), cast(Any, films.damping)),
        whirl_frequency(cast(Any, films.stiffness), cast(Any, films.damping)) / abs(case.journal_speed),
        mass_of_rotor(case, state.load),
        Threshold(),
    )
    values = _values(case, state, films) | whirl_values(case, whirl)
    checks = (*film_limits(case, values), *whirl_checks(case, whirl), clearance_check(case, values))
    return _Judged(case, state, values, checks, whirl)


def _values(case: FilmCase, state: FilmState, films: ManyFilms) -> dict[str, Any]:
    bearing = case.bearing
    duty = duty_values(case, state)
    torque = case.friction_factor * friction_of(case, cast(Any, films))[0]
    coefficient = 2.0 * torque / (state.load * bearing.diameter)
    values = {
        "diameter": bearing.diameter,
        "width": bearing.width,
        "width_ratio": bearing.width_ratio,
        "relative_clearance": bearing.relative_clearance,
        "operating_relative_clearance": state.relative_clearance,
        **duty,
        **oil_values(case, state),
        "eccentricity_ratio": films.eccentricity_ratio,
        "load_angle": math.remainder(case.load_angle, 2.0 * math.pi),
        "minimum_film_thickness": films.minimum_film_thickness,
        "maximum_pressure": films.maximum_pressure,
        "friction_number": coefficient / state.relative_clearance,
        "friction_coefficient": coefficient,
        "friction_torque": torque,
        "friction_power": state.friction_power,
        "side_flow": state.total_flow,
        "supply_flow": 0.0,
        "total_flow": state.total_flow,
        "side_inflow": films.side_inflow,
        "inlet_flow": films.inlet_flow,
        **heat_values(case, state),
        **supply_values(case, state),
        **cooling_values(case, state),
        "recommended_relative_clearance": recommended_relative_clearance(duty["surface_speed"]),
        **limit_values(case),
        "mass_balance_error": films.mass_balance_error,
    }
    for name, matrix in (("stiffness", films.stiffness), ("damping", films.damping)):
        values |= {f"{name}_{axes}": one for axes, one in zip(AXES, (*matrix[0], *matrix[1]), strict=True)}
    return {name: one for name, one in values.items() if not (feeds_itself(case) and name in OF_THE_SUPPLY)}


def _failed(found: _Judged) -> Result:
    return _result(found, ())


def _with_remarks(found: _Judged) -> tuple[Result, Verdict]:
    warnings = tuple(film_warnings(found.case, found.state, found.values, found.checks, found.whirl))
    result = _result(found, warnings)
    return result, result.verdict


def _result(found: _Judged, warnings: tuple[Any, ...]) -> Result:
    case, values = found.case, found.values
    no_mass = without_critical_mass(found.whirl)
    not_made = (*checks_not_made(case, values), *pressure_not_checked(case), *((no_mass,) if no_mass else ()))
    return Result(case.name, case.kind, METHOD, Outcome.CONVERGED, values, found.checks, warnings, not_made)
