"""Axial operators in the form the kernels take them."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from babbitt.reynolds._structs import Axial
from babbitt.reynolds.lands.axial import even_axial_operator

__all__ = ["kernel_operator"]


UNROLLED = 4  # the size for which kernels are compiled with loops unrolled; all others share one compilation


@lru_cache(maxsize=32)
def kernel_operator(unknowns: int) -> Axial:
    """Even GLL operator with ``unknowns`` nodes per line, in the symmetric variable u = sqrt(w) p."""
    operator = even_axial_operator(unknowns)
    root = np.sqrt(operator.weights[:-1])
    stiffness = np.ascontiguousarray(operator.stiffness[:-1, :-1] / np.outer(root, root))
    modes = np.ascontiguousarray(operator.modes)
    return Axial(
        size=(0,) * unknowns if unknowns == UNROLLED else np.zeros(unknowns, dtype=np.int64),
        root_weights=root,
        stiffness=stiffness,
        load=stiffness @ root,
        eigenvalues=operator.eigenvalues,
        modes=modes,
        modes_transposed=np.ascontiguousarray(modes.T),
        mode_weights=modes.T @ root,
        edge_weight=float(operator.weights[-1]),
        edge_stiffness=operator.stiffness[-1].copy(),
    )
