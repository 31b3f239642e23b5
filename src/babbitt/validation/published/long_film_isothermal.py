"""The infinitely long film of one viscosity: Reynolds' closed solution."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.journal.infinitely_long_bearing.pressure import Gap, divergence_form, published_form
from babbitt.numerics.roots import bracketed_root
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK, LINES, MARKERS, logarithmic_axis
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

ECCENTRICITIES = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8)
FORMS = {"divergence form": divergence_form, "published form": published_form}
_TOLERANCES = {
    360: {"θ_r": Within(absolute=0.2), "f": Within(relative=0.001), "F": Within(relative=0.001)},
    90: {"θ_r": Within(absolute=0.8), "f": Within(relative=0.005), "F": Within(relative=0.005)},
}


@lru_cache
def exact(eccentricity_ratio: float) -> dict[str, float]:
    """Rupture angle in degrees, load number f and friction number F by quadrature of the closed solution.

    ``dP/dθ = 6 (H - H_r)/H³`` with ``P(0) = P(θ_r) = 0``; ``W = 6 μ ω R L (R/c)² f``; friction power of the full
    film ``(μ u² L R/c) F`` with ``F = ∫ [1/H + 3 (H - H_r)/H²] dθ``.
    """
    from scipy.integrate import quad

    def gap(angle: float) -> float:
        return 1.0 + eccentricity_ratio * math.cos(angle)

    def gradient(angle: float, at_rupture: float) -> float:
        return (gap(angle) - at_rupture) / gap(angle) ** 3

    def miss(rupture: float) -> float:
        return float(quad(gradient, 0.0, rupture, (gap(rupture),), epsabs=1e-13, epsrel=1e-12)[0])

    end = bracketed_root(miss, math.pi + 1e-6, 1.5 * math.pi, absolute=1e-12)
    at_rupture = gap(end)
    # by parts: the load is the moment of the gradient
    along = quad(lambda a: gradient(a, at_rupture) * math.sin(a), 0.0, end, epsabs=1e-13, epsrel=1e-12)[0]
    across = quad(lambda a: gradient(a, at_rupture) * math.cos(a), 0.0, end, epsabs=1e-13, epsrel=1e-12)[0]
    friction = quad(lambda a: 1.0 / gap(a) + 3.0 * (gap(a) - at_rupture) / gap(a) ** 2, 0.0, end, epsrel=1e-12)[0]
    return {"θ_r": math.degrees(end), "f": math.hypot(along, across), "F": float(friction)}


@lru_cache
def computed(form: str, eccentricity_ratio: float, cells: int) -> dict[str, float]:
    """The same by one of our discretisations."""
    gap = Gap.of(eccentricity_ratio, cells)
    found = FORMS[form](gap, np.ones(cells + 1))
    slope = np.diff(found.nodes) / gap.step
    shear = found.full / gap.sectors + 0.5 * gap.sectors * slope
    return {
        "θ_r": math.degrees(found.rupture_angle),
        "f": math.hypot(*found.load(gap.step)) / 6.0,
        "F": gap.step * float(shear.sum()),
    }


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Compare rupture, load and friction, with both discretisations on two grids."""
    return tuple(_rows())


def _rows() -> Iterator[Comparison]:
    for cells, tolerances in _TOLERANCES.items():
        for form in FORMS:
            for eccentricity in ECCENTRICITIES:
                ours, theirs = computed(form, eccentricity, cells), exact(eccentricity)
                for quantity, tolerance in tolerances.items():
                    yield Comparison(
                        quantity,
                        f"ε = {eccentricity:g}, {form}, {cells} sectors",
                        theirs[quantity],
                        ours[quantity],
                        tolerance,
                        "°" if quantity == "θ_r" else "",
                        "closed form",
                        5 if quantity != "θ_r" else 3,
                    )


def draw(figure: Figure) -> None:
    """Deviation of the load over the number of sectors."""
    figure.set_size_inches(7.2, 3.2)
    sectors = (45, 90, 180, 360, 720)
    panels = figure.subplots(1, 2, sharey=True)
    for axes, form in zip(panels, FORMS, strict=True):
        for eccentricity, line, marker in zip((0.2, 0.5, 0.8), LINES, MARKERS, strict=False):
            misses = [
                100.0 * abs(computed(form, eccentricity, n)["f"] / exact(eccentricity)["f"] - 1.0) for n in sectors
            ]
            axes.plot(
                sectors, misses, linestyle=line, marker=marker, color=INK, markerfacecolor="none",
                label=f"ε = {eccentricity:g}",
            )  # fmt: skip
        axes.plot(sectors, [0.1 * (90.0 / n) ** 2 for n in sectors], color=GREY, linewidth=0.8, label="slope 2")
        logarithmic_axis(axes, sectors)
        axes.set_yscale("log")
        axes.set_xlabel("sectors")
        axes.set_title(form)
    panels[0].set_ylabel("deviation of the load in %")
    panels[0].legend(fontsize=7)


CASE = ValidationCase(
    name="long_film_isothermal",
    title="Long film of one viscosity: Reynolds' closed solution",
    story=Story(
        what=(
            "Without change of viscosity the infinitely long film has a closed solution: where it breaks, what it "
            "carries, what it rubs. Both discretisations of `method: long_film` must meet it; that they meet it "
            "alike shows that they differ by the change of viscosity alone."
        ),
        source=(
            "O. Reynolds (1886), A. Sommerfeld (1904), with the rupture condition of H. W. Swift (1932) and "
            "W. Stieber (1933); the integrals by adaptive quadrature to twelve digits."
        ),
        assumptions="None: one viscosity, rigid surfaces, pressure zero at the widest gap and at rupture.",
        tolerances=(
            "Load and friction 0.1 % and rupture angle 0.2° with 360 sectors, 0.5 % and 0.8° with 90, as a "
            "reconstruction of the published model asks for."
        ),
        differences=(
            "Nothing beyond the discretisation, which falls with the square of the sector (figure). The rupture "
            "angle is found within a sector from the parabola in which the pressure ends."
        ),
    ),
    run=run,
    draw=draw,
    caption="Deviation of the load from the closed solution over the number of sectors; thin: slope two.",
)
