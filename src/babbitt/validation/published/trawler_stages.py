"""The staged study of a trawler's thrust bearing: what its percentages mean, and which cannot be."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.shaft_line.stages import stages
from babbitt.kinds.shaft_line.sweeps import ring_sweep
from babbitt.validation.case import Comparison, Evidence, Story, ValidationCase
from babbitt.validation.figure import GREY, INK, logarithmic_axis
from babbitt.validation.published.trawler_line import duty, films
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STAGES = {
    "1a": "1a runout, rigid shaft",
    "1b": "1b propeller, rigid shaft",
    "1c": "1c both",
    "2": "2 with tilt",
    "3": "3 with elastic shaft",
    "3d": "3d with propeller damping",
}
NOT_REPRODUCIBLE = (
    "not reproducible: damping cannot raise the pad force. Seen from the propeller the line has an impedance "
    "D with "
    "Im D >= 0 while every film damps; then U1 = Q/(D + j nu b0) falls with b0, and each pad force is a fixed "
    "multiple "
    "of U1."
)
NEEDS = "57 % needs a shaft of 57 m or a softer seating; neither is printed"


@lru_cache
def run() -> tuple[Comparison, ...]:
    """The stages against the print and against the prototype, the ring sweep, the protection by a soft ring."""
    return (*_printed(), *_prototype(), *_rings())


def _losses() -> dict[str, float]:
    return {stage.name: 100.0 * stage.state.losses.mean_bound for stage in stages(duty(), films())}


def _printed() -> Iterator[Comparison]:
    found = _losses()
    for name, value in reference_data("trawler_line")["published"].items():
        said = {"3": NEEDS, "3d": NOT_REPRODUCIBLE}.get(name, "")
        yield Comparison(
            "L₁",
            STAGES[name],
            value,
            found[name],
            None if said else Within(absolute=1.0),
            "%",
            "study, text",
            decimals=0,
            suspect=said if name == "3d" else "",
            information=said if name == "3" else "",
        )


def _prototype() -> Iterator[Comparison]:
    found = _losses()
    for name, value in reference_data("trawler_line")["stages"].items():
        yield Comparison(
            "L₁, prototype", STAGES[name], value, found[name], Within(absolute=0.3), "%", "prototype", decimals=1
        )


def _rings() -> Iterator[Comparison]:
    rows = reference_data("trawler_line")["rings"]
    for row, point in zip(rows, ring_sweep(duty(), films(), [row[0] for row in rows]), strict=True):
        place = f"ring {row[0] / 1e9:g} GN/m"
        for name, value, ours, unit in (
            ("runout share", row[1], 100.0 * point.runout, "%"),
            ("ripple share", row[2], 100.0 * point.ripple, "%"),
            ("L₁ over the ring", row[3], 100.0 * point.bound, "%"),
            ("film amplitude by runout", row[4], 1e6 * point.film_amplitude, "µm"),
            ("first frequency", row[5], point.first_frequency / (2.0 * np.pi), "Hz"),
        ):
            half_digit = 0.006 if unit == "µm" else 0.06
            yield Comparison(name, place, value, ours, Within(0.02, half_digit), unit, "prototype")


def draw(figure: Figure) -> None:
    """Stages as bars beside the print; loss over the ring."""
    figure.set_size_inches(7.2, 3.6)
    left, right = figure.subplots(1, 2)
    printed, ours = reference_data("trawler_line")["published"], _losses()
    at = np.arange(len(printed))
    left.bar(
        at - 0.2, list(printed.values()), 0.38, facecolor="white", edgecolor=INK, hatch="///", label="printed"
    )
    left.bar(at + 0.2, [ours[name] for name in printed], 0.38, facecolor="0.75", edgecolor=INK, label="computed")
    left.axhline(50.0, color=GREY, linewidth=0.8)
    left.set_xticks(at, list(printed))
    left.set_xlabel("stage")
    left.set_ylabel("dynamic over mean static pad load in %")
    left.legend(loc="upper left")
    rings = np.geomspace(5e7, 5e11, 25)
    points = ring_sweep(duty(), films(), list(rings))
    for name, dashes in (("bound", "-"), ("runout", "--"), ("ripple", ":")):
        right.plot(
            rings / 1e9,
            [100.0 * getattr(point, name) for point in points],
            color=INK,
            linestyle=dashes,
            label={"bound": "both", "ripple": "thrust ripple"}.get(name, name),
        )
    logarithmic_axis(right, (0.1, 1.0, 10.0, 100.0))
    right.set_xlabel("ring stiffness per pad in GN/m")
    right.set_ylabel("dynamic over mean static pad load in %")
    right.legend(loc="upper left")


CASE = ValidationCase(
    name="trawler_stages",
    title="Shaft line: the stages of a trawler's main thrust bearing",
    story=Story(
        what=(
            "A study builds the dynamic load of the thrust pads of a geared-diesel trawler in stages: runout "
            "of the "
            "collar, thrust ripple of the propeller, tilt of the housing, elasticity of the shaft, damping of the "
            "propeller. Each stage is one line of a table that designers quote."
        ),
        source=(
            "I. N. Sidorika, *Eastern-European Journal of Enterprise Technologies* 4/7 (70), 2014. It prints "
            "percentages "
            "only: no dimension, load or film. Rows named prototype are an independent program of the same "
            "equations."
        ),
        assumptions=(
            "All inputs are ours: 500 kN, 125 rpm, eight pads, 5 µm runout, 30 µm tilt, 10 % ripple, a 30 m "
            "shaft, a ring "
            "of 20 GN/m per pad. Runout, ripple, ring and tilt were chosen inside realistic ranges with the "
            "printed "
            "percentages in view, so that agreement with the print is consistency, not proof."
        ),
        tolerances="Print: one percentage point. Prototype: 0.3 points for the stages, 2 % over the ring.",
        differences=(
            "Stage 3d, 67 % by propeller damping, is **not reproducible: damping cannot raise the pad "
            "force**. Proof: seen "
            "from the propeller the line has the impedance D(ν) with Im D ≥ 0 as long as every film damps, "
            "and U₁ = "
            "Q/(D + j ν b₀); so |U₁| falls with b₀, and with it every |N_i| = |T_i| |U₁|, T_i not knowing b₀. "
            "If the "
            "printed 57 % leaves the tilt out and 67 % has it in, the increase is that of the tilt. Stage 3 "
            "itself needs a "
            "shaft of 57 m or a softer seating. Tilt raises the figure on the mean-load basis only: against "
            "its own static "
            "load the tightest pad stays below 40 %. A ring ten times softer than the film takes the runout "
            "share to a "
            "tenth, as the study says, but hardly the propeller's."
        ),
    ),
    run=run,
    draw=draw,
    caption="Printed and computed stages, the line at the usual limit of 50 %; and the dynamic load over the "
    "stiffness of "
    "the backing ring.",
    evidence=Evidence.REPRODUCTION,
)
