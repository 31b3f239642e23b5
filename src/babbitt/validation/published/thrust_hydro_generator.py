"""Tilting-pad thrust bearing of a hydro-generator: a temperature field here and there, and one viscosity."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.thrust.bearing import ThrustBearing
from babbitt.kinds.thrust.design import Oil, PrescribedThrust, ThrustDesign, ThrustState, operating_state
from babbitt.kinds.thrust.gap import minimum_gap
from babbitt.kinds.thrust.pad import ThrustPad
from babbitt.properties.lubricants import lubricant
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

ONE = "by one viscosity from the global heat balance: what the temperature field changes"


def solved(carry_over: float, *, own: bool = False, resolved: bool = False) -> ThrustState:
    """The bearing by the global heat balance, or with temperatures of its own in the film."""
    data = reference_data("thrust_hydro_generator")
    pad = ThrustPad(
        data["inner_radius_m"],
        data["outer_radius_m"],
        math.radians(data["extent_deg"]),
        data["pivot_radius_m"],
        data["pivot_angle_deg"] / data["extent_deg"],
    )
    oil = Oil(
        lubricant(data["oil"]),
        supply_temperature=data["supply_degC"] + ZERO_CELSIUS,
        carry_over=carry_over,
        own_temperatures=own,
        resolved=resolved,
    )
    design = ThrustDesign(
        "Hydro-generator",
        ThrustBearing(pad, data["pads"]),
        PrescribedThrust(data["load_N"]),
        data["rpm"] * math.pi / 30.0,
        oil,
    )
    return operating_state(design)


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Side by side; judged is what one viscosity can answer."""
    return tuple(_rows())


def _rows() -> Iterator[Comparison]:
    data = reference_data("thrust_hydro_generator")
    z, source = data["pads"], "ross/tests/test_thrust_pad.py"
    pad = solved(0.0, own=True).share.states[0]
    assert pad.heat is not None
    for name, expected, ours, allowed, unit in (
        ("h_p", data["pivot_film_um"], 1e6 * pad.height, Within(0.08), "µm"),
        ("h_max", data["maximum_film_um"], -1e6 * float(minimum_gap(pad.pad, -pad.motion)), Within(0.05), "µm"),
        ("h_min", data["minimum_film_um"], 1e6 * pad.minimum_film_thickness, Within(0.1), "µm"),
        ("p_max", data["maximum_pressure_MPa"], 1e-6 * pad.maximum_pressure, Within(0.07), "MPa"),
        ("T_max", data["maximum_temperature_degC"], pad.heat.maximum - ZERO_CELSIUS, Within(absolute=2.0), "°C"),
        ("K, tilts held", data["stiffness_N_per_m"], z * float(pad.stiffness[0, 0]), Within(0.1), "N/m"),
        ("C, tilts held", data["damping_Ns_per_m"], z * float(pad.damping[0, 0]), Within(0.15), "N s/m"),
    ):
        yield Comparison(name, "", expected, ours, allowed, unit, source)
    state = solved(0.0)
    plain = state.share.states[0]
    assert state.temperatures is not None
    for name, expected, ours, unit in (
        ("h_p", data["pivot_film_um"], 1e6 * plain.height, "µm"),
        ("h_min", data["minimum_film_um"], 1e6 * plain.minimum_film_thickness, "µm"),
        ("p_max", data["maximum_pressure_MPa"], 1e-6 * plain.maximum_pressure, "MPa"),
        ("T, trailing", data["maximum_temperature_degC"], state.temperatures.trailing - ZERO_CELSIUS, "°C"),
        ("C, tilts held", data["damping_Ns_per_m"], z * float(plain.damping[0, 0]), "N s/m"),
    ):
        yield Comparison(name, "one viscosity", expected, ours, None, unit, source, information=ONE)


def draw(figure: Figure) -> None:
    """Film and temperature over the hot oil carried over, by both models."""
    figure.set_size_inches(7.2, 3.4)
    left, right = figure.subplots(1, 2)
    data = reference_data("thrust_hydro_generator")
    shares = np.linspace(0.0, 0.8, 6)
    for own, style in ((True, "-"), (False, "--")):
        states = [solved(float(share), own=own) for share in shares]
        name = "temperatures in the film" if own else "one viscosity"
        pads = [state.share.states[0] for state in states]
        left.plot(shares, [1e6 * pad.height for pad in pads], color=INK, linestyle=style, label=name)
        left.plot(shares, [1e6 * pad.minimum_film_thickness for pad in pads], color=INK, linestyle=style)
        mixed = [state.temperatures for state in states if state.temperatures is not None]
        trailing = [temperatures.trailing - ZERO_CELSIUS for temperatures in mixed]
        hottest = [pad.heat.maximum - ZERO_CELSIUS for pad in pads if pad.heat is not None]
        right.plot(shares, trailing, color=INK, linestyle=style, label=f"trailing edge, {name}")
        if own:
            right.plot(shares, hottest, color=INK, linestyle=":", label="hottest place in the film")
    for name in ("pivot_film_um", "minimum_film_um"):
        left.axhline(data[name], color=GREY, linewidth=0.8)
    left.set_ylim(0.0, None)
    left.set_ylabel("film at the pivot and thinnest film in µm")
    left.legend(loc="lower left")
    right.axhline(data["maximum_temperature_degC"], color=GREY, linewidth=0.8)
    right.set_ylabel("temperature in °C")
    right.legend(loc="upper left")
    for axes in (left, right):
        axes.set_xlabel("hot oil carried over")


CASE = ValidationCase(
    name="thrust_hydro_generator",
    title="Thrust bearing: 12 pads of a hydro-generator, another program",
    story=Story(
        what=(
            "A tilting-pad thrust bearing of 13.3 MN at 90 rpm that a public program solves with the temperature "
            "field of film and pads. Ours is solved with temperatures along the pad and across the gap, no "
            "heat to pad "
            "and collar; beside it the answer of one viscosity by a global heat balance: a comparison of codes "
            "and of "
            "models."
        ),
        source=(
            "ROSS (petrobras/ross), `ross/tests/test_thrust_pad.py`; set-up attributed there to Barbosa (2016), "
            "Heinrichson (2007), Nicoletti (1999). Regression values on a mesh of 10 x 10, not an experiment."
        ),
        assumptions=(
            "No hot oil carried over, as there every pad gets fresh oil. ISO VG 68 is the oil of our catalogue, "
            "viscosity index 95; the source has its own law of viscosity."
        ),
        tolerances=(
            "Film at the pivot 8 %, thinnest film 10 %, highest pressure 7 %, highest temperature 2 K, "
            "stiffness 10 % "
            "and damping 15 %, each at its own film: the coarse mesh, the other oil and the heat that the "
            "source lets "
            "into the pad leave that much open. What one viscosity answers is shown, not judged."
        ),
        differences=(
            "Films are 6 % thinner than those of the source, and stiffness and damping follow from that: at "
            "equal film "
            "K would be 10 % and C 7 % below. The coefficients agree with the tilts held; free to tilt the "
            "stiffness "
            "would be a third less. One viscosity misses what the field does: cold oil at the leading edge "
            "carries "
            "load and keeps the film a quarter thicker, and viscosity that falls along the pad tilts it more "
            "(h_min/h_p "
            "0.61 against 0.74); the damping by one viscosity is nearly twice as large."
        ),
    ),
    run=run,
    draw=draw,
    caption="Film and temperature over the share of hot oil carried over; grey lines: the source, without any.",
)
