"""Narrow-groove theory against Reynolds' equation in two dimensions on one groove pitch."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.footstep.narrow_groove import NarrowGrooveAnnulus
from babbitt.validation.case import Comparison, Evidence, Story, ValidationCase
from babbitt.validation.figure import GREY, INK
from babbitt.validation.published.screw_heel_common import CUBIC_MILLIMETRE, footstep
from babbitt.validation.research.groove_pitch import GroovePitch, PitchFilm, pitch_film
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

RISE = 0.5e6
"""Pa; the film is linear in it."""
STARTS = (5, 10, 20, 40, 80)
JUDGED_FROM = 20


@lru_cache
def film(starts: int, rise: float) -> PitchFilm:
    """Film of one pitch of the study's groove with another number of starts."""
    step, groove = footstep(), footstep().groove
    assert groove is not None, "the study's heel has a groove"
    pitch = GroovePitch(
        step.geometry.radius, step.geometry.length, starts, groove.groove_share, groove.angle, step.clearance,
        groove.depth, step.oil.viscosity, step.angular_speed * step.geometry.radius,
    )  # fmt: skip
    return pitch_film(pitch, rise)


def _pairs(starts: int) -> dict[str, tuple[float, float, str]]:
    """By quantity: narrow-groove theory, film in two dimensions, unit."""
    annulus, mu = NarrowGrooveAnnulus(footstep()), footstep().oil.viscosity
    still, driven = film(starts, 0.0), film(starts, RISE)
    dead_end = RISE * still.flow / (still.flow - driven.flow)
    power = mu * float(annulus.wall_power(np.asarray(annulus.dragged_flow)))
    return {
        "Q₀": (annulus.dragged_flow / CUBIC_MILLIMETRE, still.flow / CUBIC_MILLIMETRE, "mm³/s"),
        "G": (
            annulus.conductance / mu / CUBIC_MILLIMETRE * 1e6,
            (still.flow - driven.flow) / RISE / CUBIC_MILLIMETRE * 1e6,
            "mm³/(s MPa)",
        ),
        "p without flow": (annulus.dragged_flow / annulus.conductance * mu * 1e-6, dead_end * 1e-6, "MPa"),
        "P": (power, still.wall_power, "W"),
    }


def run() -> tuple[Comparison, ...]:
    """Compare for 5 to 80 starts."""
    return tuple(
        Comparison(
            quantity,
            f"{starts} starts",
            theory,
            ours,
            Within(relative=0.02),
            unit,
            "narrow-groove theory",
            information="" if starts >= JUDGED_FROM else "few grooves: shown, since the theory is for many",
        )
        for starts in STARTS
        for quantity, (theory, ours, unit) in _pairs(starts).items()
    )


def draw(figure: Figure) -> None:
    """Deviation over the number of starts, and the pressure of one pitch at five starts."""
    figure.set_size_inches(7.2, 3.2)
    left, right = figure.subplots(1, 2)
    for quantity, line, marker in (("G", "-", "o"), ("p without flow", "--", "s"), ("Q₀", ":", "^")):
        misses = [100.0 * abs(ours / theory - 1.0) for theory, ours, _ in (_pairs(n)[quantity] for n in STARTS)]
        left.loglog(STARTS, misses, color=INK, linestyle=line, marker=marker, label=quantity)
    left.axhline(2.0, color=GREY, linewidth=0.8)
    left.set_xticks(STARTS, [str(n) for n in STARTS])
    left.set_xticks([], minor=True)
    left.set(xlabel="number of starts", ylabel="deviation in %")
    left.legend()
    found = film(5, 0.0)
    for share, line in ((0.25, ":"), (0.5, "--"), (0.75, "-")):
        column = int(np.argmin(np.abs(found.z - share * (found.z[-1] + found.z[0]))))
        right.plot(
            1e3 * found.s, 1e-6 * found.pressure[:, column], color=INK, linestyle=line, label=f"z = {share:g} L"
        )
    right.set(xlabel="across one pitch in mm", ylabel="p − p_a in MPa")
    right.legend()


CASE = ValidationCase(
    name="film_groove_pitch",
    title="Screw groove: narrow-groove theory against the film in two dimensions",
    story=Story(
        what="Narrow-groove theory replaces a grooved clearance by a film with averaged properties, as if there "
        "were "
        "infinitely many grooves. The film of one real pitch, with its jumps and its open ends, says how many "
        "grooves "
        "are many: flow without pressure difference, conductance, pressure without flow, friction.",
        source="J. H. Vohr and C. Y. Chow, Journal of Basic Engineering 87 (1965) 568-578 (narrow-groove "
        "theory), for "
        "the heel of the pump footstep of A. S. Kirichenko (2011) with 5 to 80 starts of equal shares.",
        assumptions="Uniform pressure at both ends of the heel; one viscosity. The pitch shrinks as the starts "
        "grow, "
        "angle, depth and share of the groove stay.",
        tolerances="2 % for 20 or more starts, where the theory is meant to hold. Fewer are shown without "
        "judgement.",
        differences="All deviations fall with one over the number of starts: what differs is the end of each "
        "groove, a "
        "piece as long as the pitch. The pump's own 5 starts let through 2.9 % more than the theory says.",
    ),
    run=run,
    draw=draw,
    caption="Left: deviation of the film from the theory. Right: pressure across one pitch of the pump's "
    "groove, no "
    "pressure difference between its ends.",
    evidence=Evidence.REGRESSION,
)
