"""What one temperature for the whole film costs, in words: the fullest thermal film compared with the others."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.limited_flow import quantity_held
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.compare.thermal_variants import GLOBAL
from babbitt.study.comparison import Comparison

__all__ = ["cost_of_one_temperature"]

ONE_TEMPERATURE = ("ISO 7902", GLOBAL, f"{GLOBAL}, Reynolds")
FULLEST = ("full thermal film", "adiabatic film")


def cost_of_one_temperature(comparison: Comparison) -> Iterator[str]:
    """Say how a film with its own temperatures differs from one of a single temperature.

    Of a bearing short of oil the film counts against which its limits are held.

    Parameters
    ----------
    comparison : Comparison

    Yields
    ------
    str
        One sentence per method of a single temperature; nothing where no film with its own temperatures has been
        solved.
    """
    solved = {one.label: one.result for one in comparison.variants if one.result.outcome.solved and one.is_method}
    fullest = next((label for label in FULLEST if label in solved), None)
    if fullest is None:
        return
    for label in ONE_TEMPERATURE:
        if label in solved:
            yield _said(label, solved[label], fullest, solved[fullest])


def _said(label: str, plain: Result, fullest: str, full: Result) -> str:
    whom = label.replace(GLOBAL, "the film of one temperature")
    thickness = plain.values[quantity_held(plain, "minimum_film_thickness")]
    thin = full.minimum_film_thickness / thickness - 1.0
    less = full.friction_power / plain.values[quantity_held(plain, "friction_power")] - 1.0
    film = QUANTITIES["minimum_film_thickness"]
    words = (
        f"Against {whom} the {fullest} is {abs(thin):.0%} {'thinner' if thin < 0.0 else 'thicker'} at its "
        f"thinnest ({film.format(full.minimum_film_thickness)} instead of "
        f"{film.format(thickness)} {film.display.label}) and takes {abs(less):.0%} "
        f"{'less' if less < 0.0 else 'more'} power"
    )
    known = "outlet_temperature" if "outlet_temperature" in plain.values else "effective_temperature"
    place = "bush" if "maximum_bush_temperature" in full.values else "film"
    hottest = full.values.get("maximum_bush_temperature", full.maximum_temperature)
    apart = hottest - plain.values[quantity_held(plain, known)]
    said = "outlet" if known == "outlet_temperature" else "effective temperature"
    return (
        f"{words}; its {place} reaches {hottest - ZERO_CELSIUS:.0f} °C, {abs(apart):.0f} K "
        f"{'above' if apart > 0.0 else 'below'} the {said} that {whom} tells."
    )
