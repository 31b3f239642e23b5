"""Reports of tilting pads in German and Russian lack no word, whatever films, pivots and walls they have."""

from __future__ import annotations

import re

import pytest
from pad_journals import STEEL, pad_case

from babbitt.case import case_from_dict
from babbitt.core.language import LANGUAGES, written_in
from babbitt.core.report_level import Level
from babbitt.report.bearing_content import calculation_content
from babbitt.report.chapters import chapters
from babbitt.report.content import content
from babbitt.solving import solve

CONDUCTING = STEEL | {"conductivity": "50 W/(m K)"}
OWN = {"name": "C45", "conductivity": "45 W/(m K)", "poisson_ratio": 0.3, **STEEL}
CONTACT = {"pivot_radius": "60 mm", "housing_radius": "60.3 mm"}

BEARINGS = {
    "given place, turbulent": (
        {"load": None, "pads.each": [{"probe_fraction": 0.7}, {}, {}, {}]},
        {
            "position": {"x": "0 um", "y": "-40 um"}, "effective_temperature": "60 degC", "thermal": "isothermal",
            "turbulence": "ng_pan", "whirl_ratios": [0.5, 1], "groove_pressure": "50 kPa", "rotor_mass": "1000 kg",
            "limits": {"probe_alarm": "95 degC", "probe_trip": "110 degC"}, "load_angle": "-80 deg",
        },
    ),
    "pivots": (
        {
            "pads.mass": "1 kg",
            "pads.each": [
                {"pivot": {"kind": "rocker"}},
                {"preload": 0.45, "pivot": {"kind": "point", **CONTACT}},
                {"width": "65 mm", "pivot": {"kind": "line", **CONTACT, "length": "30 mm", "depth": "20 mm",
                                             "housing_depth": "30 mm"}},
                {"pivot": {"kind": "table", "points": [{"load": "5 kN", "displacement": "6 um"},
                                                       {"load": "10 kN", "displacement": "9 um"}]}},
            ],
        },
        {"thermal": "global", "turbulence": "constantinescu", "speed": "9000 rpm"},
    ),
    "bending of one temperature": (
        {},
        {
            "thermal": "global", "deformation": ["bending"], "materials": {"pads": STEEL, "bearing_metal": "B83"},
            "supply": {"temperature": "40 degC", "flow": "5 L/min"}, "rotor_mass": "1000 kg",
            "surfaces": {"kind": "direct", "roughness_bearing": "4 um", "roughness_journal": "2 um"},
        },
    ),
    "adiabatic, what assumptions move": (
        {},
        {"thermal": "adiabatic", "assumption_sensitivity": True, "feed": "leading_edge_groove",
         "limits": {"temperature": "78 degC"}},
    ),
    "plates, little oil": (
        {"pads.each": [{"material": OWN}, {}, {}, {}]},
        {
            "thermal": "full", "deformation": ["growth", "bending"], "pad_bending": "plate",
            "walls": {"pads": {}, "journal": {"shaft_conductance": "2 W/K"}}, "materials": {"pads": CONDUCTING},
            "supply": {"temperature": "40 degC", "flow": "4 L/min"}, "reference_temperature": "20 degC",
        },
    ),
    "walls as given": (
        {"pads.mass": "1 kg"},
        {
            "thermal": "full", "effective_temperature": "50 degC",
            "walls": {
                "pads": {"conductivity": "50 W/(m K)", "heat_transfer_coefficient": "200 W/(m2 K)",
                         "temperature": "45 degC"},
                "housing": {"temperature": "45 degC"}, "journal": {"shaft_conductance": "2 W/K"},
            },
        },
    ),
    "two pads": (
        {"pads.number": 2, "pads.first_pivot": "-90 deg", "pads.extent": "100 deg", "pads.preload": -0.1,
         "pads.pivot": {"kind": "rigid", "fraction": 0.45}},
        {"thermal": "isothermal"},
    ),
    "cross-coupling, offset": (
        {"pads.pivot": {"kind": "flexure", "fraction": 0.55, "rotational_stiffness": "5 kN m/rad",
                        "stiffness": "800 MN/m"}},
        {"anticipated_cross_coupling": "60 MN/m", "rotor_mass": "1000 kg", "shaft_stiffness": "30 MN/m"},
    ),
    "no threshold": (
        {},
        {
            "anticipated_cross_coupling": "0.01 MN/m", "rotor_mass": "10 kg",
            "pedestal": {"stiffness_x": "700 MN/m", "stiffness_y": "1.1 GN/m", "damping_x": "20 kN s/m",
                         "damping_y": "20 kN s/m", "mass": "250 kg"},
        },
    ),
    "clearance closed by growth": (
        {},
        {"thermal": "full", "deformation": ["growth"], "walls": {"pads": {}}, "materials": {"pads": STEEL},
         "speed": "16000 rpm", "reference_temperature": "-30 degC"},
    ),
    "vortices": ({"pads.clearance": {"kind": "radial", "mean": "250 um"}}, {"speed": "16000 rpm"}),
}  # fmt: skip
"""Changes and fields of bearings that reach what the examples do not."""


@pytest.mark.usefixtures("no_images")
@pytest.mark.parametrize("bearing", BEARINGS)
def test_no_word_is_lacking(bearing):
    changes, fields = BEARINGS[bearing]
    machine = solve(case_from_dict(pad_case(changes, **fields)))
    said = {}
    for language in LANGUAGES:
        with written_in(language) as missing:
            (said[language],) = content(machine, Level.STANDARD)["bearings"]
            for part in chapters(machine.solutions):
                calculation_content(part)
        assert not list(missing), language
    english = words_of(said["en"])
    assert english
    assert english & words_of(said["ru"]) == set()


def words_of(bearing):
    """Texts in words of what may be the user's own, too, and is not missing where it stays as it is."""
    rows = [row for group in bearing["inputs"] for row in group["rows"]]
    cells = [cell for table in bearing["tables"] for row in table["rows"] for cell in row]
    heads = [head["text"] for table in bearing["tables"] for head in table["columns"] if head["symbol"] is None]
    said = {*bearing["assumptions"], *cells, *heads, *(row[key] for row in rows for key in ("label", "value"))}
    return {one for one in said if re.search("[a-z]{4}", one)}
