"""What a surveyor asks of a thrust bearing and its shaft line, answered in sentences."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from babbitt.report.verdict import governing
from babbitt.results import Bound, Check, Result
from babbitt.thrust.temperature_limits import hottest_of_pads
from babbitt.units import ZERO_CELSIUS

__all__ = ["answers"]

CAUSES = {
    "runout_share": "the runout of the collar",
    "ripple_share": "the thrust ripple of the propeller",
    "tilt_share": "the tilt of the housing",
    "elasticity_share": "the elasticity of the shaft",
}


NEAR = 0.2
"""Relative distance from a natural frequency below which a line is near resonance, as check C204 has it."""


def answers(result: Result) -> tuple[str, ...]:
    """Sentences about a solved thrust bearing or shaft line; none for other kinds.

    >>> from babbitt.results import Outcome
    >>> answers(Result("A", "journal", "film", Outcome.CONVERGED, {}))
    ()
    """
    if not result.outcome.solved:
        return ()
    if result.kind == "thrust_line":
        return tuple(_of_line(result))
    if result.kind == "thrust":
        return (_share(result), _oil(result))
    return ()


def _share(result: Result) -> str:
    loads, films = (result.arrays[name][0] for name in ("pad_load", "pad_minimum_film_thickness"))
    most, thinnest = 1 + loads.index(max(loads)), 1 + films.index(min(films))
    if max(loads) < 1.000001 * min(loads):
        return f"All pads carry {max(loads) / 1e3:.1f} kN on a film of {_micro(min(films))} at its thinnest place."
    return (
        f"Pad {most} carries most, {max(loads) / 1e3:.1f} kN, {result.values['pad_load_ratio']:.2f} times the "
        "mean; "
        f"the thinnest film is {_micro(min(films))}, at pad {thinnest}."
    )


def _of_line(result: Result) -> Iterator[str]:
    checks = {check.code: check for check in result.checks}
    yield _survival(result, checks)
    yield _loss(result, checks["C201"])
    yield _causes(result)
    if result.values["loss_mean_bound"] > 0.0 and checks["C202"].value > 0.0:
        yield _ring(result)
    if bearable := _bearable(result, checks["C201"].limit):
        yield bearable
    yield _frequencies(result)
    if "nonlinear_load_peak" in result.values:
        yield _nonlinear(result)
    yield _oil(result)


def _survival(result: Result, checks: dict[str, Check]) -> str:
    film, margin = checks["C202"], checks["C203"]
    word = "The film survives" if film.ok and margin.ok else "The film does not survive"
    kept = [
        own - moved
        for own, moved in zip(*(result.arrays[n][0] for n in ("pad_load", "dynamic_bound")), strict=True)
    ]
    films = result.arrays["pad_dynamic_film"][0]
    unloaded, thinnest = 1 + kept.index(min(kept)), 1 + films.index(min(films))
    left = f"pad {unloaded}, which is unloaded most, keeps {_percent(margin.value)} of the mean load"
    if margin.value <= 0.0:
        left = f"pad {unloaded} leaves the collar (margin {_percent(margin.value)} of the mean load)"
    if film.value <= 0.0:
        return (
            f"{word}: pad {thinnest} touches the collar at the worst phases, and {left}. "
            "The figures suppose films that move less than they are thick: they say that pads touch, "
            "not how hard, nor what a ring would do."
        )
    sign = "≥" if film.ok else "<"
    return (
        f"{word}: thinnest film {_micro(film.value)} {sign} {_micro(film.limit)} at pad {thinnest}, and {left}, "
        "at the worst phases."
    )


def _loss(result: Result, check: Check) -> str:
    v = result.values
    kept = "within" if check.ok else "beyond"
    assert check.bound is Bound.AT_MOST
    return (
        f"Dynamic load: {_percent(v['loss_mean_bound'])} of the mean static pad load at the worst phases, {kept} "
        f"the limit of "
        f"{_percent(check.limit)}; {_percent(v['loss_mean_peak'])} with the phases given. Of the static load "
        f"of the pad "
        f"itself it is {_percent(v['loss_own_bound'])}: tilt counts on the mean basis only, since the "
        f"tightest pad carries "
        f"{v['pad_load_ratio']:.2f} times the mean."
    )


def _causes(result: Result) -> str:
    v = result.values
    if not v["loss_mean_bound"] > 0.0:
        return "Nothing shakes the line: neither thrust ripple nor runout has an amplitude."
    first = max(CAUSES, key=lambda name: v[name])
    return (
        f"What dominates: {CAUSES[first]}. Runout alone gives {_percent(v['runout_share'])}, thrust ripple alone "
        f"{_percent(v['ripple_share'])} of the mean static pad load, both {_percent(v['loss_mean_bound'])}. "
        "Without "
        f"tilt and pad heights both would give {_percent(v['loss_mean_bound'] - v['tilt_share'])}, with a "
        "rigid shaft "
        f"{_percent(v['loss_mean_bound'] - v['elasticity_share'])}. {_damping(v)}"
    )


def _damping(v: Mapping[str, float]) -> str:
    if v.get("frequency_separation", 1.0) < NEAR:
        return "So near a resonance, more damping at the propeller lowers what the ripple does to the pads."
    return "More propeller damping cannot raise what the ripple does to a pad."


def _ring(result: Result) -> str:
    v = result.values
    if "best_ring_loss" not in v:
        return "On no ring of the sweep do the pads find a film."
    best = (
        f"the least of the sweep is {_percent(v['best_ring_loss'])} on a ring of {_giga(v['best_ring_stiffness'])}"
    )
    if "half_load_ring_stiffness" in v:
        half = _giga(v["half_load_ring_stiffness"])
        said = f"A backing ring of {half} per pad would halve the dynamic load; {best}"
    else:
        said = f"No ring of the sweep halves the dynamic load; {best}"
    return f"{said}. A soft ring evens out the tilt and keeps runout away, but lets the first frequency fall."


def _bearable(result: Result, limit: float) -> str:
    v = result.values
    parts = []
    if "admissible_runout" in v:
        parts.append(
            f"runout up to {_micro(v['admissible_runout'])} (indicator {_micro(2.0 * v['admissible_runout'])})"
        )
    if "admissible_tilt" in v:
        parts.append(f"tilt up to {_micro(v['admissible_tilt'])}")
    if "admissible_ripple" in v:
        share = _percent(v["admissible_ripple"] / v["load"])
        parts.append(f"thrust ripple up to {v['admissible_ripple'] / 1e3:.1f} kN, {share} of the thrust")
    if not parts:
        return ""
    return f"Each alone, the others unchanged, keeps {_percent(limit)}: {'; '.join(parts)}."


def _frequencies(result: Result) -> str:
    v = result.values
    first = v["natural_frequency_1"] / math.tau
    said = f"First axial natural frequency {first:.2f} Hz, undamped and on the stiffness of the films at rest"
    if "frequency_separation" in v:
        said += (
            f"; the nearest excitation is {_percent(v['frequency_separation'])} away from an undamped frequency"
        )
    if damped := result.arrays.get("damped_modes", ()):
        frequency, ratio = damped[0][0] / math.tau, damped[0][1]
        why = ", higher as films stiffen with frequency" if frequency > first else ""
        said += (
            f". Let go, the damped line swings at {frequency:.2f} Hz{why}, with a damping ratio of "
            f"{_percent(ratio)}; near there its response peaks"
        )
    barred = result.arrays.get("barred_ranges", ())
    spans = [f"{_rpm(low)} to {_rpm(high)} rpm (order {order:g})" for low, high, order in barred]
    if spans:
        said += f". Within 20 % of the undamped frequency and to be barred or passed quickly: {', '.join(spans)}"
    elif "campbell" in result.arrays:
        said += ". No speed of the map comes within 20 % of the undamped frequency"
    return f"{said}."


def _nonlinear(result: Result) -> str:
    v = result.values
    return (
        f"Nonlinear motion: largest load {v['nonlinear_load_peak'] / 1e3:.1f} kN above and "
        f"{v['nonlinear_unload_peak'] / 1e3:.1f} kN below the static one, thinnest film "
        f"{_micro(v['nonlinear_minimum_film'])}, mean films up to {_micro(v['mean_film_shift'])} thicker than "
        f"at rest."
    )


def _oil(result: Result) -> str:
    v = result.values
    if "outlet_temperature" in v:
        rise = v["outlet_temperature"] - v["supply_temperature"]
        return (
            f"Oil: {v['friction_power'] / 1e3:.2f} kW of friction warm {6e4 * v['total_flow']:.1f} L/min of "
            "fresh oil "
            f"by {rise:.1f} K to {_celsius(v['outlet_temperature'])}; {_hottest(result)}."
        )
    # of a given viscosity: what the friction would do to the oil that leaves the pads
    return (
        f"Oil: {v['friction_power'] / 1e3:.2f} kW of friction warm the {6e4 * v['passing_flow']:.1f} L/min "
        "that pass "
        f"the pads by {v['temperature_rise']:.1f} K; the viscosity was given and does not follow."
    )


def _hottest(result: Result) -> str:
    """The hottest oil known, with its limit where it has one."""
    name = hottest_of_pads(result.values) or "outlet_temperature"
    where = {"maximum_temperature": "in a film", "trailing_temperature": "at the trailing edges"}
    said = f"it is at most {_celsius(result.values[name])} {where.get(name, '')}".rstrip()
    limit = governing(result, name)
    if limit is None:
        return said
    return f"{said}, {'within' if limit.ok else 'beyond'} the limit of {_celsius(limit.limit)}"


def _celsius(kelvin: float) -> str:
    return f"{kelvin - ZERO_CELSIUS:.1f} °C"


def _percent(share: float) -> str:
    return f"{100.0 * share:.1f} %"


def _micro(length: float) -> str:
    return f"{1e6 * length:.1f} µm"


def _giga(stiffness: float) -> str:
    return f"{stiffness / 1e9:.3g} GN/m"


def _rpm(speed: float) -> str:
    return f"{speed * 30.0 / math.pi:.0f}"
