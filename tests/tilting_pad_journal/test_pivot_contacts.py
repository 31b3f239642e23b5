"""Pressure in the contacts of pivots, and the Reynolds number at both clearances."""

import pytest
from pad_journals import OIL, result_of

from babbitt.kinds.tilting_pad_journal.report.tables import tables
from babbitt.reynolds.tilting_pads.pivots import YIELD, PointContact

POINT = {"kind": "point", "pivot_radius": "100 mm", "housing_radius": "110 mm"}
ISOTHERMAL = {"thermal": "isothermal", "lubricant": OIL}


def told(result, code):
    return [one for one in result.warnings if one.code == code]


def test_a_result_has_the_pressure_of_every_contact():
    result = result_of({"pads.pivot": POINT}, **ISOTHERMAL)
    (loads,), (pressures,) = result.arrays["pad_load"], result.arrays["pivot_contact_pressure"]
    law = PointContact(0.1, 0.11)
    assert pressures == pytest.approx([law.contact_pressure(load) for load in loads])
    assert result.values["largest_contact_pressure"] == max(pressures)
    assert "pivot_contact_pressure" not in result_of({"pads.pivot": {"kind": "rocker"}}, **ISOTHERMAL).arrays


@pytest.mark.parametrize("over", [0.98, 1.02])
def test_a_pivot_yields_from_1_6_times_its_yield_strength_on(over):
    """A load that brings p_0 just below that, or just above; p_0 ~ P^(1/3) tells which, but for the other pads."""
    pivot = POINT | {"housing_radius": "400 mm", "pivot_radius": "60 mm"}
    load, wanted = 10.0, over * 1.6 * YIELD
    for _ in range(9):
        found = result_of({"pads.pivot": pivot}, **ISOTHERMAL | {"load": f"{load} kN"})
        reached = found.values["largest_contact_pressure"]
        load *= (wanted / reached) ** 3
    assert bool(told(found, "W418")) == (reached > 1.6 * YIELD)
    assert reached == pytest.approx(wanted, rel=0.01)


@pytest.mark.parametrize("strength", [900.0, 1100.0])
def test_a_pivot_yields_at_the_strength_that_is_given(strength):
    """p_0 at yield is proportional to it; the film does not depend on it."""
    pivot = POINT | {"housing_radius": "400 mm", "pivot_radius": "60 mm"}
    assumed, given = (
        result_of({"pads.pivot": pivot | own}, **ISOTHERMAL | {"load": "80 kN"})
        for own in ({}, {"yield_strength": f"{strength} MPa"})
    )
    (notice, *_) = told(assumed, "W418")
    assert notice.values["bearable"] == pytest.approx(1.6 * 650e6)
    reached = given.values["largest_contact_pressure"]
    assert reached == assumed.values["largest_contact_pressure"]
    notices = told(given, "W418")
    assert bool(notices) == (reached > 1.6e6 * strength)
    assert all(one.values["bearable"] == pytest.approx(1.6e6 * strength) for one in notices)


def test_contacts_of_rockers_are_listed_as_not_checked():
    for pivot, listed in (({"kind": "rocker"}, True), (POINT, False)):
        result = result_of({"pads.pivot": pivot}, **ISOTHERMAL)
        assert ("C409" in [one.code for one in result.not_checked]) is listed


@pytest.mark.parametrize(("pivot", "columns"), [(POINT, 4), ({"kind": "rocker"}, 3)])
def test_the_note_below_the_pivots_names_what_its_columns_show(pivot, columns):
    result = result_of({"pads.pivot": pivot}, **ISOTHERMAL)
    (table,) = (one for one in tables(result) if one["title"] == "Pivots")
    assert len(table["columns"]) == 1 + columns
    assert table["note"].count(",") == columns - 1
    assert ("pressure" in table["note"]) == ("pivot_contact_pressure" in result.arrays)


def test_the_reynolds_number_is_given_at_both_clearances():
    thin = OIL | {"dynamic_viscosity": "1 mPa s"}
    fast = result_of(lubricant=thin, thermal="isothermal", speed="20000 rpm", load="3 kN")
    (notice,) = told(fast, "W407")
    values = notice.values
    assert values["preload"] == pytest.approx(0.47)
    assert values["at_assembled"] == pytest.approx(0.53 * values["film_reynolds_number"])
    assert values["assembled"] == pytest.approx(0.53 * values["machined"])
    assert values["critical_assembled"] == pytest.approx(41.3 * (0.05 / values["assembled"]) ** 0.5)


def test_what_of_a_contact_is_taken_as_of_steel_is_said():
    """All of it where nothing is given, and what is left; nothing of rockers and of contacts given whole."""
    line = {"kind": "line", "pivot_radius": "60 mm", "housing_radius": "62 mm", "depth": "20 mm",
            "housing_depth": "20 mm"}  # fmt: skip
    steel = {"elastic_modulus": "210 GPa", "poisson_ratio": 0.3}
    given = steel | {f"housing_{name}": value for name, value in steel.items()}
    for pivot, said in (
        (line, "housing of 210 GPa"),
        (line, "yield strength 650 MPa (42CrMo4, quenched and tempered)"),
        (line | given, "as of steel: yield strength 650 MPa"),
        (line | given | {"yield_strength": "800 MPa"}, ""),
        ({"kind": "rocker"}, ""),
    ):
        told_of = [one for one in result_of({"pads.pivot": pivot}, **ISOTHERMAL).assumptions if "Contacts" in one]
        assert len(told_of) == bool(said)
        assert said in "".join(told_of)
