"""What the study of the screw-grooved footstep claims, beside what its own corrected equations give."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.footstep.clearances import critical_clearances
from babbitt.kinds.footstep.states import SteadyState, steady_states
from babbitt.kinds.footstep.superposition import GroovedFootstep
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK
from babbitt.validation.published.screw_heel_common import SOURCE, footstep, smooth, states
from babbitt.validation.tolerance import AtLeast, AtMost, SetBy, Tolerance, Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SOURCE_OF_CLAIMS = "text of the study"
GAPS = (5.0, 7.0, 10.0, 15.0, 20.0, 30.0, 40.0, 60.0)
CLEARANCES = (10.0, 15.0, 20.0, 25.0, 30.0, 40.0)


@dataclass(frozen=True)
class Claim:
    """One claim of the study.

    Attributes
    ----------
    says : str
        What it claims.
    quantity, place, unit : str
        The number that decides, and where.
    claimed : float
        The number claimed.
    hot, cold : float
        What the equations give for either steady state.
    tolerance : Tolerance
    refuted : str
        Why the equations cannot give it; empty for a claim that they reproduce in the hot state, which is not
        stable.
    """

    says: str
    quantity: str
    place: str
    unit: str
    claimed: float
    hot: float
    cold: float
    tolerance: Tolerance
    refuted: str = ""

    @property
    def verdict(self) -> str:
        """What the comparison says of the claim."""
        if self.tolerance.share(self.claimed, self.hot) <= 1.0:
            return "reproduced by the hot state, which is not stable"
        if self.tolerance.share(self.claimed, self.cold) <= 1.0:
            return "reproduced by the cold state"
        return "NOT REPRODUCED"


def _ratio(read: Callable[[SteadyState], float], name: str, gap: float, clearance: float) -> float:
    """A quantity of a state over that of the smooth heel."""
    found = states(footstep(gap, clearance))
    return read(found[name]) / read(found["smooth"])


def _gain(name: str, gap: float, clearance: float) -> float:
    return 100.0 * (_ratio(lambda s: s.load, name, gap, clearance) - 1.0)


def _rise(name: str, gap: float, clearance: float) -> float:
    found = states(footstep(gap, clearance))
    return found[name].rim_temperature - found["smooth"].rim_temperature


def _over(
    read: Callable[[SteadyState], float], name: str, first: tuple[float, float], last: tuple[float, float]
) -> float:
    """A quantity at the last point (gap, clearance) over that at the first."""
    return read(states(footstep(*last))[name]) / read(states(footstep(*first))[name])


def _power_saved(name: str, clearance: float) -> float:
    found = states(footstep(20.0, clearance))
    return found["smooth"].friction_power - found[name].friction_power


def largest_gain(gap: float, clearance: float) -> float:
    """Load gain in percent that the highest pressure of the groove allows at any groove flow."""
    import numpy as np

    model = GroovedFootstep(footstep(gap, clearance))
    flows = np.geomspace(1e-4, 1.0, 4000) * model.channel.largest_flow
    best = flows[int(np.argmax(model.channel.end(flows)[0]))]
    plain = steady_states(smooth(footstep(gap, clearance)))[0].load
    return 100.0 * (model.load_at(float(best)) / plain - 1.0)


@lru_cache
def claims() -> tuple[Claim, ...]:
    """Every claim of the study's text that has a number, those that fail included."""
    return (*_reproduced(), *_refuted())


def _both(of: Callable[[str], float]) -> tuple[float, float]:
    return of("hot"), of("cold")


def _ratios(read: Callable[[SteadyState], float], gap: float, clearance: float) -> tuple[float, float]:
    return _both(lambda name: _ratio(read, name, gap, clearance))


def _reproduced() -> Iterator[Claim]:
    hot, cold = critical_clearances(footstep())
    yield Claim(
        "a critical clearance exists, about 10 µm", "δ_cr", "", "µm", 10.0, 1e6 * hot.clearance,
        1e6 * cold.clearance,
        Within(relative=0.1),
    )  # fmt: skip
    yield Claim(
        "the temperature at small clearance does not exceed 70 °C", "θ", "δ = δ_cr", "°C", 70.0,
        hot.temperature - ZERO_CELSIUS, cold.temperature - ZERO_CELSIUS, AtMost(SetBy.SOURCE),
    )  # fmt: skip
    yield Claim(
        "the temperature is about 15 K above that of the smooth heel", "θ − θ_smooth", "h = δ = 20 µm", "K", 15.0,
        *_both(lambda name: _rise(name, 20.0, 20.0)), Within(relative=0.15),
    )  # fmt: skip
    spread = _both(lambda name: _spread([_rise(name, gap, 20.0) for gap in GAPS]))
    yield Claim(
        "this difference hardly depends on the face gap", "largest less smallest θ − θ_smooth", "h = 5..60 µm",
        "K", 0.0,
        *spread, Within(absolute=0.5),
    )  # fmt: skip
    for clearance in (10.0, 20.0, 40.0):
        yield Claim(
            "the friction power is about half", "P_smooth/P", f"h = 20 µm, δ = {clearance:g} µm", "", 2.0,
            *_ratios(lambda s: 1.0 / s.friction_power, 20.0, clearance), Within(relative=0.1),
        )  # fmt: skip
    yield Claim(
        "the load rises with the face gap", "T(60 µm)/T(20 µm)", "δ = 20 µm", "", 1.0,
        *_both(lambda name: _over(lambda s: s.load, name, (20.0, 20.0), (60.0, 20.0))), AtLeast(SetBy.SOURCE),
    )  # fmt: skip
    yield Claim(
        "and saturates at the pressure of the recess", "p₁(60 µm)/p₂", "δ = 20 µm", "", 1.0,
        *_both(lambda name: states(footstep(60.0, 20.0))[name].rim_pressure / footstep().supply_pressure),
        Within(relative=0.02),
    )  # fmt: skip
    yield Claim(
        "the leakage rises with the face gap", "Q_l(60 µm)/Q_l(20 µm)", "δ = 20 µm", "", 1.0,
        *_both(lambda name: _over(lambda s: s.leakage, name, (20.0, 20.0), (60.0, 20.0))), AtLeast(SetBy.SOURCE),
    )  # fmt: skip
    yield Claim(
        "and with the clearance", "Q_l(40 µm)/Q_l(20 µm)", "h = 20 µm", "", 1.0,
        *_both(lambda name: _over(lambda s: s.leakage, name, (20.0, 20.0), (20.0, 40.0))), AtLeast(SetBy.SOURCE),
    )  # fmt: skip
    yield Claim(
        "the load falls with the clearance", "T(15 µm)/T(10 µm)", "h = 20 µm", "", 1.0,
        *_both(lambda name: _over(lambda s: s.load, name, (20.0, 10.0), (20.0, 15.0))), AtMost(SetBy.SOURCE),
    )  # fmt: skip


def _refuted() -> Iterator[Claim]:
    yield Claim(
        "the load is 10 % larger", "load gain", "h = δ = 20 µm", "%", 10.0,
        *_both(lambda name: _gain(name, 20.0, 20.0)), Within(absolute=2.0),
        "the hot state gains nothing (−1.8 to 0 % over h = 5..60 µm); the cold one, which alone is stable, "
        "gains 60 "
        "to 5 %",
    )  # fmt: skip
    yield Claim(
        "the load is 25 % larger", "load gain", "h = 20 µm, δ = 10 µm", "%", 25.0,
        *_both(lambda name: _gain(name, 20.0, 10.0)), Within(absolute=2.0),
        "the highest pressure that the groove reaches at any flow bounds the gain at "
        f"{largest_gain(20.0, 10.0):.1f} %",
    )  # fmt: skip
    for clearance in (20.0, 10.0):
        yield Claim(
            "the leakage is several orders of magnitude above that of the smooth heel", "Q_l/Q_l,smooth",
            f"h = 20 µm, δ = {clearance:g} µm", "", 100.0,
            *_ratios(lambda s: s.leakage, 20.0, clearance), AtLeast(SetBy.OWN),
            "the leakage follows pressure and viscosity at the rim, and neither differs by orders",
        )  # fmt: skip
    yield Claim(
        "the powers keep their distance over the clearance", "ΔP(25 µm)/ΔP(10 µm)", "h = 20 µm", "", 1.0,
        *_both(lambda name: _power_saved(name, 25.0) / _power_saved(name, 10.0)), Within(relative=0.1),
        "both powers fall with the clearance and their ratio, not their difference, stays",
    )  # fmt: skip


def _spread(values: list[float]) -> float:
    return max(values) - min(values)


def claims_table() -> str:
    """The claims as lines of text: claim, number claimed, both states, verdict."""
    lines = [f"{'claim':<72} {'where':<24} {'claimed':>9} {'hot':>9} {'cold':>9}  verdict"]
    for claim in claims():
        numbers = " ".join(f"{value:9.4g}" for value in (claim.claimed, claim.hot, claim.cold))
        lines.append(f"{claim.says:<72} {claim.place:<24} {numbers}  {claim.verdict}")
    return "\n".join(lines)


def run() -> tuple[Comparison, ...]:
    """The hot state, which the study computes, is judged where a claim can hold; the cold one is shown."""
    rows = []
    for claim in claims():
        where = f"{claim.place}, " if claim.place else ""
        rows.append(
            Comparison(
                claim.quantity,
                f"{where}hot, not stable",
                claim.claimed,
                claim.hot,
                claim.tolerance,
                claim.unit,
                SOURCE_OF_CLAIMS,
                suspect=f"not reproduced: {claim.refuted}" if claim.refuted else "",
            )
        )
        rows.append(
            Comparison(
                claim.quantity,
                f"{where}cold, stable",
                claim.claimed,
                claim.cold,
                claim.tolerance,
                claim.unit,
                SOURCE_OF_CLAIMS,
                information="the stable steady state, for comparison",
            )
        )
    return tuple(rows)


def draw(figure: Figure) -> None:
    """Load gain over the face gap and over the clearance, with what the study claims."""
    figure.set_size_inches(7.2, 3.2)
    left, right = figure.subplots(1, 2, sharey=True)
    for name, style in (("hot", "-"), ("cold", "--")):
        left.plot(GAPS, [_gain(name, gap, 20.0) for gap in GAPS], color=INK, linestyle=style, label=name)
        right.plot(
            CLEARANCES, [_gain(name, 20.0, at) for at in CLEARANCES], color=INK, linestyle=style, label=name
        )
    left.axhline(10.0, color=GREY, linewidth=0.8)
    left.annotate("claimed: 10 %", (60.0, 10.0), xytext=(0, 3), textcoords="offset points", ha="right", color=GREY)
    right.plot(10.0, 25.0, "x", color=GREY)
    right.annotate(
        "claimed: 25 %", (10.0, 25.0), xytext=(6, 0), textcoords="offset points", va="center", color=GREY
    )
    left.set(xlabel="h in µm, δ = 20 µm", ylabel="load gain over the smooth heel in %")
    right.set(xlabel="δ in µm, h = 20 µm")
    left.legend()


CASE = ValidationCase(
    name="screw_heel_claims",
    title="Screw-grooved footstep: what the study claims",
    story=Story(
        what="Every claim of the study's text that has a number, beside what its own equations give once "
        "misprints are "
        "corrected, for both steady states. The state that reproduces the claims, the hot one, is not stable: a "
        "small "
        "change of temperature takes the heel to the cold state or lets the groove drain the rim. A designer "
        "should "
        "know which claims stand before cutting a groove.",
        source=SOURCE,
        assumptions="The friction of the clearance takes the mean of two viscosities, which the study does not "
        "say and "
        "which is the choice that meets its claim on power. 'About half' is taken as 2, 'several orders' as at "
        "least 100.",
        tolerances="Words such as 'about' are given 10 to 15 %.",
        differences="Load gains of 10 and 25 %, a leakage larger by orders, and powers at equal distance are no "
        "property "
        "of the equations: they are shown as the study prints them and not judged. What is judged and agrees "
        "belongs "
        "to a state that will not be found running. By narrow-groove theory with "
        "a metal "
        "that takes 5 W/K a gain of 10 % at δ = 20 µm is plausible; a halved power is not, since at equal "
        "temperature the "
        "groove takes at most a quarter of the friction away.",
    ),
    run=run,
    draw=draw,
    caption="Load gain of both steady states (hot: not stable; cold: stable) over face gap and clearance, and "
    "the gains "
    "that the study claims.",
)
