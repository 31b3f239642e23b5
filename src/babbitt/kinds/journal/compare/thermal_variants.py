"""The thermal models of the film method that `babbitt compare` puts side by side, and what each neglects."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from babbitt.case import CaseFile
from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.case.build import film_cases
from babbitt.kinds.journal.case.film_heat import unknown_to_own_temperatures
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.film.model import FilmCase

__all__ = [
    "GLOBAL",
    "OWN",
    "ThermalVariant",
    "left_out_of_thermal_variants",
    "describe_factor",
    "thermal_variants",
]

GLOBAL = "film, one temperature"

INLET = "inlet"
PRESCRIBED = "prescribed"

REMARKS = {
    INLET: (
        "sees the feeding; takes the temperature of the fresh oil for the whole film: neglects that the film "
        "heats itself"
    ),
    PRESCRIBED: "sees the feeding; takes the given temperature for the whole film, whatever heat it makes",
    GLOBAL: "sees the feeding; conserves the oil; assumes one temperature for the whole film",
    "adiabatic film": (
        "finds the temperature at every place of the film, and what the grooves mix; neglects the heat that bush "
        "and journal take, and that they carry from hot places to cold ones"
    ),
    "full thermal film": (
        "as adiabatic film, with bush and housing that conduct heat and a journal of one temperature; neglects "
        "heat along the bush"
    ),
}
"""What each model of the temperature sees and neglects, from the simplest to the fullest; of the bore see
`_remark`."""

OWN = {"adiabatic": "adiabatic film", "full": "full thermal film"}


@dataclass(frozen=True)
class ThermalVariant:
    """A film with one model of its temperature; ``detail`` grows with what it sees."""

    label: str
    remark: str
    case: FilmCase
    detail: int


def thermal_variants(bearing: JournalBearing, case: CaseFile) -> Iterator[tuple[ThermalVariant, ...]]:
    """Films of a bearing at each of its points, one for every thermal model that applies.

    Parameters
    ----------
    bearing : JournalBearing
    case : CaseFile
        The file that the bearing belongs to.

    Yields
    ------
    tuple of ThermalVariant
        From the simplest to the fullest; that of the bearing itself stands first where it names the film method.
    """
    own_films, with_balance = film_cases(bearing, case), film_cases(bearing, case, "global")
    free = not left_out_of_thermal_variants(bearing, case)
    heated = {name: film_cases(bearing.without_friction_factor(), case, name) for name in OWN if free}
    for index, own in enumerate(own_films):
        found = {}
        if own.effective_temperature is not None:
            found[PRESCRIBED] = own
        if own.oil_supply is not None:
            cold = replace(with_balance[index], effective_temperature=own.oil_supply.temperature)
            found[INLET] = cold
        if own.oil_supply is not None or own.cooling is not None:
            found[GLOBAL] = with_balance[index]
        found |= {OWN[name]: films[index] for name, films in heated.items()}
        yield tuple(
            ThermalVariant(
                _label(name, film),
                _remark(name, film) + ("" if film.heat is None else describe_factor(bearing)),
                film,
                list(REMARKS).index(name),
            )
            for name, film in _ordered(bearing, own, found)
        )


def describe_factor(bearing: JournalBearing) -> str:
    """Say that a method leaves out the factor on friction of a bearing; empty where it has none."""
    factor = bearing.friction.factor
    if factor == 1.0:
        return ""
    return f"; without the factor {factor:g} on friction, which ISO 7902 and films of one temperature know"


def left_out_of_thermal_variants(bearing: JournalBearing, case: CaseFile) -> str:
    """Why films with their own temperatures do not know a bearing, in words; empty where they do."""
    reason = unknown_to_own_temperatures(bearing)
    supplies = [film.oil_supply for film in film_cases(bearing, case)]
    if reason or all(one is not None and one.flow is None for one in supplies):
        return reason
    flooded = "a film with its own temperatures is fed by pressure, not by a given flow"
    return flooded if all(supplies) else "a film with its own temperatures needs the temperature of fresh oil"


def _label(name: str, film: FilmCase) -> str:
    """What stands at the head of a column: a prescribed temperature by its value."""
    if film.effective_temperature is None:
        return name
    return f"film at {film.effective_temperature - ZERO_CELSIUS:.4g} °C"


def _remark(name: str, film: FilmCase) -> str:
    """What a model sees and neglects, deformation of the bore by pressure and by heat among it."""
    if film.heat is None or film.heat.walls is None:
        return REMARKS[name]
    neglected = [
        cause
        for cause, counted in (("pressure", film.bearing.compliance), ("uneven heat", film.heat.growth))
        if not counted
    ]
    also = f", and deformation by {' or by '.join(neglected)}" if neglected else ""
    return f"{REMARKS[name]}{also}"


def _ordered(bearing: JournalBearing, own: FilmCase, found: dict[str, FilmCase]) -> Iterator[tuple[str, FilmCase]]:
    """The model of the bearing first where it names the film method."""
    first = ""
    if bearing.method == "film":
        first = PRESCRIBED if own.effective_temperature is not None else GLOBAL
        first = first if own.heat is None else OWN[own.heat.name]
        yield first, own
    yield from ((label, film) for label, film in found.items() if label != first)
