"""A number without unit is refused in a file wherever people vary the unit, in every kind of case."""

import json

import pytest
import yaml

from babbitt.case import CaseError, case_from_dict, kinds, parse_case, template
from babbitt.core.units import KINDS, SiField, read
from babbitt.core.units.reading import bare_number
from babbitt.kinds.journal.case.files import JournalCase

JOURNAL = {
    "kind": "journal",
    "name": "Test",
    "diameter": "80 mm",
    "width": "40 mm",
    "clearance": {"kind": "relative", "mean": "1.5 permille"},
    "span": "180 deg",
    "materials": {"bearing": "C10", "journal": "C45"},
    "lubricant": "ISO VG 46",
    "supply": {"temperature": "50 degC", "pressure": "0.2 MPa"},
    "load": "6 kN",
    "speed": "2000 rpm",
}


@pytest.mark.parametrize(
    ("field", "given", "words"),
    [
        ("speed", 3000, "speed: 3000 has no unit; allowed: 0.1 rpm to .* write '3000 rpm'"),
        ("speed", "3000", "speed: 3000 has no unit"),
        ("speed", -3e3, "speed: -3000 has no unit; .* write '-3000 rpm'"),
        ("load", 12000, "load: 12000 has no unit; .* write '12000 N' or '12000 kN'"),
        ("load", 999, "load: 999 has no unit; .* write '999 kN' or '999 N'"),
        ("load", 12, "load: 12 has no unit; .* write '12 kN' or '12 N'"),
        ("diameter", 2500, "diameter: 2500 has no unit; .* write '2500 mm'"),
        ("diameter", 0.08, "diameter: 0.08 has no unit"),
        ("span", 180, "span: 180 has no unit; allowed: 360 deg, .* write '180 deg'"),
        ("load_angle", -1.57, "load_angle: -1.57 has no unit"),
        ("effective_temperature", 0, "effective_temperature: 0 has no unit"),
        ("effective_temperature", 333, "effective_temperature: 333 has no unit; .* write '333 degF' or '333 K'"),
        ("rotor_mass", 2, "rotor_mass: 2 has no unit"),
        ("supply", {"temperature": 50, "pressure": "0.2 MPa"}, "supply.temperature: 50 has no unit"),
        ("supply", {"temperature": "50 degC", "pressure": 2e5}, "supply.pressure: 200000 .* write '200000 Pa'"),
        ("supply", {"temperature": "50 degC", "flow": 26}, "supply.flow: 26 has no unit; .* write '26 L/min'"),
        ("lubricant", {"name": "Own", "density": 870, "viscosity": 0.02}, "lubricant"),
    ],
)
def test_a_number_without_unit_is_refused(field, given, words):
    with pytest.raises(CaseError, match=words):
        case_from_dict(JOURNAL | {field: given})


@pytest.mark.parametrize(
    ("field", "zero"), [("load_angle", "0 deg"), ("bearing_speed", "0 rpm"), ("cavitation_pressure", "0 Pa")]
)
def test_zero_is_zero_in_any_unit(field, zero):
    assert case_from_dict(JOURNAL | {field: 0}) == case_from_dict(JOURNAL | {field: zero})


def test_where_all_write_one_unit_it_may_be_left_out():
    cooling = {"ambient_temperature": "20 degC", "surface": "0.3 m2"}
    bare, with_unit = (
        case_from_dict(JOURNAL | {"cooling": cooling | {"heat_transfer_coefficient": given}})
        for given in (20, "20 W/(m2 K)")
    )
    assert bare == with_unit


def test_python_speaks_si():
    """What a program builds from classes has no units to forget; a file that says the same is refused."""
    plain = parse_case(json.dumps(JOURNAL)).model_dump(exclude_defaults=True)
    plain["span"] = "180 deg"
    assert JournalCase(**plain).speed == pytest.approx(read("2000 rpm", "rad/s"))
    with pytest.raises(CaseError, match="has no unit"):
        case_from_dict(plain)


def test_fields_and_points_alike():
    with pytest.raises(CaseError, match=r"operating_points\[0 'fast'\].speed: 3000 has no unit"):
        case_from_dict(JOURNAL | {"operating_points": [{"name": "fast", "speed": 3000}]})


def _stripped(given, path=()):
    """Every way to leave out one unit of a case: path, and the case without it."""
    if isinstance(given, dict):
        pairs = list(given.items())
    elif isinstance(given, list):
        pairs = list(enumerate(given))
    else:
        words = given.split(" ", 1) if isinstance(given, str) else []
        if len(words) == 2 and bare_number(words[0]) and any(words[1] in kind.everyday for kind in KINDS.values()):
            yield path, float(words[0])
        return
    for key, value in pairs:
        for where, changed in _stripped(value, (*path, key)):
            made = given.copy()
            made[key] = changed
            yield where, made


@pytest.mark.parametrize("kind", kinds())
def test_no_kind_takes_a_quantity_without_its_unit(kind):
    """Each unit of a template in turn: what is still read belongs to a kind of quantity with one unit."""
    given = yaml.safe_load(template(kind))
    one_unit = {unit for one in KINDS.values() if one.one_unit for unit in one.everyday}
    tried = 0
    for path, changed in _stripped(given):
        place = given
        for step in path:
            place = place[step]
        if place.split(" ", 1)[1] in one_unit - {"K"}:
            continue
        tried += 1
        with pytest.raises(CaseError):
            case_from_dict(changed).problems()
    assert tried >= 5


def test_kinds_have_keys_of_their_own():
    """Two kinds under one key: the second would shadow the first in messages and units."""
    phrases = [kind.phrase for kind in KINDS.values()]
    assert len(set(phrases)) == len(phrases)
    assert all(SiField(key).kind.key == key for key in KINDS)
    with pytest.raises(ValueError, match="m/Pa"):
        _keyed_twice()


def _keyed_twice():
    from babbitt.core.units.kinds import keyed

    kind = KINDS["m/Pa"]
    return keyed((kind, kind))
