"""Tables 4 and 5 of the gearbox study: all eleven bearings of the reverse gear."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from babbitt.core.result import Result
from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.iso7902.procedure import check, check_at_temperature
from babbitt.validation.case import Comparison, Evidence, Story, ValidationCase
from babbitt.validation.figure import BAND, GREY, INK
from babbitt.validation.published.reverse_gear_inputs import (
    design_case,
    inferred,
    inferred_bearing,
    published,
)
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_FRICTION_UNKNOWN = (
    "The friction of the study is not known. With 1.10 times the friction curve of the full bearing the "
    "heat balance gives these outlet temperatures; Table 2 of the same study needs 1.256."
)


@dataclass(frozen=True)
class _Column:
    """A column of the tables: symbol, unit, how to read it from a result, how far it may be off."""

    symbol: str
    unit: str
    table: str
    read: Callable[[Result], float]
    tolerance: Within


_COLUMNS = {
    "eccentricity_ratio": _Column("ε", "", "5", lambda r: r.eccentricity_ratio, Within(absolute=0.008)),
    "minimum_film_um": _Column("h_min", "µm", "4", lambda r: r.minimum_film_thickness * 1e6, Within(absolute=1.5)),
    "side_flow_L_min": _Column("Q₃", "L/min", "4", lambda r: r.side_flow * 6e4, Within(relative=0.06)),
    "supply_flow_L_min": _Column("Qp", "L/min", "4", lambda r: r.supply_flow * 6e4, Within(relative=0.05)),
    "reynolds_number": _Column("Re", "", "5", lambda r: r.film_reynolds_number, Within(relative=0.045)),
    "critical_reynolds_number": _Column(
        "Re_cr", "", "5", lambda r: r.critical_reynolds_number, Within(relative=0.001)
    ),
    "stability_clearance_permille": _Column(
        "ψ_min", "‰", "5", lambda r: r.stability_relative_clearance * 1e3, Within(absolute=0.05)
    ),
    "recommended_clearance_permille": _Column(
        "ψ_rec", "‰", "5", lambda r: r.recommended_relative_clearance * 1e3, Within(absolute=0.05)
    ),
    "experience_film_limit_um": _Column(
        "h_lim,1", "µm", "4", lambda r: r.empirical_film_limit * 1e6, Within(absolute=0.01)
    ),
}
_SUPPLY_THROUGH_POCKETS = Within(relative=0.10)


@lru_cache
def solved(name: str) -> Result:
    """Our answer at the effective temperature that belongs to the published outlet temperature."""
    inlet = inferred()["common"]["inlet_temperature_C"]
    outlet = next(
        row["outlet_temperature_C"] for row in published()["tables_4_and_5"]["rows"] if row["name"] == name
    )
    return check_at_temperature(design_case(name), (inlet + outlet) / 2.0 + ZERO_CELSIUS)


@lru_cache
def outlet_temperature(name: str) -> float:
    """Our own outlet temperature in °C, with the friction factor that suits these tables."""
    factor = inferred()["common"]["friction_factor_of_tables_4_and_5"]
    kelvin: float = check(design_case(name, friction_factor=factor)).outlet_temperature
    return kelvin - ZERO_CELSIUS


def run() -> tuple[Comparison, ...]:
    """Compare eleven bearings; their temperatures are shown as information."""
    rows = published()["tables_4_and_5"]["rows"]
    return tuple(comparison for row in rows for comparison in _bearing(row))


def _bearing(row: dict[str, Any]) -> Iterator[Comparison]:
    decimals = published()["tables_4_and_5"]["decimals"]
    name = row["name"]
    bearing = inferred_bearing(name)
    for key, column in _COLUMNS.items():
        yield Comparison(
            column.symbol,
            name,
            row[key],
            column.read(solved(name)),
            _tolerance(key, bearing),
            column.unit,
            f"Table {column.table}",
            decimals[key],
        )
    yield Comparison(
        "T_ex",
        name,
        row["outlet_temperature_C"],
        outlet_temperature(name),
        None,
        "°C",
        "Table 4",
        decimals["outlet_temperature_C"],
        information=_FRICTION_UNKNOWN,
    )


def _tolerance(key: str, bearing: dict[str, Any]) -> Within:
    pockets = key == "supply_flow_L_min" and bearing["supply_element"] == "pockets"
    return _SUPPLY_THROUGH_POCKETS if pockets else _COLUMNS[key].tolerance


def draw(figure: Figure) -> None:
    """Deviation of every quantity for every bearing, with its tolerance."""
    figure.set_size_inches(7.6, 6.0)
    rows = run()
    names = list(dict.fromkeys(row.place for row in rows))
    shown = ("ε", "h_min", "Q₃", "Qp", "Re", "Re_cr", "ψ_min", "T_ex")
    panels = figure.subplots(2, 4, sharey=True)
    for axes, symbol in zip(panels.ravel(), shown, strict=True):
        _draw_quantity(axes, [row for row in rows if row.quantity == symbol])
    for first in panels[:, 0]:
        first.set_yticks(range(len(names)), names)
        first.set_ylim(len(names) - 0.5, -0.5)


def _draw_quantity(axes: Axes, rows: list[Comparison]) -> None:
    """One dot for each bearing; what would set the scale for all others is written as a number."""
    relative = bool(getattr(rows[0].tolerance, "relative", 0.0))
    misses = [100.0 * row.relative_deviation if relative else row.deviation for row in rows]
    edges = [_edge(row) for row in rows]
    reach = 1.25 * max(*edges, *(abs(miss) for miss, row in zip(misses, rows, strict=True) if row.share <= 1.0))
    reach = reach or 1.25 * max(map(abs, misses))
    for place, (row, miss, edge) in enumerate(zip(rows, misses, edges, strict=True)):
        axes.barh(place, 2.0 * edge, left=-edge, height=1.0, color=BAND)
        if abs(miss) <= reach:
            marker, colour = ("o", INK) if row.judged else ("x", GREY)
            axes.plot(miss, place, marker, color=colour)
        else:
            side = math.copysign(0.62, miss)
            axes.text(side * reach, place, f"{miss:+.2g}", ha="center", va="center", fontsize=7.5, color=INK)
    axes.axvline(0.0, color=GREY, linewidth=0.8, zorder=1)
    axes.set_xlim(-reach, reach)
    mark = edges[0] or 1.0
    axes.set_xticks((-mark, 0.0, mark), [f"{-mark:g}", "0", f"{mark:g}"])
    unit = "%" if relative else rows[0].unit.replace("°C", "K")
    axes.set_xlabel(f"Δ{rows[0].quantity}" + (f" in {unit}" if unit else ""))
    axes.grid(visible=False, axis="y")


def _edge(row: Comparison) -> float:
    """Tolerance in per cent or in the unit of the quantity; 0 where nothing is judged."""
    return 100.0 * getattr(row.tolerance, "relative", 0.0) or getattr(row.tolerance, "absolute", 0.0)


CASE = ValidationCase(
    name="reverse_gear",
    title="Marine reverse gear: eleven bearings",
    story=Story(
        what=(
            "The eleven bearings of a marine reverse gear, from the pinion of the gas turbine with 45 m/s to the "
            "output wheel with 6.6 m/s. The study checks them by ISO 7902 and prints film thickness, flows, "
            "Reynolds numbers, clearances and the rules of thumb against whirl."
        ),
        source=("Published gearbox study (Russian journal, 2023, vol. 15, no. 5, p. 825 ff.), Tables 4 and 5."),
        assumptions=(
            "Dimensions, speeds, cold clearances, supply pressure and the oil are **inferred and not "
            "published**; they stand with that statement in `reverse_gear.json`. Since the friction of the "
            "study is not known, every film is computed at the effective temperature that belongs to the "
            "published outlet temperature, T_eff = (50 °C + T_ex)/2: so errors of friction do not enter the "
            "other columns. The outlet temperatures of our own heat balance, with 1.10 times the friction "
            "curve of the full bearing, are shown beside the print and not judged. The geometric film limit "
            "(16 µm in every row) needs tolerances of the drawings and is not compared."
        ),
        tolerances=(
            "Eccentricity 0.008, film 1.5 µm, side flow 6 %, supply flow 5 % through grooves and 10 % through "
            "pockets, Reynolds number 4.5 %, its limit 0.1 %, clearance against whirl and recommended clearance "
            "0.05 ‰ (half of the last printed digit), film limit by experience exact. Outlet temperatures are "
            "printed in whole degrees, which alone moves the viscosity by 2 %."
        ),
        differences=(
            "**The output wheel** takes the load from Table 3: 452 kN on the bearing beside the coupling, with "
            "the mesh force downward, see the load share of its shaft. With 527.5 mm, B/D 0.774 and 6.6 m/s "
            "every column follows; the film is 1.4 µm thinner than in print.\n\n"
            "**The side flow is 2 to 5 % lower in print** in every row, as linear interpolation in a table "
            "with few columns would make it; see the five spans of the input pinion.\n\n"
            "**The supply flow through pockets comes out 4 % above the print** for the second-stage pinions "
            "(0.73 of the width) and 9 % for the output wheel (0.82). The correction q_P of the flow formula ends "
            "at 0.7 and is held there, as in the study; the logarithm takes the true width. By the heat balance "
            "this larger flow leaves the pinion (a) 2.3 K cooler than in print, the others 1.5 K at most.\n\n"
            "**The electric-motor pinion** turns at 12.5 m/s by its Reynolds number, flow and recommended "
            "clearance, although the text speaks of 22 to 26 m/s.\n\n"
            "**Table 4 and Table 2 do not quite agree** on the same bearing: T_ex 77 and 76.5 °C, film 89 "
            "and 88 µm, supply flow 9.9 L/min (0.594 m³/h) and 0.62 m³/h.\n\n"
            "**Remarks of the study that its own numbers do not bear out.** It puts the clearance at 28 to "
            "55 % below the recommended one; the printed values give 24 to 39 % of the recommended, or 31 "
            "to 64 % of the actual clearance. Its conclusions speak of 10 K gained by symmetric pockets "
            "where Table 4 shows 12 K. For shock loads the limit of B83 on pressure times speed is 50 MPa "
            "m/s; four of these bearings are at 56 to 58, which the study passes over and Babbitt's check "
            "C107 would report."
        ),
    ),
    run=run,
    draw=draw,
    caption="Deviation of our values from Tables 4 and 5, bearing by bearing; grey bars are the tolerances, "
    "crosses and grey numbers are shown and not judged. Outlet temperatures by our own heat balance.",
    evidence=Evidence.REPRODUCTION,
)
