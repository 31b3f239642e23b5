"""What all bearings of a machine need together: the numbers that size its pump and its cooler."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from babbitt.core.language import translated
from babbitt.core.limited_flow import quantity_held
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.design.values import pumped_flow
from babbitt.report.columns import is_fed
from babbitt.report.machine_table import in_machine_table
from babbitt.report.names import bearing_of
from babbitt.report.text import counted

NAMES = {
    "total_flow": "oil flow",
    "pump_flow": "required pump flow",
    "friction_power": "friction power",
    "heat_to_oil": "heat to the oil",
    "heat_to_surroundings": "heat to the surroundings",
}
"""What is summed up, and how it is called."""

MEANT = {
    "total_flow": "what passes the films that the limits are held against",
    "pump_flow": "what all films want, whatever the supply delivers",
    "heat_to_oil": "what the oil takes away",
}
"""What a sum is of, where its name does not say it."""

ONE_FLOW = 1e-3
"""Relative difference up to which the flow of the pump reads as that of the films."""


@dataclass(frozen=True)
class Sum:
    """One sum as it is shown."""

    name: str
    symbol: str
    value: str
    unit: str
    meant: str


@dataclass(frozen=True)
class Totals:
    """Sums over all bearings of a machine, in SI under the names of the quantities."""

    bearings: int
    values: Mapping[str, float]

    @property
    def heading(self) -> str:
        """What the sums are of."""
        return translated("Total of {bearings}", bearings=counted(self.bearings, "bearing"))

    @property
    def sums(self) -> tuple[Sum, ...]:
        """The sums in the engineer's units; the flow of the pump where it is another than that of the films."""
        flows = (self.values.get(name, 0.0) for name in ("pump_flow", "total_flow"))
        alike = math.isclose(*flows, rel_tol=ONE_FLOW)
        shown = {name: value for name, value in self.values.items() if not (alike and name == "pump_flow")}
        known = [(name, value, QUANTITIES[name].suited(value)) for name, value in shown.items()]
        return tuple(
            Sum(
                translated(NAMES[name]),
                q.symbol,
                q.format(value),
                q.display.label,
                translated(MEANT.get(name, "")),
            )
            for name, value, q in known
        )

    @property
    def sentence(self) -> str:
        """The sums in one line.

        >>> Totals(2, {"total_flow": 6e-4, "pump_flow": 8e-4}).sentence
        'Total of 2 bearings: oil flow Q = 36.0 L/min, required pump flow Q_pump = 48.0 L/min'
        """
        return f"{self.heading}: " + ", ".join(f"{s.name} {s.symbol} = {s.value} {s.unit}" for s in self.sums)


def totals(results: Sequence[Result]) -> Totals | None:
    """Sum up a machine.

    Parameters
    ----------
    results : sequence of Result

    Returns
    -------
    Totals or None
        None for a single bearing, where a bearing stands in the list more than once (operating points, clearance
        cases), and where one has no operating point: such a sum would be that of no machine.
    """
    films = [result for result in results if in_machine_table(result)]
    apart = {bearing_of(result.name) for result in films}
    if len(films) < 2 or len(apart) < len(films) or not all(result.outcome.solved for result in films):
        return None
    fed = [result for result in films if is_fed(result)]
    cooled = [result for result in films if "ambient_temperature" in result.values]
    concerned = {
        "total_flow": (fed, _value_of("total_flow")),
        "pump_flow": (fed, _pumped),
        "friction_power": (films, _value_of("friction_power")),
        "heat_to_oil": (fed, _value_of("heat_to_oil")),
        "heat_to_surroundings": (cooled, _value_of("heat_to_surroundings")),
    }
    values = {name: sum(map(value, of)) for name, (of, value) in concerned.items() if of}
    known = {name: value for name, value in values.items() if not math.isnan(value)}
    return Totals(len(films), known) if known else None


def _value_of(name: str) -> Callable[[Result], float]:
    """The reading of a quantity of the film that limits are held against; NaN where a result does not know it."""
    return lambda result: result.values.get(quantity_held(result, name), math.nan)


def _pumped(result: Result) -> float:
    """Oil in m3/s that a pump is to bring to a bearing: what its film wants, though the supply delivers less."""
    return pumped_flow(result.values)
