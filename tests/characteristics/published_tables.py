"""Published tables of characteristics as arrays, for the tests."""

import json
from importlib.resources import files
from pathlib import Path

import numpy as np

_TABLES = ("sommerfeld_number", "attitude_angle_degrees", "side_flow", "width_ratio_1", "width_ratio_0.25")


def _load(text):
    data = json.loads(text)
    return {name: np.array(value) if name in _TABLES else value for name, value in data.items()}


_PUBLISHED = files("babbitt") / "validation" / "data"
BUTENSCHOEN = _load((_PUBLISHED / "butenschoen_1976.json").read_text(encoding="utf-8"))
RAIMONDI_BOYD = _load((_PUBLISHED / "raimondi_boyd_1958.json").read_text(encoding="utf-8"))
ARC_CHECK_VALUES = json.loads(Path(__file__).with_name("arc_check_values.json").read_text(encoding="utf-8"))
