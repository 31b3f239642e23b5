"""What a supply delivers: the estimate of the ISO 7902 check set against films that conserve their oil.

    python benchmarks/supply_capacity.py [number [seed [holes or grooves [global or adiabatic]]]]

Random bearings, half of them fed by holes and half by pockets, or by grooves all around and half grooves, of
which as many are computed as needed for `number` with a supply capacity below the side flow Q3 of the standard:
pockets of 10 to 90 deg (to 60 deg at both sides), diameters 40 to 400 mm, B/D 0.4 to 1, 0.3 to 3 MPa, 3 to 40
m/s, clearances 0.9 to 1.6 times that of Vogelpohl's rule, oils ISO VG 32 to 100 at 40 to 50 degC and 0.5 to 3
bar. Each is computed by the standard with all the oil that its film wants, by the standard with the flow limited
to the supply capacity, and by `method: film` with one temperature (`thermal: global`) or with its own
(`adiabatic`, if not given). One line a bearing, and the quartiles of the ratios.
"""

import math
import sys

import numpy as np

from babbitt import parse_case
from babbitt.kinds.journal.case.build import film_cases, iso7902_cases
from babbitt.kinds.journal.film.check import film_check
from babbitt.kinds.journal.iso7902 import check

GRADES = (32, 46, 68, 100)
Random = np.random.Generator


def hole(rng: Random, width: float) -> str:
    place = rng.choice(["opposite", "side", "both_sides"])
    return f"{{kind: hole, diameter: {rng.uniform(0.05, 0.3) * width * 1e3:.2f} mm, place: {place}}}"


def pocket(rng: Random, width: float) -> str:
    place = rng.choice(["opposite", "side", "both_sides"])
    extent = rng.uniform(10.0, 60.0 if place == "both_sides" else 90.0)
    wide = rng.uniform(0.2, 0.7) * width * 1e3
    return f"{{kind: pocket, width: {wide:.2f} mm, place: {place}, extent: {extent:.0f} deg}}"


def groove_360(rng: Random, width: float) -> str:
    return f"{{kind: groove_360, width: {rng.uniform(0.05, 0.2) * width * 1e3:.2f} mm}}"


def groove_180(rng: Random, width: float) -> str:
    return f"{{kind: groove_180, width: {rng.uniform(0.05, 0.2) * width * 1e3:.2f} mm}}"


ELEMENTS = {"holes": (hole, pocket), "grooves": (groove_360, groove_180)}


def bearing(rng: Random, number: int, fed: str) -> str:
    diameter = math.exp(rng.uniform(math.log(0.04), math.log(0.4)))
    width, speed = rng.uniform(0.4, 1.0) * diameter, math.exp(rng.uniform(math.log(3.0), math.log(40.0)))
    pressure = math.exp(rng.uniform(math.log(0.3e6), math.log(3e6)))
    clearance = rng.uniform(0.9, 1.6) * 0.8e-3 * speed**0.25
    element = ELEMENTS[fed][number % 2](rng, width)
    span = 180 if "groove_180" in element else 360
    return f"""
kind: journal
name: bearing {number}
diameter: {diameter * 1e3:.3f} mm
width: {width * 1e3:.3f} mm
clearance: {{kind: relative, mean: {clearance * 1e3:.4f} permille}}
span: {span} deg
supply_element: {element}
lubricant: ISO VG {rng.choice(GRADES)}
supply: {{temperature: {rng.uniform(40, 50):.1f} degC, pressure: {rng.uniform(0.05, 0.3):.3f} MPa}}
materials: {{bearing: C45, journal: C45}}
specific_load: {pressure / 1e6:.4f} MPa
surface_speed: {speed:.3f} m/s
"""


def main(wanted: int = 30, seed: int = 15, fed: str = "holes", thermal: str = "adiabatic") -> None:
    rng, number, rows = np.random.default_rng(seed), 0, []
    flow, heat, gap = "Q3   Q_cap  Q_st  Q_film  L/min", "T_ex   T_st  T_film", "h_min h_st h_film um"
    print(f"             element              {flow} |  {heat} |  {gap}")
    while len(rows) < wanted and number < 20 * wanted:
        number += 1
        text = bearing(rng, number, fed)
        case = parse_case(text)
        iso = check(iso7902_cases(case, case)[0])
        if not iso.outcome.solved or iso.supply_capacity >= iso.side_flow:
            continue
        starved = iso.values.get("starved_outlet_temperature")
        film = film_check(film_cases(case, case, thermal)[0])
        if starved is None or not film.outcome.solved:
            said = "unsolved" if starved is None else "solved"
            print(f"bearing {number}: limited flow {said}, film {film.outcome.value}")
            continue
        element = case.supply_element
        flows = [iso.side_flow, iso.supply_capacity, iso.starved_total_flow, film.total_flow]
        hot = [iso.outlet_temperature, starved, film.outlet_temperature]
        thin = [iso.minimum_film_thickness, iso.starved_minimum_film_thickness, film.minimum_film_thickness]
        hottest = film.values.get("maximum_temperature", film.outlet_temperature)
        rows.append((*flows, *hot, *thin, hottest))
        print(
            f"{number:4d} {element.kind:10s} {getattr(element, 'place', ''):10s}",
            f"s = {element.axial_size / case.width:.2f}",
            *(f"{6e4 * flow:6.2f}" for flow in flows), "|",
            *(f"{one - 273.15:6.1f}" for one in hot), f"(T_max {hottest - 273.15:.1f}) |",
            *(f"{one * 1e6:6.1f}" for one in thin), flush=True,
        )  # fmt: skip
    table = np.array(rows)
    wants, delivers, limited, flows, hot, hotter, film_hot, thin, thinner, film_thin, hottest = table.T
    for said, ratio in (
        ("flow of the film over the supply capacity", flows / delivers),
        ("flow of the film over the limited flow", flows / limited),
        ("flow of the film over Q3", flows / wants),
        ("least film of the film method over that with all oil", film_thin / thin),
        ("least film of the film method over that with the limited flow", film_thin / thinner),
        ("K: outlet of the film less outlet with all oil", film_hot - hot),
        ("K: outlet of the film less outlet with the limited flow", film_hot - hotter),
        ("K: hottest film less outlet with all oil", hottest - hot),
        ("K: hottest film less outlet with the limited flow", hottest - hotter),
    ):
        least, quarter, middle, upper, most = np.percentile(ratio, (0, 25, 50, 75, 100))
        print(f"{said}: {least:.2f} to {most:.2f}, quartiles {quarter:.2f}, {middle:.2f}, {upper:.2f}")


if __name__ == "__main__":
    main(*(int(one) for one in sys.argv[1:3]), *sys.argv[3:])
