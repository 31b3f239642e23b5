"""What the source of the long film says of one mean temperature and of a conducting bush."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from babbitt.kinds.journal.infinitely_long_bearing.mean_temperature import mean_temperature_film
from babbitt.kinds.journal.infinitely_long_bearing.model import Discretisation, ExchangeZone
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import INK, LINES, MARKERS
from babbitt.validation.published.long_film_bearing import conducting_bush_ratio, film, solved
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import AtLeast, AtMost, SetBy, Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PUBLISHED = (Discretisation.PUBLISHED_MEAN, Discretisation.PUBLISHED_LITERAL)
SPEEDS = (3000, 12000)


@lru_cache
def mean_temperature_ratio(discretisation: Discretisation, speed: int, eccentricity_ratio: float) -> float:
    """Load along the eccentricity over that of the film of one mean temperature, which rubs where it is full."""
    own = film(discretisation, speed)
    alone = mean_temperature_film(own, eccentricity_ratio, ExchangeZone.FILM)
    return solved(discretisation, speed, eccentricity_ratio).load_along / alone.load_along


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Compare both statements."""
    return (*_mean_temperature(), *_bush())


def _mean_temperature() -> Iterator[Comparison]:
    printed = reference_data("long_film")["load_over_mean_temperature_load_at_3000_rpm_and_0.8"]
    for mode in PUBLISHED:
        at = f"ε = 0.8, 3000 rpm, {mode.value}"
        ratio = mean_temperature_ratio(mode, 3000, 0.8)
        yield Comparison("W/W_mean", at, printed, ratio, Within(absolute=0.06), "", "figure 3", 2)
        rise = mean_temperature_ratio(mode, 12000, 0.8) - ratio
        yield Comparison("rise of W/W_mean", f"12000 over {at}", 0.05, rise, AtLeast(SetBy.OWN), "", "figure 3", 2)
        for speed in SPEEDS:
            calm = mean_temperature_ratio(mode, speed, 0.2)
            place = f"ε = 0.2, {speed} rpm, {mode.value}"
            yield Comparison("W/W_mean", place, 1.0, calm, Within(absolute=0.04), "", "figure 3", 2)
    for speed in SPEEDS:
        yield Comparison(
            "W/W_mean",
            f"ε = 0.8, {speed} rpm, consistent",
            printed,
            mean_temperature_ratio(Discretisation.CONSISTENT, speed, 0.8),
            None,
            "",
            "figure 3",
            2,
            information="the rise with speed belongs to the published discretisation, not to physics",
        )


def _bush() -> Iterator[Comparison]:
    printed = reference_data("long_film")["load_with_conducting_bush_over_adiabatic_at_0.8"]
    for mode in Discretisation:
        at = {speed: conducting_bush_ratio(mode, speed, 0.8) for speed in SPEEDS}
        for speed, ratio in at.items():
            yield Comparison(
                "W(100)/W(0)", f"ε = 0.8, {speed} rpm, {mode.value}", printed, ratio, Within(absolute=0.0125), "",
                "figure 4", 2,
            )  # fmt: skip
        apart = 100.0 * abs(at[3000] - at[12000])
        yield Comparison(
            "difference between speeds", f"ε = 0.8, {mode.value}", 1.0, apart,
            AtMost(SetBy.SPECIFICATION), "percentage points", "figure 4", 1,
        )  # fmt: skip


def draw(figure: Figure) -> None:
    """Both ratios over the eccentricity."""
    figure.set_size_inches(7.2, 3.4)
    left, right = figure.subplots(1, 2)
    eccentricities = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8)
    for mode, marker in zip(Discretisation, MARKERS, strict=False):
        for speed, line in zip(SPEEDS, LINES, strict=False):
            label = f"{mode.value}, {speed} rpm"
            style = {"marker": marker, "linestyle": line, "color": INK, "markerfacecolor": "none", "label": label}
            left.plot(eccentricities, [mean_temperature_ratio(mode, speed, e) for e in eccentricities], **style)
            right.plot(eccentricities, [conducting_bush_ratio(mode, speed, e) for e in eccentricities], **style)
    left.set_ylabel("load over that of one mean temperature")
    right.set_ylabel("load with conducting over adiabatic bush")
    for axes in (left, right):
        axes.set_xlabel("eccentricity ratio ε")
    left.legend(fontsize=6.5)


CASE = ValidationCase(
    name="long_film_figures",
    title="Long film with heat exchange: one mean temperature, and a bush that conducts",
    story=Story(
        what=(
            "Two statements of the source: a film that heats up along its way carries less than one of a single "
            "mean temperature, by up to 12 % at 3000 rpm and ε = 0.8; and a bush that conducts heat around the "
            "journal, but gives off none, lowers the load by up to about 2 %, at every speed alike."
        ),
        source=(
            "Figures 3 and 4 of the same publication as the table of relative loads, as its text tells them; the "
            "caption of figure 3 inverts the ratio."
        ),
        assumptions=(
            "One mean temperature: the mean of inlet and outlet, the latter from the film's own balance with the "
            "friction of the full film (the source does not say where the film rubs). Wall of the bush 5 mm, "
            "100 W/(m K), no heat to the surroundings (wall not published)."
        ),
        tolerances=(
            "Figure 3: 0.82 to 0.94 at ε = 0.8 and 3000 rpm, rising with speed, within 4 % of 1 at ε = 0.2. "
            "Figure 4: 0.9675 to 0.9925, less than one percentage point between the speeds."
        ),
        differences=(
            "The published modes agree. The default mode, which conserves the flow, has a ratio of 0.78 and 0.75 "
            "at ε = 0.8: the single mean temperature flatters a bearing by more than the source says, and the "
            "more the faster it runs. The rise with speed is a property of the published discretisation."
        ),
    ),
    run=run,
    draw=draw,
    caption="Left: load over that of the film of one mean temperature. Right: load with a conducting bush over "
    "that with an adiabatic one.",
)
