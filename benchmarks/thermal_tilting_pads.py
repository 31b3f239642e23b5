"""Random tilting-pad bearings with their own temperatures: every one ends, and those with rigid bores are solved.

    python benchmarks/thermal_tilting_pads.py [number [seed]]

The bearings of `robustness/thermal_pads.py`, insulated walls, a journal of one temperature, and conducting pads
that bend and grow by turns; 4 x 48. Marks: rigid bores are solved or have a pad at its limit, growth leaves a film
or the share of it is told that does, or, of 1 % at most, does not converge; heat closes within 0.1 %; none takes
longer than 1 s of processor time (other work on the machine does not count).
"""

import statistics
import sys
import time
from collections import Counter
from pathlib import Path

import numpy as np

from babbitt.core.result import Outcome
from babbitt.reynolds.tilting_pads.thermal_pad_solution import ThermalTiltingPadSolution
from babbitt.reynolds.tilting_pads.thermal_pads import find_thermal_tilting_pads

sys.path.insert(0, str(Path(__file__).parent / "robustness"))
from thermal_pads import random_pads

NUMBER, SLOWEST, UNCLOSED, WITHOUT_END = 150, 1.0, 1e-3, 0.01
MODELS = "ABE"


def is_end(found: ThermalTiltingPadSolution) -> bool:
    """Whether a search ended as it may."""
    if found.outcome is Outcome.NO_CLEARANCE:
        return found.heat.growth is not None and found.growth_share < 1.0
    return found.outcome in (Outcome.CONVERGED, Outcome.PAD_AT_LIMIT)


def main() -> int:
    number = int(sys.argv[1]) if len(sys.argv) > 1 else NUMBER
    rng = np.random.default_rng(int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    find_thermal_tilting_pads(*random_pads(np.random.default_rng(0), "E"))
    ends: Counter[tuple[str, str]] = Counter()
    passes, times, errors, bad = [], [], [], 0
    for trial in range(number):
        model = MODELS[trial % len(MODELS)]
        drawn = random_pads(rng, model)
        begun = time.process_time()
        found = find_thermal_tilting_pads(*drawn)
        times.append(time.process_time() - begun)
        ends[model, found.outcome.name] += 1
        passes.append(found.passes)
        errors.append(abs(found.energy_balance_error))
        if not is_end(found) or errors[-1] > UNCLOSED:
            bad += 1
            print(f"trial {trial}, model {model}: {found.outcome.name}, heat {found.energy_balance_error:.1e}")
    for (model, outcome), count in sorted(ends.items()):
        print(f"model {model}: {count} {outcome}")
    print(f"passes: median {statistics.median(passes)}, most {max(passes)}")
    print(f"heat: median error {statistics.median(errors):.1e}, largest {max(errors):.1e}")
    print(f"time: median {1e3 * statistics.median(times):.1f} ms, slowest {1e3 * max(times):.0f} ms")
    return 0 if bad <= WITHOUT_END * number and max(times) < SLOWEST else 1


if __name__ == "__main__":
    sys.exit(main())
