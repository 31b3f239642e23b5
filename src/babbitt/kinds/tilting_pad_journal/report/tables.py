"""Tables of a tilting-pad bearing for the report: pads, coefficients, free motions."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from babbitt.core.language import listed
from babbitt.core.quantities import AXES, QUANTITIES, Quantity
from babbitt.core.result import Matrix, Result
from babbitt.kinds.tilting_pad_journal.report.stability import stability_table
from babbitt.kinds.tilting_pad_journal.sensitivity import ASSUMED, MOVED, end_in_words
from babbitt.report.columns import ABSENT
from babbitt.report.plain_tables import plain_table, table_by_pad
from babbitt.report.result_rows import result_row
from babbitt.report.symbols import symbol_node

__all__ = ["rows_of_clearances", "sensitivity_tables", "tables"]

SHAPE = ("pad_pivot_angle", "pad_clearance", "pad_assembled_clearance", "pad_preload")
FILM = (
    "pad_load",
    "pad_eccentricity_ratio",
    "pad_film_thickness",
    "pad_minimum_film_thickness",
    "pad_maximum_pressure",
    "pad_tilt",
)
OIL = ("pad_leading_flow", "pad_trailing_flow", "pad_side_flow", "pad_friction_power")
HEAT = (
    "pad_mixed_temperature",
    "pad_trailing_temperature",
    "pad_probe_temperature",
    "pad_maximum_temperature",
    "pad_mean_temperature",
    "pad_heat",
    "pad_edge_heat",
    "pad_growth",
    "pad_bending",
)
PIVOTS = {
    "pad_load": "Load",
    "pivot_displacement": "how far the pivot gives way",
    "pivot_stiffness": "its stiffness under the load",
    "pivot_contact_pressure": "the largest pressure in its contact by Hertz",
}
"""Quantities of pivots, and what the note below their table calls them."""
STRAIGHT = 0.1
"""Whirl (1: a circle) below which the rotor moves on a line: on ellipses twenty times as long as they are wide."""
BENDING = ("pad_load", "pad_bending", "pad_bending_stiffness")


def rows_of_clearances(results: Sequence[Result]) -> list[dict[str, Any]]:
    """Load of every pad at several clearances; the tables are those of one of them."""
    if len(results) < 2:
        return []
    loads = [one.arrays["pad_load"][0] if one.outcome.solved else () for one in results]
    return [
        result_row(
            "pad_load", f"Load of pad {pad + 1}", [row[pad] if row else math.nan for row in loads], f"{pad + 1}"
        )
        for pad in range(max(map(len, loads)))
    ]


def tables(result: Result) -> list[dict[str, Any]]:
    """Tables as plain data; none of an unsolved bearing."""
    return list(_tables(result)) if result.outcome.solved else []


def _tables(result: Result) -> Iterator[dict[str, Any]]:
    yield table_by_pad(
        result, "Clearances of the pads", SHAPE, "Pivot, machined and assembled clearance, preload."
    )
    yield table_by_pad(
        result,
        "Pads at rest",
        FILM,
        "Load, eccentricity ratio at the pivot, film at the pivot and thinnest, largest pressure, tilt. A pad "
        "without load has no tilt of its own; its films are those of the pad concentric with its bore.",
    )
    yield table_by_pad(
        result, "Oil of the pads", OIL, "In over the leading edge; out over the trailing edge and both sides."
    )
    if "pad_probe_temperature" in result.arrays:
        names = tuple(name for name in HEAT if name in result.arrays)
        yield table_by_pad(
            result,
            "Temperatures of the pads",
            names,
            "Oil at the leading edge, after mixing, and at the trailing edge; bore at the probe and highest; of "
            "pads that conduct their mean and the heat that leaves by backs and edges; growth and bending.",
        )
    yield from sensitivity_tables(result)
    if "pivot_stiffness" in result.arrays:
        names = tuple(name for name in PIVOTS if name in result.arrays)
        yield table_by_pad(result, "Pivots", names, f"{', '.join(PIVOTS[name] for name in names)}.")
    if "pad_bending_stiffness" in result.arrays:
        yield table_by_pad(
            result, "Bending", BENDING, "Load, how far the pad bends under it, and its stiffness against bending."
        )
    yield _coefficients(result)
    if "rotor_modes" in result.arrays:
        yield _motions(result)
    if "decrement_over_cross_coupling" in result.arrays:
        yield stability_table(result)


def sensitivity_tables(result: Result) -> Iterator[dict[str, Any]]:
    """What the assumptions of heat move; nothing where it was not asked for."""
    assumed = [name for name in ASSUMED if name in result.arrays]
    if not assumed:
        return
    moved = [QUANTITIES[name] for name in MOVED if f"sensitivity_of_{name}" in result.arrays]
    moved = [one.suited(*_finite(result.arrays[f"sensitivity_of_{one.name}"])) for one in moved]
    rows = [
        [name, *(
            one.format(row[place]) if math.isfinite(row[place]) else ABSENT
            for one in moved
            for row in (result.arrays[f"sensitivity_of_{one.name}"][number],)
        )]
        for number, place, name in _ends(result, assumed)
    ]  # fmt: skip
    heads: list[dict[str, Any]] = [{"text": "Varied", "symbol": None, "unit": ""}]
    heads += [{"text": one.symbol, "symbol": symbol_node(one.symbol), "unit": one.display.label} for one in moved]
    note = (
        "The bearing solved again with less and with more of each number of its heat that is seldom known better, "
        "given or assumed; a dash where it has no film, or its pads starve."
    )
    yield {"title": "What assumptions move", "columns": heads, "rows": rows, "note": note}


def _ends(result: Result, assumed: Sequence[str]) -> Iterator[tuple[int, int, str]]:
    """Row and column of the base, then of the low and high end of every assumption, and what stands there."""
    yield 0, 1, "as calculated"
    for number, name in enumerate(assumed):
        low, base, high = result.arrays[name][0]
        for place, value in ((0, low), (2, high)):
            if math.isfinite(value):
                yield number, place, end_in_words(name, value, base)


def _finite(matrix: Sequence[Sequence[float]]) -> list[float]:
    return [value for row in matrix for value in row if math.isfinite(value)]


def _coefficients(result: Result) -> dict[str, Any]:
    """Stiffness and damping over the whirl ratio, then what is fitted."""
    arrays = result.arrays
    every = zip(arrays["whirl_ratio"][0], arrays["dynamic_stiffness"], arrays["dynamic_damping"], strict=True)
    found = [("at rest", arrays["static_stiffness"], arrays["static_damping"])]
    found += [(f"{ratio:g}", (stiffness,), (damping,)) for ratio, stiffness, damping in every]
    note = "At whirl ratio 1 they are synchronous: stiffness and damping of the result."
    if "fitted_stiffness" in arrays:
        found.append(("fitted", arrays["fitted_stiffness"], arrays["fitted_damping"]))
        mass = _suited("virtual_mass", arrays["virtual_mass"])
        masses = listed(mass.format(one) for row in arrays["virtual_mass"] for one in row)
        note += (
            f" Fitted with virtual masses xx, xy, yx, yy of {masses} {mass.display.label}, "
            f"misfit {result.values['fit_error']:.1%}."
        )
    k = _suited("stiffness", *(stiffness for _, stiffness, _ in found))
    c = _suited("damping", *(damping for _, _, damping in found))
    rows = [
        (name, *(of.format(one) for of, matrix in ((k, stiffness), (c, damping)) for row in matrix for one in row))
        for name, stiffness, damping in found
    ]
    names = ("Whirl ratio", *(f"K {one}" for one in AXES), *(f"C {one}" for one in AXES))
    units = ("", *(k.display.label,) * 4, *(c.display.label,) * 4)
    return plain_table("Coefficients over the whirl ratio", names, units, rows, note)


def _suited(name: str, *matrices: Matrix) -> Quantity:
    """A quantity in the unit suited to the entries of some matrices."""
    return QUANTITIES[name].suited(*(one for matrix in matrices for row in matrix for one in row))


def _motions(result: Result) -> dict[str, Any]:
    """Free motions that swing."""
    rows = [
        (
            f"{frequency / math.tau:.2f}",
            f"{growth:.4g}",
            f"{decrement:.3g}",
            "straight" if abs(whirl) < STRAIGHT else "forward" if whirl > 0.0 else "backward",
            f"{100.0 * share:.0f}",
        )
        for growth, frequency, decrement, whirl, share in result.arrays["rotor_modes"]
    ]
    return plain_table(
        "Free motions of rotor and pads",
        ("Frequency", "Growth", "Log decrement", "Whirl of the rotor", "Share of the rotor"),
        ("Hz", "1/s", "", "", "%"),
        rows,
        "Those that swing, with the pads' own motions; what does not swing dies or grows without a frequency. "
        "Straight: the rotor moves on a line, or an ellipse more than twenty times as long as it is wide.",
    )
