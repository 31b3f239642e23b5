"""Which rows a study computes: products of values, joint samples, corners, differences, load cases."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.case.parts.study import StudyBlock
from babbitt.core.notices import InputError
from babbitt.study.inputs import Input
from babbitt.study.laws import Choices
from babbitt.study.sampling import sampled

__all__ = [
    "CORNER",
    "NOMINAL",
    "SAMPLE",
    "STEP",
    "Rows",
    "corners",
    "differences",
    "nominal",
    "planned",
    "product",
    "require_bearable",
    "samples_of",
    "stacked",
]

Values = dict[str, NDArray[Any]]

Rows = tuple[Values, NDArray[Any]]
"""Values of the inputs, and what each row is for."""

NOMINAL, SAMPLE, CORNER, GRID = "nominal", "sample", "corner", "grid"
"""What rows are for."""

TOLERANCE_SAMPLES, SENSITIVITY_SAMPLES = 1000, 256

MOST_CORNERS = 8
"""Inputs of which all corners are computed, 2^8."""

MOST_ROWS = 20_000_000

BYTES_A_CELL = 8

STEP = 0.02
"""Step of central differences to each side, of half the width of the distribution."""


def samples_of(block: StudyBlock) -> int:
    """Samples of a study, base samples of a sensitivity."""
    if block.samples is not None:
        return int(block.samples)
    return SENSITIVITY_SAMPLES if block.kind == "sensitivity" else TOLERANCE_SAMPLES


def planned(block: StudyBlock, inputs: Sequence[Input]) -> int:
    """Rows that a study will compute, without drawing any.

    Raises
    ------
    InputError
        E003 for a grid of what has no values.
    """
    match block.kind:
        case "sweep" | "map" | "corners" | "size":
            return int(np.prod([float(one.listed.size) for one in inputs]))
        case "tolerance":
            return 1 + samples_of(block) + _corner_count(inputs)
        case "sensitivity":
            return 1 + 2 * len(inputs) + samples_of(block) * (len(inputs) + 2)
        case "spectrum":
            return len(block.load_cases)
    return block.population * block.generations


def require_bearable(rows: float, columns: int) -> None:
    """Refuse a study that no machine holds.

    Raises
    ------
    InputError
        E003 with the size that it would take.
    """
    if rows > MOST_ROWS:
        size = rows * columns * BYTES_A_CELL
        says = f"the study has {rows:.4g} rows, about {size / 1e9:.4g} GB"
        raise InputError("E003", f"study: {says}; allowed: {MOST_ROWS} rows; take fewer samples or values")


def product(inputs: Sequence[Input]) -> Rows:
    """Every combination of the values, the last input varying fastest."""
    axes = [one.listed for one in inputs]
    meshes = np.meshgrid(*axes, indexing="ij")
    values = {one.path: mesh.ravel() for one, mesh in zip(inputs, meshes, strict=True)}
    return values, np.full(meshes[0].size, GRID, object)


def nominal(inputs: Sequence[Input]) -> Rows:
    """The medians of all inputs, of choices the first."""
    middle = np.array([0.5])
    values = {one.path: one.drawn(np.array([0.0]) if one.is_choice else middle) for one in inputs}
    return values, np.array([NOMINAL], object)


def joint_sample(inputs: Sequence[Input], block: StudyBlock) -> Rows:
    """A joint sample of the inputs."""
    count = samples_of(block)
    return sampled(inputs, count, block.sampling, block.seed), np.full(count, SAMPLE, object)


def corners(inputs: Sequence[Input]) -> Rows:
    """Every combination of smallest and largest values; of choices the first. Nothing for too many inputs."""
    count = _corner_count(inputs)
    numeric = [one for one in inputs if not one.is_choice]
    ends = [one.law.support for one in inputs if not isinstance(one.law, Choices)]
    combined = np.array(list(itertools.product(*ends))) if count else None
    values: Values = {}
    for one in inputs:
        if one in numeric:
            empty = np.empty(0)
            values[one.path] = empty if combined is None else combined[:, numeric.index(one)]
        else:
            values[one.path] = one.drawn(np.zeros(count))
    return values, np.full(count, CORNER, object)


def _corner_count(inputs: Sequence[Input]) -> int:
    numeric = sum(not one.is_choice for one in inputs)
    together = any(one.table for one in inputs)  # corners of a table would be no sample of it
    return 0 if together or not 0 < numeric <= MOST_CORNERS else 2**numeric


def differences(inputs: Sequence[Input]) -> Rows:
    """One step to each side of the median of every input, the others at theirs."""
    middle, _ = nominal(inputs)
    values = {path: np.repeat(value, 2 * len(inputs)) for path, value in middle.items()}
    groups = []
    for place, one in enumerate(inputs):
        step = step_of(one)
        values[one.path][2 * place] -= step
        values[one.path][2 * place + 1] += step
        groups += [f"less {one.path}", f"more {one.path}"]
    return values, np.array(groups, object)


def step_of(one: Input) -> float:
    """Step of the differences of an input, in its unit."""
    assert not isinstance(one.law, Choices), "choices have no slope"
    low, high = one.law.support
    return STEP * 0.5 * (high - low)


def stacked(blocks: Sequence[Rows]) -> Rows:
    """Rows of several blocks, one below the other."""
    values = {path: np.concatenate([block[0][path] for block in blocks]) for path in blocks[0][0]}
    return values, np.concatenate([block[1] for block in blocks])


def first_of(values: Mapping[str, NDArray[Any]]) -> dict[str, Any]:
    """The first row."""
    return {path: column[0] for path, column in values.items()}
