"""Design check of one bearing by segments: from the inputs to values, verdicts and warnings."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from time import perf_counter

from babbitt.core.notices import Notice
from babbitt.core.result import Check, Matrix, Outcome, Result
from babbitt.design.bounds import NO_BOUNDS, Bounds
from babbitt.design.checks import checks_not_made, clearance_check, limit_checks
from babbitt.design.conditions import PrescribedLoad
from babbitt.design.directions import directions_of, narrowest_direction
from babbitt.design.infinite_width import flattered_films
from babbitt.kinds.journal.grooved_long_bearing.model import GrooveKind, SegmentCase
from babbitt.kinds.journal.grooved_long_bearing.solve import film_at_eccentricity, film_under_load
from babbitt.kinds.journal.grooved_long_bearing.state import SegmentFilmState
from babbitt.kinds.journal.grooved_long_bearing.ungrooved_reference import UngroovedReference, ungrooved_films
from babbitt.kinds.journal.grooved_long_bearing.warnings import warnings_of_solution
from babbitt.kinds.journal.one_dimension import long_film_values, rows_over_angle, solved
from babbitt.properties.lubricants import PowerLaw

METHOD = "segments"

GAP_OF_CLASSES = (20e-6, 30e-6)
"""ν50 in m²/s between the two classes for which the source gives exponents."""


def segments_check(case: SegmentCase) -> Result:
    """Solve a bearing by segments and compare it with the ungrooved one.

    Parameters
    ----------
    case : SegmentCase

    Returns
    -------
    Result
        With a status in every case.
    """
    start = perf_counter()
    outcome, capacity, state = solved(lambda: _found(case))
    values: dict[str, float] = {}
    checks: tuple[Check, ...] = ()
    not_made: tuple[Notice, ...] = ()
    warnings = case.warnings
    arrays: dict[str, Matrix] = {}
    if state is not None:
        values, arrays = _values(case, state), _arrays(state)
        if not case.profile:
            around = directions_of(case, state.attitude_angle, state.grid.angles)
            arrays |= rows_over_angle({"film_direction": around})
        if outcome.solved:
            plain = ungrooved_films(case.film, state) if case.groove is not None else None
            values |= _ungrooved_values(state, plain)
            bounds = _bounds(case, values)
            limits = _of_the_hottest(limit_checks(case, values, bounds), values)
            checks = (*limits, clearance_check(case, values))
            not_made = checks_not_made(case, values, bounds)
            warnings = tuple(warnings_of_solution(case, state, plain, values, checks))
        values["iterations"] = float(state.iterations)
    values = {name: float(value) for name, value in values.items()} | {"wall_time": perf_counter() - start}
    return Result(
        case.name,
        case.kind,
        METHOD,
        outcome,
        values,
        checks,
        warnings,
        not_made,
        (*case.lubricant.assumptions_but_of_conduction, *case.assumptions, *_assumptions(case)),
        settings=_settings(case),
        arrays=arrays,
        failure=None if outcome.solved else _failure(case, outcome, capacity, state),
    )


def _bounds(case: SegmentCase, values: dict[str, float]) -> Bounds:
    """What flatters the bearing: a film found from its load, or one whose wall yields to too high a pressure."""
    found = isinstance(case.duty, PrescribedLoad) or case.compliance > 0.0
    return flattered_films(values) if found else NO_BOUNDS


def _of_the_hottest(checks: tuple[Check, ...], values: dict[str, float]) -> Iterator[Check]:
    """Limits of the temperature hold for the segment that the hottest oil leaves."""
    hottest = "maximum_temperature"
    for one in checks:
        ahead = one.quantity == "outlet_temperature" and values[hottest] > one.value
        yield replace(one, quantity=hottest, value=values[hottest]) if ahead else one


def _found(case: SegmentCase) -> SegmentFilmState:
    """The film under the load, or at the eccentricity of the case."""
    if isinstance(case.duty, PrescribedLoad):
        return film_under_load(case.film, case.duty.load)
    eccentricity = case.duty.eccentricity_ratio if case.duty is not None else 0.0
    return film_at_eccentricity(case.film, eccentricity)


def _values(case: SegmentCase, state: SegmentFilmState) -> dict[str, float]:
    first, last = state.segments[0], state.segments[-1]
    thinnest = float(state.film_thickness.min())
    values = long_film_values(case, state, _mean_temperature(state), last.flow) | {
        "rupture_angle": last.segment.end,
        "narrow_zone": state.width_of_narrow_zone(),
        "friction_torque": state.friction_power / abs(case.journal_speed),
        "film_flow": first.flow,
        "outlet_temperature": last.outlet_temperature,
        "maximum_temperature": max(one.outlet_temperature for one in state.segments),
        "heat_to_oil": sum(one.heat for one in state.segments),
    }
    if not case.profile:
        values["narrowest_gap_angle"] = narrowest_direction(case, state.attitude_angle)
    values["eccentricity_ratio"] = (
        1.0 - thinnest / state.film.clearance if case.profile else state.eccentricity_ratio
    )
    if case.groove is None:
        return values
    for place, one in enumerate(state.segments, start=1):
        values |= {
            f"segment_{place}_flow": one.flow,
            f"segment_{place}_power": one.friction_power,
            f"segment_{place}_heat": one.heat,
            f"segment_{place}_inlet_temperature": one.inlet_temperature,
            f"segment_{place}_mean_temperature": one.mean_temperature,
            f"segment_{place}_outlet_temperature": one.outlet_temperature,
            f"segment_{place}_viscosity": one.viscosity,
            f"segment_{place}_constant": one.segment.constant,
        }
    if state.film.groove is not None:
        values["groove_angle_from_gap"] = state.film.groove.angle
        values["groove_angle_from_load"] = state.groove_angle_from_load
    values |= {"groove_pressure": state.groove_pressure, "groove_side_flow": state.groove_side_flow}
    if case.groove.kind is GrooveKind.THROUGH:
        values |= {"groove_warm_flow": state.groove_warm_flow, "groove_heat": state.groove_heat}
    return values


def _mean_temperature(state: SegmentFilmState) -> float:
    """Mean temperatures of the segments, each over its angle, K."""
    angles = state.grid.angles
    spans = [max(one.segment.end - float(angles[one.segment.first]), 1e-12) for one in state.segments]
    means = [one.mean_temperature for one in state.segments]
    return sum(span * mean for span, mean in zip(spans, means, strict=True)) / sum(spans)


def _ungrooved_values(state: SegmentFilmState, plain: UngroovedReference | None) -> dict[str, float]:
    values: dict[str, float] = {}
    if plain is None:
        return values
    if plain.same_gap is not None:
        values["ungrooved_specific_load"] = plain.same_gap.specific_load
        values["ungrooved_outlet_temperature"] = plain.same_gap.outlet_temperature
        values["groove_load_ratio"] = state.load / plain.same_gap.load
    if plain.cut_same_gap is not None:
        values["cut_specific_load"] = plain.cut_same_gap.specific_load
        values["cut_outlet_temperature"] = plain.cut_same_gap.outlet_temperature
    if plain.same_load is not None:
        values["ungrooved_eccentricity_at_load"] = plain.same_load.eccentricity_ratio
        values["ungrooved_film_at_load"] = float(plain.same_load.film_thickness.min())
        values["ungrooved_outlet_at_load"] = plain.same_load.outlet_temperature
    if plain.cut_same_load is not None:
        values["cut_outlet_at_load"] = plain.cut_same_load.outlet_temperature
    return values


def _arrays(state: SegmentFilmState) -> dict[str, Matrix]:
    """Fields over the angle from the widest gap, each as one row."""
    return rows_over_angle({
        "film_angle": state.grid.angles,
        "film_thickness": state.film_thickness,
        "film_pressure": state.film_pressure,
        "film_temperature": state.film_temperature,
    })  # fmt: skip


def _assumptions(case: SegmentCase) -> Iterator[str]:
    yield "Infinitely long film: no oil leaves at the sides but through the groove. Adiabatic walls, laminar film."
    yield "One mean temperature for each segment; the oil enters the film with the supply temperature."
    yield "The effective temperature is the mean over the segments by their angle; nothing is computed with it."
    if case.groove is not None:
        if not case.groove.at_place_in_bush:
            yield "Angles of film and groove count from the widest gap with the rotation, not from the load."
        yield "The oil in the groove is not sheared; the mixing factor is not published."
    if case.compliance:
        yield "The wall yields to the pressure at the same place only (independent columns)."
    law = case.lubricant.viscosity_law
    if isinstance(law, PowerLaw):
        viscosity = case.lubricant.kinematic_viscosity(323.15)
        if GAP_OF_CLASSES[0] <= viscosity <= GAP_OF_CLASSES[1]:
            yield "Exponents are published below 20 and above 30 mm²/s at 50 °C; the given one lies between."


def _settings(case: SegmentCase) -> dict[str, str]:
    groove = case.groove
    return {
        "lubricant": case.lubricant.name,
        "groove": groove.kind.value if groove is not None else "none",
        "film": "profile" if case.profile else "compliant" if case.compliance else "rigid",
        "intervals": str(case.cells),
    }


def _failure(
    case: SegmentCase, outcome: Outcome, capacity: float | None, state: SegmentFilmState | None
) -> Notice:
    code, far = outcome.code, None
    if outcome is Outcome.OVERLOADED and isinstance(case.duty, PrescribedLoad) and capacity is not None:
        area = case.bearing.diameter * case.bearing.width
        far = Notice("S001", "specific_load", {"reached": capacity / area, "asked": case.duty.load / area})
    elif state is not None:
        warm, bent = state.residuals
        far = Notice(code, "walls_change", {"iterations": state.iterations, "change": warm, "wall": bent})
    elif outcome is Outcome.NO_LUBRICANT_DATA:
        far = Notice("S005", "supplied", {
            "supplied": case.oil_supply.temperature, "lubricant": case.lubricant.name,
        })  # fmt: skip
    elif outcome is Outcome.NOT_CONVERGED:
        in_bush = case.groove is not None and case.groove.at_place_in_bush
        far = Notice("S004", "no_rupture_in_bush" if in_bush else "no_rupture")
    return Notice(code, "tried", {"far": far or outcome.value})
