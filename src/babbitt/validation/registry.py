"""All published cases included."""

from __future__ import annotations

from babbitt.core.nearest_name import nearest_names
from babbitt.core.notices import InputError
from babbitt.validation.case import Evidence, ValidationCase
from babbitt.validation.published import (
    butenschoen_1976,
    closed_forms_din31652,
    fillon_1992,
    film_butenschoen_rotation,
    film_butenschoen_squeeze,
    film_characteristics,
    film_groove_pitch,
    film_heat,
    film_raimondi_boyd,
    fowell_2007,
    friswell_2010,
    grooved_segments,
    hydrostatic_pads,
    interpolation_study,
    long_film_figures,
    long_film_isothermal,
    long_film_table,
    lund_thomsen_1978,
    output_wheel_load_share,
    parabolic_slider,
    procedure_regression,
    raimondi_boyd_1958,
    recessed_journal,
    reverse_gear,
    reverse_gear_clearances,
    reverse_gear_spans,
    ross_five_pads,
    screw_heel_claims,
    screw_heel_states,
    short_bearing,
    size_short_bearing,
    someya_1989_table1,
    someya_1989_table3,
    someya_1989_table5,
    study_closed_forms,
    supply_losses,
    thrust_hydro_generator,
    thrust_pad_forms,
    trawler_stages,
    viscosity_index,
)

_CASES = (
    butenschoen_1976.CASE,
    raimondi_boyd_1958.CASE,
    short_bearing.CASE,
    size_short_bearing.CASE,
    study_closed_forms.CASE,
    closed_forms_din31652.CASE,
    interpolation_study.CASE,
    film_characteristics.CASE,
    film_butenschoen_rotation.CASE,
    film_butenschoen_squeeze.CASE,
    film_raimondi_boyd.CASE,
    film_heat.CASE,
    friswell_2010.CASE,
    lund_thomsen_1978.CASE,
    someya_1989_table1.CASE,
    someya_1989_table3.CASE,
    someya_1989_table5.CASE,
    ross_five_pads.CASE,
    fillon_1992.CASE,
    fowell_2007.CASE,
    parabolic_slider.CASE,
    long_film_isothermal.CASE,
    long_film_table.CASE,
    long_film_figures.CASE,
    grooved_segments.CASE,
    thrust_pad_forms.CASE,
    thrust_hydro_generator.CASE,
    trawler_stages.CASE,
    reverse_gear_spans.CASE,
    reverse_gear.CASE,
    reverse_gear_clearances.CASE,
    output_wheel_load_share.CASE,
    supply_losses.CASE,
    hydrostatic_pads.CASE,
    recessed_journal.CASE,
    viscosity_index.CASE,
    procedure_regression.CASE,
    screw_heel_states.CASE,
    screw_heel_claims.CASE,
    film_groove_pitch.CASE,
)


def cases() -> tuple[ValidationCase, ...]:
    """Every published case, from the film to the whole procedure."""
    return _CASES


def cases_of(evidence: Evidence) -> tuple[ValidationCase, ...]:
    """The published cases that are validations, or those that are reproductions."""
    return tuple(case for case in _CASES if case.evidence is evidence)


def validation_case(name: str) -> ValidationCase:
    """Find a published case by its name.

    Parameters
    ----------
    name : str

    Raises
    ------
    InputError
        E005 when there is no such case; the message names the nearest one, if one is near.

    Examples
    --------
    >>> validation_case("reverse_gear_spans").title
    'Marine reverse gear: five angular spans of the input pinion bearing'
    """
    by_name = {case.name: case for case in _CASES}
    if name in by_name:
        return by_name[name]
    near = nearest_names(name, by_name)
    hint = f"did you mean {near[0]!r}? " if near else ""
    raise InputError("E005", f"no validation case {name!r}; {hint}All: {', '.join(by_name)}")
