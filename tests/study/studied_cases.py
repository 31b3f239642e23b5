"""A journal bearing that is solved in milliseconds, for the tests of studies."""

from __future__ import annotations

from slider_cases import block

from babbitt.case.loading import case_from_dict

__all__ = ["JOURNAL", "block", "journal"]

JOURNAL = {
    "kind": "journal",
    "name": "Textbook bearing",
    "diameter": "120 mm",
    "width": "60 mm",
    "clearance": {"kind": "relative", "mean": "1.12 permille"},
    "span": "360 deg",
    "supply_element": {"kind": "pocket", "width": "40 mm", "place": "both_sides"},
    "lubricant": "ISO VG 46",
    "supply": {"temperature": "58 degC", "pressure": "0.5 MPa"},
    "materials": {
        "bearing_metal": "CuSn8P",
        "bearing": {"thermal_expansion": "23e-6 1/K"},
        "journal": {"thermal_expansion": "11e-6 1/K"},
    },
    "surfaces": {"kind": "direct", "roughness_bearing": "4 um", "roughness_journal": "2 um"},
    "load": "24 kN",
    "speed": "2000 rpm",
}


def journal(**changes):
    return case_from_dict({**JOURNAL, **changes})
