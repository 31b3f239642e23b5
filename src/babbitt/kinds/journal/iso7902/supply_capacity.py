"""Whether the supply delivers the oil that the film wants, and the heat balance with what it does.

ISO 7902 lets the film draw its side flow Q₃ whatever feeds it. What an element can deliver is estimated as the
oil that the supply pressure presses through it and the fresh oil that the journal shears into the loaded film over
its axial width, ``Q_cap = Q_p + (U/2) (h_s - h_r) b``: the gap ``h_s = c (1 - ε cos(α_s + β))`` at the downstream
edge of the element, α_s before the load, takes in what the film does not bring back. Warm oil comes back to a
pocket in a film ``h_r = h_0 - 2 Q_3/(U B)``, what enters the loaded arc at its start less what that loses at its
sides; a hole stops none of it (h_r = 0). Of two elements that before the load counts: the oil of the other comes
round to it and is not lost. A half groove gives its oil at its edge before the load, a groove all around by
pressure alone. Of elements at the ends of an arc below 180 deg Q_p is that of the gaps where they stand: the
formula of the standard holds at 90 deg to the load. No more comes than tubes and holes pass at the whole supply
pressure. The estimate is an assumption; ``benchmarks/supply_capacity.py`` sets it against films that conserve
their oil.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial

from babbitt.core.limited_flow import limited
from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check
from babbitt.design.failure import failure_of
from babbitt.design.heat_balance import Equilibrium, coolest_temperature, find_equilibrium
from babbitt.kinds.journal.iso7902.film import Film, SuppliedFilm, curves_of, starved_film_at
from babbitt.kinds.journal.iso7902.model import DesignCase
from babbitt.kinds.journal.iso7902.supply import CircumferentialGroove, HalfCircumferentialGroove, Holes, Pockets
from babbitt.kinds.journal.iso7902.warnings import warnings_about_validity

__all__ = [
    "assumptions_about_capacity",
    "capacity_check",
    "capacity_not_checked",
    "warnings_about_capacity",
    "lacks_oil",
    "starved_equilibrium",
    "starved_values",
    "worse_of",
]

Values = Mapping[str, float]

STARVED = {
    name: limited(name)
    for name in (
        "effective_temperature",
        "outlet_temperature",
        "bearing_temperature",
        "operating_relative_clearance",
        "effective_viscosity",
        "sommerfeld_number",
        "eccentricity_ratio",
        "attitude_angle",
        "minimum_film_thickness",
        "maximum_pressure",
        "friction_coefficient",
        "friction_power",
        "side_flow",
        "supply_flow",
        "total_flow",
        "film_reynolds_number",
        "critical_reynolds_number",
        "transition_speed",
        "heat_to_oil",
        "heat_to_surroundings",
    )
}
"""Results with the flow limited to what the supply delivers, by those with all the oil that the film wants."""

SOURCE = (
    "ISO 7902: the supply delivers Q₃; "
    "Q_p + (U/2) h b with gap h and width b at its edge is an estimate (assumption)"
)

OF_THE_CLEARANCE = ("W130", "W193")

TRUSTED_SHARE = 0.5
"""Share of Q₃ down to which what holes, slots and pockets deliver does not question the result (an assumption).

The limits are held against the film with that flow. Random films of one temperature that conserve their oil passed
at least 0.8 of the estimate, and no outlet was hotter (docs/theory/supply.md): it errs to the hot side.
"""


def lacks_oil(film: SuppliedFilm) -> bool:
    """Whether the supply delivers less than the side flow of the film."""
    return film.supply_capacity is not None and film.supply_capacity < film.side_flow


def gets_less(film: SuppliedFilm) -> bool:
    """Whether the film gets less than Q₃ and Q_p of the standard: for want of oil, or as elements stand closer."""
    return lacks_oil(film) or film.stands_closer


def starved_equilibrium(case: DesignCase, film: SuppliedFilm) -> Equilibrium[Film] | None:
    """Close the heat balance with the flow that the supply delivers.

    Returns
    -------
    Equilibrium or None
        None where the film gets what the standard gives it, or where no heat balance is made.
    """
    if case.effective_temperature is not None or not gets_less(film):
        return None
    # less oil carries less heat off, down to the inlet temperature: no equilibrium lies below that of all the oil
    supply = case.oil_supply
    cooled = supply is not None and coolest_temperature(case) < supply.temperature
    above = 0.0 if cooled else film.temperature
    return find_equilibrium(case, partial(starved_film_at, case=case, shape=curves_of(case)), above=above)


def assumptions_about_capacity(case: DesignCase, film: SuppliedFilm) -> Iterator[str]:
    """What the limited heat balance takes for granted, where it is made."""
    if film.stands_closer:
        yield "Q_p of elements at the ends of the arc goes with the mean cube of the gaps where they stand."
    if not lacks_oil(film):
        return
    if case.effective_temperature is None:
        yield "With the flow that the supply delivers the film counts as full of oil of its T_eff (assumption)."
    said = (
        "The supply delivers what its pressure presses through it and what the journal shears off before the load"
    )
    match case.bearing.supply_element:
        case CircumferentialGroove():
            yield "The supply delivers what pressure presses out of the groove around the bore, nothing by shear."
        case HalfCircumferentialGroove():
            yield (
                f"{said}: of a half groove at its edge alone, though it fills the unloaded half along its whole "
                "length, which errs to the hot side at the outlet."
            )
        case _:
            yield f"{said}; what the film keeps from turn to turn is not counted."


def starved_values(values: Values) -> dict[str, float]:
    """Give the results of the starved film their own names."""
    return {STARVED[name]: values[name] for name in STARVED if name in values}


def worse_of(checks: Iterable[Check], starved: Iterable[Check]) -> tuple[Check, ...]:
    """Hold every limit against the worse of both answers; one that a single answer knows stands by itself."""
    of_full = {check.code: check for check in checks}
    of_starved = {
        check.code: replace(check, quantity=STARVED[check.quantity]) if check.quantity in STARVED else check
        for check in starved
    }
    both = {**of_full, **of_starved}  # the order of the standard
    return tuple(min(of_full.get(code, check), check, key=lambda one: one.margin) for code, check in both.items())


def capacity_check(film: SuppliedFilm, starved: Equilibrium[Film] | None) -> Iterator[Check]:
    """Compare what the supply delivers with the side flow.

    A miss decides nothing by itself: the limits are held against the starved film. Where that has no equilibrium,
    the miss is a violated limit.
    """
    if film.supply_capacity is None:
        return
    answered = starved is None or starved.outcome.solved
    capacity = film.supply_capacity
    yield Check("C117", "supply_capacity", capacity, film.side_flow, Bound.AT_LEAST, SOURCE, advisory=answered)


def capacity_not_checked(case: DesignCase, film: SuppliedFilm) -> Iterator[Notice]:
    """Say why the supply capacity was not compared."""
    if case.oil_supply is None or film.supply_capacity is not None:
        return
    yield Notice("C117")


def warnings_about_capacity(
    case: DesignCase, film: SuppliedFilm, starved: Equilibrium[Film] | None, values: Values
) -> Iterator[Notice]:
    """Report what the supply lacks, and what follows from it.

    Parameters
    ----------
    case : DesignCase
    film : SuppliedFilm
        With all the oil that it wants.
    starved : Equilibrium or None
        With what the supply delivers.
    values : Mapping[str, float]
        Named results of the starved film, if there is one.
    """
    if case.oil_supply is None:
        return
    capacity, wanted = film.supply_capacity, film.side_flow
    if case.bearing.supply_element is None:
        balanced = case.effective_temperature is None
        yield Notice("W185" if balanced else "W124", "no_element", {"wanted": wanted})
    elif capacity is not None and capacity <= 0.0:
        grooved = isinstance(case.bearing.supply_element, CircumferentialGroove)
        yield Notice("W185", "full_groove" if grooved else "no_pressure", {"wanted": wanted})
    elif film.supply_flow <= 0.0 and film.feed is not None and film.feed.limit is None:
        yield Notice("W124", "no_pressure_left")
    if not gets_less(film):
        return
    code = _code_of_lack(case, film)
    lack = tuple(_lack(code, film))
    if starved is None:
        yield Notice(code, "no_balance", {"lack": lack})
        return
    if not starved.outcome.solved:
        # Where Q₃ is delivered, C117 is no miss that would decide.
        yield Notice("W123" if lacks_oil(film) else "W185", "no_equilibrium", {
            "lack": lack, "outcome": starved.outcome.value, "reason": failure_of(case, starved),
        })  # fmt: skip
        return
    reached = Notice(code, "reached", {
        "effective_temperature": values["effective_temperature"],
        "minimum_film_thickness": values["minimum_film_thickness"],
    })  # fmt: skip
    if "outlet_temperature" in values:
        reached = Notice(code, "reached_outlet", {
            "outlet_temperature": values["outlet_temperature"], "reached": reached,
        })  # fmt: skip
    yield Notice(code, "limited", {"lack": lack, "total_flow": values["total_flow"], "reached": reached})
    for warning in warnings_about_validity(case, values):
        if warning.code in OF_THE_CLEARANCE:
            continue  # the same as with all the oil
        yield Notice(warning.code, "limited_flow", {"said": warning})


def _code_of_lack(case: DesignCase, film: SuppliedFilm) -> str:
    """The code of the warning about what a film lacks of the flows of the standard."""
    if film.supply_capacity is None or not lacks_oil(film):
        return "W195"
    enough = film.supply_capacity >= TRUSTED_SHARE * film.side_flow
    return "W190" if enough and isinstance(case.bearing.supply_element, Holes | Pockets) else "W123"


def _lack(code: str, film: SuppliedFilm) -> Iterator[Notice]:
    """What the film lacks of the flows of the standard."""
    if film.stands_closer:
        yield Notice(code, "place", {"taken": film.supply_flow, "there": film.supply_flow_at_place})
    capacity, wanted = film.supply_capacity, film.side_flow
    if capacity is not None and lacks_oil(film):
        share = capacity / wanted
        yield Notice(code, "capacity", {"supply_capacity": capacity, "wanted": wanted, "share": share})
