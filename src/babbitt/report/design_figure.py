"""The figure of a design: which designs keep their limits, at which power."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.core.language import translated
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Verdict
from babbitt.report.drawing import GREY, INK, Sheet
from babbitt.study.design import designs_of
from babbitt.study.study import Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["design_figures"]

MARKERS = "osD^vP*Xhd8p"


def design_figures(study: Study) -> Iterator[tuple[str, str, Figure]]:
    """Least margin over friction power of all designs within the limits, the proposals numbered."""
    found = designs_of(study)
    shown = [one for one in found.tried if one.within] or list(found.nearest)
    if not shown:
        return
    figure, axes = Sheet(150.0, 84.0, left=14.0, bottom=11.0).panels()
    panel, power = axes[0][0], QUANTITIES["friction_power"]
    oils = list(dict.fromkeys(str(one.fields["lubricant"]) for one in sorted(shown, key=lambda one: one.power)))
    for place, oil in enumerate(oils):
        own = [one for one in shown if one.fields["lubricant"] == oil]
        colour, marker = str(0.75 * place / max(1, len(oils) - 1)), MARKERS[place % len(MARKERS)]
        for clean, fill, label in ((True, colour, oil), (False, "white", "_")):
            chosen = [one for one in own if (one.verdict == Verdict.PASS.key) == clean]
            at = [power.shown(one.power) for one in chosen], [100.0 * one.margin for one in chosen]
            look = {"markerfacecolor": fill, "markersize": 3.0, "markeredgewidth": 0.5, "zorder": 2 + clean}
            panel.plot(*at, marker, color=colour, label=label, **look)
    panel.axhline(100.0 * study.block.reserve, color=GREY, linewidth=0.7, linestyle=(0, (5, 2)))
    for place, (one, _) in enumerate(found.proposals, 1):
        best = (power.shown(one.power), 100.0 * one.margin)
        panel.plot(*best, "o", color=INK, markerfacecolor="none", markersize=8.0, markeredgewidth=0.8)
        panel.annotate(str(place), best, xytext=(5, 4), textcoords="offset points", fontsize=8, weight="bold")
    panel.set_xlabel(
        translated("{quantity} in {unit}", quantity=translated("friction power"), unit=power.display.label)
    )
    panel.set_ylabel(translated("least margin in %"))
    panel.legend(frameon=False, fontsize=6, handlelength=1.0, loc="best")
    caption = translated(
        "{which}, by their oil: least margin over largest friction power of all clearances. Open: with remarks or "
        "beyond a limit; rings: the proposals; dashed: the margin from which they are ranked by power.",
        which=translated("Designs within all limits" if found.within else "The nearest misses"),
    )
    yield "designs", caption, figure
