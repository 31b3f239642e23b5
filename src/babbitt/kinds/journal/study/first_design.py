"""From a duty to first designs of a journal bearing: which widths, fits, oils and feeds are tried, and why."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, cast

from babbitt.case.case_file import CaseFile
from babbitt.case.parts.study import Vary
from babbitt.core.check_text import number, written
from babbitt.core.language import decimal, translated, translated_if_known
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.core.units import QuantityError, read
from babbitt.design.conditions import CheckedProblem, surface_speed
from babbitt.design.screening import recommended_relative_clearance
from babbitt.kinds.journal.iso7902.supply import FIT_RANGE
from babbitt.properties.fits import Clearance
from babbitt.properties.lubricants import catalogue
from babbitt.study.candidates import least
from babbitt.study.held_film import value_held
from babbitt.study.size_choices import JOURNAL_CLASSES

__all__ = [
    "EDGES",
    "METHODS",
    "OUTPUTS",
    "REASONS",
    "choices",
    "departures",
    "duty",
    "fit_together",
    "reasons",
    "shown",
]

OUTPUTS = (
    "width_ratio",
    "relative_clearance",
    "specific_load",
    "minimum_film_thickness",
    "outlet_temperature",
    "friction_power",
    "total_flow",
    "starved_minimum_film_thickness",
    "starved_outlet_temperature",
    "starved_friction_power",
    "starved_total_flow",
    "side_flow",
    "supply_flow",
    "supply_capacity",
    "recommended_relative_clearance",
    "surface_speed",
    "hydrodynamic_speed",
    "transition_speed",
    "starved_transition_speed",
)
"""Quantities that proposals are ranked by and shown with."""

WIDTH_RATIOS = (0.4, 1.0)
"""B/D of the widths that are tried. Assumption: what drawings of plain journal bearings usually have."""


@dataclass(frozen=True)
class _Ruler:
    """Lengths as drawings of a country have them.

    Attributes
    ----------
    unit : str
    metres : float
        Of the unit.
    steps : tuple of float
        Widths are whole multiples of one of these lengths, in the unit.
    finest : float
        Pockets and holes are whole multiples of this length, in the unit.
    """

    unit: str
    metres: float
    steps: tuple[float, ...]
    finest: float

    def text(self, length: float) -> str:
        """A length as a case has it."""
        return f"{length / self.metres:.6g} {self.unit}"

    def within(self, length: float) -> float:
        """The largest whole length up to one in m; that itself where it is less than the finest."""
        whole = math.floor(length / (self.metres * self.finest) + 1e-9)
        return whole * self.finest * self.metres if whole else length


MILLIMETRES = _Ruler("mm", 1e-3, (1.0, 2.0, 5.0, 10.0, 20.0, 50.0), 1.0)
INCHES = _Ruler("in", 0.0254, (0.0625, 0.125, 0.25, 0.5, 1.0, 2.0), 0.0625)

STEPS_A_DIAMETER = 20.0
"""The step of the widths is about the diameter over this number."""

BORE_CLASS = "H7"
FITS = 3
"""How many fits are tried: those of `JOURNAL_CLASSES` and c8 with a mean clearance nearest to the recommended."""

NEAR = math.log(1.3)
"""Logarithm of the ratio to the recommended clearance up to which a fit will do (assumption)."""

TOLERANCE = 0.15
"""Of a clearance that no fit has: by which it may be smaller or larger (assumption)."""

POCKET_SHARE = FIT_RANGE[1]
"""Largest width of a pocket over that of the bearing, in whole millimetres: the end of what ISO 7902 covers."""

POCKET_PLACES = ("both_sides", "opposite")
"""Where pockets stand: in the joint of a bearing in halves, or opposite the load."""

HOLE_SHARE, LARGEST_HOLE = 0.1, 20e-3
"""Diameter of a hole over that of the bearing, and in m at most. Assumptions."""

LEAST_OVER_TRANSITION = 3.0
"""Least ratio of the speed to the transition speed; of faster bearings the surface speed in m/s takes its place: a
usual rule of design for short starts and stops in mixed friction (assumption)."""

TRANSITION = "n/n_tr"
"""What the rule for the transition speed is called."""

MOST_PRESSURE = 3.0
"""Multiple of the supply pressure up to which more pressure is named as a remedy (assumption)."""

EDGES = {
    "width": ("width_ratio", "narrowest", "widest"),
    "clearance": ("relative_clearance", "smallest", "largest"),
}
"""By the path of a field with an order the quantity that has it, and what its smallest and largest are called."""

METHODS = ("iso7902", "film")
"""What a proposal is found with, and what confirms it."""

REASONS = {
    "lubricant": "viscosity grades of the catalogue (ISO 3448)",
    "clearance": "fits nearest to the recommended clearance, 0.8 ‰ U^(1/4), U in m/s (Vogelpohl); where none is "
    f"near, that ±{TOLERANCE:.0%} (assumption)",
    "width": f"B/D of {WIDTH_RATIOS[0]:g} to {WIDTH_RATIOS[1]:g} in whole steps (assumption)",
    "supply_element": f"pockets of at most {POCKET_SHARE:g} B (end of ISO 7902) at both sides or opposite the "
    f"load, or a hole of {HOLE_SHARE:g} D, at most {1e3 * LARGEST_HOLE:g} mm, opposite the load (assumptions)",
    "method": "the procedure finds, the film confirms",
}

ASSUMED = {
    "supply_temperature": "45 degC",
    "supply_pressure": "0.2 MPa",
    "metal": "SnSb8Cu4",
}


def duty(
    diameter: Any,
    load: Any,
    speed: Any,
    supply_temperature: Any = None,
    supply_pressure: Any = None,
    metal: str | None = None,
    name: str | None = None,
) -> dict[str, Any]:
    """A case with a duty, and with what is assumed where the duty does not say it.

    Parameters
    ----------
    diameter, load, speed : quantity
        As a case file has them.
    supply_temperature, supply_pressure : quantity, optional
    metal : str, optional
        Of the catalogue.
    name : str, optional
        Of the bearing; what the duty says without it.

    Returns
    -------
    dict
        As a case file says it; every assumption is listed under ``assumptions``.
    """
    given = {"supply_temperature": supply_temperature, "supply_pressure": supply_pressure, "metal": metal}
    taken = {name: ASSUMED[name] if value is None else value for name, value in given.items()}
    assumed = [f"{name.replace('_', ' ')} {ASSUMED[name]}" for name, value in given.items() if value is None]
    try:
        size = read(diameter, "m")
    except QuantityError:  # the case says what is wrong with it
        size = 0.1
    ruler = _ruler_of(diameter)
    return {
        "kind": "journal",
        "name": f"Bearing for {load} at {speed}, D = {diameter}" if name is None else name,
        "diameter": diameter,
        "width_ratio": 0.7,
        "clearance": {"kind": "relative", "mean": "1.5 permille"},
        "span": "360 deg",
        "supply_element": _hole(size, ruler),
        "lubricant": "ISO VG 46",
        "supply": {"temperature": taken["supply_temperature"], "pressure": taken["supply_pressure"]},
        "materials": {"bearing_metal": taken["metal"], "bearing": "C10", "journal": "42CrMo4"},
        "surfaces": {"kind": "direct", "roughness_bearing": "2 um", "roughness_journal": "1 um"},
        "load": load,
        "speed": speed,
        "assumptions": [
            f"Not given and assumed: {', '.join([*assumed, 'shell of C10, journal of 42CrMo4'])}.",
            "Roughness Rz of 2 µm in the bore and of 1 µm on the journal is assumed; no tilt, no waviness.",
        ],
    }


def choices(case: CaseFile, given: Mapping[str, Vary]) -> dict[str, Vary]:
    """The fields of a first design with the values that are tried; what is given stays."""
    problem = cast(CheckedProblem, case.calculations()[0].problem)
    diameter = problem.bearing.diameter
    ruler = _ruler_of(case.origin.given.get("diameter") if case.origin is not None else None)
    made = dict(given)
    made.setdefault("lubricant", _listed(one.name for one in catalogue() if one.name.startswith("ISO VG")))
    made.setdefault(
        "clearance", _listed(_clearances(diameter, recommended_relative_clearance(surface_speed(problem))))
    )
    made.setdefault("width", _listed(ruler.text(one) for one in _widths(diameter, ruler)))
    made.setdefault("supply_element", _listed(_feeds(diameter, _numbers(made["width"]), ruler)))
    made["method"] = _listed(METHODS)
    first = ("lubricant", "clearance", "width", "supply_element")
    return {name: made[name] for name in (*first, *(name for name in made if name not in first))}


def _listed(values: Iterator[Any] | Sequence[Any]) -> Vary:
    return Vary(values=tuple(values))


def _clearances(diameter: float, recommended: float) -> tuple[Any, ...]:
    """Fits whose mean relative clearance is nearest to the recommended one, the narrowest first.

    Where none comes near it, as of large bearings, the recommended clearance itself stands at their end.
    """
    means = {}
    for journal in (*JOURNAL_CLASSES, "c8"):
        try:
            means[f"{BORE_CLASS}/{journal}"] = (
                Clearance.from_tolerance_classes(diameter, BORE_CLASS, journal).mean / diameter
            )
        except InputError:  # of a diameter beyond the tables
            continue
    misses = {fit: abs(math.log(mean / recommended)) for fit, mean in means.items()}
    nearest = sorted(misses, key=misses.__getitem__)[:FITS]
    fits = tuple(sorted(nearest, key=means.__getitem__))
    if min(misses.values(), default=math.inf) <= NEAR:
        return fits
    ends = {
        "mean": math.ceil(1e5 * recommended) * 1e-5,  # not below what is recommended
        "minimum": recommended * (1.0 - TOLERANCE),
        "maximum": recommended * (1.0 + TOLERANCE),
    }
    return (*fits, {"kind": "relative", **{name: f"{1e3 * value:.2f} permille" for name, value in ends.items()}})


def _ruler_of(diameter: Any) -> _Ruler:
    """Inches for a diameter in inches."""
    words = str(diameter).split()
    return INCHES if len(words) > 1 and words[-1] in ("in", "inch") else MILLIMETRES


def _widths(diameter: float, ruler: _Ruler) -> tuple[float, ...]:
    """Widths in whole steps between the usual ratios to the diameter."""
    steps = (one * ruler.metres for one in ruler.steps)
    step = min(steps, key=lambda one: abs(math.log(one * STEPS_A_DIAMETER / diameter)))
    low, high = (ratio * diameter / step for ratio in WIDTH_RATIOS)
    return tuple(step * count for count in range(math.ceil(low - 1e-9), math.floor(high + 1e-9) + 1))


def _numbers(widths: Vary) -> list[float]:
    """Widths in m; none of those that are not listed, or that the case refuses."""
    made = []
    for one in widths.values or ():
        with suppress(QuantityError):
            made.append(read(one, "m"))
    return made


def _feeds(diameter: float, widths: Sequence[float], ruler: _Ruler) -> list[dict[str, Any]]:
    """All feeds of all widths, each once."""
    pockets = [_pocket(width, place, ruler) for place in POCKET_PLACES for width in widths]
    return [*(one for place, one in enumerate(pockets) if one not in pockets[:place]), _hole(diameter, ruler)]


def _pocket(width: float, place: str, ruler: _Ruler) -> dict[str, Any]:
    """The widest pocket of whole millimetres or sixteenths of an inch within the range of its correlation."""
    return {"kind": "pocket", "width": ruler.text(ruler.within(POCKET_SHARE * width)), "place": place}


def _hole(diameter: float, ruler: _Ruler) -> dict[str, Any]:
    hole = min(HOLE_SHARE * diameter, LARGEST_HOLE)
    return {"kind": "hole", "diameter": ruler.text(ruler.within(hole)), "place": "opposite"}


def fit_together(values: Mapping[str, Any], stated: Collection[str]) -> bool:
    """Whether the values of a row belong together: a pocket of these rules goes with its width."""
    feed, width = values.get("supply_element"), values.get("width")
    if "supply_element" in stated or not isinstance(feed, Mapping) or feed["kind"] != "pocket" or width is None:
        return True
    return feed == _pocket(float(width), feed["place"], _ruler_of(feed["width"]))


def shown(fields: Mapping[str, Any], values: Mapping[str, float]) -> dict[tuple[str, str], str]:
    """The cells of a design in a table, by heading and unit: what was chosen, and what comes of it."""
    feed = str(fields["supply_element"]).replace("_", " ").replace(",", "")
    numbers = {
        "relative_clearance": values["relative_clearance"],
        "specific_load": values["specific_load"],
        **{name: value_held(values, name) for name in ("minimum_film_thickness", "outlet_temperature")},
    }
    return {
        (translated("lubricant"), ""): str(fields["lubricant"]),
        (translated("clearance"), ""): translated_if_known(
            str(fields["clearance"]).replace("permille", "‰").replace("imum", ".")
        ),
        (translated("feed"), ""): translated_if_known(
            feed.replace("place ", "").replace("width ", "").replace("diameter ", "")
        ),
        (QUANTITIES["width"].symbol, QUANTITIES["width"].display.label): decimal(
            f"{QUANTITIES['width'].shown(fields['width']):.4g}"
        ),
        **{
            (QUANTITIES[name].symbol, QUANTITIES[name].display.label): number(name, value)
            for name, value in numbers.items()
        },
    }


def departures(line: Mapping[str, Any]) -> Iterator[str]:
    """Usual rules that a design does not keep at a clearance, beside its recommendations."""
    if _over_transition(line) < _least_over_transition(line):
        yield TRANSITION


def _over_transition(line: Mapping[str, Any]) -> float:
    """Speed over the transition speed of the film that limits are held against; NaN where none is known."""
    return float(line.get("hydrodynamic_speed", math.nan)) / value_held(line, "transition_speed")


def _least_over_transition(line: Mapping[str, Any]) -> float:
    return max(LEAST_OVER_TRANSITION, float(line["surface_speed"]))


def reasons(lines: Sequence[Mapping[str, Any]], limits: Mapping[str, float]) -> Iterator[str]:
    """Why a proposal is as it is: the usual rules with its numbers and where they come from.

    Parameters
    ----------
    lines : sequence of mapping
        Of each clearance the columns in SI, the mean one in the middle.
    limits : mapping
        By the code of a check its limit.
    """
    values = lines[len(lines) // 2]
    pressure = values["specific_load"]
    if (most := limits.get("C105", limits.get("C103"))) is not None:
        yield translated(
            "p̄ = {pressure} of {most} that the metal bears",
            pressure=written("specific_load", pressure),
            most=written("specific_load", most),
        )
    mean, wanted = values["relative_clearance"], values["recommended_relative_clearance"]
    sign = "≥" if mean >= wanted else "<"
    yield translated(
        "ψ = {mean} ‰ {sign} {wanted} ‰, the {rule}",
        mean=decimal(f"{1e3 * mean:.2f}"),
        sign=sign,
        wanted=decimal(f"{1e3 * wanted:.2f}"),
        rule=translated("0.8 ‰ U^(1/4), U in m/s (Vogelpohl)"),
    )
    low, high = (decimal(f"{end:g}") for end in WIDTH_RATIOS)
    yield translated(
        "B/D = {ratio}, usual {low} to {high} (assumption)",
        ratio=decimal(f"{values['width_ratio']:.2f}"),
        low=low,
        high=high,
    )
    ratio = least(map(_over_transition, lines))
    if math.isfinite(ratio):
        yield translated(
            "the speed is {ratio} times the transition speed, usual at least {usual}, U in m/s and no less than "
            "{least} (assumption)",
            ratio=decimal(f"{ratio:.3g}"),
            usual=decimal(f"{_least_over_transition(values):.3g}"),
            least=decimal(f"{LEAST_OVER_TRANSITION:g}"),
        )
    share = least(line["supply_capacity"] / line["side_flow"] for line in lines)
    if math.isfinite(share):
        held = "" if share >= 1.0 else f"; {_more_pressure(lines)}"
        said = translated(
            "the feed gives at least {share} of Q₃ (ISO 7902), whatever the clearance",
            share=decimal(f"{share:.2g}"),
        )
        yield f"{said}{held}"


def _more_pressure(lines: Sequence[Mapping[str, Any]]) -> str:
    """What follows from a feed that gives less than Q₃, and the pressure that presses the missing oil through."""
    held = translated("the limits are held against the hotter film with that flow")
    lacks = [
        (line["side_flow"] - line["supply_capacity"]) / pressed
        for line in lines
        if (pressed := line["supply_flow"]) > 0.0
    ]
    more = 1.0 + max(lacks, default=math.inf)
    if not more <= MOST_PRESSURE:
        return held
    needed = translated("about {more} times the supply pressure would give it all", more=decimal(f"{more:.1f}"))
    return f"{held}; {needed}"
