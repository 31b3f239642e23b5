"""Warnings about a hydrostatic bearing: where its theory, or good practice, ends."""

from __future__ import annotations

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
OPEN_MASS = 1e-6
"""Relative error of the oil's balance from which there is no verdict; the temperature is sought to 1e-6 K."""
MOST_EDGE_INERTIA, MOST_LOSS, WARMEST = 0.2, 0.2, 20.0
LARGEST_RISE_UNBALANCED = 40.0
"""K, where viscosity or temperature of the film is given and no heat balance made (an assumption).

The film is half of it warmer than its supply, which halves the viscosity of mineral oils."""


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
            yield Notice("W301", f"recess {k + 1} pushes {-6e4 * flow:.3g} L/min back through its restrictor")
    worst, said = 0.0, ""
    for k, (restrictor, flow) in enumerate(zip(case.feeding.restrictors, network.flows, strict=True)):
        law = law_of(restrictor)
        if isinstance(law, Capillary):
            number = law.reynolds_number(float(flow))
            if number > max(worst, LAMINAR_TUBE):
                worst, said = (
                    number,
                    f"Re = {number:.0f} in the capillary of recess {k + 1}, above {LAMINAR_TUBE:.0f}",
                )
    if said:
        yield Notice("W303", said)
    for law in dict.fromkeys(law_of(one) for one in case.feeding.restrictors):
        if isinstance(law, Capillary) and law.length < SLENDER * law.diameter:
            ratio = law.length / law.diameter
            yield Notice("W303", f"the capillary is {ratio:.3g} diameters long, less than {SLENDER:.0f}")
        if isinstance(law, Orifice) and law.diameter < SMALLEST_ORIFICE:
            yield Notice("W304", f"the orifice has {1e3 * law.diameter:.3g} mm, less than 0.3 mm")


def of_pressures(case: HydrostaticCase, found: Answer, named: Mapping[str, float]) -> Iterator[Notice]:
    """Pressure ratio, supply, inertia at the edge of a recess."""
    ratio = named["mean_pressure_ratio"]
    if is_pumped(case):
        worst, supply = int(found.network.pressures.argmax()), found.network.supply_pressure
        if float(found.network.pressures[worst]) > supply:
            yield Notice("W313", f"recess {worst + 1} stands at {1e-6 * found.network.pressures[worst]:.4g} MPa, "
                         f"its pump is given {1e-6 * supply:.4g} MPa")  # fmt: skip
    elif not 0.3 <= ratio <= 0.8:
        yield Notice("W302", f"recess over supply pressure is {ratio:.3f} on average, outside 0.3 to 0.8")
    highest = case.highest_supply_pressure
    if highest is not None and not is_pumped(case) and named["supply_pressure"] > highest:
        yield Notice("W313", f"{1e-6 * named['supply_pressure']:.4g} MPa are needed, the pump holds "
                     f"{1e-6 * highest:.4g} MPa")  # fmt: skip
    inertia = named.get("edge_inertia", 0.0)
    if inertia > MOST_EDGE_INERTIA:
        yield Notice("W308", f"rho U²/2 is {inertia:.3g} of the lowest recess pressure, above {MOST_EDGE_INERTIA}")
    loss = named["compressibility_damping_loss"]
    if loss > 1.0:
        yield Notice("W310", f"the oil in recess and line takes away {loss:.2f} times the damping")
    elif loss > MOST_LOSS:
        yield Notice("W309", f"the oil in recess and line takes away {100.0 * loss:.0f} % of the damping")


def of_film(case: HydrostaticCase, found: Answer, named: Mapping[str, float]) -> Iterator[Notice]:
    """Laminar flow, deep recesses, rupture beside a recess."""
    for name, where in (("film_reynolds_number", "film"), ("recess_reynolds_number", "recess")):
        number = named.get(name, 0.0)
        if number > LAMINAR_FILM:
            code = "W305" if where == "film" else "W306"
            yield Notice(code, f"Re = {number:.0f} in the {where}, above {LAMINAR_FILM:.0f}")
    gap = case.rest_gap if case.is_journal else named["gap"]
    if case.recesses.depth < 10.0 * gap:
        yield Notice("W307", f"the recess is {case.recesses.depth / gap:.3g} gaps deep, less than 10")
    if found.film is not None and dry_beside_recess(found):
        share = 100.0 * found.film.dry_share
        yield Notice("W315", f"{share:.2g} % of the lands are without film, some at a recess")


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
    if case.surface_speed > 0.0 and not 1.0 <= ratio <= 3.0:
        yield Notice("W311", f"friction over pumping power is {ratio:.3g}, outside 1 to 3")
    rise = named["temperature_rise"]
    if rise > WARMEST:
        yield Notice("W312", f"the oil warms by {rise:.3g} K between manifold and drain")
    balanced = "energy_balance_error" in named
    bound = LARGEST_RISE if balanced else LARGEST_RISE_UNBALANCED
    if rise > bound:
        given = "" if balanced else "; viscosity or temperature of the film is given, which it would then not have"
        yield Notice("W322", f"the oil would warm by {rise:.0f} K > {bound:.0f} K{given}")
    oil = case.oil
    if oil.is_warmed and oil.lubricant is not None and oil.temperature is not None:  # a given one: by the case
        yield from beyond_data(oil.lubricant, oil.temperature, "the film")


def of_balances(case: HydrostaticCase, named: Mapping[str, float]) -> Iterator[Notice]:
    """Oil and heat that are not accounted for."""
    mass, heat = named["mass_balance_error"], named.get("energy_balance_error", 0.0)
    if not mass < OPEN_MASS:
        yield Notice("W324", f"{mass:.2g} of the oil is not accounted for")
    if not heat < OPEN_HEAT:
        yield Notice("W325", f"{heat:.2g} of the heat of the film is not accounted for")


def of_vibration(case: HydrostaticCase, found: Answer) -> Iterator[Notice]:
    """Negative damping of some motion at a frequency of the case."""
    for frequency in case.frequencies:
        damping = impedance(found.response, found.network, case.compressibility, frequency)[1]
        if case.kind == "hydrostatic_pad":
            damping = damping[:1, :1]
        if float(np.linalg.eigvalsh(0.5 * (damping + damping.T)).min()) < 0.0:
            yield Notice("W323", f"a motion at {frequency / (2.0 * np.pi):.4g} Hz is not damped but fed")


def of_method(case: HydrostaticCase) -> Iterator[Notice]:
    """Limits of closed forms, and journals with too few recesses."""
    shape = case.shape
    if isinstance(shape, RecessedJournal) and shape.count < 3:
        yield Notice("W316", f"{shape.count} recess{'es' * (shape.count > 1)} cannot carry in every direction")
    if case.method == "quick" and isinstance(shape, RectangularPad):
        along, aside = shape.lands
        if abs(along - aside) > 1e-6 * along:
            yield Notice("W317", f"lands of {1e3 * along:.4g} and {1e3 * aside:.4g} mm by strips without corners")
        elif min(shape.recess_length, shape.recess_width) < 2.0 * along:
            least = min(shape.recess_length, shape.recess_width) / along
            yield Notice("W318", f"the shorter recess side is {least:.3g} land widths, less than 2")
    if case.method == "quick" and isinstance(shape, RecessedJournal | ThrustRing):
        yield Notice("W319", "lands lumped between recesses; damping without squeeze between them")
