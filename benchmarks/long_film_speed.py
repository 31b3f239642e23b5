"""Speed of the films of one dimension.

Run ``python benchmarks/long_film_speed.py`` on a quiet machine. Medians and minima, warm, one thread. Target: the
long film under 2 ms.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import babbitt
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.grooved_long_bearing.solve import film_under_load as segments_under_load
from babbitt.kinds.journal.infinitely_long_bearing.check import long_film_check
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.infinitely_long_bearing.solve import film_at_eccentricity, film_under_load

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
REPEATS = 200


def milliseconds(work: Callable[[], object]) -> tuple[float, float]:
    """Median and minimum time of one call, after one call to warm up."""
    work()
    times = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        work()
        times.append(1e3 * (time.perf_counter() - start))
    return statistics.median(times), min(times)


def main() -> None:
    """Print measured figures beside their target."""
    (long_film,) = babbitt.load_case(EXAMPLES / "long_film.yaml").problems()
    (grooved,) = babbitt.load_case(EXAMPLES / "grooved.yaml").problems()
    assert isinstance(long_film, LongFilmCase)
    assert isinstance(grooved, SegmentCase)
    film, load = long_film.film, 25e3
    journal_only = replace(film, exchange=type(film.exchange)())
    measured = (
        ("long film, journal only, ε given", lambda: film_at_eccentricity(journal_only, 0.65)),
        ("long film, journal only, load given", lambda: film_under_load(journal_only, load)),
        ("long film, bush and shaft, load given", lambda: film_under_load(film, load)),
        ("long film, whole design check", lambda: long_film_check(long_film)),
        ("segments with groove, load given", lambda: segments_under_load(grooved.film, 45.5e3)),
    )
    for name, work in measured:
        median, least = milliseconds(work)
        target = "target 2 ms" if name.startswith("long") else ""
        print(f"{name:40s} median {median:7.3f} ms   minimum {least:7.3f} ms   {target}")


if __name__ == "__main__":
    main()
