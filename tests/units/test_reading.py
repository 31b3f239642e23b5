"""Quantities are read as pint would read them, faster, and nothing else is read."""

import math
from decimal import Decimal, localcontext
from functools import partial

import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.core.units import KINDS, QuantityError, bare_number, read, reading, written
from babbitt.core.units.reading import _for_pint

REGISTRY = pint.UnitRegistry(autoconvert_offset_to_baseunit=True)
PAIRS = [(kind.unit, unit) for kind in KINDS.values() if kind.open_to_pint for unit in kind.everyday]
NOT_IN_PINT = {"1/°C", "Pas", "mPas", "rev", "C", "F", "ppm/K", "P", "mil", "mils", "gpm", "W/m2K"}
NOT_IN_PINT |= {"kp", "kilopond"}


@pytest.mark.parametrize(("si", "unit"), [pair for pair in PAIRS if pair[1] not in NOT_IN_PINT])
def test_everyday_factors_are_those_of_pint(si, unit):
    text = _for_pint(unit).replace("m2K", "m**2*K").replace("mK", "m*K").replace("kgK", "kg*K")
    expected = REGISTRY.Quantity(7.25, text.replace("/degC", "/delta_degC")).to(_for_pint(si)).magnitude
    assert read(f"7.25 {unit}", si) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("120 mm", "m", 0.12),
        ("120mm", "m", 0.12),
        ("  120   mm ", "m", 0.12),
        ("1.2e2 mm", "m", 0.12),
        ("0.12", "m", 0.12),
        ("−5 mm", "m", -0.005),
        ("12 µm", "m", 12e-6),
        ("12 μm", "m", 12e-6),
        ("12 um", "m", 12e-6),
        ("50 degC", "K", 323.15),
        ("50 °C", "K", 323.15),
        ("323 K", "K", 323.0),
        ("122 °F", "K", 323.15),
        ("3000 rpm", "rad/s", 100.0 * math.pi),
        ("3000 1/min", "rad/s", 100.0 * math.pi),
        ("3000 min⁻¹", "rad/s", 100.0 * math.pi),
        ("3000 min-1", "rad/s", 100.0 * math.pi),
        ("3000 U/min", "rad/s", 100.0 * math.pi),
        ("3000 r/min", "rad/s", 100.0 * math.pi),
        ("-3000 U/min", "rad/s", -100.0 * math.pi),
        ("50 Hz", "rad/s", 100.0 * math.pi),
        ("314 rad/s", "rad/s", 314.0),
        ("0.16 %", "1", 0.0016),
        ("1.6 ‰", "1", 0.0016),
        ("1.6 permille", "1", 0.0016),
        ("20 W/(m²·K)", "W/(m2 K)", 20.0),
        ("20 W/(m^2*K)", "W/(m2 K)", 20.0),
        ("20 W / (m**2 K)", "W/(m2 K)", 20.0),
        ("11e-6/K", "1/K", 11e-6),
        ("11e-6 1/K", "1/K", 11e-6),
        ("16 mPa s", "Pa s", 0.016),
        ("16 mPa·s", "Pa s", 0.016),
        ("10 furlong", "m", 2011.684),  # by pint
        ("3 kilopond", "N", 29.41995),
        ("1 L/hour", "m3/s", 1e-3 / 3600.0),
        ("1 gal/min", "m3/s", 231.0 * 0.0254**3 / 60.0),  # that of the US, 231 cubic inches
        ("2 tonne", "kg", 2000.0),
        ("3000 /min", "rad/s", 100.0 * math.pi),
        ("100 1/s", "frequency", 200.0 * math.pi),  # of a frequency it is no other than Hz
    ],
)
def test_ways_of_writing(text, unit, value):
    assert read(text, unit) == pytest.approx(value, rel=1e-6)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_a_bare_number_is_si(number):
    assert read(number, "m") == number
    assert read(repr(number), "m") == number


@pytest.mark.parametrize(
    ("unit", "one", "other", "ratio", "step"),
    [
        ("m", "m", "mm", "1000", "0"),
        ("m", "mm", "um", "1000", "0"),
        ("m", "ft", "in", "12", "0"),
        ("m", "mil", "um", "25.4", "0"),
        ("m", "in", "mm", "25.4", "0"),
        ("N", "kN", "N", "1000", "0"),
        ("Pa", "MPa", "bar", "10", "0"),
        ("m3/s", "m3/h", "L/h", "1000", "0"),
        ("m3/s", "L/s", "L/min", "60", "0"),
        ("rad/s", "Hz", "rpm", "60", "0"),
        ("rad", "turn", "deg", "360", "0"),
        ("K", "degC", "degF", "1.8", "32"),
    ],
)
@given(digits=st.integers(-99999, 99999), exponent=st.integers(-6, 2))
def test_one_quantity_in_two_units_is_one_number(unit, one, other, ratio, step, digits, exponent):
    """To the last digit: a search that turns on it goes the same way."""
    kind, number = KINDS[unit], Decimal(f"{digits}e{exponent}")
    assert kind.to_si(float(number), one) == kind.to_si(float(number * Decimal(ratio) + Decimal(step)), other)


def test_reading_does_not_depend_on_how_the_program_around_it_reckons():
    with localcontext(prec=5):
        assert KINDS["m"].to_si(268.36123, "mm") == 0.26836123


@given(st.floats(1e-6, 1e6), st.sampled_from(PAIRS))
def test_written_is_read_back(number, pair):
    si, unit = pair
    value = KINDS[si].to_si(number, unit)
    if KINDS[si] is next(kind for kind in KINDS.values() if unit in kind.everyday):
        shown = written(value, unit)
        back = read(shown, si)
        assert back - KINDS[si].offsets.get(unit, 0.0) == pytest.approx(
            number * KINDS[si].everyday[unit], rel=1e-3
        )


@pytest.mark.parametrize(
    ("given", "unit", "words"),
    [
        ("120 kg", "m", ["'120 kg' is a mass", "a length such as '120 mm'"]),
        ("1 ounce", "m", ["is a mass"]),
        ("5 kg m3", "Pa", ["of another kind", "a pressure"]),
        ("150 %", "rad", ["a number without unit", "an angle"]),
        ("3 rad", "1", ["an angle", "without unit"]),
        ("3 mmm", "m", ["not known", "did you mean 'mm'?"]),
        ("80 mn", "m", ["not known", "did you mean 'mm'?"]),
        ("80 MM", "m", ["did you mean 'mm'?"]),
        ("80 q", "m", ["not known", "such as '120 mm'"]),
        ("1.2 permile", "1", ["did you mean 'permille'?"]),
        ("1 kn", "N", ["did you mean 'kN'?"]),
        ("300 1/s", "rad/s", ["ambiguous", "write 'rad/s', or 'rev/s' or 'rpm'"]),
        ("300 s-1", "rad/s", ["ambiguous", "'rad/s'"]),
        ("300 s⁻¹", "rad/s", ["ambiguous", "'rad/s'"]),
        ("300/s", "rad/s", ["ambiguous", "'rad/s'"]),
        ("2 ton", "kg", ["ambiguous", "'t' is the tonne"]),
        ("2 tons", "kg", ["ambiguous", "'t' is the tonne"]),
        ("0.9 ton/m3", "kg/m3", ["ambiguous", "'t' is the tonne"]),
        ("1,5 mm", "m", ["comma", "write '1.5 mm'"]),
        ("1,500 rpm", "rad/s", ["write '1500 rpm' if thousands are meant, or '1.5 rpm'"]),
        ("12,000 N", "N", ["write '12000 N' if thousands are meant, or '12 N'"]),
        ("1 500 mm", "m", ["grouped", "write '1500 mm'"]),
        ("1'500 mm", "m", ["write '1500 mm'"]),
        ("1_500 mm", "m", ["write '1500 mm'"]),
        ("nan", "m", ["not a quantity"]),
        ("inf m", "m", ["not a quantity"]),
        ("1e999 m", "m", ["not a finite number"]),
        (float("nan"), "m", ["nan is not a finite number"]),
        (-math.inf, "m", ["not a finite number"]),
        (10**400, "m", ["far too large"]),
        (True, "m", ["true is not a quantity"]),
        (None, "m", ["an empty value"]),
        ([1], "m", ["a list"]),
        ({}, "m", ["a mapping"]),
        ("", "m", ["'' is not a quantity"]),
        ("mm", "m", ["not a quantity"]),
        ("1 2 mm", "m", ["not a quantity"]),
        ("3 (m", "m", ["not known"]),
        ("3 \x1b[31mm", "m", ["?[31mm"]),
        ("9" * 5000 + " mm", "m", ["..."]),
    ],
)
def test_refusals(given, unit, words):
    with pytest.raises(QuantityError) as caught:
        read(given, unit)
    message = str(caught.value)
    assert all(word in message for word in words), message
    assert message.isprintable()
    assert len(message) < 250
    assert "pint" not in message


@pytest.mark.parametrize(
    ("given", "unit", "kind"),
    [("12 m/s", "rad/s", "m/s"), ("1 knot", "rad/s", "m/s"), ("1 kg m3", "m", None), ("1 mmm", "m", None)],
)
def test_a_refusal_knows_what_was_given_instead(given, unit, kind):
    with pytest.raises(QuantityError) as caught:
        read(given, unit)
    assert caught.value.given is (None if kind is None else KINDS[kind])


@pytest.mark.parametrize(
    ("given", "number"),
    [
        *[(3, 3.0), (2.5, 2.5), ("40", 40.0), ("1e3", 1000.0), ("40 N", None), (True, None), (None, None)],
        *[([1], None), ("x", None), (10**400, None)],
    ],
)
def test_bare_numbers(given, number):
    assert bare_number(given) == number


@pytest.mark.parametrize(
    "text",
    [
        "2**999999999 m",
        "3 m**999999999",
        "3 m**9**9**9",
        "3 m^99",
        "(1+1) m",
        "3 __import__('os')",
        "1 m" + "*m" * 500,
        "3 " + "((((" * 12 + "m",
        "1e9999999999 m",
        "0x10 m",
        "3 m;m",
        "3 {m}",
    ],
)
def test_expressions_are_not_evaluated(text, monkeypatch):
    """What is no number with a product of units is refused before pint sees it."""
    monkeypatch.setattr(reading, "pint_registry", lambda: pytest.fail("handed to pint"))
    with pytest.raises(QuantityError):
        read(text, "m")


@given(st.text(max_size=80), st.sampled_from(list(KINDS)))
def test_any_text_is_read_or_refused(text, unit):
    try:
        assert math.isfinite(read(text, unit))
    except QuantityError as error:
        assert str(error).isprintable()  # noqa: PT017


def test_a_quantity_with_an_everyday_unit_does_not_load_pint():
    import subprocess
    import sys

    program = (
        "import sys; from babbitt.core.units import read; read('120 mm', 'm'); assert 'pint' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", program], check=True)


def test_an_application_that_redefines_units_does_not_reach_us(request):
    own = pint.UnitRegistry()
    own.define("furlong = 1 * meter")
    request.addfinalizer(partial(pint.set_application_registry, pint.get_application_registry().get()))
    pint.set_application_registry(own)
    assert read("10 furlong", "m") == pytest.approx(2011.684, rel=1e-6)
