"""Table 2 of the gearbox study: one bearing with five angular spans, temperature found by the heat balance."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

from babbitt.core.result import Result
from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.iso7902.model import Friction
from babbitt.kinds.journal.iso7902.procedure import check
from babbitt.validation.case import Comparison, Evidence, Story, ValidationCase
from babbitt.validation.figure import BAND, GREY, INK
from babbitt.validation.published.reverse_gear_inputs import design_case, published
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BEARING = "Input pinion, gas-turbine side"


@dataclass(frozen=True)
class _Column:
    """A column of the table: symbol, unit, how to read it from a result, how far it may be off."""

    symbol: str
    unit: str
    label: str
    read: Callable[[Result], float]
    tolerance: Within


_COLUMNS = {
    "outlet_temperature_C": _Column(
        "T_ex", "°C", "outlet temperature", lambda r: r.outlet_temperature - ZERO_CELSIUS, Within(absolute=2.0)
    ),
    "friction_power_kW": _Column(
        "P_f", "kW", "friction power", lambda r: r.friction_power / 1e3, Within(relative=0.04)
    ),
    "side_flow_m3_h": _Column("Q₃", "m³/h", "side flow", lambda r: r.side_flow * 3600.0, Within(relative=0.045)),
    "supply_flow_m3_h": _Column(
        "Qp", "m³/h", "supply flow", lambda r: r.supply_flow * 3600.0, Within(relative=0.03)
    ),
    "eccentricity_ratio": _Column(
        "ε", "", "eccentricity ratio", lambda r: r.eccentricity_ratio, Within(absolute=0.006)
    ),
    "minimum_film_um": _Column(
        "h_min", "µm", "smallest film", lambda r: r.minimum_film_thickness * 1e6, Within(absolute=1.2)
    ),
}


@lru_cache
def solved(span: int, friction: Friction | None = None, friction_factor: float | None = None) -> Result:
    """Our answer for one span."""
    return check(design_case(BEARING, span=span, friction=friction, friction_factor=friction_factor))


def run() -> tuple[Comparison, ...]:
    """Compare the whole table, the misprint in it, and the one number of the text that contradicts it."""
    table = published()["table_2"]
    rows = tuple(row for printed in table["rows"] for row in _row(printed, table))
    return (*rows, _contradiction(table["suspect"][1]))


def _row(printed: dict[str, float], table: dict[str, dict[str, int]]) -> Iterator[Comparison]:
    span = int(printed["span_deg"])
    misprint = published()["table_2"]["suspect"][0]
    for name, column in _COLUMNS.items():
        value, ours = printed[name], column.read(solved(span))
        decimals = table["decimals"][name]
        if name == misprint["quantity"] and span == misprint["span_deg"]:
            yield Comparison(
                column.symbol,
                f"{span}°, as printed",
                value,
                ours,
                column.tolerance,
                column.unit,
                f"Table 2, row {span}",
                decimals,
                suspect=misprint["reason"],
            )
            yield Comparison(
                column.symbol,
                f"{span}°, read as {misprint['read_as']}",
                misprint["read_as"],
                ours,
                column.tolerance,
                column.unit,
                f"Table 2, row {span}",
                decimals,
            )
        else:
            source = f"Table 2, row {span}"
            yield Comparison(
                column.symbol, f"{span}°", value, ours, column.tolerance, column.unit, source, decimals
            )


def _contradiction(slip: dict[str, str]) -> Comparison:
    span, column = int(slip["span_deg"]), _COLUMNS[slip["quantity"]]
    return Comparison(
        column.symbol,
        f"{span}°, as in the text",
        float(slip["printed"]),
        column.read(solved(span)),
        column.tolerance,
        column.unit,
        slip["where"],
        2,
        suspect=slip["reason"],
    )


def draw(figure: Figure) -> None:
    """Each quantity over the span: published with its tolerance, ours, and ours by the default friction."""
    figure.set_size_inches(7.2, 4.8)
    panels = figure.subplots(2, 3).ravel()
    rows, misprint = published()["table_2"]["rows"], published()["table_2"]["suspect"][0]
    spans = [row["span_deg"] for row in rows]
    places = range(len(spans))
    for axes, (name, column) in zip(panels, _COLUMNS.items(), strict=True):
        values = [row[name] for row in rows]
        if name == misprint["quantity"]:
            values[spans.index(misprint["span_deg"])] = misprint["read_as"]
        edges = [column.tolerance.relative * value + column.tolerance.absolute for value in values]
        low, high = ([v + sign * e for v, e in zip(values, edges, strict=True)] for sign in (-1, 1))
        axes.fill_between(places, low, high, color=BAND, label="tolerance")
        default = [column.read(solved(span, Friction.FULL, 1.0)) for span in spans]
        axes.plot(places, default, linestyle=":", color=GREY, label="ours, default friction")
        axes.plot(places, [column.read(solved(span)) for span in spans], color=INK, label="ours")
        axes.plot(places, values, "o", color=INK, markerfacecolor="white", label="published")
        axes.set_xticks(places, [f"{span}" for span in spans])
        axes.set_xlabel("angular span in °")
        axes.set_ylabel(f"{column.label} {column.symbol}" + (f" in {column.unit}" if column.unit else ""))
    place = spans.index(misprint["span_deg"])
    panels[1].annotate(
        f"print: {misprint['printed']}",
        (place, misprint["read_as"]),
        (18, 22),
        textcoords="offset points",
        fontsize=8.0,
        color=GREY,
        arrowprops={"arrowstyle": "-", "color": GREY, "linewidth": 0.7},
    )
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=4)


CASE = ValidationCase(
    name="reverse_gear_spans",
    title="Marine reverse gear: five angular spans of the input pinion bearing",
    story=Story(
        what=(
            "The fastest bearing of a marine reverse gear (250 mm, 45 m/s) computed by ISO 7902 with a film of "
            "360, 180, 150, 120 and 90 degrees. The whole procedure is at work: characteristics of partial arcs, "
            "supply through a groove over half the circumference, friction, and the temperature found by the "
            "heat balance. One set of inputs has to meet thirty printed numbers."
        ),
        source="Published gearbox study (Russian journal, 2023, vol. 15, no. 5, p. 825 ff.), Table 2.",
        assumptions=(
            "The study prints results and hardly any dimensions. Diameter, width, clearance, groove, supply "
            "pressure and the oil (50 mm²/s at 40 °C, viscosity index 90) are **inferred and not "
            "published**; they stand with that statement in `reverse_gear.json` and were chosen once for "
            "all five rows. The friction is 1.256 times the friction curve of the full bearing at the "
            "eccentricity of each span; the study does not say how it computed friction, and this is what "
            "reproduces it."
        ),
        tolerances=(
            "Outlet temperature 2 K, power 4 %, side flow 4.5 %, supply flow 3 %, eccentricity 0.006, film "
            "1.2 µm. The print alone is uncertain by 0.005 in eccentricity, by 0.5 µm in film and by 1 % in "
            "the smaller flows; the rest is what one inferred set can do, and what the print does not keep "
            "among its own rows (below)."
        ),
        differences=(
            "**The power at 180°** is printed as 61.66 kW. The other rows and the heat balance want 31.66, "
            "which is what is judged.\n\n"
            "**Two rows do not close the heat balance like the others.** Power over flow and temperature "
            "rise gives 1.80 to 1.82 MJ/(m³ K) for 150, 120 and 90°, the usual heat capacity of oil, but "
            "1.92 for 360° and 1.95 for 180°. Their outlet temperatures are about 2 K too low or their "
            "power is too high, which a temperature iteration stopped too early would explain. This is the "
            "1.8 K at 180° and the 3.7 % of power at 360°.\n\n"
            "**The side flow is 1 to 4 % lower in print.** Side flow bends downwards over width and "
            "eccentricity, and linear interpolation in a table with few columns cuts such a curve short, "
            "here by 4 to 6 % (columns B/D 0.5 and 1, rows ε 0.4, 0.6, 0.8). That the tables of the "
            "study were read like this is likely, since it compares such rules itself, but not stated.\n\n"
            "**Friction is the only quantity without an explanation.** The printed power is 1.23 to 1.28 "
            "times the friction curve of the full bearing at the printed eccentricities: the span acts on "
            "load and flow and not on friction. For a film around the shaft under the load of each span the "
            "factor would have to run from 1.30 to 0.89, for a film on the arc alone from 1.30 to 2.25. The "
            "dotted lines show Babbitt's default (film all around, factor 1): power 20 % lower at 360° and "
            "9 % higher at 90°, temperatures from 3.6 K lower to 2 K higher, while eccentricity and film "
            "hardly move.\n\n"
            "**With the oil named in the text** (63.5 and 8.0 mm²/s) temperatures come out 5 to 7 K too "
            "high and the supply flow 12 to 16 % too low. The tables belong to a thinner oil.\n\n"
            "The text gives ε = 0.54 for 120° where the table has 0.57; 0.54 belongs to 150°."
        ),
    ),
    run=run,
    draw=draw,
    caption="Six quantities over the angular span: printed values with their tolerance, our values, and ours "
    "with the default friction model. The printed power at 180° lies off the chart.",
    evidence=Evidence.REPRODUCTION,
)
