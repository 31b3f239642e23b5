"""A plane slider, whose answers have closed forms, as a kind that studies know: rows one by one, or as arrays."""

from __future__ import annotations

import numpy as np
from plane_slider.method import load_number

from babbitt.case.loading import case_from_dict
from babbitt.case.parts.study import StudyBlock
from babbitt.core.units import AS_WRITTEN
from babbitt.study.rows import answers_of_arrays

SLIDER = {
    "kind": "plane_slider",
    "name": "Slider",
    "length": "50 mm",
    "width": "200 mm",
    "inlet_film": "60 um",
    "outlet_film": "30 um",
    "speed": "5 m/s",
    "viscosity": "30 mPa s",
    "least_film": "20 um",
}


def slider(**changes):
    return case_from_dict({**SLIDER, **changes})


def block(**given):
    return StudyBlock.model_validate(given, context=AS_WRITTEN)


def many_sliders(task, rows):
    """Sliders as arrays; row by row where something else than a quantity varies."""
    known = {"length", "width", "inlet_film", "outlet_film", "speed", "viscosity", "least_film"}
    if not {one.path for one in task.inputs} <= known:
        return None
    fixed = task.case({name: column[0] for name, column in rows.items()})
    one = {name: rows.get(name, np.full(rows["row"].size, getattr(fixed, name))) for name in known}
    if np.any(one["inlet_film"] <= one["outlet_film"]):
        return None
    ratio = one["inlet_film"] / one["outlet_film"]
    load = np.array([load_number(each) for each in ratio]) * 6.0 * one["viscosity"] * one["speed"]
    load *= one["width"] * (one["length"] / one["outlet_film"]) ** 2
    margin = (one["outlet_film"] - one["least_film"]) / one["least_film"]
    verdicts = np.where(margin < -1e-9, "fail", np.where(ratio > 5.0, "remarks", "pass")).astype(object)
    values = {"film_ratio": ratio, "load": load, "minimum_film_thickness": one["outlet_film"]}
    return answers_of_arrays(task, rows, "Slider", values, {"X102": margin}, verdicts)
