"""Turbulence, viscosity under pressure and given supply flows, from the case to the answer."""

import math

import pytest
from film_bearings import answer, film, solved

from babbitt.core.result import Outcome
from babbitt.design.numbers import critical_reynolds_number
from babbitt.kinds.journal.film.layout import film_of, given_flows

FAST = {"diameter": "300 mm", "width": "180 mm", "load": "60 kN", "speed": "9000 rpm"}
COOL = {"effective_temperature": "60 degC"}
LITRE = 1e-3 / 60.0
FED = {"grooves": None, "pockets": [{"angle": "90 deg", "extent": "30 deg", "width": "80 mm", "flow": "5 L/min"}]}


def codes(result):
    return [notice.code for notice in result.warnings]


def test_laminar_unless_asked_and_told_where_it_is_not():
    laminar = answer(**FAST)
    assert "W101" in codes(laminar)
    assert "C110" in [check.code for check in laminar.checks]
    assert laminar.settings["turbulence"] == "laminar"
    assert "turbulent_share" not in laminar.values
    for law in ("ng_pan", "constantinescu"):
        turbulent = answer(**FAST, turbulence=law)
        assert "W101" not in codes(turbulent)
        assert "C110" not in [check.code for check in turbulent.checks]
        # the turbulent friction is in the heat balance
        assert turbulent.effective_temperature > laminar.effective_temperature + 10.0
        assert turbulent.heat_to_oil == pytest.approx(turbulent.friction_power, rel=1e-6)
        assert 0.85 < turbulent.turbulent_share < 0.9  # the lands: 320 of 360 degrees
        assert any("fully turbulent from 2 times" in said for said in turbulent.assumptions)


def test_turbulence_sets_in_at_the_critical_reynolds_number():
    made = film_of(film(turbulence="ng_pan"), 1.5e-3, 0.02, 0.0, 870.0)
    assert made.turbulence.onset == critical_reynolds_number(1.5e-3)
    assert made.turbulence.end == 2.0 * made.turbulence.onset
    assert made.turbulence.density == 870.0


def test_slow_film_is_laminar_whatever_is_asked():
    slow = {"speed": "300 rpm", **COOL}
    # the same grid of nodes for both: the laws differ by nothing
    laminar, asked = answer(**slow), answer(**slow, turbulence="ng_pan")
    assert asked.turbulent_share == 0.0
    assert asked.friction_power == pytest.approx(laminar.friction_power, rel=2e-3)


def test_pressure_thickens_the_oil():
    heavy = {"load": "200 kN", **COOL}
    plain = answer(**heavy)
    barus, roelands = (
        answer(**heavy, pressure_viscosity={"kind": kind, "coefficient": "20 1/GPa"})
        for kind in ("barus", "roelands")
    )
    assert plain.minimum_film_thickness < roelands.minimum_film_thickness < barus.minimum_film_thickness
    assert barus.minimum_film_thickness < 1.3 * plain.minimum_film_thickness
    assert barus.settings["pressure_viscosity"] == "barus"


def test_flow_of_the_supply_that_suffices_leaves_a_surplus():
    found = answer(supply={"temperature": "45 degC", "flow": "100 L/min"})
    assert "W140" not in codes(found)
    assert found.least_fill == 1.0
    assert found.given_flow == pytest.approx(100.0 * LITRE)
    assert found.surplus_flow == pytest.approx(found.given_flow - found.total_flow, rel=1e-6)
    assert "supply_pressure" not in found.values
    ambient = answer(supply={"temperature": "45 degC", "pressure": "1 kPa"})
    assert found.minimum_film_thickness == pytest.approx(ambient.minimum_film_thickness, rel=1e-2)


@pytest.mark.parametrize("speed", ["3000 rpm", "-3000 rpm"])
def test_too_little_flow_starves_the_film(speed):
    flooded, starved = (answer(supply={"temperature": "45 degC", "flow": flow}, speed=speed, **COOL)
                        for flow in ("100 L/min", "4 L/min"))  # fmt: skip
    assert "W140" in codes(starved)
    assert starved.total_flow == pytest.approx(4.0 * LITRE, rel=1e-8)
    assert starved.surplus_flow == pytest.approx(0.0, abs=1e-12)
    assert starved.arrays["supply_fill"] == ((starved.least_fill,) * 2,)
    assert starved.least_fill < 1.0
    assert starved.full_film_share < flooded.full_film_share
    assert starved.minimum_film_thickness < flooded.minimum_film_thickness


def test_heat_balance_of_a_starved_film():
    """All friction heat leaves with the little oil that is given."""
    found = answer(**FED)
    assert found.total_flow == pytest.approx(5.0 * LITRE, rel=1e-8)
    carried = found.volumetric_heat_capacity * found.total_flow
    assert carried * (found.outlet_temperature - found.supply_temperature) == pytest.approx(
        found.friction_power, rel=1e-6
    )


def test_flows_find_their_supplies():
    """Numbers in the order of the film, whatever the order in the case and the sense of rotation."""
    grooves = [
        {"angle": "200 deg", "extent": "10 deg", "flow": "3 L/min"},
        {"angle": "-40 deg", "extent": "10 deg"},
        {"angle": "80 deg", "extent": "10 deg", "flow": "1 L/min"},
    ]
    for speed in ("3000 rpm", "-3000 rpm"):
        case = film(grooves=grooves, speed=speed, supply={"temperature": "45 degC", "flow": "2 L/min"})
        made = film_of(case, 1.5e-3, 0.02, 0.0)
        flows = {given.members[0]: given.flow / LITRE for given in given_flows(case, made)}
        order = [made.lands[land].end_angle for land in made.land_order]  # each groove lies behind its land
        for place, end in enumerate(order):
            middle = (math.degrees(end) + 5.0) % 360.0
            assert flows[place] == pytest.approx({200.0: 3.0, 320.0: 2.0, 80.0: 1.0}[round(middle)])


def test_pressure_of_one_beside_the_flow_of_another():
    grooves = [
        {"angle": "0 deg", "extent": "20 deg", "flow": "0.5 L/min"},
        {"angle": "180 deg", "extent": "20 deg"},
    ]
    found = answer(grooves=grooves, **COOL)
    assert found.given_flow == pytest.approx(0.5 * LITRE)
    (fills,) = found.arrays["supply_fill"]
    assert fills[0] < 1.0 == fills[1]
    assert found.supply_pressure == pytest.approx(0.15e6)


def test_no_film_for_want_of_oil_is_told_with_what_would_do():
    (found,) = solved(**FED | {"pockets": [FED["pockets"][0] | {"flow": "0.0001 L/min"}]}, **COOL).results
    assert found.outcome is Outcome.OVERLOADED
    assert "the oil given is too little" in found.message
    assert "L/min" in found.message


def test_flow_at_an_operating_point_replaces_the_pressure():
    points = [{"name": "full"}, {"name": "pump worn", "supply_flow": "4 L/min"}]
    full, worn = solved(operating_points=points, **COOL).results
    assert "given_flow" not in full.values
    assert worn.given_flow == pytest.approx(4.0 * LITRE)
    assert "W140" in codes(worn)


def test_cavitation_pressure_holds_the_film_together():
    """A film that bears suction is full farther on; no pressure falls below what the case gives."""
    plain, deep = (answer(**FED | {"pockets": [{"angle": "90 deg", "extent": "30 deg", "width": "80 mm"}]}, **COOL,
                          cavitation_pressure=pressure) for pressure in ("0 Pa", "-60 kPa"))  # fmt: skip
    assert deep.minimum_film_thickness != plain.minimum_film_thickness
    made = film_of(film(cavitation_pressure="-60 kPa"), 1.5e-3, 0.02, 0.0)
    assert made.cavitation_pressure == -60e3
