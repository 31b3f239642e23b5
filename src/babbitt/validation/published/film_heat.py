"""The thermal film: Couette flow with dissipation between walls against its closed form, and convergence."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.units import ZERO_CELSIUS
from babbitt.reynolds.heat.heat_model import (
    THERMAL_ENGINEERING,
    BushRing,
    ConductingWalls,
    FilmHeat,
    HeatGrid,
    JournalHeat,
)
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land, Resolution, grooved_bore
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK
from babbitt.validation.published.film_bearings import Array
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from babbitt.reynolds.heat.thermal_solution import ThermalFilm

_VISCOSITY, _CONDUCTIVITY, _CAPACITY = 0.02, 0.13, 1.7e6
_DIAMETER, _WIDTH, _GAP, _SPEED = 0.1, 0.05, 50e-6, 300.0
_BUSH, _JOURNAL, _COLD = 330.0, 340.0, 323.15
_LAYERS = (4, 8, 16, 32)
_INTERVALS = (24, 48, 96, 192)
_LOAD = 112.8e3


def _same(temperature: Array) -> Array:
    return np.full_like(temperature, _VISCOSITY)


def _iso_vg_32(temperature: Array) -> Array:
    """Pa s: a Vogel law through 0.0275 Pa s at 40 °C and 0.0046 Pa s at 100 °C."""
    return np.asarray(4.0e-5 * np.exp(1000.0 / (temperature - 160.02)))


def couette(eta: Array) -> Array:
    """Temperature across the gap in K: T_B + (T_J - T_B) η + μ U²/(2 k) η (1 - η)."""
    heated = _VISCOSITY * (0.5 * _DIAMETER * _SPEED) ** 2 / (2.0 * _CONDUCTIVITY)
    return np.asarray(_BUSH + (_JOURNAL - _BUSH) * eta + heated * eta * (1.0 - eta))


@lru_cache
def concentric(layers: int) -> ThermalFilm:
    """Concentric journal, one viscosity, both walls held at their temperatures."""
    from babbitt.reynolds.heat.thermal_equilibrium import thermal_film_at

    ring = JournalFilm(
        _DIAMETER, _WIDTH, _GAP, _VISCOSITY, _SPEED, (Land(0.0, 2.0 * math.pi),), Cavitation.REYNOLDS,
        FilmStart.PERIODIC,
    )  # fmt: skip
    held = ConductingWalls(
        BushRing((0.5 * _DIAMETER, 0.5 * _DIAMETER + 1e-7), (1e9,), 1e9, _BUSH), JournalHeat(_JOURNAL)
    )
    heat = FilmHeat(_same, _CAPACITY, _CONDUCTIVITY, 300.0, held, HeatGrid(layers))
    return thermal_film_at(ring, heat, (0.0, 0.0))


@lru_cache
def bearing(intervals: int, layers: int | None = None) -> ThermalFilm:
    """Two lands of 176 degrees with conducting bush, D = 0.4 m, 900 rpm, 112.8 kN, ISO VG 32 at 50 °C."""
    from babbitt.reynolds.heat.thermal_equilibrium import solve_thermal_journal

    lands = grooved_bore((0.0, math.pi), math.radians(4.0))
    film = JournalFilm(0.4, 0.263, 195e-6, float(_iso_vg_32(np.array(_COLD))), 30.0 * math.pi, lands)
    walls = ConductingWalls(BushRing((0.2, 0.3), (50.0,), 50.0, 293.15))
    heat = FilmHeat(_iso_vg_32, 1.72e6, _CONDUCTIVITY, _COLD, walls)
    if layers is not None:
        heat = replace(heat, grid=HeatGrid(layers))
    usual = (THERMAL_ENGINEERING.intervals, None)
    fine = Resolution(6, intervals, intervals // 2, 1e-7)
    return solve_thermal_journal(
        film, heat, (0.0, -_LOAD), THERMAL_ENGINEERING if (intervals, layers) == usual else fine
    )


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Compare the closed form, the balances, and the default grid with the finest."""
    return tuple(_rows())


def _rows() -> Iterator[Comparison]:
    found = concentric(_LAYERS[-1])
    closed = couette(found.layers)
    place = f"{_LAYERS[-1]} layers"
    yield Comparison("T_max", place, closed.max() - ZERO_CELSIUS, float(found.maximum_temperature) - ZERO_CELSIUS,
                     Within(absolute=0.02), "°C", "closed form")  # fmt: skip
    power = _VISCOSITY * (0.5 * _DIAMETER * _SPEED) ** 2 / _GAP * math.pi * _DIAMETER * _WIDTH
    yield Comparison("P_f", place, power, found.heat.dissipation, Within(relative=1e-6), "W", "closed form")
    slope = 0.5 * _VISCOSITY * (0.5 * _DIAMETER * _SPEED) ** 2 / _GAP
    towards = slope + _CONDUCTIVITY * (_JOURNAL - _BUSH) / _GAP
    area = math.pi * _DIAMETER * _WIDTH
    yield Comparison("heat to the bush", place, towards * area, found.heat.bush, Within(relative=1e-3), "W",
                     "closed form")  # fmt: skip
    usual, finest = bearing(THERMAL_ENGINEERING.intervals), bearing(_INTERVALS[-1], 24)
    grids = "default against finest grid"
    hottest, ours = (one.maximum_temperature - ZERO_CELSIUS for one in (finest, usual))
    yield Comparison("T_max", grids, hottest, ours, Within(absolute=0.2), "°C", "own grid")  # fmt: skip
    thin = finest.film.minimum_film_thickness
    yield Comparison("h_min", grids, 1e6 * thin, 1e6 * usual.film.minimum_film_thickness, Within(relative=0.01),
                     "µm", "own grid")  # fmt: skip
    yield Comparison("heat unaccounted for", "default grid", 0.0, usual.heat.balance_error, Within(absolute=1e-8),
                     "", "identity")  # fmt: skip


def draw(figure: Figure) -> None:
    """Temperature across the gap, and how errors fall with layers and intervals."""
    figure.set_size_inches(7.2, 3.4)
    left, middle, right = figure.subplots(1, 3)
    eta = np.linspace(0.0, 1.0, 101)
    left.plot(couette(eta) - ZERO_CELSIUS, eta, color=GREY, label="closed form")
    coarse = concentric(_LAYERS[1])
    left.plot(coarse.temperature[0, 0] - ZERO_CELSIUS, coarse.layers, "o", color=INK, fillstyle="none",
              label=f"{_LAYERS[1]} layers")  # fmt: skip
    left.set(xlabel="T in °C", ylabel="y/h")
    left.legend(fontsize=7)
    errors = [np.abs(concentric(n).temperature[0, 0] - couette(concentric(n).layers)).max() for n in _LAYERS]
    middle.loglog(_LAYERS, errors, marker="o", color=INK)
    middle.set(xlabel="layers", ylabel="largest error in K, Couette film")
    finest = bearing(_INTERVALS[-1], 24).maximum_temperature
    right.semilogx(_INTERVALS[:-1], [abs(bearing(n, 24).maximum_temperature - finest) for n in _INTERVALS[:-1]],
                   marker="o", color=INK)  # fmt: skip
    right.set(xlabel="intervals per land", ylabel="T_max against the finest grid in K")
    for panel, counts in ((middle, _LAYERS), (right, _INTERVALS[:-1])):
        panel.set_xticks(counts, [str(count) for count in counts])
        panel.set_xticks([], minor=True)


CASE = ValidationCase(
    name="film_heat",
    title="Thermal film: Couette flow between walls, balance of heat, convergence",
    story=Story(
        what=(
            "The film between concentric cylinders makes heat everywhere alike and gives it to both walls: a "
            "parabola across the gap. A loaded bearing with conducting bush shows how its temperatures change "
            "with the grid, and that no heat is lost."
        ),
        source=(
            "Closed form of the Couette flow with dissipation between walls of given temperatures, as in "
            "textbooks of heat transfer. The bearing is compared with Babbitt's own finest grid; no measured "
            "bearing of which everything is published is included."
        ),
        assumptions=(
            "Couette: one viscosity of 20 mPa s, D = 100 mm, gap 50 µm, 300 rad/s. Bearing: two lands of 176°, "
            "D = 400 mm, 900 rpm, 112.8 kN, ISO VG 32 fed at 50 °C, bush of 100 mm, 50 W/(m K), to still air."
        ),
        tolerances=(
            "Closed form: 0.02 K with 32 layers, friction power to round-off. Bearing: 0.2 K and 1 % of the film "
            "thickness on the default grid; heat unaccounted for 1e-8 of the friction power."
        ),
        differences=(
            "The error across the gap falls with the square of the layers. Along the film the scheme is of first "
            "order: the hottest place moves by less than 0.2 K from the default to the finest grid."
        ),
    ),
    run=run,
    draw=draw,
    caption="Temperature across the gap of the Couette film; its error over the number of layers; and the highest "
    "temperature of the loaded bearing over the intervals of a land, against the finest grid.",
)
