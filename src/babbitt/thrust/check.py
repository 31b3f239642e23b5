"""Design check of a thrust bearing: values, verdicts and doubts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from time import perf_counter

import numpy as np

from babbitt.design.doubts import doubt_about_pressure
from babbitt.notices import Notice
from babbitt.results import Bound, Check, Matrix, Outcome, Result
from babbitt.thrust.assumed import oil_assumptions
from babbitt.thrust.design import ThrustDesign, ThrustState, bearing_state
from babbitt.thrust.failures import NoPadFilmError
from babbitt.thrust.heat import Temperatures
from babbitt.thrust.sharing import Share, share_of
from babbitt.thrust.standing import standing_on_runout
from babbitt.thrust.state import CONTACT, condensed

__all__ = [
    "pad_arrays",
    "share_doubts",
    "share_values",
    "temperature_not_checked",
    "thrust_check",
]

METHOD = "film"
LEAST_SHARE = 0.01
"""Pad load over the mean below which a pad is as good as unloaded."""
LAMINAR_UP_TO = 1000.0
"""Reynolds number of a film, rho U h/mu, up to which it is taken as laminar: Ng and Pan's theory departs there."""
TURNS = 24
"""Positions of the collar at which its runout is shared out slowly."""


def thrust_check(design: ThrustDesign) -> Result:
    """Solve a thrust bearing.

    Parameters
    ----------
    design : ThrustDesign

    Returns
    -------
    Result
        With a status in every case.
    """
    start = perf_counter()
    try:
        state = bearing_state(design)
    except NoPadFilmError as failure:
        return Result(
            design.name,
            design.kind,
            METHOD,
            failure.outcome,
            {},
            message=failure.said,
            assumptions=_assumptions(design),
        )
    values = share_values(design, state)
    if design.runout:
        values["quasi_static_load_ratio"] = _turned(design, state)
    values["wall_time"] = perf_counter() - start
    limit = Check(
        "C202",
        "minimum_film_thickness",
        values["minimum_film_thickness"],
        design.film_limit,
        Bound.AT_LEAST,
        design.film_limit_source,
    )
    return Result(
        design.name,
        design.kind,
        METHOD,
        Outcome.CONVERGED,
        values,
        (limit,),
        (*design.doubts, *share_doubts(design, state)),
        (temperature_not_checked(values),),
        (*design.lubricant.assumptions, *design.assumptions, *_assumptions(design)),
        settings={"lubricant": design.lubricant.name, "pivot": design.bearing.pad.pivot.value},
        arrays=pad_arrays(state.share, design.speed),
    )


def share_values(design: ThrustDesign, state: ThrustState) -> dict[str, float]:
    """Values of the static share."""
    share, bearing = state.share, design.bearing
    worst = share.states[int(share.loads.argmax())]
    viscosity = effective_viscosity(design, state)
    values = {
        "load": share.thrust,
        "pad_number": float(bearing.number),
        "specific_load": share.thrust / bearing.area,
        "angular_speed": design.speed,
        "surface_speed": design.speed * 0.5 * (bearing.pad.inner_radius + bearing.pad.outer_radius),
        "ring_stiffness": bearing.ring_stiffness,
        "pivot_film_thickness": worst.height,
        "minimum_film_thickness": min(pad.minimum_film_thickness for pad in share.states),
        "maximum_pressure": max(pad.maximum_pressure for pad in share.states),
        "largest_pad_load": float(share.loads.max()),
        "smallest_pad_load": float(share.loads.min()),
        "pad_load_ratio": share.largest_over_mean,
        "collar_moment": share.collar_moment,
        "friction_torque": sum(pad.friction_torque for pad in share.states),
        "friction_power": sum(pad.friction_power for pad in share.states),
        "side_flow": sum(pad.side_flow for pad in share.states),
        **_temperatures(design, state.temperatures, share),
        **_hottest(share),
        "effective_viscosity": viscosity,
        "film_reynolds_number": reynolds_number(design, share, viscosity, state.temperatures),
        "axial_stiffness": float(sum(condensed(pad, 0.0).real for pad in share.states)),
        "axial_damping": float(
            sum(condensed(pad, design.speed, bearing.inertia).imag for pad in share.states) / design.speed
        ),
    }
    return {name: value for name, value in values.items() if np.isfinite(value)}


def effective_viscosity(design: ThrustDesign, state: ThrustState) -> float:
    """Of the films, Pa s: theirs, or that at the effective temperature where each has its own."""
    if design.oil.warm is None or state.temperatures is None:
        return state.films.viscosity
    return float(design.lubricant.dynamic_viscosity(state.temperatures.effective))


def _hottest(share: Share) -> dict[str, float]:
    found = [pad.heat.maximum for pad in share.states if pad.heat is not None]
    return {"maximum_temperature": max(found)} if found else {}


def _temperatures(design: ThrustDesign, found: Temperatures | None, share: Share) -> dict[str, float]:
    if found is None:
        prescribed = design.oil.effective_temperature
        capacity = float(
            design.lubricant.volumetric_heat_capacity(prescribed if prescribed is not None else 323.15)
        )
        power = sum(pad.friction_power for pad in share.states)
        own = {} if prescribed is None else {"effective_temperature": prescribed}
        passing = sum(pad.trailing_flow + pad.side_flow for pad in share.states)
        return {**own, "passing_flow": passing, "temperature_rise": power / (capacity * passing)}
    return {
        "total_flow": found.fresh_flow,
        "supply_temperature": found.supply,
        "pad_inlet_temperature": found.inlet,
        "trailing_temperature": found.trailing,
        "effective_temperature": found.effective,
        "outlet_temperature": found.drain,
        "energy_balance_error": abs(found.error),
    }


def reynolds_number(design: ThrustDesign, share: Share, viscosity: float, found: Temperatures | None) -> float:
    """Of the thickest pivot film at the mean radius."""
    pad = design.bearing.pad
    at = found.effective if found is not None else design.oil.effective_temperature
    density = float(design.lubricant.density(at if at is not None else 323.15))
    surface = design.speed * 0.5 * (pad.inner_radius + pad.outer_radius)
    return density * surface * float(share.heights.max()) / viscosity


def _turned(design: ThrustDesign, state: ThrustState) -> float:
    """Largest pad load over the mean while the collar turns so slowly that nothing swings."""
    largest = 0.0
    for turned in 2.0 * np.pi * np.arange(TURNS) / TURNS:
        stands = standing_on_runout(design.bearing, design.runout, float(turned))
        share = share_of(state.films, design.bearing, state.share.thrust, stands)
        largest = max(largest, share.largest_over_mean)
    return largest


def pad_arrays(share: Share, speed: float) -> dict[str, Matrix]:
    """One row with a number per pad for each quantity, and the full coefficients of the pad loaded most."""
    inertia = share.bearing.inertia
    rows: dict[str, Iterable[float]] = {
        "pad_load": share.loads,
        "pad_film_thickness": share.heights,
        "pad_minimum_film_thickness": [pad.minimum_film_thickness for pad in share.states],
        "pad_maximum_pressure": [pad.maximum_pressure for pad in share.states],
        "pad_leading_flow": [pad.leading_flow for pad in share.states],
        "pad_trailing_flow": [pad.trailing_flow for pad in share.states],
        "pad_inner_flow": [pad.inner_flow for pad in share.states],
        "pad_outer_flow": [pad.outer_flow for pad in share.states],
        "pad_friction_power": [pad.friction_power for pad in share.states],
        "pad_slope_radial": [pad.slope_x for pad in share.states],
        "pad_slope_along": [pad.slope_y for pad in share.states],
        "pad_stiffness": [condensed(pad, 0.0).real for pad in share.states],
        "pad_damping": [condensed(pad, speed, inertia).imag / speed for pad in share.states],
    }
    heats = [pad.heat for pad in share.states if pad.heat is not None]
    if heats:
        rows["pad_mixed_temperature"] = [heat.inlet for heat in heats]
        rows["pad_trailing_temperature"] = [heat.trailing for heat in heats]
        rows["pad_maximum_temperature"] = [heat.maximum for heat in heats]
    worst = share.states[int(share.loads.argmax())]
    arrays: dict[str, Matrix] = {name: (tuple(float(one) for one in row),) for name, row in rows.items()}
    for name, matrix in (("full_stiffness", worst.stiffness), ("full_damping", worst.damping)):
        arrays[name] = tuple(tuple(float(one) for one in row) for row in matrix)
    return arrays


def share_doubts(design: ThrustDesign, state: ThrustState) -> Iterator[Notice]:
    """Doubts about the static share."""
    share, bearing = state.share, design.bearing
    even = state.films.height_for(share.mean_load)
    nearest = -float(bearing.departures().min())
    if nearest >= even:
        yield Notice(
            "W201",
            f"tilt and heights bring pad {1 + int(bearing.departures().argmin())} {nearest * 1e6:.1f} µm "
            "nearer to the collar, more than the "
            f"film of {even * 1e6:.1f} µm that an even share has",
        )
    least = float(share.loads.min() / share.mean_load)
    if least < LEAST_SHARE:
        yield Notice("W201", f"pad {1 + int(share.loads.argmin())} carries {least:.2%} of the mean load")
    yield from doubt_about_pressure(max(pad.maximum_pressure for pad in share.states), "in the film of a pad")
    films = [pad.minimum_film_thickness for pad in share.states]
    if min(films) <= CONTACT:
        yield Notice(
            "W207",
            f"pad {1 + films.index(min(films))} would run on {min(films) * 1e6:.2f} µm under "
            f"{share.states[films.index(min(films))].load / 1e3:.0f} kN; surfaces touch below "
            f"{CONTACT * 1e6:g} µm",
        )
    reynolds = reynolds_number(design, share, effective_viscosity(design, state), state.temperatures)
    if design.turbulence is None and reynolds > LAMINAR_UP_TO:
        yield Notice("W204", f"Re = {reynolds:.0f} > {LAMINAR_UP_TO:.0f}")
    known = (*_hottest(share).values(), *([] if state.temperatures is None else [state.temperatures.trailing]))
    hottest = max(known, default=design.oil.effective_temperature)
    if hottest is not None and not design.lubricant.covers(hottest):
        low, high = (kelvin - 273.15 for kelvin in design.lubricant.temperature_range)
        yield Notice("W145", f"film up to {hottest - 273.15:.1f} °C, data from {low:.4g} to {high:.4g} °C")


def temperature_not_checked(values: dict[str, float]) -> Notice:
    """That no temperature is held against a limit, and the hottest one that is known."""
    names = ("maximum_temperature", "trailing_temperature", "effective_temperature")
    known = next((values[name] for name in names if name in values), None)
    if known is None:
        return Notice("C104", "the viscosity of the films is given, their temperature is not known")
    return Notice(
        "C104", f"no limit belongs to a thrust case; the hottest oil known is at {known - 273.15:.1f} °C"
    )


def _assumptions(design: ThrustDesign) -> tuple[str, ...]:
    said = [*oil_assumptions(design.oil)]
    if design.oil.warm is not None:
        said.append("Each pad takes in what the pad before it sends off, mixed with fresh oil.")
    if design.turbulence is not None:
        said.append(f"Turbulence by {design.turbulence.name}: {design.turbulence.source}.")
    return tuple(said)
