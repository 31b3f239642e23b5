"""The rules for what is given in Python, each with what would go wrong without it."""

from __future__ import annotations

import enum
import inspect
import math
import pickle
import pkgutil
import subprocess
import sys
from importlib import import_module

import numpy as np
import pint
import pytest

import babbitt
import babbitt as bb
from babbitt import case as case_language
from babbitt import solving
from babbitt.case import case_hash
from babbitt.case.part import Part
from babbitt.case.problems import Problem
from babbitt.core.notices import InputError
from babbitt.core.picklable_error import PicklableError

GIVEN = {
    "diameter": "100 mm",
    "width": "50 mm",
    "clearance": "H7/e8",
    "span": "360 deg",
    "load": "10 kN",
    "speed": "1500 rpm",
    "lubricant": "ISO VG 46",
    "supply": {"temperature": "50 degC", "pressure": "0.1 MPa"},
    "materials": {"bearing": "C10", "journal": "C45"},
}


@pytest.fixture(scope="module")
def bearing():
    return bb.JournalBearing(**GIVEN)


def own_registry():
    registry = pint.UnitRegistry(system="imperial")
    registry.define("dalton_weight = 250 newton")
    return registry


REGISTRY = own_registry()


@pytest.mark.parametrize(
    ("width", "exact"),
    [
        (0.05, True),
        (np.float64(0.05), True),
        (np.array(0.05), True),
        (np.float32(0.05), False),
        (pint.Quantity(50, "mm"), True),
        (REGISTRY.Quantity(np.float64(50.0), "millimeter"), True),
        (REGISTRY.Quantity(50.0, "mm").to("inch"), False),  # the nearest number of inches is not 50 mm
    ],
    ids=str,
)
def test_a_quantity_is_a_number_in_si_or_has_a_unit(bearing, width, exact):
    made = bearing.replace(width=width)
    assert made.width == pytest.approx(0.05, rel=1e-7)
    assert (made == bearing) is exact


def test_whole_numbers_of_numpy_are_numbers(bearing):
    assert bearing.replace(load=np.int32(10_000)) == bearing
    assert bearing.replace(load=10_000) == bearing


def test_a_unit_that_only_its_registry_knows_is_converted(bearing):
    assert bearing.replace(load=REGISTRY.Quantity(40, "dalton_weight")).load == pytest.approx(10e3, rel=1e-14)


def test_a_quantity_of_another_kind_is_refused(bearing):
    with pytest.raises(bb.CaseError, match="is a mass"):
        bearing.replace(load=REGISTRY.Quantity(40, "kg"))


def test_temperatures_of_pint_have_their_offset(bearing):
    warm = bearing.replace({"supply.temperature": pint.Quantity(50, "degC")})
    assert warm.supply.temperature == bearing.supply.temperature == 323.15


def test_plain_numbers_are_si_angles_included(bearing):
    assert bearing.replace(speed=50.0 * math.pi).speed == pytest.approx(bearing.speed, rel=1e-15)
    assert bearing.replace(load_angle=0.5).load_angle == 0.5
    assert bearing.replace(span=math.pi).span == 180
    assert case_hash(case_language.parse_case(bearing.replace(span=math.pi).to_yaml())) == case_hash(
        bearing.replace(span="180 deg")
    )


@pytest.mark.parametrize("wrong", [math.nan, np.nan, np.float32("nan"), math.inf, np.array([1.0, np.nan])])
def test_what_is_not_finite_is_refused_wherever_it_stands(bearing, wrong):
    with pytest.raises(bb.CaseError, match="not a finite number"):
        bearing.replace(load=wrong)
    with pytest.raises(bb.CaseError, match="not a finite number"):
        bearing.replace({"supply.temperature": wrong})
    with pytest.raises(bb.CaseError, match="not a finite number"):
        bb.Lobes(preload=wrong)


@pytest.mark.parametrize(
    "changes",
    [
        {"load": -10e3},
        {"rotor_mass": -1.0},
        {"width": -0.05},
        {"lubricant": {"kind": "constant", "dynamic_viscosity": -0.02, "density": 870.0}},
        {"cavitation_pressure": "-2 MPa"},
        {"load": (0.0, -10e3)},
        {"load": [10e3]},
        {"load": True},
    ],
)
def test_impossible_values_are_refused(bearing, changes):
    with pytest.raises(bb.CaseError):
        bearing.replace(**changes)


class Cavitation(enum.Enum):
    REYNOLDS = "reynolds"
    MASS_CONSERVING = 2


def test_enumerations_take_their_spelling_or_a_member(bearing):
    film = bearing.replace(method="film")
    assert film.replace(cavitation=Cavitation.REYNOLDS).cavitation == "reynolds"
    assert film.replace(cavitation=Cavitation.MASS_CONSERVING).cavitation == "mass_conserving"
    for wrong in ("Reynolds ", "jfo", 1, None.__class__):
        with pytest.raises(bb.CaseError):
            film.replace(cavitation=wrong)


def test_unknown_fields_are_refused_with_the_nearest():
    with pytest.raises(bb.CaseError, match="did you mean 'diameter'"):
        bb.JournalBearing(diametr="100 mm")
    with pytest.raises(bb.CaseError, match="preload"):
        bb.Lobes(preloads=0.5)
    with pytest.raises(bb.CaseError, match="thermal"):
        bb.Film(thermals="global")


def test_all_that_is_wrong_is_told_at_once():
    with pytest.raises(bb.CaseError) as caught:
        bb.JournalBearing(diameter="100 kg", clearance="H7/zz", lubricant="ISO VG 47")
    assert {problem.field for problem in caught.value.problems} >= {"diameter", "lubricant"}


def test_parts_ask_for_what_they_need():
    with pytest.raises(bb.CaseError, match="preload: is missing"):
        bb.Lobes()
    assert bb.JournalBearing(bore={"kind": "lobes"}).missing[:3] == ("diameter", "clearance", "bore.preload")


def test_a_dict_does_in_place_of_a_part(bearing):
    assert bearing.replace(supply=bb.Supply(temperature="50 degC", pressure=0.1e6)) == bearing


def test_a_method_brings_its_options_and_takes_those_of_the_former(bearing):
    film = bearing.replace(method=bb.Film(thermal="adiabatic", accuracy="draft"))
    assert (film.method, film.thermal, film.accuracy) == ("film", "adiabatic", "draft")
    assert film.replace({"method.thermal": "global"}).thermal == "global"
    other = film.replace(method=bb.Film(cavitation="reynolds"))
    assert (other.thermal, other.accuracy, other.cavitation) == (None, "engineering", "reynolds")
    assert film.replace(method=bb.Iso7902()) == bearing
    with pytest.raises(bb.CaseError, match=r"thermal: is the former word for what method.thermal says"):
        bb.JournalBearing(method=bb.Film(thermal="global"), thermal="adiabatic")


def test_a_value_takes_the_place_of_what_says_the_same_otherwise(bearing):
    assert bearing.replace(specific_load="2 MPa").load is None
    assert bearing.replace(specific_load="2 MPa").replace(load="10 kN") == bearing
    assert bearing.replace(load=None).missing == ("load",)


def test_objects_keep_the_text_that_they_were_given(bearing):
    assert bearing.given["diameter"] == "100 mm"
    assert bearing.replace(load="10000 N").given["load"] == "10000 N"
    assert bearing.replace(load=1e4 / 3.0).load == 1e4 / 3.0
    assert case_language.parse_case(bearing.replace(load=1e4 / 3.0).to_yaml()).load == 1e4 / 3.0
    text = "# with a remark\n" + bearing.to_yaml()
    read = bb.parse_case(text)
    assert read.text == read.to_yaml() == text
    assert "remark" not in read.replace(load="12 kN").text
    assert "12 kN" in read.replace(load="12 kN").text


def test_a_copy_with_other_values_keeps_no_stale_text(bearing):
    read = bb.parse_case(bearing.to_yaml())
    unseen = read.model_copy(update={"load": 12e3})
    assert unseen == read.replace(load="12 kN")
    assert "12 kN" in unseen.to_yaml()
    assert unseen.solve().minimum_film_thickness == read.solve(load="12 kN").minimum_film_thickness
    plain = case_language.parse_case(bearing.to_yaml()).model_copy(update={"load": 12e3})
    assert plain.text == ""
    with pytest.raises(bb.CaseError):
        read.model_copy(update={"load": -5.0}).solve()


def test_a_copy_of_a_part_with_other_values_is_used_with_them(bearing):
    """It kept what it was given, and the bearing was made of that."""
    cool = bb.Supply(temperature="50 degC", pressure="0.1 MPa")
    warm = cool.model_copy(update={"temperature": 333.15})
    assert warm.given == {"temperature": "60 degC", "pressure": "0.1 MPa"}
    assert cool.given["temperature"] == "50 degC"
    assert bearing.replace(supply=warm) == bearing.replace({"supply.temperature": "60 degC"})
    unseen = bearing.model_copy(update={"supply": warm})
    assert "60 degC" in unseen.to_yaml()
    assert unseen.replace(load="11 kN").supply.temperature == 333.15
    assert bb.Supply(**warm.given) == warm
    for wrong in ({"temperature": math.nan}, {"pressure": -2e5}, {"temperature": "warm"}):
        with pytest.raises(bb.CaseError):
            bearing.replace(supply=cool.model_copy(update=wrong))
        with pytest.raises(bb.CaseError):
            bearing.model_copy(update={"supply": cool.model_copy(update=wrong)}).to_yaml()
    with pytest.raises(bb.CaseError, match="not a finite number"):
        bearing.model_copy(update={"width": math.nan}).to_yaml()


def test_a_bearing_lists_its_fields_and_what_it_can_do_and_nothing_of_pydantic(bearing):
    listed = dir(bearing)
    assert {"diameter", "load", "solve", "gradient", "replace", "missing", "to_yaml", "model_copy"} <= {*listed}
    assert not [name for name in listed if name.startswith(("_", "model_")) and name != "model_copy"]
    assert not {"model_dump", "schema", "construct", "parse_obj"} & {*listed}
    assert all(hasattr(bearing, name) for name in listed)


def test_a_copy_of_an_incomplete_case_knows_what_it_gained():
    bare = {name: value for name, value in GIVEN.items() if name not in ("load", "speed")}
    filled = bb.JournalBearing(**bare).model_copy(update={"load": 10e3, "speed": 50.0 * math.pi})
    assert filled.missing == ()
    assert filled.span == 360
    assert case_hash(case_language.parse_case(filled.to_yaml())) == case_hash(bb.JournalBearing(**GIVEN))


def test_objects_are_immutable_and_equal_by_content(bearing):
    with pytest.raises(AttributeError, match=r"load of a JournalBearing cannot be set; replace\(load=...\)"):
        bearing.load = 5.0
    with pytest.raises(AttributeError, match=r"loads of a JournalBearing cannot be set; replace\(field=...\)"):
        bearing.loads = 5.0
    with pytest.raises(AttributeError, match=r"load of a JournalBearing cannot be deleted; replace\(load="):
        del bearing.load
    for part, name in ((bearing.supply, "Supply"), (bb.Supply(temperature="50 degC"), "Supply")):
        says = rf"temperature of a {name} cannot be set; model_copy\(update={{'temperature': ...}}\)"
        with pytest.raises(AttributeError, match=says):
            part.temperature = 300.0
    with pytest.raises(AttributeError, match="cannot be set"):
        bb.Machine(bearings=[bearing]).bearings = ()
    bearing.given["load"] = "1 N"
    assert bearing.given["load"] == "10 kN"
    same = bb.JournalBearing(**GIVEN | {"diameter": 0.1})
    assert same == bearing
    assert len({same, bearing}) == 1
    assert bearing != bearing.replace(load="11 kN")
    assert bearing != "bearing"
    assert pickle.loads(pickle.dumps(bb.Lobes(preload=0.5))) == bb.Lobes(preload=0.5)


def test_a_missing_field_is_named_when_it_is_read():
    with pytest.raises(AttributeError, match="diameter is missing in this JournalBearing"):
        _ = bb.JournalBearing().diameter


def test_objects_are_shown_in_few_lines(bearing):
    assert repr(bb.Lobes(preload=0.5)) == "Lobes(preload=0.5)"
    long = bearing.replace(
        method="film", bore={"kind": "measured", "departures": [0.0] * 360}, notes="word " * 200, limits={}
    )
    for text in (repr(long), str(long), repr(bb.JournalBearing())):
        assert len(text.splitlines()) < 25
        assert max(map(len, text.splitlines())) < 130


def test_clearances_say_their_kind(bearing):
    assert bearing.replace(clearance=bb.fit("H7/e8")) == bearing
    diametral = bearing.replace(clearance=bb.diametral_clearance("130 um"))
    radial = bearing.replace(clearance=bb.radial_clearance("65 um"))
    assert radial.clearance.mean == bearing.replace(clearance=bb.radial_clearance(65e-6)).clearance.mean == 65e-6
    both = [one.clearance.at_20_degrees(one.diameter).mean for one in (radial, diametral)]
    assert both[0] == pytest.approx(both[1], rel=1e-15)
    assert bearing.replace(clearance=bb.relative_clearance("1.5 permille")).clearance.mean == 1.5e-3
    for bare in ("65 um", 65e-6):
        with pytest.raises(bb.CaseError):
            bearing.replace(clearance=bare)
    with pytest.raises(bb.CaseError, match="is a mass"):
        bb.radial_clearance("65 g")
    with pytest.raises(bb.CaseError, match="is no fit"):
        bb.fit("H7")


def test_a_refusal_of_a_method_is_a_case_error(bearing, monkeypatch):
    """What shows only when a problem is solved names its field, too."""

    def refusing(case, *given):
        raise InputError("E101", "load is beyond reach")

    assert bearing.check() is None
    monkeypatch.setattr(solving, "solve", refusing)
    with pytest.raises(bb.CaseError) as caught:
        bearing.solve()
    assert [problem.field for problem in caught.value.problems] == ["load"]


def test_what_cannot_be_balanced_or_compared_is_a_case_error():
    bearing = bb.parse_case(bb.template("thrust"))
    with pytest.raises(bb.CaseError, match=r"pads.pivot.radius: .* no tilt balances"):
        bearing.replace({"pads.pivot.radius": "250 mm"})
    with pytest.raises(bb.CaseError, match=r"nothing to compare|method"):
        bearing.compare()


def test_a_sweep_refuses_what_it_cannot_go_through(bearing):
    with pytest.raises(bb.CaseError, match="no values"):
        bearing.sweep({"load": 5.0})
    with pytest.raises(bb.CaseError, match="is not a field"):
        bearing.sweep({"loads": [5e3]})
    with pytest.raises(InputError, match="workers"):
        bearing.sweep({"load": [5e3]}, workers=0)
    with pytest.raises(bb.CaseError, match="3 bearings"):
        bearing.replace(clearance_cases="all").sweep({"load": [5e3]})


def all_errors():
    for module in pkgutil.walk_packages(babbitt.__path__, "babbitt."):
        if module.name.endswith("__main__"):
            continue
        for one in vars(import_module(module.name)).values():
            is_error = isinstance(one, type) and issubclass(one, Exception)
            if is_error and one.__module__ == module.name and not one.__name__.startswith("_"):
                yield one


def test_every_exception_that_takes_more_than_a_message_is_pickled_whole():
    """One that is not hangs the process pool in which it is raised."""
    found = {*all_errors()}
    assert len(found) > 15
    for one in found:
        own = "__init__" in vars(one) or any("__init__" in vars(base) for base in one.__mro__[:-3])
        takes_message = not own or [*inspect.signature(one.__init__).parameters] in (["self", "args", "kwargs"],)
        assert takes_message or issubclass(one, PicklableError), one


def test_exceptions_come_whole_out_of_a_pickle():
    problems = [Problem("a.yaml", 3, "load", "is missing")]
    for error in (bb.CaseError(problems), InputError("E005", "there is none")):
        copied = pickle.loads(pickle.dumps(error))
        assert type(copied) is type(error)
        assert str(copied) == str(error)
        assert vars(copied) == vars(error)


def test_parts_are_all_in_the_package_and_of_the_case_language():
    parts = [one for name in bb.__all__ if isinstance(one := getattr(bb, name), type) and issubclass(one, Part)]
    assert len(parts) > 90
    assert {*bb.__all__} <= {*dir(bb)}
    assert all(one.__doc__ for one in parts)


def test_the_package_is_light_to_import():
    """What is heavy loads where it is used; `import babbitt` itself loads next to nothing."""
    heavy = "{'numpy', 'numba', 'scipy', 'pydantic', 'pint', 'xarray', 'matplotlib', 'yaml'}"
    code = f"import sys, babbitt; dir(babbitt); print({heavy} & {{*sys.modules}})"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout == "set()\n"
