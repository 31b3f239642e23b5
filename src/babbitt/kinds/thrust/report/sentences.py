"""What a surveyor asks of a thrust bearing and its shaft line, answered in sentences."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from babbitt.core.check_text import written
from babbitt.core.result import Bound, Check, Result
from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.thrust.temperature_limits import hottest_of_pads
from babbitt.report.verdict import governing

__all__ = ["answers"]

CAUSES = {
    "runout_share": "the runout of the collar",
    "ripple_share": "the thrust ripple of the propeller",
    "tilt_share": "the tilt of the housing",
    "elasticity_share": "the elasticity of the shaft",
}


ROUND_OFF = 1.0 + 1e-9
NEAR = 0.2
"""Relative distance from a resonance below which a line is near resonance, as check C204 has it."""


def answers(result: Result) -> tuple[str, ...]:
    """Sentences about a solved thrust bearing or shaft line; none for other kinds.

    >>> from babbitt.core.result import Outcome
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
        said = f"All pads carry {max(loads) / 1e3:.1f} kN on a film of {_micro(min(films))} at its thinnest place."
        return f"{said}{_turning(result)}"
    said = (
        f"Pad {most} carries most, {max(loads) / 1e3:.1f} kN, {result.values['pad_load_ratio']:.2f} times the "
        "mean; "
        f"the thinnest film is {_micro(min(films))}, at pad {thinnest}."
    )
    return f"{said}{_turning(result)}"


def _turning(result: Result) -> str:
    """What the runout does while the collar turns slowly; nothing without one."""
    v = result.values
    if "quasi_static_load_ratio" not in v:
        without = any(notice.code == "W209" for notice in result.warnings)
        said = " While the collar turns slowly with its runout, no films of the pads were found."
        return said if without else ""
    ratio, film = v["quasi_static_load_ratio"], v["quasi_static_minimum_film_thickness"]
    limit = governing(result, "quasi_static_minimum_film_thickness")
    held = "" if limit is None else f", {'within' if limit.ok else 'beyond'} the limit of {_micro(limit.limit)}"
    return (
        f" While the collar turns slowly with its runout, a pad carries up to {ratio:.2f} times the mean, on "
        f"{_micro(film)} at the thinnest{held}."
    )


def _of_line(result: Result) -> Iterator[str]:
    checks = {check.code: check for check in result.checks}
    yield _survival(result, checks)
    yield _loss(result, checks["C201"])
    yield _causes(result)
    if result.values["loss_mean_bound"] > 0.0 and checks["C202"].value > 0.0:
        yield _ring(result)
    if bearable := _bearable(result):
        yield bearable
    yield _axial(result, checks.get("C205"))
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
        f"itself it is at most {_percent(v['loss_own_bound'])}; the tightest pad carries "
        f"{v['pad_load_ratio']:.2f} times the mean."
    )


def _causes(result: Result) -> str:
    v = result.values
    if not v["loss_mean_bound"] > 0.0:
        return "Nothing shakes the line: neither thrust ripple nor runout has an amplitude."
    first = max(CAUSES, key=lambda name: v[name])
    alone, ripple, both = (_most(result, name) for name in ("runout_force", "ripple_force", "dynamic_bound"))
    return (
        f"What dominates: {CAUSES[first]}. Runout alone gives {_percent(v['runout_share'])}{alone}, "
        f"thrust ripple alone {_percent(v['ripple_share'])}{ripple} of the mean static pad load, both "
        f"{_percent(v['loss_mean_bound'])}{both}. "
        "Without "
        f"tilt and pad heights both would give {_percent(v['loss_mean_bound'] - v['tilt_share'])}, with a "
        "rigid shaft "
        f"{_percent(v['loss_mean_bound'] - v['elasticity_share'])}. {_damping(v)}"
    )


def _most(result: Result, name: str) -> str:
    """On which pad a force is largest; nothing where there is none."""
    forces = result.arrays[name][0]
    return f" (pad {1 + forces.index(max(forces))})" if max(forces) > 0.0 else ""


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


ENDS = {
    "C201": "the dynamic load",
    "C202": "the film",
    "C203": "the load left on a pad",
    "C103": "the pressure on a pad",
    "C105": "the pressure on a pad",
    "C104": "the oil temperature",
    "C108": "the oil temperature",
}


def _bearable(result: Result) -> str:
    """How large each cause may be, and what ends it."""
    parts = [
        said
        for name, cause in (("runout", "runout"), ("tilt", "tilt"), ("ripple", "thrust ripple"))
        if (said := _largest(result, f"admissible_{name}", cause))
    ]
    if not parts:
        return ""
    return f"Each alone, the others unchanged, within all limits: {'; '.join(parts)}."


def _largest(result: Result, name: str, cause: str) -> str:
    end = result.settings.get(f"{name}_ends", "")
    if name not in result.values:
        return f"{cause}: {end}" if end else ""
    value = result.values[name]
    by = ENDS.get(end, f"check {end}")
    if not value > 0.0:
        return f"{cause}: none, since without any {by} misses its limit"
    more = ""
    if cause == "runout":
        more = f", indicator {written(name, 2.0 * value)}"
    if cause == "thrust ripple":  # rounded down like the force
        more = f", {math.floor(1000.0 * value / result.values['load'] + 1e-9) / 10.0:.1f} % of the thrust"
    then = "then the pads find no film" if end == "no film" else f"then {by} misses its limit"
    return f"{cause} up to {written(name, value)}{more} ({then})"


def _axial(result: Result, check: Check | None) -> str:
    v = result.values
    held = "; no admissible amplitude is given"
    if check is not None:
        held = f", {'within' if check.ok else 'beyond'} the admissible {_micro(check.limit)}"
    return (
        f"Axial vibration at the worst phases: {_micro(v['collar_axial_amplitude'])} of the collar, "
        f"{_micro(v['far_end_axial_amplitude'])} at the other end of the shaft, at most "
        f"{_micro(v['axial_amplitude'])} along it{held}."
    )


def _frequencies(result: Result) -> str:
    v = result.values
    first = v["natural_frequency_1"] / math.tau
    damped = {order: (f / math.tau, ratio) for f, ratio, order in result.arrays.get("damped_modes", ())}
    if 1 in damped:
        frequency, ratio = damped[1]
        why = ": films stiffen with frequency" if frequency > first else ""
        said = (
            f"Let go, the line swings in its first axial mode at {frequency:.2f} Hz with a damping ratio of "
            f"{_percent(ratio)}; on the stiffness of the films at rest and undamped it is {first:.2f} Hz{why}"
        )
    else:
        said = (
            "Let go, the line creeps back in its first axial mode and does not swing; undamped and on the "
            f"stiffness of the films at rest it would swing at {first:.2f} Hz"
        )
    peaks = sorted(result.arrays.get("response_peaks", ()), key=lambda row: -row[1])
    if peaks:
        said += (
            f". The response peaks highest at {peaks[0][0] / math.tau:.2f} Hz, {peaks[0][1]:.1f} times the static "
            "pad force"
        )
    if "frequency_separation" in v:
        said += f"; the nearest excitation is {_percent(v['frequency_separation'])} away from a resonance"
    else:
        said += ". No excitation meets a resonance: no peak exceeds twice the static pad force"
    barred = result.arrays.get("barred_ranges", ())
    map_ends = [row[0] for row in result.arrays.get("campbell", ())]
    spans = [_span(low, high, order, map_ends) for low, high, order in barred]
    if spans:
        said += f". Within 20 % of a resonance and to be barred or passed quickly: {', '.join(spans)}"
    elif "campbell" in result.arrays:
        said += ". At no speed of the map an excitation comes within 20 % of a resonance"
    return f"{said}."


def _span(low: float, high: float, order: float, speeds: list[float]) -> str:
    """A barred range; one that the map cuts goes on beyond it."""
    begins = f"{_rpm(low)}" if low > min(speeds) * ROUND_OFF else f"the beginning of the map at {_rpm(low)}"
    ends = f"{_rpm(high)} rpm" if high * ROUND_OFF < max(speeds) else f"the end of the map at {_rpm(high)} rpm"
    return f"{begins} to {ends} (order {order:g})"


def _nonlinear(result: Result) -> str:
    v = result.values
    return (
        f"Nonlinear motion: largest load {v['nonlinear_load_peak'] / 1e3:.1f} kN above and "
        f"{v['nonlinear_unload_peak'] / 1e3:.1f} kN below the static one, thinnest film "
        f"{_micro(v['nonlinear_minimum_film'])}, mean films up to {_micro(v['mean_film_shift'])} thicker than "
        f"at rest.{_flight(result)}"
    )


def _flight(result: Result) -> str:
    """That what follows a moment without load or film is no result to rely on."""
    if not any(notice.code == "W205" for notice in result.warnings):
        return ""
    return " A pad leaves the collar or touches it (W205): these figures show that it does, not how hard."


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
        f"the pads by {v['temperature_rise']:.1f} K on the mean; the viscosity was given and does not follow."
    )


def _hottest(result: Result) -> str:
    """The hottest oil known, with its limit where it has one."""
    name = hottest_of_pads(result.values) or "outlet_temperature"
    where = {
        "maximum_temperature": "in a film",
        "trailing_temperature": "at the trailing edges",
        "hottest_trailing_temperature": "at the hottest trailing edge",
    }
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
