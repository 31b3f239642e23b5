"""Fowell et al. (2007): inlet suction in a pocketed wedge, exact with mass-conserving rupture."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK
from babbitt.validation.published.film_bearings import Array
from babbitt.validation.published.sliders import Slider, SliderFilm, solve_slider
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_INTERVALS = 800  # lines fall on both edges of the pocket


def _data() -> dict[str, Any]:
    data: dict[str, Any] = reference_data("sliders")["fowell_2007"]
    return data


def gap(x: Array) -> Array:
    """Linear wedge with a rectangular pocket, m."""
    data = _data()
    wedge = data["h_max_m"] + (data["h_min_m"] - data["h_max_m"]) * x / data["L_m"]
    begin, end = data["pocket_start_m"], data["pocket_start_m"] + data["pocket_length_m"]
    inside = (x > begin * (1.0 + 1e-9)) & (x < end * (1.0 - 1e-9))
    return np.asarray(wedge + np.where(inside, data["pocket_depth_m"], 0.0))


@lru_cache
def film(intervals: int = _INTERVALS) -> SliderFilm:
    """The engine's film."""
    data = _data()
    slider = Slider(data["L_m"], data["h_min_m"], data["U_m_s"], data["mu_Pa_s"], data["p_ambient_Pa"], gap)
    return solve_slider(slider, intervals)


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Compare flux, pressure, load and where the film closes."""
    return tuple(_rows())


def _rows() -> Iterator[Comparison]:
    data, found = _data(), film()
    peak = int(found.pressure.argmax())
    interval = data["L_m"] / _INTERVALS
    for quantity, published, computed, tolerance, unit in (
        ("q/U", data["q_over_U_m"] * 1e6, found.flux / data["U_m_s"] * 1e6, Within(relative=1e-3), "µm"),
        ("p_max", data["p_max_Pa"] / 1e6, float(found.pressure[peak]) / 1e6, Within(relative=1e-3), "MPa"),
        (
            "x of p_max",
            data["x_p_max_m"] * 1e3,
            float(found.x[peak]) * 1e3,
            Within(absolute=500.0 * interval),
            "mm",
        ),
        (
            "x of reformation",
            data["x_reformation_m"] * 1e3,
            found.ruptured[1] * 1e3,
            Within(absolute=2e3 * interval),
            "mm",
        ),
        (
            "load above ambient",
            data["load_per_width_above_ambient_N_per_m"] / 1e3,
            found.load(data["p_ambient_Pa"]) / 1e3,
            Within(relative=1e-3),
            "kN/m",
        ),
    ):
        yield Comparison(quantity, "", published, computed, tolerance, unit, "closed form")


def draw(figure: Figure) -> None:
    """Pressure and liquid fraction along the wedge."""
    figure.set_size_inches(7.2, 3.6)
    left, right = figure.subplots(1, 2)
    data, found = _data(), film()
    left.plot(found.x * 1e3, found.pressure / 1e6, color=INK, label="engine")
    left.plot(
        data["x_p_max_m"] * 1e3, data["p_max_Pa"] / 1e6, marker="o", color=INK, markerfacecolor="none",
        linestyle="none", label="closed form",
    )  # fmt: skip
    left.set_ylabel("absolute pressure in MPa")
    left.legend()
    right.plot(found.x * 1e3, found.liquid, color=INK, label="liquid fraction θ")
    right.plot(found.x * 1e3, found.gap * 5e5, color=GREY, linestyle="--", label="gap, half of its µm")
    exact = np.linspace(data["pocket_start_m"], data["x_reformation_m"], 9)[1:-1]
    right.plot(
        exact * 1e3, 2.0 * data["q_over_U_m"] / gap(exact), marker="o", color=INK, markerfacecolor="none",
        linestyle="none", label="closed form, 2 q/(U h)",
    )  # fmt: skip
    right.axvline(data["x_reformation_m"] * 1e3, color=GREY, linewidth=0.8)
    right.set_ylim(0.0, 1.25)
    right.legend(fontsize=7, loc="lower right")
    right.set_ylabel("liquid fraction; gap in 2 µm")
    for axes in (left, right):
        axes.set_xlabel("x in mm")


CASE = ValidationCase(
    name="fowell_2007",
    title="Film engine: inlet suction of a pocketed wedge (Fowell et al. 2007)",
    story=Story(
        what=(
            "A pocket behind the inlet of a nearly parallel slider: the film ruptures where the gap widens, the "
            "vacuum sucks oil in, and the film closes again inside the pocket. Only a rupture condition that "
            "conserves the oil finds this. The exact solution is known."
        ),
        source=(
            "M. Fowell, A. V. Olver, A. D. Gosman, H. A. Spikes and I. Pegg, *Entrainment and inlet suction: two "
            "mechanisms of hydrodynamic lubrication in textured bearings*, Journal of Tribology 129 (2007) "
            "336–347; closed form as coded in the public repository octave-user/mboct-mbdyn-pkg, evaluated for "
            "its set-up."
        ),
        assumptions=(
            "Cavitation at zero absolute pressure, both ends flooded at 0.1 MPa. The slider enters the engine as "
            "a land of 1 rad with a bore profile of 4001 points, ten thousand times as wide as long, so that "
            "nothing leaves by the sides; 800 intervals of equal length. The flux is read in the ruptured film, "
            "U h θ/2."
        ),
        tolerances=(
            "Flux, largest pressure and load 0.1 %; the place of the largest pressure within half an interval, "
            "that of reformation within two intervals of 12.5 µm, for the engine knows it by lines only."
        ),
        differences=(
            "Nothing beyond the resolution: flux, pressure and load within 0.002 %. The film "
            "closes between two lines."
        ),
    ),
    run=run,
    draw=draw,
    caption="Pressure, liquid fraction and gap along the pocketed wedge: engine (lines) and closed form "
    "(circles). The vertical line marks where the film closes again.",
)
