"""Table 3 of the gearbox study: how an overhung coupling shares the load between two bearings."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from babbitt.kinds.shaft.model import STANDARD_GRAVITY
from babbitt.kinds.shaft.overhung_coupling import MeshForce, bearing_loads
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK
from babbitt.validation.published.reverse_gear_inputs import inferred_bearing, output_wheel_shaft, published
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_STATICS = "independent statics from Table 3"
_ROUNDED = Within(absolute=0.01)

# Reactions in kN (far bearing, bearing beside the coupling, either without coupling); effect of the coupling in %.
_INDEPENDENT = {
    MeshForce.UPWARD: (380.34, 363.80, 375.51, 1.29, -3.12),
    MeshForce.DOWNWARD: (434.98, 452.02, 439.93, -1.13, 2.75),
}


def run() -> tuple[Comparison, ...]:
    """Compare weights, arm, reactions and the load per area."""
    return (*_weights(), *_reactions(), _load_per_area())


def _weights() -> Iterator[Comparison]:
    given = output_wheel_shaft(MeshForce.UPWARD)
    yield Comparison("a", "", 780.5, given.coupling_arm * 1e3, Within(absolute=0.05), "mm", _STATICS, 1)
    gear = given.gear_mass * STANDARD_GRAVITY / 1e3
    yield Comparison("G₁", "gear", 69.71, gear, _ROUNDED, "kN", _STATICS, 2)
    coupling = given.coupling_mass * STANDARD_GRAVITY / 2e3
    yield Comparison("G₂", "half the coupling", 7.60, coupling, _ROUNDED, "kN", _STATICS, 2)


def _reactions() -> Iterator[Comparison]:
    for direction, (far, near, alone, far_change, near_change) in _INDEPENDENT.items():
        loads, place = bearing_loads(output_wheel_shaft(direction)), f"mesh force {direction.value}"
        none = loads.reaction_without_coupling
        for symbol, expected, ours in (
            ("R₁", far, loads.reaction_1),
            ("R₂", near, loads.reaction_2),
            ("R₀", alone, none),
        ):
            yield Comparison(symbol, place, expected, ours / 1e3, _ROUNDED, "kN", _STATICS, 2)
        for symbol, expected, ours in (
            ("R₁/R₀ - 1", far_change, loads.reaction_1),
            ("R₂/R₀ - 1", near_change, loads.reaction_2),
        ):
            yield Comparison(symbol, place, expected, 100.0 * (ours / none - 1.0), _ROUNDED, "%", _STATICS, 2)


def _load_per_area() -> Comparison:
    """The only number of the print that the reactions can be held against."""
    wheel = inferred_bearing("Output wheel")
    area = 1e-6 * wheel["diameter_mm"] ** 2 * wheel["width_ratio"]
    rows = published()["tables_4_and_5"]["rows"]
    printed = next(row["specific_load_MPa"] for row in rows if row["name"] == "Output wheel")
    load = bearing_loads(output_wheel_shaft(MeshForce.DOWNWARD)).reaction_2
    place = "bearing beside the coupling, mesh force downward, 527.5 × 408.3 mm"
    fitted = "The dimensions were inferred with this load: no test of it."
    return Comparison("p", place, printed, load / area / 1e6, None, "MPa", "Table 4", 2, information=fitted)


def draw(figure: Figure) -> None:
    """Both reactions over the mass of the coupling."""
    figure.set_size_inches(7.2, 3.4)
    panels = figure.subplots(1, 2)
    for axes, direction in zip(panels, MeshForce, strict=True):
        given = output_wheel_shaft(direction)
        masses = [0.05 * k * given.coupling_mass for k in range(41)]
        loads = [bearing_loads(replace(given, coupling_mass=mass)) for mass in masses]
        tonnes = [mass / 1e3 for mass in masses]
        axes.plot(tonnes, [each.reaction_1 / 1e3 for each in loads], color=INK, label="R₁, far bearing")
        axes.plot(
            tonnes,
            [each.reaction_2 / 1e3 for each in loads],
            color=INK,
            linestyle="--",
            label="R₂, beside the coupling",
        )
        axes.axvline(given.coupling_mass / 1e3, color=GREY, linewidth=0.8)
        for value, marker in zip(_INDEPENDENT[direction][:2], "os", strict=True):
            axes.plot(given.coupling_mass / 1e3, value, marker, color=INK, markerfacecolor="white")
        axes.set_title(f"mesh force {direction.value}")
        axes.set_xlabel("mass of the coupling in t")
        axes.set_ylabel("bearing load in kN")
    panels[0].legend()


CASE = ValidationCase(
    name="output_wheel_load_share",
    title="Marine reverse gear: load share of the output wheel's bearings",
    story=Story(
        what=(
            "The shaft of the output wheel carries a coupling beyond its second bearing. Half of the coupling's "
            "weight hangs there as on a lever: it lifts the far bearing and presses on the near one. Whether that "
            "adds to a bearing's load depends on which way the mesh force pushes."
        ),
        source=(
            "Published gearbox study (Russian journal, 2023, vol. 15, no. 5, p. 825 ff.): inputs of Table 3, load "
            "per area of Table 4. The study does not print the reactions; the values compared are an independent "
            "evaluation of the statics from Table 3."
        ),
        assumptions=(
            "Two simple supports, the gear at mid-span, half of the coupling's weight acting a quarter of its "
            "length beyond the flange. The bearing of 527.5 × 408.3 mm, needed for the load per area, is inferred "
            "from the tables with this load, so that the load per area is shown and not judged."
        ),
        tolerances="Statics leaves no room: 0.01 kN, the last digit of the values compared.",
        differences=(
            "Nothing. The more loaded bearing, beside the coupling with the mesh force downward, carries the 452 "
            "kN with which one set of dimensions gives the whole row of Tables 4 and 5, see the eleven bearings "
            "of the gear; no set was found for the upward force."
        ),
    ),
    run=run,
    draw=draw,
    caption="Bearing loads over the mass of the coupling; the thin line is the coupling of the study, with the "
    "independent values.",
)
