"""Tables of a thrust bearing and its shaft line for the report: pads, damped modes, rings."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from babbitt.core.result import Result
from babbitt.report.plain_tables import plain_table, table_by_pad

__all__ = ["tables"]

PAD_COLUMNS = (
    "pad_load",
    "pad_film_thickness",
    "pad_minimum_film_thickness",
    "pad_maximum_pressure",
    "pad_stiffness",
    "pad_damping",
    "pad_slope_radial",
    "pad_slope_along",
)
FLOW_COLUMNS = ("pad_leading_flow", "pad_trailing_flow", "pad_inner_flow", "pad_outer_flow", "pad_friction_power")
THERMAL_COLUMNS = ("pad_load", "pad_mixed_temperature", "pad_trailing_temperature", "pad_maximum_temperature")
BALANCE_COLUMNS = (
    "pad_load",
    "pad_mixed_temperature",
    "pad_effective_temperature",
    "pad_trailing_temperature",
)
DYNAMIC_COLUMNS = ("pad_load", "runout_force", "ripple_force", "dynamic_peak", "dynamic_bound", "pad_dynamic_film")
RINGS_SHOWN = 10


def tables(result: Result) -> list[dict[str, Any]]:
    """Tables as plain data: title, columns of (symbol, unit), rows of texts, a note."""
    if not result.outcome.solved:
        return []
    return list(_tables(result))


def _tables(result: Result) -> Iterator[dict[str, Any]]:
    yield table_by_pad(
        result,
        "Pads at rest",
        PAD_COLUMNS,
        "Load, film at the pivot and thinnest, largest pressure, stiffness at rest and damping at the frequency "
        "of the shaft with tilts free. Slopes of the gap along the radius (α_x, positive: wider outside) and "
        "along the motion (α_y, negative: narrower towards the trailing edge).",
    )
    yield table_by_pad(
        result,
        "Oil of the pads",
        FLOW_COLUMNS,
        "In over the leading edge; out over the trailing, inner and outer edge; friction power.",
    )
    if "pad_maximum_temperature" in result.arrays:
        yield table_by_pad(
            result, "Temperatures of the pads", THERMAL_COLUMNS, "After mixing; mean over the flow; highest."
        )
    if "pad_effective_temperature" in result.arrays:
        yield table_by_pad(
            result,
            "Temperatures of the pads",
            BALANCE_COLUMNS,
            "After mixing; of the film, by its own heat balance; at the trailing edge.",
        )
    if result.kind != "thrust_line":
        return
    yield table_by_pad(
        result,
        "Pads in motion",
        DYNAMIC_COLUMNS,
        "Static load; amplitudes by runout and by thrust ripple; both, as peak with the phases given and as bound "
        "for any; thinnest film with the bound.",
    )
    yield from _over_frequency(result)
    modes = result.arrays["damped_modes"]
    if modes:
        yield plain_table(
            "Damped modes",
            ("Mode", "Damped frequency", "Damping ratio"),
            ("", "Hz", "%"),
            [(f"{n:.0f}" if n else "–", f"{f / math.tau:.2f}", f"{100.0 * d:.2f}") for f, d, n in modes],
            "Of the free motion that decays, films and tilts at the frequency of the mode; numbered as the "
            "undamped frequencies they belong to. Below a ratio of 25 % a mode resonates.",
        )
    if peaks := result.arrays.get("response_peaks", ()):
        yield plain_table(
            "Peaks of the response",
            ("Excitation", "Frequency", "Pad force over static"),
            ("", "Hz", ""),
            [
                (
                    "thrust" if not lobes else f"runout, {lobes:g} lobe{'s' if lobes > 1 else ''}",
                    f"{f / math.tau:.2f}",
                    f"{height:.2f}",
                )
                for f, height, lobes in peaks
            ],
            "Maxima of the largest pad force over frequency that exceed twice its static value; excitations are "
            "held against these and the damped modes.",
        )
    rings = result.arrays["ring_sweep"]
    step = max(1, len(rings) // RINGS_SHOWN)
    yield plain_table(
        "Backing rings",
        (
            "Stiffness per pad",
            "Runout",
            "Ripple",
            "Both",
            "Film amplitude",
            "Thinnest film",
            "First frequency, undamped",
            "Static max/mean",
        ),
        ("GN/m", "%", "%", "%", "µm", "µm", "Hz", ""),
        [_ring(row) for row in rings[::step]],
        "Dynamic over mean static pad load for any phases, each on the pad where it is largest; film amplitude by "
        "runout at a pivot.",
    )


def _over_frequency(result: Result) -> Iterator[dict[str, Any]]:
    stiffness, damping = (result.arrays[f"pad_{name}_over_frequency"] for name in ("stiffness", "damping"))
    for (nu, *k), (_, *d) in zip(stiffness, damping, strict=True):
        yield plain_table(
            f"Films at {nu / math.tau:.3g} Hz",
            ("Pad", "Stiffness", "Damping"),
            ("", "GN/m", "MN s/m"),
            [
                (str(pad), f"{a / 1e9:.4g}", f"{b / 1e6:.4g}")
                for pad, (a, b) in enumerate(zip(k, d, strict=True), 1)
            ],
            "At the frequency of an excitation, tilts free and with their inertia.",
        )


def _ring(row: Sequence[float]) -> tuple[str, ...]:
    stiffness, runout, ripple, bound, amplitude, film, first, ratio = row
    return (
        f"{stiffness / 1e9:.3g}",
        f"{100 * runout:.1f}",
        f"{100 * ripple:.1f}",
        f"{100 * bound:.1f}",
        f"{1e6 * amplitude:.2f}",
        f"{1e6 * film:.1f}",
        f"{first / math.tau:.1f}",
        f"{ratio:.2f}",
    )
