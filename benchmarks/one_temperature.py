"""How far one temperature flatters: ISO 7902 set against films with temperatures, walls and housing of their own.

    python benchmarks/one_temperature.py [number [seed]]

Random ordinary bearings: diameters 60 to 300 mm, B/D 0.5 to 1, 0.8 to 5 MPa, 2 to 35 m/s, clearances 1 to 1.5
times those of Vogelpohl's rule, spans of 360 to 120 deg, pockets at both sides of 0.5 to 0.7 of the width, oils
ISO VG 22 to 68 at 40 to 50 degC and 1 to 3 bar, tin and copper alloys. The film is `thermal: full`. Held against
each other are the thinnest film, and the hottest bush against the outlet, with the flow that the supply delivers
where that is less. One line a bearing; quartiles, ends and twentieths; verdicts by both.
"""

import math
import sys
from collections import Counter

import numpy as np

from babbitt import parse_case
from babbitt.core.result import Result
from babbitt.solving import solve

Random = np.random.Generator


def bearing(rng: Random, number: int) -> str:
    diameter = float(rng.choice([60, 80, 100, 120, 150, 200, 300]))
    width = rng.uniform(0.5, 1.0) * diameter
    speed = math.exp(rng.uniform(math.log(2.0), math.log(35.0)))
    clearance = rng.uniform(1.0, 1.5) * 0.8 * speed**0.25
    return f"""
kind: journal
name: bearing {number}
diameter: {diameter:g} mm
width: {width:.1f} mm
clearance: {{kind: relative, mean: {clearance:.3f} permille}}
span: {rng.choice([360, 180, 150, 120])} deg
supply_element: {{kind: pocket, width: {rng.uniform(0.5, 0.7) * width:.1f} mm, place: both_sides}}
lubricant: ISO VG {rng.choice([22, 32, 46, 68])}
supply: {{temperature: {rng.choice([40, 45, 50])} degC, pressure: {rng.choice([0.1, 0.2, 0.3])} MPa}}
materials: {{bearing_metal: {rng.choice(["SnSb8Cu4", "CuSn8P", "B83"])}, bearing: C10, journal: C45}}
specific_load: {rng.uniform(0.8, 5.0):.3f} MPa
surface_speed: {speed:.2f} m/s
"""


def worse(result: Result, name: str, better: float) -> float:
    """A value, or that with the flow which the supply delivers; `better` is 1 where more is better, else -1."""
    known = [result.values[one] for one in (name, f"starved_{name}") if one in result.values]
    return better * min(better * value for value in known)


def main(wanted: int = 48, seed: int = 3) -> None:
    rng, number, rows, verdicts = np.random.default_rng(seed), 0, [], Counter()
    while len(rows) < wanted and number < 10 * wanted:
        number += 1
        text = bearing(rng, number)
        (iso,) = solve(parse_case(text)).results
        (film, *_) = solve(parse_case(f"{text}method: film\nthermal: full\n")).results
        if not (iso.outcome.solved and film.outcome.solved):
            print(f"{number}: {iso.outcome.value}; {film.outcome.value}")
            continue
        thin = film.minimum_film_thickness / worse(iso, "minimum_film_thickness", 1.0)
        hot = film.maximum_bush_temperature - worse(iso, "outlet_temperature", -1.0)
        rows.append((thin, hot))
        near = "W191" in {notice.code for notice in iso.warnings}
        verdicts[(iso.verdict.value, "near" if near else "", film.verdict.value)] += 1
        print(
            f"{number:4d} h_film/h_iso {thin:.2f}, bush less outlet {hot:+.1f} K: "
            f"{iso.verdict.value}{' (W191)' if near else ''}, film {film.verdict.value}",
            flush=True,
        )
    for said, column in zip(("h_film/h_iso", "bush less outlet in K"), np.array(rows).T, strict=True):
        print(said, *(f"{value:.2f}" for value in np.percentile(column, (0, 5, 25, 50, 75, 95, 100))))
    for (iso_says, near, film_says), count in sorted(verdicts.items()):
        print(f"{count:3d}: ISO 7902 {iso_says} {near}, film {film_says}")


if __name__ == "__main__":
    main(*(int(one) for one in sys.argv[1:3]))
