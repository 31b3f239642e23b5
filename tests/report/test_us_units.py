"""Tables and reports in US units: one partner a unit of the SI, of the right size, and JSON as it was."""

import math
import re

import pint
import pytest

from babbitt.core.quantities import QUANTITIES, displayed_in
from babbitt.core.quantities.display import SI, US

REGISTRY = pint.UnitRegistry(autoconvert_offset_to_baseunit=True)
REGISTRY.define("cSt_ = 1e-6 m**2/s")
IN_PINT = {
    "mil": "thou", "lbf ft": "lbf*ft", "hp": "hp", "gpm": "gallon/min", "cSt": "cSt_", "in³/s": "in**3/s",
    "lb/ft³": "lb/ft**3", "Btu/(ft³ °F)": "Btu_it/ft**3/delta_degF", "1e-6/°F": "1e-6/delta_degF",
    "lbf s/in": "lbf*s/in", "psi ft/s": "psi*ft/s", "lbf ft/rad": "lbf*ft", "lbf ft/mrad": "1e3*lbf*ft",
    "lbf ft s/rad": "lbf*ft*s", "in²": "in**2", "mil/in": "1e-3", "Mpsi": "1e6*psi",
    "in": "inch", "°F": "delta_degF", "Btu/(lb °F)": "Btu_it/lb/delta_degF",
}  # fmt: skip
COHERENT = {
    "mm": "m", "um": "m", "um2": "m", "MPa": "Pa", "MPa3": "Pa", "kPa": "Pa", "GPa": "Pa", "degC": "kelvin",
    "K": "kelvin", "kN": "N", "N": "N", "Nm": "N*m", "kNm": "N*m", "kW": "W", "W": "W", "L/min": "m**3/s",
    "mm3/s": "m**3/s", "mPas": "Pa*s", "mm2/s": "m**2/s", "m/s": "m/s", "mm/s": "m/s", "kg/m3": "kg/m**3",
    "MJ/m3K": "J/m**3/kelvin", "pv": "Pa*m/s", "1e-6/K": "1/kelvin", "t": "kg", "kg": "kg", "N/um": "N/m",
    "MN/m": "N/m", "GN/m": "N/m", "kN/m": "N/m", "kNs/m": "N*s/m", "MNs/m": "N*s/m", "Ns/m": "N*s/m",
    "kNm/rad": "N*m", "kNm/mrad": "N*m", "Nms/rad": "N*m*s", "cm2": "m**2", "mrad": "1",
    "J/kgK": "J/kg/kelvin",
}  # fmt: skip
ALIKE = {"", "balance", "count", "percent", "permille", "rpm", "rpm2", "deg", "s", "Hz", "%", "urad"}


def test_every_unit_is_of_the_us_or_alike_in_both():
    assert set(US) | ALIKE == set(SI)
    assert not set(US) & ALIKE


@pytest.mark.parametrize("name", US)
def test_a_partner_has_the_size_that_pint_gives(name):
    shown = US[name]
    one = REGISTRY.parse_expression(IN_PINT.get(shown.label, shown.label))
    size = REGISTRY.Quantity(1.0, "dimensionless") * one
    assert 1.0 / size.to(COHERENT[name]).magnitude == pytest.approx(shown.scale, rel=1e-8)


def test_temperatures_have_the_offset_and_differences_none():
    with displayed_in("us"):
        assert QUANTITIES["outlet_temperature"].shown(373.15) == pytest.approx(212.0, abs=1e-9)
        assert QUANTITIES["outlet_temperature"].shown(273.15) == pytest.approx(32.0, abs=1e-9)
        assert QUANTITIES["temperature_rise"].shown(10.0) == pytest.approx(18.0)


@pytest.mark.parametrize("name", QUANTITIES)
def test_what_is_written_is_the_same_value(name):
    quantity = QUANTITIES[name]
    value = (47.3 - quantity.metric.offset) / quantity.metric.scale
    with displayed_in("us"):
        text, shown = quantity.suited(value).format(value), quantity.suited(value).display
    digit = (
        0.5 * 10.0 ** -len(re.sub(r"e.*", "", text).partition(".")[2]) * 10.0 ** int([*text.split("e"), "0"][1])
    )
    assert float(text) == pytest.approx(value * shown.scale + shown.offset, abs=1.001 * digit)
    assert math.isfinite(value)


def test_the_system_ends_with_its_block_even_by_an_error():
    with pytest.raises(ZeroDivisionError), displayed_in("us"):
        1 / 0  # noqa: B018
    assert QUANTITIES["load"].display.label == "kN"


def test_an_unknown_system_is_refused():
    with pytest.raises(ValueError, match="si, us"), displayed_in("imperial"):
        pass


def test_the_option_leaves_json_alone_and_ends_with_the_command(tmp_path):
    from typer.testing import CliRunner

    import babbitt.cli.solve  # noqa: F401  # registers its commands
    from babbitt.case import template
    from babbitt.cli.app import app

    case, out = tmp_path / "case.yaml", tmp_path / "out.json"
    case.write_text(template("journal"), encoding="utf-8")
    found = {}
    for units in ("si", "us"):
        run = CliRunner().invoke(app, ["solve", str(case), "--units", units, "--json", str(out)])
        assert run.exit_code == 0, run.output
        found[units] = run.output, re.sub(r'"wall_time": .*', "", out.read_text(encoding="utf-8"))
        out.unlink()
    assert found["si"][1] == found["us"][1]
    assert "psi" in found["us"][0]
    assert not re.search(r"µm|MPa|kN|kW|L/min", found["us"][0])
    assert QUANTITIES["load"].display.label == "kN"
