"""Tables and reports in US units: one partner a unit of the SI, of the right size, and JSON as it was."""

import math
import re
from pathlib import Path

import numpy as np
import pint
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

import babbitt
from babbitt.case import load_case, parse_case, template
from babbitt.core.quantities import QUANTITIES, displayed_in
from babbitt.core.quantities.display import SI, US
from babbitt.report.content import content
from babbitt.report.us_figure import Elsewhere
from babbitt.report.us_words import NOT_TEXT, OTHERS, PARTNERS, in_us_units
from babbitt.report.view import view_of
from babbitt.solving import solve

REGISTRY = pint.UnitRegistry(autoconvert_offset_to_baseunit=True)
REGISTRY.define("cSt_ = 1e-6 m**2/s")
IN_PINT = {
    "mil": "thou", "lbf ft": "lbf*ft", "hp": "hp", "gpm": "gallon/min", "cSt": "cSt_", "in³/s": "in**3/s",
    "lb/ft³": "lb/ft**3", "Btu/(ft³ °F)": "Btu_it/ft**3/delta_degF", "1e-6/°F": "1e-6/delta_degF",
    "lbf s/in": "lbf*s/in", "klbf s/in": "klbf*s/in", "psi ft/s": "psi*ft/s", "lbf ft/rad": "lbf*ft",
    "lbf ft/mrad": "1e3*lbf*ft", "lbf ft s/rad": "lbf*ft*s", "in²": "in**2", "mil/in": "1e-3", "Mpsi": "1e6*psi",
    "in": "inch", "°F": "delta_degF", "Btu/(lb °F)": "Btu_it/lb/delta_degF",
    "Btu/(h ft² °F)": "Btu_it/hour/ft**2/delta_degF",
}  # fmt: skip
COHERENT = {
    "mm": "m", "um": "m", "um2": "m", "MPa": "Pa", "MPa3": "Pa", "kPa": "Pa", "GPa": "Pa", "degC": "kelvin",
    "K": "kelvin", "kN": "N", "N": "N", "Nm": "N*m", "kNm": "N*m", "kW": "W", "W": "W", "L/min": "m**3/s",
    "mm3/s": "m**3/s", "mPas": "Pa*s", "mm2/s": "m**2/s", "m/s": "m/s", "mm/s": "m/s", "kg/m3": "kg/m**3",
    "MJ/m3K": "J/m**3/kelvin", "pv": "Pa*m/s", "1e-6/K": "1/kelvin", "t": "kg", "kg": "kg", "N/um": "N/m",
    "MN/m": "N/m", "GN/m": "N/m", "kN/m": "N/m", "kNs/m": "N*s/m", "MNs/m": "N*s/m", "Ns/m": "N*s/m",
    "kNm/rad": "N*m", "kNm/mrad": "N*m", "Nms/rad": "N*m*s", "cm2": "m**2", "mrad": "1",
    "J/kgK": "J/kg/kelvin", "W/m2K": "W/m**2/kelvin", "L/min2": "m**3/s",
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


@pytest.mark.parametrize(
    ("name", "si", "shown"),
    [
        ("stiffness", 507.8e6, "2900 klbf/in"),  # not 2899612 lbf/in
        ("stiffness", 2.647e9, "15.11 Mlbf/in"),
        ("stiffness", 1e4, "57.1 lbf/in"),
        ("damping", 19.47e6, "111.2 klbf s/in"),
        ("damping", 3e5, "1713 lbf s/in"),
    ],
)
def test_large_and_small_coefficients_have_a_unit_of_their_size(name, si, shown):
    with displayed_in("us"):
        assert QUANTITIES[name].suited(si).with_unit(si) == shown


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


EXAMPLES = Path(babbitt.__file__).parents[2] / "examples"
BY_LABEL = {
    (SI[name].label, us.label): (
        us.scale / SI[name].scale,
        us.offset - SI[name].offset * us.scale / SI[name].scale,
    )
    for name, us in US.items()
}
"""Factor and offset from a number in one unit of an axis to that in another one."""


def figures_of(machine, monkeypatch):
    """The figures of a machine in both systems of units."""
    made = []
    monkeypatch.setattr(
        Figure, "savefig", lambda figure, target, **_: made.append(figure) or target.write(b"<svg/>")
    )
    for system in ("si", "us"):
        with displayed_in(system):
            for solution in machine.solutions:
                view_of(solution.result).figures(solution, "svg")
    half = len(made) // 2
    return list(zip(made[:half], made[half:], strict=True))


def unit_of(label):
    return label.rpartition(" in ")[2]


@pytest.mark.parametrize("name", ["grooved.yaml", "pump_footstep.yaml"])
def test_curves_are_in_the_units_that_stand_at_their_axes(name, monkeypatch):
    """What is drawn in US units is what is drawn in those of the SI, converted from label to label."""
    compared = 0
    for figure, other in figures_of(solve(load_case(EXAMPLES / name)), monkeypatch):
        for axes, theirs in zip(figure.axes, other.axes, strict=True):
            for axis in "xy":
                if isinstance(getattr(theirs, f"{axis}axis").get_major_locator(), Elsewhere):
                    continue  # drawn in the SI, with ticks of the US
                ours, own = (unit_of(getattr(one, f"get_{axis}label")()) for one in (axes, theirs))
                factor, offset = (1.0, 0.0) if ours == own else BY_LABEL[ours, own]
                for line, drawn in zip(axes.get_lines(), theirs.get_lines(), strict=True):
                    if line.get_transform() == axes.transData and ours:
                        values, shown = (
                            np.asarray(getattr(one, f"get_{axis}data")(), float) for one in (line, drawn)
                        )
                        assert shown == pytest.approx(factor * values + offset, rel=1e-6, abs=1e-9, nan_ok=True)
                        compared += ours != own
    assert compared > 10


def test_maps_of_a_film_name_the_unit_of_their_numbers(monkeypatch):
    given = (EXAMPLES / "stribeck_mixed.yaml").read_text(encoding="utf-8")
    plain = re.sub("(?m)^mixed_friction.*$", "", given).replace(
        "method: film", "method: {kind: film, accuracy: draft}"
    )
    machine = solve(parse_case(plain))
    thinnest = machine.results[0].values["minimum_film_thickness"]
    figure, other = figures_of(machine, monkeypatch)[0]
    for one, unit, value in ((figure, "µm", 1e6 * thinnest), (other, "mil", thinnest / 25.4e-6)):
        said = {text.get_text() for text in one.findobj(Text)}
        assert f"film thickness in {unit}" in said
        assert any(abs(float(text) - value) < 0.01 * value for text in said if re.fullmatch(r"[\d.]+", text))


MORE_IN_PINT = {
    "m²": "m**2", "kg m²": "kg*m**2", "1/K": "1/delta_degC", "µm/MPa": "um/MPa", "L/(min MPa)": "L/min/MPa",
    "W/K": "W/delta_degC", "W/(m K)": "W/m/delta_degC", "W/(m² K)": "W/m**2/delta_degC",
    "kg/(m³ K)": "kg/m**3/delta_degC", "J/(kg K²)": "J/kg/delta_degC**2", "mL": "mL", "L": "L", "1/GPa": "1/GPa",
    "ft²": "ft**2", "in³": "in**3", "gal": "gallon", "lb ft²": "lb*ft**2", "1/°F": "1/delta_degF",
    "1/Mpsi": "1/(1e6*psi)", "mil/kpsi": "thou/(1000*psi)", "gpm/psi": "gallon/min/psi",
    "Btu/(h °F)": "Btu_it/hour/delta_degF", "Btu/(h ft °F)": "Btu_it/hour/ft/delta_degF",
    "Btu/(h ft² °F)": "Btu_it/hour/ft**2/delta_degF", "lb/(ft³ °F)": "lb/ft**3/delta_degF",
    "Btu/(lb °F²)": "Btu_it/lb/delta_degF**2",
}  # fmt: skip


@pytest.mark.parametrize("unit", OTHERS)
def test_units_of_texts_have_the_size_that_pint_gives(unit):
    partner, factor = OTHERS[unit]
    one, other = (REGISTRY.parse_expression(MORE_IN_PINT.get(name, name)) for name in (unit, partner))
    assert REGISTRY.Quantity(1.0, "dimensionless") * one / other == pytest.approx(factor, rel=1e-6)


UNITS_OF_THE_SI = "|".join(re.escape(unit) for unit in sorted(PARTNERS, key=len, reverse=True))
LEFT = re.compile(rf"(?<![\w.])\d[\d.]*\s?({UNITS_OF_THE_SI})(?![\w/²³])")
QUOTED = ("references", "source", "name", "notes", "bearing")
"""What a report quotes as it stands."""


def said(data, path=()):
    if isinstance(data, str):
        yield path, data
    elif isinstance(data, dict):
        for key, part in data.items():
            if key not in (*NOT_TEXT, *QUOTED):
                yield from said(part, (*path, key))
    elif isinstance(data, list | tuple):
        for place, part in enumerate(data):
            yield from said(part, (*path, place))


KINDS = ["journal", "thrust", "screw_heel", "hydrostatic_pad", "hydrostatic_journal", "jacking_pocket", "shaft",
         "overhung_coupling", "tilting_pad_journal"]  # fmt: skip


@pytest.mark.usefixtures("no_images")
@pytest.mark.parametrize("kind", KINDS)
def test_no_unit_of_the_si_is_left_in_a_report(kind):
    machine = solve(parse_case(template(kind)))
    plain = dict(said(content(machine)))
    with displayed_in("us"):
        whole = content(machine)
    found = dict(said(whole))
    assert plain.keys() == found.keys()
    assert [one for one in plain.values() if LEFT.search(one)]
    left = [one for path, one in found.items() if (path[-1] == "unit" and one in PARTNERS) or LEFT.search(one)]
    assert [one for one in left if "ISO 3448" not in one] == []
    with displayed_in("us"):
        assert in_us_units(whole) == whole


def test_texts_have_their_values_in_both_systems():
    assert in_us_units(["5 mm", "20 °C"]) == ["5 mm", "20 °C"]
    with displayed_in("us"):
        assert in_us_units("capillary 0.6 mm × 60 mm at 20 to 60 °C, pad 2, 5 MN/m, a rise of 10 K") == (
            "capillary 0.02362 in × 2.362 in at 68 to 140 °F, pad 2, 28.55 klbf/in, a rise of 18 °F"
        )
        row = {"label": "Whole", "value": "-45, 135", "unit": "kN", "note": "5 W of SAE 10W-30, 3 mm2"}
        assert in_us_units(row) == {
            "label": "Whole", "value": "-10120, 30350", "unit": "lbf", "note": "0.006705 hp of SAE 10W-30, 3 mm2",
        }  # fmt: skip
        own = {"label": "Notes", "value": "for shafts of 40 mm", "unit": ""}
        assert in_us_units(own) == own
        table = {"columns": [{"unit": ""}, {"unit": "µm"}], "rows": [["1", "25.4"]], "note": ""}
        assert in_us_units(table)["rows"] == [["1", "1"]]


@pytest.mark.parametrize(("said", "turned"), [
    ("expands by 12e-6 1/K", "expands by 0.000006667 1/°F"),
    ("0.01 L/(min MPa)", "0.00001821 gpm/psi"),
    ("1.2 × 10^−5 m", "0.00003937 ft"),
    ("warms by 10 °C", "warms by 18 °F"),
    ("±5 °C", "±9 °F"),
])  # fmt: skip
def test_small_numbers_and_differences_are_turned_as_such(said, turned):
    """12e-6 1/K was said to be 0 1/°F, and mantissa and power of ten were turned apart."""
    with displayed_in("us"):
        assert in_us_units(said) == turned


def test_assumptions_of_the_case_stay_in_its_words():
    own = "Drawing 4711-2, 30 mm; oil rises by 10 °C"
    machine = solve(parse_case(template("journal") + f'\nassumptions: ["{own}"]\n'))
    with displayed_in("us"):
        assert own in content(machine)["bearings"][0]["assumptions"]


def test_texts_in_other_languages_keep_their_decimal_comma():
    from babbitt.core.language import written_in

    with displayed_in("us"), written_in("de"):
        assert in_us_units("Tasche 40,5 mm breit") == "Tasche 1,594 in breit"


NAMED = re.compile(rf" in ({UNITS_OF_THE_SI})(?=$|[ ),.;:])")


@pytest.mark.parametrize("kind", ["hydrostatic_journal", "thrust", "tilting_pad_journal"])
def test_figures_drawn_in_the_si_have_ticks_and_texts_of_the_us(kind, monkeypatch):
    """What is drawn stays; the number at a tick is where it stands, in the unit that the axis names."""
    turned = 0
    for figure, other in figures_of(solve(parse_case(template(kind))), monkeypatch):
        for axes, theirs in zip(figure.axes, other.axes, strict=True):
            for axis in "xy":
                named = NAMED.search(getattr(axes, f"get_{axis}label")())
                if named is None:
                    continue
                label = getattr(theirs, f"get_{axis}label")()
                partner, factor, offset = PARTNERS[named[1]]
                power = re.search(r" in \$10\^\{(\d)\}\$ ", label)
                assert label.split(" (")[0].rstrip().endswith(partner)
                scale = getattr(theirs, f"{axis}axis")
                for place in scale.get_majorticklocs():
                    number = float(scale.get_major_formatter()(place)) * 10.0 ** int(power[1] if power else 0)
                    assert number == pytest.approx(factor * place + offset, rel=6e-3, abs=1e-6)
                turned += 1
        said = [text.get_text() for text in other.findobj(Text)]
        assert not [one for one in said if LEFT.search(one) or NAMED.search(one)]
    assert turned > 4 or kind == "thrust"
