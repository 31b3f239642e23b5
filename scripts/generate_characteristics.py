"""Compute the tables of bearing characteristics that ship with Babbitt.

Run from the repository root::

    python scripts/generate_characteristics.py

Solves Reynolds' equation for every span, B/D and eccentricity below (about 7000 films, a few minutes on two
cores) and writes ``src/babbitt/kinds/journal/iso7902/characteristics/tables.npz``. The file depends on this script
and the solver alone: no date, no host, values rounded to eight significant digits, so that a second run gives the
same bytes.
"""

from __future__ import annotations

import argparse
import math
import multiprocessing
import os
import sys
import time
from pathlib import Path

# One thread per worker: the banded systems are too small to share. Must be set before numpy is imported.
os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"

import numpy as np

from babbitt.kinds.journal.iso7902.characteristics.tables import SPANS_DEGREES, TABLE_FILE
from babbitt.validation.research.arc_film import DEFAULT_CELLS, solve_arc

SOURCE = Path(__file__).parents[1] / "src" / "babbitt"
TARGET = SOURCE / "kinds" / "journal" / "iso7902" / "characteristics" / TABLE_FILE
FORMAT_VERSION = 1
SIGNIFICANT_DIGITS = 8

# Even steps of 0.025 in the middle; towards both ends about even in ln(eps/(1 - eps)).
ECCENTRICITY_RATIOS = np.round(
    np.concatenate(
        [
            [0.01, 0.015, 0.02, 0.03, 0.04, 0.05, 0.0625, 0.075, 0.0875],
            np.arange(0.1, 0.901, 0.025),
            [
                0.91,
                0.92,
                0.93,
                0.94,
                0.95,
                0.955,
                0.96,
                0.965,
                0.97,
                0.975,
                0.9775,
                0.98,
                0.9825,
                0.985,
                0.9875,
                0.99,
            ],
        ]
    ),
    6,
)
WIDTH_RATIOS = np.round(
    np.concatenate(
        [
            [0.1, 0.11, 0.125, 0.14, 0.16, 0.18],
            np.arange(0.2, 0.601, 0.025),
            np.arange(0.65, 1.01, 0.05),
            [1.1, 1.2, 1.3, 1.4, 1.5],
        ]
    ),
    6,
)
QUANTITIES = ("sommerfeld_number", "attitude_angle", "side_flow_number", "pressure_ratio")


def column(task: tuple[int, float]) -> np.ndarray:
    """All eccentricities of one span and one B/D, shape (len(QUANTITIES), len(ECCENTRICITY_RATIOS))."""
    span_degrees, width_ratio = task
    values = np.empty((len(QUANTITIES), len(ECCENTRICITY_RATIOS)))
    guess = None
    for index, eccentricity_ratio in enumerate(ECCENTRICITY_RATIOS):
        film = solve_arc(math.radians(span_degrees), width_ratio, float(eccentricity_ratio), attitude_guess=guess)
        values[:, index] = [getattr(film, name) for name in QUANTITIES]
        guess = film.attitude_angle
    return values


def rounded(values: np.ndarray) -> np.ndarray:
    """Values to `SIGNIFICANT_DIGITS`, so that the last bits of another processor do not show in the file."""
    texts = [f"{value:.{SIGNIFICANT_DIGITS - 1}e}" for value in values.flat]
    return np.array(texts, dtype=float).reshape(values.shape)


def generate(workers: int) -> dict[str, np.ndarray]:
    """Compute every node and return the arrays of the file."""
    tasks = [(span, float(x)) for span in SPANS_DEGREES for x in WIDTH_RATIOS]
    start = time.perf_counter()
    columns = []
    with multiprocessing.get_context("spawn").Pool(workers) as pool:
        for done, values in enumerate(pool.imap(column, tasks), start=1):
            columns.append(values)
            elapsed = time.perf_counter() - start
            left = elapsed / done * (len(tasks) - done)
            print(f"\r{done}/{len(tasks)} columns, {elapsed:.0f} s, {left:.0f} s left ", end="", file=sys.stderr)
    print(file=sys.stderr)
    # (span, B/D, quantity, eps) to one array (span, eps, B/D) per quantity
    grid = np.stack(columns).reshape(len(SPANS_DEGREES), len(WIDTH_RATIOS), len(QUANTITIES), -1)
    arrays = {name: rounded(grid[:, :, index].swapaxes(1, 2)) for index, name in enumerate(QUANTITIES)}
    return {
        "format_version": np.array(FORMAT_VERSION),
        "description": np.array(
            "Circular bearing arcs, load through the arc centre: So, attitude angle [rad], Q3*, p_max/p over "
            "(span, eccentricity ratio, width ratio). Reynolds' equation, Reynolds rupture, finite volumes, "
            "extrapolated from the grids (n, m) and (2 n, 2 m). Made by scripts/generate_characteristics.py."
        ),
        "coarse_cells": np.array(DEFAULT_CELLS),
        "span_degrees": np.array(SPANS_DEGREES),
        "eccentricity_ratio": ECCENTRICITY_RATIOS,
        "width_ratio": WIDTH_RATIOS,
        **arrays,
    }


def main() -> None:
    """Read the options, compute, write."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--workers", type=int, default=2, help="processes (default 2)")
    parser.add_argument("--output", type=Path, default=TARGET, help=f"file to write (default {TARGET})")
    options = parser.parse_args()
    arrays = generate(options.workers)
    np.savez_compressed(options.output, allow_pickle=False, **arrays)
    print(f"{options.output}: {options.output.stat().st_size / 1e3:.0f} kB", file=sys.stderr)


if __name__ == "__main__":
    main()
