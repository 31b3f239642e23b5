"""From a bearing, as the engineer wrote it, to the case of its film."""

from __future__ import annotations

from babbitt.case.parts.turbulence import LAWS_OF_TURBULENCE
from babbitt.kinds.journal.case.as_given import words_of
from babbitt.kinds.journal.case.assumptions import common_assumptions_of
from babbitt.kinds.journal.case.film_heat_cases import fuller_heat_model, heat_assumptions, heat_model
from babbitt.kinds.journal.case.film_layout import film_layout
from babbitt.kinds.journal.case.joined_inputs import (
    Inputs,
    Point,
    clearance_limits,
    duty,
    expansions,
    housing_cooling,
    journal_speed,
    oil_supply,
)
from babbitt.kinds.journal.case.mixed_friction import asperities_of
from babbitt.kinds.journal.case.warnings import warnings_about_numbers
from babbitt.kinds.journal.film.bore import RoundBore
from babbitt.kinds.journal.film.model import Accuracy, FeedSize, FilmBearing, FilmCase, Search
from babbitt.properties.materials import LoadCharacter
from babbitt.reynolds.model import Cavitation


def film_case(inputs: Inputs, at: Point, thermal: str | None = None) -> FilmCase:
    """Film case of one bearing at one operating point and clearance.

    Parameters
    ----------
    inputs : Inputs
    at : Point
    thermal : str, optional
        ``global``, ``adiabatic`` or ``full`` in place of what the case says.
    """
    bearing, point = inputs.bearing, at.given
    speed = journal_speed(bearing, point)
    asperities = (
        None
        if bearing.mixed_friction is None or thermal not in (None, "global")
        else asperities_of(bearing.mixed_friction, bearing.surfaces, inputs.materials)
    )
    layout = film_layout(bearing, point, inputs.width, 1.0 if speed >= 0.0 else -1.0)
    of_film = _film_bearing(inputs, at, layout.feeds)
    return FilmCase(
        name=at.name,
        bearing=of_film,
        duty=duty(inputs, point),
        journal_speed=speed,
        lubricant=inputs.lubricant,
        oil_supply=oil_supply(inputs, point),
        cooling=housing_cooling(inputs),
        bearing_speed=bearing.bearing_speed,
        load_angle=bearing.load_angle,
        cavitation=Cavitation[bearing.cavitation.upper()],
        cavitation_pressure=bearing.cavitation_pressure,
        accuracy=Accuracy(bearing.accuracy),
        effective_temperature=bearing.effective_temperature if thermal is None else None,
        friction_factor=bearing.friction.factor,
        rotor_mass=bearing.rotor_mass,
        shaft_stiffness=bearing.shaft_stiffness,
        error_estimate=bearing.error_estimate,
        limiting_speeds=bearing.limiting_speeds,
        changing_load=bearing.dynamic_load.changing_load() if bearing.dynamic_load is not None else None,
        moving_mass=bearing.dynamic_load.moving_mass if bearing.dynamic_load is not None else 0.0,
        search=Search[bearing.equilibria.upper()],
        tilt_coefficients=bearing.tilt_coefficients,
        limits=bearing.limits.limits(),
        given=words_of(bearing, point, at.clearance_case, inputs.cooling, inputs.materials),
        assumptions=(
            *inputs.shared_assumptions,
            *bearing.assumptions,
            *layout.assumptions,
            *common_assumptions_of(bearing, inputs.supply, inputs.cooling, inputs.materials),
            *heat_assumptions(inputs, thermal),
            *(asperities.assumptions if asperities is not None else ()),
        ),
        warnings=(
            *layout.warnings,
            *(inputs.turned_supply if layout.by_element else ()),
            *warnings_about_numbers(inputs, point),
        ),
        kind=bearing.kind,
        clearance_limits=clearance_limits(inputs, at),
        turbulence=LAWS_OF_TURBULENCE[bearing.turbulence],
        pressure_viscosity=bearing.pressure_viscosity.law() if bearing.pressure_viscosity is not None else None,
        heat=heat_model(inputs, thermal),
        fuller=fuller_heat_model(inputs, point, thermal),
        asperities=asperities.contact if asperities is not None else None,
    )


def _film_bearing(inputs: Inputs, at: Point, feeds: tuple[FeedSize, ...]) -> FilmBearing:
    bearing, materials = inputs.bearing, inputs.materials
    of_bearing, of_journal = expansions(inputs)
    given, slope = bearing.misalignment, bearing.slope_of_shaft
    return FilmBearing(
        diameter=bearing.diameter,
        width=inputs.width,
        relative_clearance=at.clearance,
        expansion_bearing=of_bearing,
        expansion_journal=of_journal,
        feeds=feeds,
        bore=bearing.bore.bore() if bearing.bore is not None else RoundBore(),
        film_start=bearing.film_starts(),
        misalignment=slope if given is None else (given.x + slope[0], given.y + slope[1]),
        steps=tuple(step.step() for step in bearing.steps),
        crowning=bearing.crowning.crowning(inputs.width) if bearing.crowning is not None else (),
        displacement=bearing.displacement.field(inputs.width) if bearing.displacement is not None else (),
        displacement_start=bearing.displacement.start if bearing.displacement is not None else 0.0,
        own_form=bearing.displacement.form or "" if bearing.displacement is not None else "",
        compliance=tuple(part.compliance(bearing.diameter) for part in bearing.compliance),
        side_pressures=bearing.side_pressures or (0.0, 0.0),
        surfaces=bearing.surfaces.surfaces() if bearing.surfaces is not None else None,
        metal=materials.metal(),
        load_character=LoadCharacter(materials.load_character or LoadCharacter.CALM),
        clearance_tolerance=at.tolerance,
        mean_clearance=at.mean,
    )
