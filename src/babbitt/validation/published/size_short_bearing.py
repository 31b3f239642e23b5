"""The largest load of a narrow bearing by the search for permitted values, against its algebraic root."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from babbitt.case.case_file import CaseFile
from babbitt.case.loading import case_from_dict
from babbitt.solving import solve
from babbitt.study.plan import plan
from babbitt.study.size import size_block, size_of
from babbitt.study.study import run_study
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import INK, LINES, MARKERS
from babbitt.validation.published.short_bearing import closed_form
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DIAMETER, CLEARANCE, VISCOSITY, SPEED = 0.1, 100e-6, 0.1, 1500.0 * math.pi / 30.0
"""m, m on the radius, Pa s, rad/s."""

_WIDTHS = (0.101, 0.202)
_ECCENTRICITIES = (0.2, 0.5, 0.8)
_NARROW = {0.2: 0.006, 0.5: 0.012, 0.8: 0.04}
_LIMIT = {0.2: 0.001, 0.5: 0.002, 0.8: 0.01}


def root(width_ratio: float, eccentricity_ratio: float) -> float:
    """Load at which the film is as thin as its limit by the theory of the short bearing, N.

    The film ``c (1 - ε)`` gives the eccentricity, and that the load ``F = So η ω B D/ψ²``: no search is needed.
    """
    sommerfeld = closed_form(width_ratio, eccentricity_ratio)["So"]
    area = width_ratio * DIAMETER**2
    return sommerfeld * VISCOSITY * SPEED * area / (2.0 * CLEARANCE / DIAMETER) ** 2


@lru_cache
def found(width_ratio: float, eccentricity_ratio: float) -> float:
    """The upper end of the permitted loads by the search, N."""
    near = root(width_ratio, eccentricity_ratio)
    case = _case(width_ratio, eccentricity_ratio, near)
    block = size_block(case, "load", f"{near / 3.0!r} N", f"{3.0 * near!r} N", 24, limits=("C101",))
    size = size_of(run_study(plan(case, block)))
    return size.intervals[-1].upper.value


def _case(width_ratio: float, eccentricity_ratio: float, load: float) -> CaseFile:
    return case_from_dict(
        {
            "kind": "journal",
            "name": "Narrow bearing",
            "diameter": f"{DIAMETER!r} m",
            "width": f"{width_ratio * DIAMETER!r} m",
            "span": "360 deg",
            "clearance": {"kind": "radial", "mean": f"{CLEARANCE!r} m"},
            "materials": {part: {"thermal_expansion": "11e-6 1/K"} for part in ("bearing", "journal")},
            "lubricant": {"kind": "constant", "dynamic_viscosity": f"{VISCOSITY!r} Pa s"},
            "effective_temperature": "20 degC",
            "load": f"{load!r} N",
            "speed": f"{SPEED!r} rad/s",
            "limits": {"minimum_film_thickness": f"{CLEARANCE * (1.0 - eccentricity_ratio)!r} m"},
        }
    )


def in_the_limit(eccentricity_ratio: float) -> float:
    """The load that was found over the root, as the width vanishes: both widths free of the term in its square."""
    half, full = (found(x, eccentricity_ratio) / root(x, eccentricity_ratio) for x in _WIDTHS)
    return half + (half - full) / 3.0


def run() -> tuple[Comparison, ...]:
    """Compare loads at B/D = 0.101 and in the limit, and the film at the end that was found with its limit."""
    return (*_loads(), *_films())


def _loads() -> Iterator[Comparison]:
    for eccentricity in _ECCENTRICITIES:
        narrow = _WIDTHS[0]
        place = f"h_lim = {1.0 - eccentricity:g} c, B/D"
        yield Comparison(
            "F_max", f"{place} = {narrow:g}", root(narrow, eccentricity), found(narrow, eccentricity),
            Within(relative=_NARROW[eccentricity]), "N", "closed form",
        )  # fmt: skip
        yield Comparison(
            "F_max over root", f"{place} → 0", 1.0, in_the_limit(eccentricity),
            Within(relative=_LIMIT[eccentricity]), "", "closed form",
        )  # fmt: skip


def _films() -> Iterator[Comparison]:
    for eccentricity in _ECCENTRICITIES:
        load = found(_WIDTHS[0], eccentricity)
        result = solve(_case(_WIDTHS[0], eccentricity, load)).results[0]
        limit = 1e6 * CLEARANCE * (1.0 - eccentricity)
        yield Comparison(
            "h_min at F_max", f"h_lim = {1.0 - eccentricity:g} c", limit, 1e6 * result.minimum_film_thickness,
            Within(relative=1e-4), "µm", "limit of the case",
        )  # fmt: skip


def draw(figure: Figure) -> None:
    """What is permitted over the film limit, beside the roots."""
    figure.set_size_inches(6.4, 3.6)
    axes = figure.subplots()
    films = [0.15 + 0.1 * step for step in range(8)]
    for width, line, marker in zip(_WIDTHS, LINES, MARKERS, strict=False):
        roots = [root(width, 1.0 - film) for film in films]
        axes.plot(films, roots, linestyle=line, color=INK, label=f"short bearing, B/D = {width:g}")
        ours = [found(width, 1.0 - film) for film in films]
        axes.plot(
            films, ours, marker=marker, linestyle="none", color=INK, markerfacecolor="none",
            label=f"size, B/D = {width:g}",
        )  # fmt: skip
    axes.set_yscale("log")
    axes.set_xlabel("least film that is permitted over the radial clearance")
    axes.set_ylabel("largest load in N")
    axes.legend()


CASE = ValidationCase(
    name="size_short_bearing",
    title="Permitted loads: a narrow bearing against its algebraic root",
    story=Story(
        what=(
            "`babbitt size` scans a field and brackets each end of what is permitted. The largest load of a "
            "bearing "
            "whose film may not be thinner than a limit has an algebraic root by the theory of the short bearing, "
            "since the limit gives the eccentricity and that the load. The search knows nothing of it: it solves "
            "the bearing by ISO 7902 at each load."
        ),
        source=(
            "F. W. Ocvirk, *Short-bearing approximation for full journal bearings*, NACA TN 2808 (1952), as on "
            "the "
            "page of the short bearing."
        ),
        assumptions="One viscosity, no expansion by heat; D = 100 mm, c = 100 µm, 0.1 Pa s, 1500 rpm.",
        tolerances=(
            "At B/D = 0.101 what the width takes of the load in the theory itself: 0.6, 1.2 and 4 % from thick to "
            "thin film. Extrapolated to vanishing width 0.1, 0.2 and 1 %, as the next term of the theory grows "
            "towards thin films. The film at the end that was found is that of the limit within 0.01 %, the "
            "promise "
            "of the search."
        ),
        differences=(
            "Nothing beyond the finite width, as on the page of the short bearing: the load that was found is "
            "smaller "
            "than the root by a share that falls as the square of the width."
        ),
    ),
    run=run,
    draw=draw,
    caption="Largest permitted load over the film limit: algebraic roots (lines) and what the search finds "
    "(points), at two widths.",
)
