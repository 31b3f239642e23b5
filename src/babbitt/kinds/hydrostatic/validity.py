"""Warnings about a hydrostatic bearing: where its theory, or good practice, ends."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from babbitt.core.notices import Notice
from babbitt.design.warnings import LARGEST_RISE, OPEN_HEAT
from babbitt.kinds.hydrostatic.answer import Answer
from babbitt.kinds.hydrostatic.geometry import RecessedJournal, RectangularPad, ThrustRing
from babbitt.kinds.hydrostatic.impedance import impedance
from babbitt.kinds.hydrostatic.model import HydrostaticCase, beyond_data
from babbitt.kinds.hydrostatic.pumping import is_pumped, law_of
from babbitt.kinds.hydrostatic.restrictors import Capillary, Orifice

__all__ = ["warnings_of_solution"]

LAMINAR_FILM, LAMINAR_TUBE = 1000.0, 2000.0
SLENDER, SMALLEST_ORIFICE = 20.0, 0.3e-3
USUAL_PRESSURES, USUAL_POWERS = (0.3, 0.8), (1.0, 3.0)
"""Recess over supply pressure; friction over pumping power."""
DEEP, WIDE_RECESS = 10.0, 2.0
"""Least depth of a recess over the gap; least side of a recess over its land."""
OPEN_MASS = 1e-6
"""Relative error of the oil's balance from which there is no verdict; the temperature is sought to 1e-6 K."""
MOST_EDGE_INERTIA, MOST_LOSS, WARMEST = 0.2, 0.2, 20.0
LARGEST_RISE_UNBALANCED = 40.0
"""K, where viscosity or temperature of the film is given and no heat balance made (an assumption).

The film is half of it warmer than its supply, which halves the viscosity of mineral oils."""

THINNED_BY_A_KELVIN = 0.045
"""1/K: share of the viscosity that mineral oils lose by a kelvin, ISO VG 32 to 68 at 40 to 60 °C."""


def warmed_gap(gap: float, rise: float) -> float:
    """Gap of a film of given viscosity if its oil took on the whole temperature rise, m.

    Behind restrictors that stay cool, and with given flows, it goes with the cube root of the viscosity.

    >>> round(warmed_gap(22.4e-6, 14.0) * 1e6, 1)
    18.2
    """
    return gap * math.exp(-THINNED_BY_A_KELVIN * rise / 3.0)


def beyond_film(case: HydrostaticCase, rise: float) -> float:
    """Temperature in K of the oil that leaves over that of the film, of which a given one counts already."""
    oil = case.oil
    if oil.film_temperature is None or oil.supply_temperature is None:
        return rise
    return oil.supply_temperature + rise - oil.film_temperature


def warnings_of_solution(case: HydrostaticCase, found: Answer, named: Mapping[str, float]) -> Iterator[Notice]:
    """All that is to be said of a solved bearing.

    Parameters
    ----------
    case : HydrostaticCase
    found : Answer
    named : mapping
        Its values.
    """
    yield from of_restrictors(case, found)
    yield from of_pressures(case, found, named)
    yield from of_film(case, found, named)
    yield from of_powers(case, named)
    yield from of_balances(case, named)
    yield from of_vibration(case, found)
    yield from of_method(case)


def of_restrictors(case: HydrostaticCase, found: Answer) -> Iterator[Notice]:
    """Back flow, and the validity of tubes and holes."""
    network = found.network
    for k, flow in enumerate(network.flows):
        if flow < -1e-9 * float(np.abs(network.flows).max()):
            yield Notice("W301", values={"recess": k + 1, "restrictor_flow": -float(flow)})
    numbers = [
        law.reynolds_number(float(flow)) if isinstance(law := law_of(restrictor), Capillary) else 0.0
        for restrictor, flow in zip(case.feeding.restrictors, network.flows, strict=True)
    ]
    if (worst := max(numbers)) > LAMINAR_TUBE:
        yield Notice("W303", "turbulent", {
            "restrictor_reynolds_number": worst, "recess": numbers.index(worst) + 1, "limit": LAMINAR_TUBE,
        })  # fmt: skip
    for law in dict.fromkeys(law_of(one) for one in case.feeding.restrictors):
        if isinstance(law, Capillary) and law.length < SLENDER * law.diameter:
            yield Notice("W303", "short", {"ratio": law.length / law.diameter, "least": SLENDER})
        if isinstance(law, Orifice) and law.diameter < SMALLEST_ORIFICE:
            yield Notice("W304", values={"diameter": law.diameter, "least": SMALLEST_ORIFICE})


def of_pressures(case: HydrostaticCase, found: Answer, named: Mapping[str, float]) -> Iterator[Notice]:
    """Pressure ratio, supply, inertia at the edge of a recess."""
    ratio = named["mean_pressure_ratio"]
    if is_pumped(case):
        worst, supply = int(found.network.pressures.argmax()), found.network.supply_pressure
        if float(found.network.pressures[worst]) > supply:
            pressure = float(found.network.pressures[worst])
            yield Notice("W313", "recess", {"recess": worst + 1, "recess_pressure": pressure, "given": supply})
    elif not USUAL_PRESSURES[0] <= ratio <= USUAL_PRESSURES[1]:
        least, most = USUAL_PRESSURES
        yield Notice("W302", values={"mean_pressure_ratio": ratio, "least": least, "most": most})
    highest = case.highest_supply_pressure
    if highest is not None and not is_pumped(case) and named["supply_pressure"] > highest:
        yield Notice("W313", "supply", {"needed": named["supply_pressure"], "held": highest})
    inertia = named.get("edge_inertia", 0.0)
    if inertia > MOST_EDGE_INERTIA:
        yield Notice("W308", values={"edge_inertia": inertia, "limit": MOST_EDGE_INERTIA})
    loss = named["compressibility_damping_loss"]
    if loss > 1.0:
        yield Notice("W310", values={"times": loss})
    elif loss > MOST_LOSS:
        yield Notice("W309", values={"compressibility_damping_loss": loss})


def of_film(case: HydrostaticCase, found: Answer, named: Mapping[str, float]) -> Iterator[Notice]:
    """Laminar flow, deep recesses, rupture beside a recess."""
    for code, name in (("W305", "film_reynolds_number"), ("W306", "recess_reynolds_number")):
        number = named.get(name, 0.0)
        if number > LAMINAR_FILM:
            yield Notice(code, values={"reynolds_number": number, "limit": LAMINAR_FILM})
    gap = case.rest_gap if case.is_journal else named["gap"]
    if case.recesses.depth < DEEP * gap:
        yield Notice("W307", values={"gaps": case.recesses.depth / gap, "least": DEEP})
    if found.film is not None and dry_beside_recess(found):
        yield Notice("W315", values={"cavitated_share": float(found.film.dry_share)})


def dry_beside_recess(found: Answer) -> bool:
    """Whether a node without film has a recess for neighbour."""
    assert found.film is not None
    recess, wet = found.film.film.of.recess, found.film.film.work.wet
    dry = (recess == -1) & ~wet
    held = recess >= 0
    beside = np.roll(held, 1, axis=0) | np.roll(held, -1, axis=0)
    beside[:, 1:] |= held[:, :-1]
    beside[:, :-1] |= held[:, 1:]
    return bool((dry & beside).any())


def of_powers(case: HydrostaticCase, named: Mapping[str, float]) -> Iterator[Notice]:
    """Power ratio and temperature rise."""
    ratio = named["power_ratio"]
    least, most = USUAL_POWERS
    if case.surface_speed > 0.0 and not least <= ratio <= most:
        yield Notice("W311", values={"power_ratio": ratio, "least": least, "most": most})
    rise = named["temperature_rise"]
    if rise > WARMEST:
        yield Notice("W312", "warm", {"temperature_rise": rise})
    balanced = "energy_balance_error" in named
    if not (balanced or case.is_journal or case.duty.load is None) and case.least_gap is not None:
        gap, limit = named["minimum_film_thickness"], case.least_gap
        warm = warmed_gap(gap, beyond_film(case, rise))
        if warm < limit <= gap:
            yield Notice(
                "W312", "kept", {"temperature_rise": rise, "minimum_film_thickness": warm, "limit": limit}
            )
    bound = LARGEST_RISE if balanced else LARGEST_RISE_UNBALANCED
    if rise > bound:
        yield Notice("W322", "balanced" if balanced else "given", {"temperature_rise": rise, "limit": bound})
    oil = case.oil
    if oil.is_warmed and oil.lubricant is not None and oil.temperature is not None:  # a given one: by the case
        yield from beyond_data(oil.lubricant, oil.temperature, "film")


def of_balances(case: HydrostaticCase, named: Mapping[str, float]) -> Iterator[Notice]:
    """Oil and heat that are not accounted for."""
    mass, heat = named["mass_balance_error"], named.get("energy_balance_error", 0.0)
    if not mass < OPEN_MASS:
        yield Notice("W324", values={"mass_balance_error": mass})
    if not heat < OPEN_HEAT:
        yield Notice("W325", values={"energy_balance_error": heat})


def of_vibration(case: HydrostaticCase, found: Answer) -> Iterator[Notice]:
    """Negative damping of some motion at a frequency of the case."""
    for frequency in case.frequencies:
        damping = impedance(found.response, found.network, case.compressibility, frequency)[1]
        if case.kind == "hydrostatic_pad":
            damping = damping[:1, :1]
        if float(np.linalg.eigvalsh(0.5 * (damping + damping.T)).min()) < 0.0:
            yield Notice("W323", values={"frequency": frequency})


def of_method(case: HydrostaticCase) -> Iterator[Notice]:
    """Limits of closed forms, and journals with too few recesses."""
    shape = case.shape
    if isinstance(shape, RecessedJournal) and shape.count < 3:
        yield Notice("W316", values={"recesses": shape.count})
    if case.method == "quick" and isinstance(shape, RectangularPad):
        along, aside = shape.lands
        if abs(along - aside) > 1e-6 * along:
            yield Notice("W317", values={"along": along, "across": aside})
        elif min(shape.recess_length, shape.recess_width) < WIDE_RECESS * along:
            widths = min(shape.recess_length, shape.recess_width) / along
            yield Notice("W318", values={"widths": widths, "least": WIDE_RECESS})
    if case.method == "quick" and isinstance(shape, RecessedJournal | ThrustRing):
        yield Notice("W319")
