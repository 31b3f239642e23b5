"""The films of the pads of a solved tilting-pad bearing, as arrays."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from babbitt.core.solution import Solution
from babbitt.reynolds.tilting_pads.pad_lands import pad_gaps

if TYPE_CHECKING:
    from babbitt.kinds.tilting_pad_journal.check import PadSolutionState
    from babbitt.kinds.tilting_pad_journal.model import PadCase
    from babbitt.reynolds.tilting_pads.thermal_pad_solution import ThermalTiltingPadSolution

__all__ = ["SolvedPadFilms"]

Array = NDArray[np.float64]


class SolvedPadFilms:
    """Fields of the films of all pads: read-only arrays in SI, the first axis over the pads.

    Lines run from the leading to the trailing edge of a pad, places from the mid-plane to its side; the grid is
    that of ``result.fields``. A pad without load stands concentric with its bore.

    Parameters
    ----------
    solution : Solution
        Of a tilting-pad journal bearing, with its state.
    """

    def __init__(self, solution: Solution) -> None:
        self._state: PadSolutionState = solution.state
        self._case: PadCase = solution.problem
        self._films = self._state.films.solution

    @property
    def position(self) -> Array:
        """Journal centre from the bearing centre, m, shape (2,)."""
        return _read_only(self._films.position)

    @property
    def angle(self) -> Array:
        """Angles of the lines from +x, counter-clockwise, rad, shape (pads, n)."""
        return _read_only([pad.angles for pad in self._films.pads])

    @property
    def z(self) -> Array:
        """Places along the shaft from the mid-plane, m, shape (pads, k)."""
        return _read_only([pad.axial_positions for pad in self._films.pads])

    @property
    def pressure(self) -> Array:
        """Gauge pressure, Pa, shape (pads, n, k)."""
        return _read_only([pad.pressure for pad in self._films.pads])

    @property
    def liquid_fraction(self) -> Array:
        """Share of the gap that is filled with oil, shape (pads, n, k)."""
        return _read_only([1.0 - pad.void for pad in self._films.pads])

    @cached_property
    def film_thickness(self) -> Array:
        """Film thickness, m, shape (pads, n): the same over the width."""
        return _read_only(pad_gaps(self._films))

    @property
    def gap(self) -> Array:
        """Gap between journal and bores, m, shape (pads, n): that of the film, for pads have no pockets."""
        return self.film_thickness

    @property
    def temperature(self) -> Array:
        """Temperature of the oil, mean across the gap and over the width, K, shape (pads, n).

        Raises
        ------
        AttributeError
            For films of one temperature, which is ``result.effective_temperature``.
        """
        return _read_only([heat.film_mean for heat in self._thermal.temperatures])

    @property
    def bore_temperature(self) -> Array:
        """Temperature of the bores of the pads, K, shape (pads, n); errors as `temperature`."""
        return _read_only([heat.bore for heat in self._thermal.temperatures])

    @property
    def _thermal(self) -> ThermalTiltingPadSolution:
        found = self._state.films.thermal
        if found is None:
            raise AttributeError(
                f"{self._case.name}: the films have one temperature, result.effective_temperature; films with "
                "their own temperatures are solved with thermal: adiabatic or full"
            )
        return found

    def __dir__(self) -> list[str]:
        return [one for one in super().__dir__() if not one.startswith("_")]

    def __repr__(self) -> str:
        pads, n, k = self.pressure.shape
        own = ", temperature, bore_temperature" if self._state.films.thermal is not None else ""
        return (
            f"films of {self._case.name}: {pads} pads, each {n} angles x {k} places along the shaft\n"
            f"  angle, z, pressure, film_thickness, gap, liquid_fraction{own}"
        )


def _read_only(values: object) -> Array:
    array = np.array(values, dtype=np.float64)
    array.setflags(write=False)
    return array
