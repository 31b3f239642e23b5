"""Whether rotors whirl that Orlov's screening of the ISO 7902 check (C112) lets pass.

    python benchmarks/whirl_screening.py [number [seed]]

Random bearings of `one_temperature.py`, each with its load as the mass of a rigid rotor: those that keep the
screening are computed as films of one temperature with the critical mass (C115). Lists those that whirl, with
the margin of the screening.
"""

import sys
from collections import Counter

import numpy as np
from one_temperature import bearing

from babbitt import parse_case
from babbitt.solving import solve

GRAVITY = 9.80665


def main(wanted: int = 200, seed: int = 5) -> None:
    rng, number, kept, ends = np.random.default_rng(seed), 0, 0, Counter()
    while kept < wanted:
        number += 1
        text = bearing(rng, number)
        (iso,) = solve(parse_case(text)).results
        screening = next((one for one in iso.checks if one.code == "C112"), None)
        if screening is None or not screening.ok:
            continue
        kept += 1
        mass = f"rotor_mass: {iso.load / GRAVITY:.3f} kg"
        (film,) = solve(parse_case(f"{text}method: film\nthermal: global\n{mass}\n")).results
        if not film.outcome.solved:
            ends[film.outcome.value] += 1
            continue
        whirl = next((one for one in film.checks if one.code == "C115"), None)
        ends["no critical mass" if whirl is None else "stable" if whirl.ok else "whirls"] += 1
        if whirl is not None and not whirl.ok:
            kept_by = f"C112 kept by {screening.margin:.1%}, eps {iso.eccentricity_ratio:.2f}"
            print(f"{number}: {kept_by}, C115 {whirl.margin:.0%}")
    print(f"{kept} kept the screening: {dict(ends)}")


if __name__ == "__main__":
    main(*(int(one) for one in sys.argv[1:3]))
