"""Supply of a machine and of its bearings: what a bearing gives takes the place of what the machine gives."""

from __future__ import annotations

import pytest

from babbitt.case import CaseError, case_from_dict
from babbitt.case.variation import case_variation
from babbitt.core.notices import InputError


@pytest.mark.parametrize(
    ("machine", "own", "wanted"),
    [
        ({"pressure": "0.2 MPa"}, {"flow": "0.3 L/min"}, (0.0, 0.3 / 6e4)),
        ({"flow": "0.3 L/min"}, {"pressure": "0.2 MPa"}, (2e5, None)),
        ({"pressure": "0.2 MPa"}, {"temperature": "50 degC"}, (2e5, None)),
    ],
)
def test_pressure_or_flow_of_a_bearing_replaces_both_of_its_machine(machine, own, wanted):
    bearing = {
        "kind": "journal", "name": "A", "method": "film", "diameter": "100 mm", "width": "50 mm",
        "clearance": {"kind": "relative", "mean": "1.2 permille"}, "load": "6 kN", "speed": "2000 rpm",
        "grooves": [{"angle": "90 deg", "extent": "20 deg"}], "supply": own,
    }  # fmt: skip
    case = case_from_dict(
        {
            "kind": "machine", "name": "M", "lubricant": "ISO VG 46", "bearings": [bearing],
            "materials": {"bearing": "C10", "journal": "C45"}, "supply": {"temperature": "45 degC"} | machine,
        }
    )  # fmt: skip
    (found,) = case.problems()
    assert (found.oil_supply.pressure, found.oil_supply.flow) == pytest.approx(wanted)


@pytest.mark.parametrize(
    ("path", "instead"),
    [("speed", "operating_points.0.speed"), ("supply.temperature", "operating_points.0.supply_temperature")],
)
def test_a_field_that_every_operating_point_overrides_is_not_varied(path, instead, tmp_path):
    file = tmp_path / "points.yaml"
    file.write_text(
        "kind: journal\nname: J\ndiameter: 120 mm\nwidth: 60 mm\nclearance: {kind: relative, mean: 1.2 permille}\n"
        "span: 360 deg\nlubricant: ISO VG 46\nsupply: {temperature: 45 degC, pressure: 0.2 MPa}\n"
        "supply_element: {kind: groove_180, width: 5 mm}\nmaterials: {bearing: C10, journal: C45}\nload: 12 kN\n"
        "operating_points:\n  - {name: a, speed: 1000 rpm, supply_temperature: 40 degC}\n"
    )
    varied = {"speed": "2000 rpm", "supply.temperature": "50 degC"}[path]
    with pytest.raises(InputError, match=instead):
        case_variation(file, path).case(varied)
    assert case_variation(file, "load").case("10 kN") is not None


@pytest.mark.parametrize(
    ("path", "value", "own", "instead"),
    [
        ("supply.temperature", "50 degC", "supply: {temperature: 45 degC}", "bearings.1.supply.temperature"),
        ("supply.pressure", "0.3 MPa", "method: film, supply: {flow: 1 L/min}", "bearings.0.supply.pressure"),
        ("lubricant", "ISO VG 32", "lubricant: ISO VG 68", "bearings.0.lubricant"),
        (
            "supply.temperature",
            "50 degC",
            "operating_points: [{name: a, supply_temperature: 40 degC}]",
            "bearings.1.operating_points.0.supply_temperature",
        ),
        (
            "bearings.0.supply_element.width",
            "4 mm",
            "operating_points: [{name: a, supply_element: {kind: groove_180, width: 6 mm}}]",
            "bearings.0.operating_points.0.supply_element",
        ),
    ],
)
def test_a_field_of_a_machine_that_every_bearing_overrides_is_not_varied(path, value, own, instead, tmp_path):
    rest = (
        "span: 180 deg, diameter: 120 mm, width: 60 mm, load: 6 kN, speed: 1000 rpm, "
        "clearance: {kind: relative, mean: 1.2 permille}, supply_element: {kind: groove_180, width: 5 mm}"
    )
    file = tmp_path / "machine.yaml"
    shared = (
        "kind: machine\nname: M\nlubricant: ISO VG 46\nmaterials: {bearing: C10, journal: C45}\n"
        "supply: {temperature: 45 degC, pressure: 0.2 MPa}\nbearings:\n"
    )
    first = f"  - {{kind: journal, name: A, {rest}, {own}}}\n"
    file.write_text(f"{shared}{first}  - {{kind: journal, name: B, {rest}, {own}}}\n")
    with pytest.raises(InputError, match=instead):
        case_variation(file, path).case(value)
    file.write_text(f"{shared}{first.replace(own, '')}  - {{kind: journal, name: B, {rest}, {own}}}\n")
    assert case_variation(file, path).case(value) is not None


COOLED = {
    "kind": "journal", "name": "A", "diameter": "100 mm", "width": "50 mm", "span": "360 deg",
    "clearance": {"kind": "relative", "mean": "1.2 permille"}, "load": "2 kN", "speed": "300 rpm",
    "lubricant": "ISO VG 46", "materials": {"bearing": "C10", "journal": "C45"},
    "cooling": {"surface": "0.3 m2", "ambient_temperature": "20 degC"},
}  # fmt: skip


@pytest.mark.parametrize("method", ["iso7902", "film"])
@pytest.mark.parametrize(
    ("field", "value"),
    [("supply_temperature", "40 degC"), ("supply_pressure", "0.2 MPa"), ("supply_flow", "1 L/min")],
)
def test_an_operating_point_changes_no_supply_that_there_is_not(method, field, value):
    points = [{"name": "cold"}, {"name": "fed", field: value}]
    with pytest.raises(CaseError, match=rf"{field}.*there is none"):
        case_from_dict(COOLED | {"method": method, "operating_points": points})


def test_operating_points_may_give_the_whole_supply():
    points = [{"name": "fed", "supply_temperature": "40 degC", "supply_pressure": "0.2 MPa"}]
    (design,) = case_from_dict(COOLED | {"supply": {}, "operating_points": points}).problems()
    assert (design.oil_supply.temperature, design.oil_supply.pressure) == pytest.approx((313.15, 2e5))


@pytest.mark.parametrize("field", [{"supply_pressure": "0.3 MPa"}, {"supply_flow": "2 L/min"}])
def test_a_film_of_one_dimension_tells_that_no_pressure_or_flow_drives_it(field):
    fed = {name: value for name, value in COOLED.items() if name != "cooling"}
    fed |= {"method": "long_film", "supply": {"temperature": "45 degC"}}
    plain, driven = case_from_dict(
        fed | {"operating_points": [{"name": "plain"}, {"name": "driven"} | field]}
    ).problems()
    told = "pressure, flow and element are ignored"
    assert not any(told in said for said in plain.assumptions)
    assert any(told in said for said in driven.assumptions)
