"""Thrust pads and shaft line against closed forms and an independent prototype."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.shaft_line.forced import forced
from babbitt.kinds.shaft_line.impedance import respond
from babbitt.kinds.shaft_line.line import Seating, ShaftLine
from babbitt.kinds.shaft_line.natural import undamped_frequencies
from babbitt.kinds.shaft_line.pads import FilmPads, PrescribedPads
from babbitt.kinds.thrust.sharing import share_of
from babbitt.kinds.thrust.state import condensed
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK
from babbitt.validation.published.trawler_line import PAD, RIPPLE, ROD, RUNOUT, SPEED, duty, films, line
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BLADE = 4.0 * SPEED
LENGTH, LAND, SPEED_OF_SLIDER, OIL, FAR_OUT = 0.02, 20e-6, 5.0, 0.03, 50.0


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Closed forms, then the prototype."""
    return (*_sliders(), *_exact(), *_pad(), *_given_films(), *_base_case())


def wide_pad(intervals: int) -> float:
    """Load at mid radius of a wide plane pad, h1/h2 = 2.19, in mu U B^2 L/h2^2."""
    from babbitt.reynolds.sector.sector import PlaneMotion, SectorPad, sector_film

    pad = SectorPad(FAR_OUT - 0.3, FAR_OUT + 0.3, LENGTH / FAR_OUT, OIL, SPEED_OF_SLIDER / FAR_OUT)
    film = sector_film(pad, PlaneMotion(2.19 * LAND, 0.0, -1.19 * LAND / LENGTH), intervals=intervals, degree=24)
    middle = film.pressure[:, film.radius.size // 2]
    scale = LAND**2 / (OIL * SPEED_OF_SLIDER * LENGTH**2)
    return float(np.trapezoid(middle, film.theta * FAR_OUT)) * scale


def exponential_pad(intervals: int) -> float:
    """Load of a square pad under h = h1 exp(-a x), h1/h2 = 2.2, in mu U B^2 L/h2^2."""
    from babbitt.reynolds.sector.sector import PlaneMotion, SectorPad, sector_film

    along = np.linspace(0.0, 1.0, 8 * intervals + 1)
    form = tuple((float(value), float(value)) for value in LAND * (2.2 ** (1.0 - along) - 1.0))
    half = 0.5 * LENGTH
    pad = SectorPad(FAR_OUT - half, FAR_OUT + half, LENGTH / FAR_OUT, OIL, SPEED_OF_SLIDER / FAR_OUT, form=form)
    film = sector_film(pad, PlaneMotion(LAND), intervals=intervals, degree=12)
    return film.load * LAND**2 / (OIL * SPEED_OF_SLIDER * LENGTH**3)


def exponential_series() -> float:
    """The same by a Fourier series across: P'' - 3 a P' - k^2 P = -(6 mu U a/h1^2) c_n exp(2 a x)."""
    a, total = math.log(2.2), 0.0
    for n in range(1, 400, 2):
        k, sign = n * math.pi, (-1.0) ** ((n - 1) // 2)
        particular = -6.0 * a * (4.0 * sign / k) / 2.2**2 / (-2.0 * a * a - k * k)
        root = math.sqrt(9.0 * a * a + 4.0 * k * k)
        up, down = 0.5 * (3.0 * a + root), 0.5 * (3.0 * a - root)
        matrix = np.array([[math.exp(-up), 1.0], [1.0, math.exp(down)]])
        grow, fall = np.linalg.solve(matrix, -particular * np.array([1.0, math.exp(2.0 * a)]))
        along = grow * (1.0 - math.exp(-up)) / up + fall * (math.exp(down) - 1.0) / down
        total += (along + particular * (math.exp(2.0 * a) - 1.0) / (2.0 * a)) * 2.0 * sign / k
    return total


def _sliders() -> Iterator[Comparison]:
    k = 1.19
    closed = 6.0 * (math.log(1.0 + k) - 2.0 * k / (k + 2.0)) / k**2
    yield Comparison("W*", "wide plane pad, h₁/h₂ = 2.19", closed, wide_pad(256), Within(1e-4), "", "closed form")
    series = exponential_series()
    for n, allowed in ((32, 6e-3), (64, 1.5e-3)):
        yield Comparison(
            "W*",
            f"square exponential film, {n} intervals",
            series,
            exponential_pad(n),
            Within(allowed),
            "",
            "Fourier series",
        )


def _exact() -> Iterator[Comparison]:
    state = films().state(50e-6)
    yield Comparison(
        "k(0)",
        "tilting pad, 2 W/h_p",
        2.0 * state.load / state.height,
        condensed(state, 0.0).real,
        Within(1e-6),
        "N/m",
        "similarity",
    )
    hard = PrescribedPads((1e16,) * 8, (0.0,) * 8)
    bare = ShaftLine(14e3, 0.0, (ROD,), 8e3)
    angle = BLADE * ROD.transit_time
    magnified = 1.0 / (math.cos(angle) - 14e3 / ROD.mass * angle * math.sin(angle))
    total = respond(bare, hard, BLADE, 1.0, np.zeros(8, dtype=complex)).total_force.real
    yield Comparison("ΣN/Q", "rod on a rigid bearing, 8.33 Hz", magnified, total, Within(1e-5), "", "closed form")
    first = undamped_frequencies(bare, hard, 1)[0] * ROD.transit_time
    yield Comparison(
        "kl tan kl",
        "rod on a rigid bearing, m₃/m₁",
        ROD.mass / 14e3,
        first * math.tan(first),
        Within(1e-4),
        "",
        "closed form",
    )
    even = PrescribedPads((2.5e9,) * 8, (1.8e8,) * 8, 2e10, 18.0)
    kt = even.film(SPEED)[0]
    under = 2e10 - SPEED**2 * 18.0
    expected = abs(kt * under / (kt + under)) * 5e-6
    alone = forced(line(), even, SPEED, (), (RUNOUT,)).bounds()[0]
    yield Comparison("|N_R|", "no tilt, |Z| A_R", expected, float(alone), Within(1e-6), "N", "closed form")


def _pad() -> Iterator[Comparison]:
    data = reference_data("trawler_line")["pad"]
    state = films().state(films().height_for(data["load_N"]))
    inertia = duty().bearing.inertia
    pairs = [
        ("h_p", data["pivot_film_um"], 1e6 * state.height, "µm"),
        ("h_min", data["minimum_film_um"], 1e6 * state.minimum_film_thickness, "µm"),
        ("p_max", data["maximum_pressure_MPa"], 1e-6 * state.maximum_pressure, "MPa"),
        ("k(0)", data["stiffness_0"], condensed(state, 0.0).real, "N/m"),
    ]
    for order in (1, 4):
        moving = condensed(state, order * SPEED, inertia)
        pairs.append((f"k({order} ω)", data[f"stiffness_{order}"], moving.real, "N/m"))
        pairs.append((f"d({order} ω)", data[f"damping_{order}"], moving.imag / (order * SPEED), "N s/m"))
    for name, expected, ours, unit in pairs:
        yield Comparison(name, "pad at 62.5 kN", expected, ours, Within(5e-3), unit, "prototype")


def given_pads() -> PrescribedPads:
    """Films given: k_i = 2.5e9 (1 + 0.4 cos gamma_i), d_i = 1.8e8 (1 + 0.4 cos gamma_i)."""
    weight = 1.0 + 0.4 * np.cos(2.0 * math.pi * np.arange(8) / 8)
    return PrescribedPads(tuple(2.5e9 * weight), tuple(1.8e8 * weight), 2e10, 18.0)


def _given_films() -> Iterator[Comparison]:
    data = reference_data("trawler_line")["given_films"]
    both = forced(line(), given_pads(), SPEED, (RIPPLE,), (RUNOUT,))
    point = forced(line().rigid(), given_pads(), SPEED, (RIPPLE,), ())
    for name, found, rows in (
        ("N_Q, rigid shaft", point.parts[0].response.forces, data["ripple_point_N"]),
        ("N_Q, rod", both.parts[0].response.forces, data["ripple_rod_N"]),
        ("N_R, rod", both.parts[1].response.forces, data["runout_rod_N"]),
    ):
        for pad, (real, imaginary) in enumerate(rows):
            expected = complex(real, imaginary)
            yield Comparison(
                f"|{name}|",
                f"pad {pad + 1}",
                abs(expected),
                abs(complex(found[pad])),
                Within(1e-5),
                "N",
                "prototype",
            )
    for pad, peak in enumerate(data["peaks_N"]):
        yield Comparison(
            "peak, rod", f"pad {pad + 1}", peak, float(both.peaks()[pad]), Within(1e-5), "N", "prototype"
        )
    seated = ShaftLine(14e3, 8e4, (ROD,), 8e3, seating=Seating(1e9, 0.0, 12e3))
    for name, of, values in (
        ("f, rod", line(), data["natural_rod_Hz"]),
        ("f, seated", seated, data["natural_seated_Hz"]),
    ):
        found_frequencies = undamped_frequencies(of, given_pads(), len(values))
        for n, (expected, ours) in enumerate(zip(values, found_frequencies, strict=True), start=1):
            yield Comparison(name, f"mode {n}", expected, ours / math.tau, Within(1e-5), "Hz", "prototype")


def _base_case() -> Iterator[Comparison]:
    data = reference_data("trawler_line")
    share = share_of(films(), duty().bearing, duty().thrust)
    for pad, load in enumerate(data["share_kN"]):
        yield Comparison(
            "W_i", f"pad {pad + 1}", load, float(share.loads[pad]) / 1e3, Within(5e-3), "kN", "prototype"
        )
    frequencies = undamped_frequencies(line(), FilmPads(share), 4)
    for n, (expected, found) in enumerate(zip(data["natural_Hz"], frequencies, strict=True), start=1):
        yield Comparison("f, films", f"mode {n}", expected, found / math.tau, Within(1e-3), "Hz", "prototype")


def draw(figure: Figure) -> None:
    """Errors of three loads over the number of intervals: lines of slope two."""
    figure.set_size_inches(7.2, 3.6)
    axes = figure.subplots()
    counts = (8, 16, 32, 64, 128)
    from babbitt.kinds.thrust.equilibrium import pad_state

    fine = [pad_state(PAD, 50e-6, 0.045, SPEED, intervals=n, degree=12).load for n in (128, 256)]
    limit = fine[1] + (fine[1] - fine[0]) / 3.0
    series = exponential_series()
    k = 1.19
    closed = 6.0 * (math.log(1.0 + k) - 2.0 * k / (k + 2.0)) / k**2
    for label, marker, errors in (
        ("wide plane pad", "o", [abs(wide_pad(n) / closed - 1.0) for n in counts]),
        ("square exponential film", "s", [abs(exponential_pad(n) / series - 1.0) for n in counts]),
        (
            "tilting sector pad",
            "^",
            [abs(pad_state(PAD, 50e-6, 0.045, SPEED, intervals=n, degree=12).load / limit - 1.0) for n in counts],
        ),
    ):
        axes.loglog(
            counts,
            [100.0 * error for error in errors],
            color=INK,
            marker=marker,
            markerfacecolor="none",
            label=label,
        )
    axes.loglog(counts, [300.0 / n**2 for n in counts], color=GREY, linewidth=0.8, label="slope 2")
    axes.set_xticks(counts, [str(n) for n in counts])
    axes.set_xticks([], minor=True)
    axes.set_xlabel("intervals along the pad")
    axes.set_ylabel("error of the load in %")
    axes.legend()


CASE = ValidationCase(
    name="thrust_pad_forms",
    title="Thrust pads and shaft line: closed forms and an independent prototype",
    story=Story(
        what=(
            "Whatever can be had in closed form of a thrust pad and of a rod with masses, and the numbers of an "
            "independent program of the same equations: pad, pads with given films, static share, frequencies."
        ),
        source=(
            "Wide plane pad: O. Reynolds (1886). Square pad under an exponential film: Fourier series across, "
            "exact along. "
            "Rods: textbook waves. Prototype: finite volumes on 97 x 129 nodes (pad) and 25 x 33 (share)."
        ),
        assumptions=(
            "Sliders are thin rings far out. The pad is that of the trawler line: radii 190 and 375 mm, 36°, "
            "pivot at 0.6 "
            "of the pad and 290 mm, 45 mPa s, 125 rpm."
        ),
        tolerances=(
            "Closed forms 1e-6 to 1e-4, films by their mesh: 0.6 % at 32 intervals, 0.15 % at 64, the usual "
            "mesh. Prototype: "
            "1e-5 where films are given, 0.5 % where both solve a film, which is what its own meshes differ by."
        ),
        differences=(
            "None beyond the meshes. Errors of our loads fall with the square of the interval; across the pad the "
            "polynomials leave less than 0.01 %. The peak pressure is read between the nodes, or it would be "
            "3 % low."
        ),
    ),
    run=run,
    draw=draw,
    caption="Error of the load of three pads over the number of intervals along them; the grey line has slope "
    "two.",
)
