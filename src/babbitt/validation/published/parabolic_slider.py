"""The parabolic slider: rupture and reformation of a converging-diverging film against exact quadrature."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK, LINES
from babbitt.validation.published.film_bearings import Array
from babbitt.validation.published.sliders import Slider, SliderFilm, solve_slider
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_INTERVALS = 1600


def _data() -> dict[str, Any]:
    data: dict[str, Any] = reference_data("sliders")["parabolic"]
    return data


def gap(x: Array) -> Array:
    """h_min (1 + (2 x/L - 1)²), m."""
    data = _data()
    return np.asarray(data["h_min_m"] * (1.0 + (2.0 * x / data["L_m"] - 1.0) ** 2))


@lru_cache
def film(intervals: int = _INTERVALS) -> SliderFilm:
    """The engine's film."""
    data = _data()
    slider = Slider(data["L_m"], data["h_min_m"], data["U_m_s"], data["mu_Pa_s"], data["p_ambient_Pa"], gap)
    return solve_slider(slider, intervals)


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Compare pressure, load, flux, and where the film ruptures and closes."""
    return tuple(_rows())


def _rows() -> Iterator[Comparison]:
    data, found = _data(), film()
    peak, length = int(found.pressure.argmax()), data["L_m"]
    place = Within(absolute=1.5 / _INTERVALS)
    for quantity, published, computed, tolerance, unit in (
        ("p_max", data["p_max_Pa"] / 1e6, float(found.pressure[peak]) / 1e6, Within(relative=1e-3), "MPa"),
        ("x/L of p_max", data["x_p_max_m"] / length, float(found.x[peak]) / length, place, ""),
        (
            "load above ambient",
            data["load_above_ambient_N_per_m"] / 1e3,
            found.load(data["p_ambient_Pa"]) / 1e3,
            Within(relative=1e-3),
            "kN/m",
        ),
        ("q", data["q_per_width_m2_s"] * 1e6, found.flux * 1e6, Within(relative=1e-3), "mm²/s"),
        ("x/L of rupture", data["x_rupture_over_L"], found.ruptured[0] / length, place, ""),
        ("x/L of reformation", data["x_reformation_over_L"], found.ruptured[1] / length, place, ""),
        ("smallest θ", data["theta_min"], float(found.liquid.min()), Within(relative=2e-3), ""),
    ):
        yield Comparison(quantity, "", published, computed, tolerance, unit, "quadrature")


def draw(figure: Figure) -> None:
    """Pressure and liquid fraction along the slider, and how the errors fall with the grid."""
    figure.set_size_inches(7.2, 3.6)
    left, right = figure.subplots(1, 2)
    data, found = _data(), film()
    x = found.x / data["L_m"]
    left.plot(x, found.pressure / data["p_max_Pa"], color=INK, label="pressure / largest")
    left.plot(x, found.liquid, color=INK, linestyle="--", label="liquid fraction θ")
    for key in ("x_rupture_over_L", "x_reformation_over_L"):
        left.axvline(data[key], color=GREY, linewidth=0.8)
    left.set_xlabel("x/L")
    left.set_ylabel("pressure and liquid fraction")
    left.legend(loc=(0.15, 0.1), handlelength=1.2, fontsize=7)
    counts = [100, 200, 400, 800, 1600]
    films = [film(count) for count in counts]
    errors = {
        "p_max": [abs(float(each.pressure.max()) / data["p_max_Pa"] - 1.0) for each in films],
        "q": [abs(each.flux / data["q_per_width_m2_s"] - 1.0) for each in films],
        "load": [
            abs(each.load(data["p_ambient_Pa"]) / data["load_above_ambient_N_per_m"] - 1.0) for each in films
        ],
    }
    for (name, values), line in zip(errors.items(), LINES, strict=False):
        right.loglog(
            counts, [100.0 * value for value in values], linestyle=line, marker="o", color=INK, label=name
        )
    right.axhline(0.1, color=GREY, linewidth=0.8)
    right.set_xticks(counts, [str(count) for count in counts])
    right.set_xticks([], minor=True)
    right.set_xlabel("intervals")
    right.set_ylabel("error in %")
    right.legend()


CASE = ValidationCase(
    name="parabolic_slider",
    title="Film engine: rupture and reformation under a parabolic slider",
    story=Story(
        what=(
            "The benchmark on which cavitation algorithms are tried: a gap that narrows and widens again. The "
            "film ruptures behind the narrowest place, and closes just before the flooded outlet, in a jump of "
            "the liquid fraction that smeared schemes miss."
        ),
        source=(
            "Set-up of D. Vijayaraghavan and T. G. Keith, Tribology Transactions 32 (1989) 225–233, and of G. "
            "Bayada and L. Chupin, Journal of Tribology 135 (2013), as in the public repository "
            "hannes-holey/GaPFlow. The reference values are ours: exact quadrature of the one-dimensional film "
            "of an incompressible liquid. The papers use other cavitation pressures and compressible liquids; "
            "their curves are not compared."
        ),
        assumptions=(
            "Jakobsson-Floberg-Olsson conditions with cavitation at zero absolute pressure, both ends flooded at "
            "0.101 MPa; flat surface moving. In the engine a land of 1 rad without side flow; 1600 intervals."
        ),
        tolerances=(
            "Pressure, load and flux 0.1 %, smallest liquid fraction 0.2 %; places within one and a half "
            "intervals, for the engine knows them by lines only."
        ),
        differences=(
            "Pressure and load agree within 0.0002 %. The flux is off by 0.06 %: it follows from the gap at the "
            "rupture, which is known to an interval, and its error falls with the first power of the interval."
        ),
    ),
    run=run,
    draw=draw,
    caption="Pressure and liquid fraction along the slider, the thin lines marking rupture and reformation by "
    "quadrature; and the error of three quantities over the number of intervals.",
)
