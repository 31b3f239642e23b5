"""Fields with a range: what lies outside is refused in the engineer's words."""

from typing import Annotated

import pytest
from pydantic import BaseModel, TypeAdapter, ValidationError

from babbitt.core import units
from babbitt.core.units import QuantityError, either_sense, si

DIAMETER = si("m", "1 mm", "3 m")


def test_bounds_are_allowed_themselves():
    assert DIAMETER("1 mm") == 0.001
    assert DIAMETER("3 m") == 3.0


@pytest.mark.parametrize(
    ("field", "given", "words"),
    [
        (DIAMETER, "2500", ["2500 has no unit", "1 mm to 3 m", "write '2500 mm'"]),
        (DIAMETER, "250", ["250 has no unit", "write '250 mm'"]),
        (DIAMETER, "4 m", ["'4 m' is too large", "1 mm to 3 m"]),
        (DIAMETER, "0.1 mm", ["'0.1 mm' is too small"]),
        (DIAMETER, 1e9, ["1 mm to 3 m"]),
        (si("K", "-30 degC", "200 degC"), "50", ["50 has no unit", "write '50 degC'"]),
        (si("rad", "-360 deg", "360 deg"), "150", ["150 has no unit", "write '150 deg'"]),
        (si("Pa", "1 kPa", "50 MPa"), "0.2", ["0.2 has no unit", "write '0.2 MPa'"]),
        (si("frequency", "1 Hz", "100 kHz"), "2", ["2 has no unit", "write '2 Hz'"]),
        (si("frequency", "1 Hz", "100 kHz"), "10 Pa", ["'10 Pa' is a pressure", "a frequency such as '100 Hz'"]),
        (si("frequency", "1 Hz", "100 kHz"), "10 hz", ["not known", "did you mean 'Hz'?"]),
        (si("1", "0.01", "0.99"), 1, ["1 is too large", "0.01 to 0.99"]),
        (si("1", "0.01 permille", "50 permille"), 1.2, ["1.2 is too large", "write '1.2 permille'"]),
        (either_sense("rad/s", "1 rpm", "900 rpm"), "-0.5 rpm", ["'-0.5 rpm' is too small", "with either sign"]),
        (either_sense("rad/s", "1 rpm", "900 rpm"), "-901 rpm", ["'-901 rpm' is too large"]),
        (either_sense("rad/s", "1 rpm", "900 rpm"), "-500", ["-500 has no unit", "write '-500 rpm'"]),
    ],
)
def test_what_lies_outside(field, given, words):
    with pytest.raises(QuantityError) as caught:
        field(given)
    assert all(word in str(caught.value) for word in words), caught.value


def test_either_sense():
    field = either_sense("m/s", "1 m/s", "10 m/s")
    assert [field(speed) for speed in ("1 m/s", "-1 m/s", -10.0)] == [1.0, -1.0, -10.0]
    assert not field.holds(0.0)


@pytest.mark.parametrize("given", [60, 500, 1e5])
def test_a_ratio_that_is_not_written_in_permille_gets_no_such_hint(given):
    with pytest.raises(QuantityError) as caught:
        si("1", "0.01", "0.99")(given)
    assert caught.value.hint == ""


def test_a_bare_number_is_not_guessed_when_no_unit_fits():
    with pytest.raises(QuantityError) as caught:
        DIAMETER(1e9)
    assert caught.value.hint == ""


def test_pydantic_gathers_the_refusals():
    class Bearing(BaseModel):
        diameter: Annotated[float, DIAMETER]
        load: units.Force

    assert Bearing(diameter="250 mm", load="4 kN").load == 4000.0
    with pytest.raises(ValidationError) as caught:
        Bearing(diameter="250 kg", load="4 mm")
    assert [error["loc"] for error in caught.value.errors()] == [("diameter",), ("load",)]


def test_schema_tells_number_or_text():
    ratio, angle = (
        TypeAdapter(Annotated[float, field]).json_schema()["anyOf"]
        for field in (si("1", "0.1", "1.5"), si("rad", "-90 deg", "90 deg"))
    )
    assert ratio == [{"type": "number", "minimum": 0.1, "maximum": 1.5}, {"type": "string"}]
    assert angle == [{"const": 0}, {"type": "string"}]
    schema = TypeAdapter(Annotated[float, DIAMETER]).json_schema()
    assert schema["anyOf"] == [{"type": "string"}]
    assert (schema["x-unit"], schema["x-allowed"], schema["x-example"]) == ("m", "1 mm to 3 m", "120 mm")


@pytest.mark.parametrize(
    ("kind", "text", "value"),
    [
        ("Length", "1 mm", 0.001),
        ("Area", "1 cm2", 1e-4),
        ("Volume", "1 L", 1e-3),
        ("Angle", "180 deg", 3.141592653589793),
        ("Mass", "1 t", 1000.0),
        ("Force", "1 kN", 1000.0),
        ("Pressure", "1 bar", 1e5),
        ("Temperature", "0 degC", 273.15),
        ("RotationalSpeed", "60 rpm", 6.283185307179586),
        ("Speed", "3.6 km/h", 1.0),
        ("Viscosity", "1 mPa s", 1e-3),
        ("KinematicViscosity", "1 cSt", 1e-6),
        ("Density", "1 g/cm3", 1000.0),
        ("FlowRate", "60 L/min", 1e-3),
        ("HeatTransferCoefficient", "20 W/(m2 K)", 20.0),
        ("ThermalExpansion", "11 um/(m K)", 11e-6),
        ("Dimensionless", "1 permille", 1e-3),
    ],
)
def test_types(kind, text, value):
    assert TypeAdapter(getattr(units, kind)).validate_python(text) == pytest.approx(value, rel=1e-12)
