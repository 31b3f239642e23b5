"""Random films, isothermal and with temperatures of their own, asked what every film must answer.

    python benchmarks/robustness/films.py [number [seed]]

Load carried, no liquid fraction outside 0 to 1, oil and torque in balance, no oil colder than all that cools it, a
heat balance that closes, and at the position found the same film as under the load. The bearings are those of
`benchmarks/film_robustness.py`, as they are and with one of `OPTIONS` each, and of
`benchmarks/thermal_robustness.py`, as they are or with one of `THERMAL_OPTIONS`.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parents[1]))

import film_robustness
import thermal_robustness

from babbitt.kinds.journal.film.isothermal import FilmState
from babbitt.kinds.journal.film.layout import load_vector
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.thermal_film import film_heat, thermal_operating_film, thermal_resolution
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.heat.thermal_equilibrium import thermal_film_at
from babbitt.reynolds.model import Cavitation, JournalFilm, Resolution, Step
from babbitt.reynolds.oil.piezoviscosity import Barus
from babbitt.reynolds.oil.turbulence import CONSTANTINESCU, NG_PAN, FilmTurbulence
from babbitt.reynolds.solution import FilmSolution

__all__ = [
    "OPTIONS", "THERMAL_OPTIONS", "film_faults", "option_film", "option_film_faults", "option_films_faults",
    "thermal_film_faults",
]  # fmt: skip

Rng = np.random.Generator

CARRIED = 1e-4
"""Residual force over load."""
BALANCED = 1e-7
"""Mass balance error, and net flow over all that leaves; films under the Reynolds condition keep none."""
GOES_AROUND = 1e-10
"""Net flow over the oil that goes around: of a journal near the centre hardly any of it leaves."""
CLOSED = 1e-4
"""Error of the heat balance over the dissipation."""
SAME = 1e-2
"""Difference of forces over the load at the position found: lines are laid for another place."""
LIGHT, SHIFTED = 0.01, 5e-3
"""Load over stiffness times smallest gap of a film that carries next to no load, and over that gap the way of the
journal that makes up for a greater difference of forces there: what lines decide about the place of a journal in a
starved film, which is stiff all the same, is per cents of such a load. So of lands that begin with less oil
than they could take, whatever the load: where such a film fills lies between two lines, so that its force comes
with the first order of the interval."""
FINE = Resolution(4, 384)
"""Grid that decides where the usual one has another force at the position: near contact that is its error."""
ABOUT_THE_CENTRE = ("axial viscosity", "hole", "pockets")
"""Kinds whose bore is round and fed all over the width or in its middle: the pressure turns it by F e sin beta."""


def turbulent(rng: Rng, film: JournalFilm) -> JournalFilm:
    """Either law; the film may be laminar, turbulent or between."""
    onset, end = np.sort(rng.uniform(50.0, 2000.0, 2))
    law = (NG_PAN, CONSTANTINESCU)[rng.integers(2)]
    return replace(film, turbulence=FilmTurbulence(law, 870.0, float(onset), float(end)))


def piezoviscous(rng: Rng, film: JournalFilm) -> JournalFilm:
    """Viscosity that grows with the pressure as of common oils."""
    return replace(film, pressure_viscosity=Barus(rng.uniform(5e-9, 2.5e-8)))


def below_ambient(rng: Rng, film: JournalFilm) -> JournalFilm:
    """Cavities below ambient pressure."""
    return replace(film, cavitation_pressure=-rng.uniform(1e4, 9e4))


def one_side_under_pressure(rng: Rng, film: JournalFilm) -> JournalFilm:
    """Up to half a bar at one side."""
    return replace(film, side_pressures=(0.0, rng.uniform(0.0, 5e4)))


def starved(rng: Rng, film: JournalFilm) -> JournalFilm:
    """Lands that begin with less oil than they could take."""
    fill = rng.uniform(0.3, 0.95)
    lands = (replace(land, start_pressure=0.0, end_pressure=0.0, start_fill=fill) for land in film.lands)
    return replace(film, cavitation=Cavitation.MASS_CONSERVING, lands=tuple(lands))


def crowned(rng: Rng, film: JournalFilm) -> JournalFilm:
    """Up to a fifth of the clearance at the sides."""
    side = rng.uniform(0.0, 0.2) * film.clearance
    return replace(film, crowning=(side, 0.0, side))


def stepped(rng: Rng, film: JournalFilm) -> JournalFilm:
    """A shallow pocket anywhere."""
    deep = rng.uniform(0.2, 1.0) * film.clearance
    return replace(film, steps=(Step(rng.uniform(-math.pi, math.pi), 0.6, 0.4 * film.width, deep),))


def displaced(rng: Rng, film: JournalFilm) -> JournalFilm:
    """A bore that is uneven by up to a tenth of the clearance."""
    rough = 0.1 * film.clearance * rng.uniform(-1.0, 1.0, 24)
    bore = 0.5 * (rough + np.roll(rough, 1))
    return replace(film, displacement=tuple((float(value),) * 5 for value in bore))


OPTIONS: dict[str, Callable[[Rng, JournalFilm], JournalFilm]] = {
    "turbulent": turbulent, "piezoviscous": piezoviscous, "below ambient": below_ambient,
    "side": one_side_under_pressure, "starved": starved, "crowned": crowned, "stepped": stepped,
    "displaced": displaced,
}  # fmt: skip
NOT_ROUND = ("stepped", "displaced")
"""Options in which the pressure turns the bore also about its centre."""


THERMAL_OPTIONS = {
    "": "", "ng_pan": "turbulence: ng_pan", "constantinescu": "turbulence: constantinescu",
    "below ambient": "cavitation_pressure: -50 kPa", "side": "side_pressures: [0 bar, 0.3 bar]",
    "displaced": "bore: {kind: measured, departures: [1 um, 0 um, -1 um, 0.5 um, 0 um, 0.7 um, -0.3 um, 0 um]}",
}  # fmt: skip
"""Lines of a case of a film with temperatures of its own; one bore for those that have none yet."""
THERMAL_ABOUT_THE_CENTRE = ("two grooves", "one groove", "hole", "pockets")
THERMAL_TURNED = 1e-4
"""Torque that stays open, over that of the friction: cavities are sheared by the void of the pass before."""
THICK_ENOUGH, THERMAL_SAME, THERMAL_SHIFTED = 0.02, 0.05, 0.01
"""Gap over clearance from which a thermal film is asked for the same force at its position, within this share of
the load or, under a light load, this way of the journal over its gap. The search has lines for where the journal
came from, a film at a position those for that position: of 800 films their forces differ by 0.036 of the load or
move the journal by 0.005 of the gap, nearer to contact by 0.08, all of it errors of the grid."""


def film_faults(seed: int, number: int) -> Iterator[str]:
    """What is wrong with random films of one temperature; those without solution are left to their benchmark."""
    rng = np.random.default_rng(seed)
    kinds = list(film_robustness.KINDS)
    for index in range(number):
        kind = kinds[index % len(kinds)]
        film, load = film_robustness.random_case(rng, kind)
        found = solve_journal(film, load)
        if found.outcome.solved:
            told = [*_of_film(found), *_of_forces(kind, film, load, found)]
            yield from (f"film {seed}/{index}, {kind}: {one}" for one in told)


def option_film(seed: int, index: int) -> tuple[str, str, JournalFilm, tuple[float, float]]:
    """Kind and option, film and load of a random film with one of `OPTIONS`."""
    rng, kinds, options = np.random.default_rng((seed, index)), list(film_robustness.KINDS), list(OPTIONS)
    kind, option = kinds[index % len(kinds)], options[index // len(kinds) % len(options)]
    film, load = film_robustness.random_case(rng, kind)
    return kind, option, OPTIONS[option](rng, film), load


def option_films_faults(seed: int, number: int) -> Iterator[str]:
    """What is wrong with random films of one temperature with an option each."""
    for index in range(number):
        yield from option_film_faults(seed, index)


def option_film_faults(seed: int, index: int) -> Iterator[str]:
    """What is wrong with a random film with one of `OPTIONS`."""
    kind, option, film, load = option_film(seed, index)
    found = solve_journal(film, load)
    if found.outcome.solved:
        shape = option if option in NOT_ROUND else kind
        told = [*_of_film(found), *_of_forces(shape, film, load, found)]
        if not (np.isfinite(found.stiffness).all() and np.isfinite(found.damping).all()):
            told.append("stiffness or damping without a number")
        yield from (f"film {seed}/{index}, {kind}, {option}: {one}" for one in told)


def thermal_film_faults(seed: int, number: int) -> Iterator[str]:
    """What is wrong with random films with temperatures of their own."""
    rng = np.random.default_rng(seed)
    kinds = list(thermal_robustness.KINDS)
    for index in range(number):
        kind = kinds[index % len(kinds)]
        option = list(THERMAL_OPTIONS)[index // len(kinds) % len(THERMAL_OPTIONS)]
        option = "" if (kind, option) == ("lobes", "displaced") else option
        text = thermal_robustness.random_text(rng, kind, index)
        case = thermal_robustness.design(f"{text}{THERMAL_OPTIONS[option]}\n")
        found = thermal_operating_film(case)
        if found.outcome.solved and found.film is not None and found.film.thermal is not None:
            told = [*_of_film(found.film.thermal.film), *_of_heat(case, found.film)]
            told += _of_thermal_forces(option if option in NOT_ROUND else kind, case, found.film)
            yield from (f"thermal film {seed}/{index}, {kind}, {option}: {one}" for one in told)


def _of_heat(case: FilmCase, state: FilmState) -> Iterator[str]:
    thermal = state.thermal
    assert thermal is not None
    assert case.heat is not None
    assert case.oil_supply is not None
    walls, coldest = case.heat.walls, case.oil_supply.temperature
    if walls is not None:
        coldest = min(coldest, walls.bush.ambient_temperature)
    if float(thermal.temperature.min()) < coldest - 0.05:
        yield f"oil of {float(thermal.temperature.min()):.2f} K, nothing below {coldest:.2f} K"
    if thermal.heat.balance_error > CLOSED:
        yield f"heat balance open by {thermal.heat.balance_error:.1e}"


def _of_thermal_forces(kind: str, case: FilmCase, state: FilmState) -> Iterator[str]:
    assert state.thermal is not None
    found, load = state.thermal.film, load_vector(case, case.duty.load)
    size = math.hypot(*load)
    yield from _of_load(found, load)
    if kind in THERMAL_ABOUT_THE_CENTRE and abs(_torque_left(found)) > THERMAL_TURNED:
        yield f"torque open by {_torque_left(found):.1e}"
    if found.minimum_film_thickness < THICK_ENOUGH * found.film.clearance:
        return
    heat = film_heat(case, state.volumetric_heat_capacity, state.temperature)
    x, y = found.position
    again = thermal_film_at(found.film, heat, (float(x), float(y)), thermal_resolution(case)).film
    if not again.outcome.solved:
        yield f"at its position {again.outcome.name}"
        return
    more = again.force - found.force
    shifted = math.hypot(*np.linalg.solve(found.stiffness, more)) / found.minimum_film_thickness
    if math.hypot(*more) > THERMAL_SAME * size and shifted > THERMAL_SHIFTED:
        yield f"at its position another force by {math.hypot(*more) / size:.1e}"


def _of_load(found: FilmSolution, load: tuple[float, float]) -> Iterator[str]:
    missed = math.hypot(*(found.force + load)) / math.hypot(*load)
    if missed > CARRIED:
        yield f"load missed by {missed:.1e}"


def _torque_left(found: FilmSolution) -> float:
    """Torque on journal and bore about its centre that nothing balances, over that of the friction."""
    (x, y), (fx, fy) = found.position, found.force
    turning = math.copysign(1.0, found.film.angular_speed) * (x * fy - y * fx)
    return float((found.friction_torque - found.bearing_torque - turning) / found.friction_torque)


def _of_film(found: FilmSolution) -> Iterator[str]:
    if found.void.min() < -1e-12 or found.void.max() > 1.0 + 1e-12:
        yield f"void from {found.void.min():.3g} to {found.void.max():.3g}"
    if found.film.cavitation is not Cavitation.MASS_CONSERVING:
        return
    if found.mass_balance_error > BALANCED:
        yield f"mass balance error {found.mass_balance_error:.1e}"
    net = found.supply_flow.sum() - found.side_flow.sum()
    if abs(net) > BALANCED * found.leaving_flow + GOES_AROUND * abs(found.inflow).sum():
        yield f"net flow {net / found.leaving_flow:.1e}"


def _of_forces(kind: str, film: JournalFilm, load: tuple[float, float], found: FilmSolution) -> Iterator[str]:
    size = math.hypot(*load)
    yield from _of_load(found, load)
    if kind in ABOUT_THE_CENTRE and abs(_torque_left(found)) > 1e-5:
        yield f"torque open by {_torque_left(found):.1e}"
    x, y = found.position
    again = film_at_position(film, (float(x), float(y)))
    if again.outcome.solved and math.hypot(*(again.force - found.force)) > SAME * size:
        again = film_at_position(film, (float(x), float(y)), resolution=FINE)
    if not again.outcome.solved:
        yield f"at its position {again.outcome.name}"
        return
    more, gap = again.force - found.force, found.minimum_film_thickness
    light = size < LIGHT * gap * float(np.linalg.norm(found.stiffness))
    fills_late = film.is_starved
    moved = (light or fills_late) and math.hypot(*np.linalg.solve(found.stiffness, more)) <= SHIFTED * gap
    if math.hypot(*more) > SAME * size and not moved:
        yield f"at its position another force by {math.hypot(*more) / size:.1e}"


def main() -> int:
    """Print all faults."""
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 5000
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    ways = (film_faults, option_films_faults, thermal_film_faults)
    faults = [one for faults_of in ways for one in faults_of(seed, number)]
    print("\n".join(faults))
    print(f"{len(faults)} faults in {len(ways)} times {number} films")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
