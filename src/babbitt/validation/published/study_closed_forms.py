"""Studies against closed forms: Sobol indices of Petroff friction, and the yield of a linear limit."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.special import ndtr

from babbitt.case.case_file import CaseFile
from babbitt.case.loading import case_from_dict
from babbitt.case.parts.study import StudyBlock
from babbitt.core.units import AS_WRITTEN
from babbitt.study.indices import Indices, indices_of
from babbitt.study.plan import plan
from babbitt.study.study import Study, run_study
from babbitt.study.yields import yield_of
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import BAND, GREY, INK
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_BEARING: dict[str, Any] = {
    "kind": "journal",
    "name": "Petroff bearing",
    "diameter": "120 mm",
    "width": "60 mm",
    "span": "360 deg",
    "materials": {part: {"thermal_expansion": "11e-6 1/K"} for part in ("bearing", "journal")},
    "clearance": {"kind": "relative", "mean": "2 permille"},
    "lubricant": {"kind": "constant", "dynamic_viscosity": "20 mPa s"},
    "effective_temperature": "20 degC",
    "speed": "1000 rpm",
}

_VARIED = {
    "lubricant.dynamic_viscosity": {"uniform": ["15 mPa s", "25 mPa s"]},
    "speed": {"uniform": ["800 rpm", "1200 rpm"]},
    "clearance.mean": {"uniform": ["1.5 permille", "2.5 permille"]},
}
_SYMBOLS = ("η", "ω", "ψ")
_SPREADS = ((15.0, 25.0, 1), (800.0, 1200.0, 2), (1.5, 2.5, -1))
"""Least and largest value, and the power with which the friction power goes."""

_BASE = 128
"""Base samples of the indices."""

_MEAN, _DEVIATION, _SAMPLES = 1.9, 0.1, 1200
"""Specific load in MPa, its standard deviation, samples."""

_LIMITS = (1.75, 1.85, 1.95, 2.05)
"""Permitted specific loads, MPa."""

_CUT = 3.0


def indices() -> tuple[list[float], list[float]]:
    """First and total Sobol indices of a product of independent powers.

    With ``v_i = Var(x_i^p)/E(x_i^p)²`` the first is ``v_i/V``, the total ``1 - (Π_{k≠i} (1 + v_k) - 1)/V``, and
    ``V = Π (1 + v_k) - 1``.
    """
    spread = [_relative_variance(*one) for one in _SPREADS]
    whole = math.prod(1.0 + one for one in spread) - 1.0
    total = []
    for place in range(len(spread)):
        others = math.prod(1.0 + one for number, one in enumerate(spread) if number != place) - 1.0
        total.append(1.0 - others / whole)
    return [one / whole for one in spread], total


def _relative_variance(low: float, high: float, power: int) -> float:
    """Variance over squared mean of a power of a uniform number."""
    return _moment(low, high, 2 * power) / _moment(low, high, power) ** 2 - 1.0


def _moment(low: float, high: float, order: int) -> float:
    if order == -1:
        return math.log(high / low) / (high - low)
    return float((high ** (order + 1) - low ** (order + 1)) / ((order + 1) * (high - low)))


def share_below(limit: float) -> float:
    """Share of a normal law truncated at 3 standard deviations below a limit: the yield of a linear limit."""
    at = (limit - _MEAN) / _DEVIATION
    return float((ndtr(at) - ndtr(-_CUT)) / (ndtr(_CUT) - ndtr(-_CUT)))


@lru_cache
def studied_indices() -> Indices:
    """The indices of the friction power of a bearing at a small eccentricity."""
    case = case_from_dict({**_BEARING, "eccentricity_ratio": 0.02})
    asked = {"kind": "sensitivity", "vary": _VARIED, "samples": _BASE, "outputs": ["friction_power"]}
    (found,) = indices_of(_study(case, asked))
    return found


@lru_cache
def studied_loads() -> tuple[float, ...]:
    """Specific loads of the samples in MPa, and with them the margins of their limit."""
    case = case_from_dict({**_BEARING, "specific_load": "1.9 MPa", "limits": {"specific_load": "2 MPa"}})
    law = {"normal": [f"{_MEAN} MPa", f"{_DEVIATION} MPa"]}
    asked = {"kind": "tolerance", "vary": {"specific_load": law}, "samples": _SAMPLES, "sampling": "random"}
    study = _study(case, asked)
    margins = study.of("sample")["margin_C103"]
    return tuple(2.0 * (1.0 - margins))


def _study(case: CaseFile, asked: dict[str, Any]) -> Study:
    return run_study(plan(case, StudyBlock.model_validate(asked, context=AS_WRITTEN)))


def run() -> tuple[Comparison, ...]:
    """Compare indices and yields."""
    return (*_indices(), *_yields())


def _indices() -> Iterator[Comparison]:
    found = studied_indices()
    for what, exact, ours in zip(("first", "total"), indices(), (found.first, found.total), strict=True):
        for symbol, expected, value in zip(_SYMBOLS, exact, ours, strict=True):
            yield Comparison(
                f"Sobol index, {what}", symbol, expected, value, Within(absolute=0.03), "", "closed form"
            )


def _yields() -> Iterator[Comparison]:
    loads = np.array(studied_loads())
    for limit in _LIMITS:
        exact = share_below(limit)
        share, *_ = yield_of(loads <= limit, [loads.size], "random")
        error = math.sqrt(exact * (1.0 - exact) / loads.size)
        yield Comparison(
            "yield", f"p̄ ≤ {limit:g} MPa", 100.0 * exact, 100.0 * share,
            Within(absolute=round(300.0 * error, 2)), "%", "closed form",
        )  # fmt: skip


def draw(figure: Figure) -> None:
    """Indices beside their closed forms, and the yield over the limit."""
    figure.set_size_inches(7.2, 3.4)
    bars, curve = figure.subplots(1, 2)
    found, places = studied_indices(), np.arange(len(_SYMBOLS), dtype=float)
    for shift, exact, ours, half, label, colour in (
        (-0.2, indices()[0], found.first, found.first_conf, "first", INK),
        (0.2, indices()[1], found.total, found.total_conf, "total", GREY),
    ):
        bars.bar(places + shift, exact, 0.3, color=BAND, edgecolor=colour)
        bars.errorbar(places + shift, ours, yerr=half, fmt="o", color=colour, label=f"{label}, study")
    bars.set_xticks(places, _SYMBOLS)
    bars.set_ylabel("Sobol index of the friction power")
    bars.legend()
    limits = np.linspace(_MEAN - 3.5 * _DEVIATION, _MEAN + 3.5 * _DEVIATION, 141)
    loads = np.array(studied_loads())
    curve.plot(limits, [100.0 * min(max(share_below(one), 0.0), 1.0) for one in limits], color=GREY)
    shown = limits[::10]
    curve.plot(
        shown, [100.0 * float(np.mean(loads <= one)) for one in shown], "o", color=INK, markerfacecolor="none"
    )
    curve.set_xlabel("permitted specific load in MPa")
    curve.set_ylabel("yield in %")


CASE = ValidationCase(
    name="study_closed_forms",
    title="Studies: Sobol indices of Petroff friction and the yield of a linear limit",
    story=Story(
        what=(
            "At a small eccentricity the friction of a bearing is that of Petroff: the power goes as viscosity "
            "times "
            "speed squared over relative clearance, a product of powers whose Sobol indices have closed forms. "
            "The "
            "yield under a linear limit, here of the specific load, is a value of the truncated normal law. Both "
            "studies solve the bearing by ISO 7902 in every row and know nothing of that."
        ),
        source=(
            "N. Petroff, *Friction in machines* (1883); I. M. Sobol, *Mathematics and Computers in Simulation* 55 "
            "(2001) 271: indices by the variances of conditional means, here of a product."
        ),
        assumptions=(
            "Eccentricity ratio 0.02, one viscosity, no expansion by heat. Scatter as named in the rows: "
            "uniform laws "
            "of ±25, ±20 and ±25 %, a normal law truncated at three standard deviations."
        ),
        tolerances=(
            "Indices 0.03, less than the 95 % intervals of 128 base samples; yields three standard errors of 2000 "
            "random "
            "samples, each with its own (the tests hold the same yield with 10⁵ samples of a slider)."
        ),
        differences=(
            "The scatter of the samples alone. The eccentricity adds less than 0.1 % to the friction of a centred "
            "journal."
        ),
    ),
    run=run,
    draw=draw,
    caption="Left: indices of viscosity, speed and relative clearance by closed form (bars) and by the study "
    "(points, 95 % intervals). Right: yield over the limit, closed form (line) and samples (points).",
)
