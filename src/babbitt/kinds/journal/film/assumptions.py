"""What the answer of a film bearing takes for granted, and the choices that its numbers depend on."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.units import ZERO_CELSIUS
from babbitt.design.conditions import PrescribedEccentricity, PrescribedPosition
from babbitt.design.turbulence import ALL_TURBULENT
from babbitt.kinds.journal.film.mixed_results import mixed_assumptions
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.orbit_results import orbit_assumptions
from babbitt.kinds.journal.film.thermal_results import coefficient_settings, thermal_assumptions, thermal_setting
from babbitt.reynolds.model import END_DAM, Cavitation

__all__ = ["film_assumptions", "film_settings"]


def film_assumptions(case: FilmCase) -> Iterator[str]:
    """What the film method assumes for a case, in sentences for the report."""
    flow = "laminar film" if case.turbulence is None else f"turbulence after {case.turbulence.name}"
    surfaces = surfaces_of(case)
    if case.heat is None:
        yield f"One viscosity for the whole film, that at the effective temperature; {surfaces}; {flow}."
    else:
        yield from thermal_assumptions(case, surfaces, flow)
    if case.bearing.misalignment != (0.0, 0.0):
        yield (
            "The journal is inclined: ε and β are those of the middle of the width, h_min and p_max the least and "
            "the largest at any place of it."
        )
    yield from displacement_assumptions(case)
    if case.turbulence is not None:
        yield (
            f"The film is laminar up to the local Reynolds number 41.3 sqrt(D/C) and fully turbulent from "
            f"{ALL_TURBULENT:g} times that number."
        )
    if case.pressure_viscosity is not None:
        law = case.pressure_viscosity
        yield (
            f"Viscosity grows with pressure after {law.law.value.capitalize()}, {law.coefficient * 1e9:.3g} 1/GPa "
            "at ambient pressure."
        )
    if _flows_given(case):
        yield (
            "Supplies of given flow: oil that a flooded film does not draw returns without passing it; stiffness, "
            "damping and thresholds hold for the fills of the operating point; no oil is stored in grooves."
        )
    if any(feed.is_closed for feed in case.bearing.feeds):
        yield (
            "Closed pockets and holes (flow: 0 L/min) stand at the pressure at which their net flow vanishes, and "
            "all oil that reaches them goes on; in stiffness and damping their pressures follow the journal, for "
            "oil is incompressible."
        )
    grooves = [feed for feed in case.bearing.feeds if feed.width is None]
    if any(feed.pressure != 0.0 for feed in grooves) and case.oil_supply is not None:
        yield (
            f"The pressure of grooves as wide as the bearing falls to that of the sides over the last "
            f"{100.0 * END_DAM:g} % of the width at either end."
        )
    if case.bearing.side_pressures != (0.0, 0.0):
        yield "Oil that a side under pressure presses into the film is as warm as that of the supply."
    if case.bearing.feeds:
        yield "Grooves, pockets and holes are deep: the oil in them is not sheared."
    if case.changing_load is not None:
        yield from orbit_assumptions(case)
    yield from mixed_assumptions(case)
    if case.cavitation is Cavitation.HALF_SOMMERFELD:
        yield "Half-Sommerfeld film: neither flows nor stiffness, damping and threshold of whirl follow from it."
    elif case.rotor_mass is None:
        yield "The mass of the rotor is not given: stability is judged as if the load were its weight."
    by_attitude = isinstance(case.duty, PrescribedEccentricity) and case.duty.attitude_angle is not None
    if by_attitude or isinstance(case.duty, PrescribedPosition):
        yield "The position is prescribed: the load found need not point along the load angle."
    if case.effective_temperature is not None:
        yield (
            f"Effective temperature prescribed: {case.effective_temperature - ZERO_CELSIUS:.1f} °C; heat balance "
            f"not closed."
        )


def surfaces_of(case: FilmCase) -> str:
    """What moves the bore of a film, in words."""
    distorted = case.heat is not None and case.heat.growth is not None
    if not case.bearing.compliance:
        return "a stiff bore that heat distorts" if distorted else "rigid surfaces"
    return "a bore that gives way and that heat distorts" if distorted else "a bore that gives way"


def displacement_assumptions(case: FilmCase) -> Iterator[str]:
    """What is taken for granted about a bore that gives way or is distorted by heat."""
    growth = case.heat.growth if case.heat is not None else None
    if not case.bearing.compliance and growth is None:
        return
    if case.bearing.compliance:
        yield (
            "Stiffness and damping count how the bore gives way to slow motions (first order in the frequency), "
            "without delay and without mass of its own; the journal is rigid."
        )
    if growth is not None:
        yield "The distortion by heat stays that of the operating point while journal or speed change."
    for one in case.bearing.compliance:
        yield one.premise
    if growth is not None:
        yield growth.premise


def film_settings(case: FilmCase) -> dict[str, str]:
    """The choices that the numbers depend on."""
    grooves = sum(feed.width is None for feed in case.bearing.feeds)
    orbit = {} if case.changing_load is None else {"orbit_cavitation": Cavitation.REYNOLDS.name.lower()}
    heat = {} if case.heat is None else coefficient_settings(case.heat)
    return (
        orbit
        | heat
        | {
            "lubricant": case.lubricant.name,
            "thermal": thermal_setting(case),
            "cavitation": case.cavitation.name.lower(),
            "film_start": case.bearing.film_start.name.lower(),
            "accuracy": case.accuracy.value,
            "rotation": case.rotation.value,
            "bore": case.bearing.own_form or type(case.bearing.bore).__name__,
            "grooves": str(grooves),
            "pockets": str(len(case.bearing.feeds) - grooves),
            "friction_factor": f"{case.friction_factor:g}",
            "turbulence": case.turbulence.name if case.turbulence is not None else "laminar",
            "pressure_viscosity": case.pressure_viscosity.law.value
            if case.pressure_viscosity is not None
            else "none",
        }
    )


def _flows_given(case: FilmCase) -> bool:
    common = case.oil_supply is not None and case.oil_supply.flow is not None
    return common or any(feed.flow for feed in case.bearing.feeds)
