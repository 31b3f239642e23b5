"""The film of a solved bearing: its fields as arrays, and its force wherever the journal may be."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from babbitt.core.kind import find_kind
from babbitt.core.notices import InputError
from babbitt.core.solution import Solution
from babbitt.kinds.journal.film.field import FilmField, field_of, journal_gap
from babbitt.kinds.journal.film.isothermal import FilmState, resolution_of, under_found_load
from babbitt.kinds.journal.film.layout import closed_pockets
from babbitt.report.view import find_view
from babbitt.reynolds.model import Cavitation
from babbitt.reynolds.surface.unwrapped_mesh import GROOVE_GAP, bore_gap

if TYPE_CHECKING:
    from babbitt.api.pad_film import SolvedPadFilms
    from babbitt.kinds.journal.film.model import FilmCase
    from babbitt.reynolds.equilibrium.many_positions import FilmPositions, PositionForces
    from babbitt.reynolds.heat.frozen_positions import FrozenPositions

__all__ = ["Contact", "SolvedFilm", "film_of_solution", "require_state"]

Array = NDArray[np.float64]

Contact = Callable[[Array, Array, Array, Array], ArrayLike]
"""Force in N, shape (n, 2), at positions x and y in m outside the clearance, moving with velocities in m/s."""


class SolvedFilm:
    """A solved film: fields over the unrolled bore, and forces at other places of the journal.

    Arrays are read-only and in SI; the grid is that of ``result.fields``. Viscosity, displacements of the bore and
    what the supplies deliver stay as solved when `force` and `linearise` move the journal.

    Parameters
    ----------
    solution : Solution
        Of the method film, with its state.
    """

    def __init__(self, solution: Solution) -> None:
        self._solution = solution
        self._state: FilmState = solution.state
        self._case: FilmCase = under_found_load(solution.problem, self._state)

    @cached_property
    def _field(self) -> FilmField:
        return field_of(self._state.solution, self._case.load_angle - math.pi)

    @cached_property
    def _positions(self) -> FilmPositions | FrozenPositions:
        from babbitt.reynolds.equilibrium.many_positions import FilmPositions
        from babbitt.reynolds.heat.frozen_positions import FrozenPositions

        if self._state.thermal is not None and self._state.thermal.nodes is not None:
            return FrozenPositions(self._state.thermal.nodes)
        return FilmPositions(self._state.solution.film, resolution_of(self._case))

    @property
    def position(self) -> Array:
        """Journal centre from the bearing centre, m, shape (2,)."""
        return _read_only(self._state.solution.position)

    @property
    def angle(self) -> Array:
        """Angles around the bore from +x, counter-clockwise, rad, one turn from opposite the load, shape (n,)."""
        return _read_only(self._field.theta)

    @property
    def z(self) -> Array:
        """Places along the shaft from the mid-plane, m, shape (k,)."""
        return _read_only(self._field.z)

    @property
    def pressure(self) -> Array:
        """Gauge pressure, Pa, shape (n, k)."""
        return _read_only(self._field.pressure)

    @property
    def liquid_fraction(self) -> Array:
        """Share of the gap that is filled with oil, shape (n, k)."""
        return _read_only(self._field.liquid_fraction)

    @property
    def film_thickness(self) -> Array:
        """Film thickness, m, shape (n, k); not a number over grooves, pockets and holes."""
        return _read_only(self._field.film_thickness)

    @property
    def gap(self) -> Array:
        """Gap between journal and bore without its pockets, m, shape (n, k); not a number over axial grooves."""
        gap = journal_gap(self._state.solution, self._field.theta, self._field.z)
        gap[bore_gap(self._state.solution.film, self._field.theta) == GROOVE_GAP] = np.nan
        return _read_only(gap)

    @property
    def temperature(self) -> Array:
        """Temperature of the oil, mean across the gap, K, shape (n, k).

        Raises
        ------
        AttributeError
            For a film of one temperature, which is ``result.effective_temperature``.
        """
        from babbitt.kinds.journal.film.temperature_field import temperature_over

        if self._state.thermal is None:
            raise AttributeError(
                f"{self._case.name}: the film has one temperature, result.effective_temperature; one with its own "
                "temperatures is solved by the method film with thermal: adiabatic or full"
            )
        return _read_only(temperature_over(self._state.thermal, self._field))

    def force(
        self,
        x: ArrayLike,
        y: ArrayLike,
        vx: ArrayLike = 0.0,
        vy: ArrayLike = 0.0,
        *,
        contact: Contact | None = None,
    ) -> Array:
        """Force of the film on the journal at a place.

        Parameters
        ----------
        x, y : array_like
            Journal centre from the bearing centre, m.
        vx, vy : array_like
            Its velocity, m/s. All four broadcast.
        contact : callable, optional
            Gives the force where the journal lies outside the clearance: arrays of x, y, vx, vy to an array
            (n, 2) in N.

        Returns
        -------
        ndarray, shape (..., 2)
            N, with the viscosity of the operating point; NaN, with a RuntimeWarning that names the place, where
            no film was found, as may be of films that are solved one by one.

        Raises
        ------
        InputError
            E101 for what is not finite; E003 for a place outside the clearance, without `contact`; E004 for a
            bearing with closed pockets, whose pressures follow the journal.

        Notes
        -----
        Films fed from grooves without pressure run through a compiled loop, other films are solved one by one.
        """
        if closed_pockets(self._case):
            raise InputError(
                "E004", f"{self._case.name}: the pressures of closed pockets follow the journal, and the force at "
                "another place does not know it; use stiffness and damping of the result, or give the pockets a "
                "pressure"
            )  # fmt: skip
        rows, shape = _rows(x, y, vx, vy)
        found = self._positions.forces(rows)
        self._check_outcomes(found, rows, contact is not None)
        if contact is not None and found.outside.any():
            found.force[found.outside] = contact(*rows[found.outside].T)
        return np.asarray(found.force.reshape(*shape, 2))

    def linearise(
        self, x: ArrayLike, y: ArrayLike, vx: ArrayLike = 0.0, vy: ArrayLike = 0.0
    ) -> tuple[Array, Array]:
        """Stiffness and damping of the film at a place, dF = -(K dx + C dv).

        Parameters
        ----------
        x, y : array_like
            Journal centre from the bearing centre, m.
        vx, vy : array_like
            Its velocity, m/s. All four broadcast.

        Returns
        -------
        stiffness, damping : ndarray, shape (..., 2, 2)
            N/m and N s/m, [[xx, xy], [yx, yy]]; NaN where no film was found, as of `force`.

        Raises
        ------
        InputError
            As `force`, but of closed pockets: they begin to follow from the pressures of the operating point.
            E004 for half-Sommerfeld films, which have no coefficients.
        """
        rows, shape = _rows(x, y, vx, vy)
        found = self._positions.coefficients(rows)
        self._check_outcomes(found, rows, False)
        if self._case.cavitation is Cavitation.HALF_SOMMERFELD:
            raise InputError(
                "E004", f"{self._case.name}: a half-Sommerfeld film has no stiffness and damping; choose another "
                "cavitation"
            )  # fmt: skip
        return found.stiffness.reshape(*shape, 2, 2), found.damping.reshape(*shape, 2, 2)

    def _check_outcomes(self, found: PositionForces, rows: Array, contact: bool) -> None:
        if found.settled.all():
            return
        if found.outside.any() and not contact:
            x, y = 1e6 * rows[found.outside][0, :2]
            raise InputError(
                "E003",
                f"{self._case.name}: the journal at x = {x:.4g} µm, y = {y:.4g} µm lies outside the clearance, "
                f"which is {1e6 * self._state.solution.film.clearance:.4g} µm (radial); give contact= a force "
                "for such places, or stay inside",
            )
        lost = ~(found.settled | found.outside)
        if not lost.any():
            return
        x, y, vx, vy = rows[lost][0]
        warnings.warn(
            f"{self._case.name}: no film was found at {np.count_nonzero(lost)} of {len(lost)} places, the first "
            f"at x = {1e6 * x:.4g} µm, y = {1e6 * y:.4g} µm with vx = {1e3 * vx:.4g} mm/s, "
            f"vy = {1e3 * vy:.4g} mm/s: the nodes with pressure changed for ever; what is asked for is NaN "
            "there, and a place close by may have a film",
            RuntimeWarning,
            stacklevel=3,
        )
        for name in ("force", "stiffness", "damping"):
            if hasattr(found, name):
                getattr(found, name)[lost] = math.nan

    def __dir__(self) -> list[str]:
        return [one for one in super().__dir__() if not one.startswith("_")]

    def __repr__(self) -> str:
        n, k = self._field.pressure.shape
        own = ", temperature" if self._state.thermal is not None else ""
        return (
            f"film of {self._case.name}: {n} angles x {k} places along the shaft\n"
            f"  angle, z, pressure, film_thickness, gap, liquid_fraction{own}\n"
            "  force(x, y, vx, vy), linearise(x, y)"
        )


def film_of_solution(solution: Solution) -> SolvedFilm | SolvedPadFilms:
    """The film of a solution, or the films of its pads.

    Raises
    ------
    AttributeError
        Where the method has no film, there is no operating point, or the film was not kept.
    """
    result = solution.result
    if find_view(result.kind, result.method).fields is None:
        known = find_kind(result.kind)
        able = [one for one in (known.views if known else ()) if find_view(result.kind, one).fields is not None]
        those = f"the method {able[0]} has one" if able else f"no method of the kind {result.kind} has one"
        raise AttributeError(f"{result.name}: the method {result.method} has no film to show; {those}")
    if not result.outcome.solved:
        raise AttributeError(f"{result.name}: no film without an operating point ({result.outcome.value})")
    require_state(solution)
    if result.kind == "tilting_pad_journal":
        from babbitt.api.pad_film import SolvedPadFilms

        return SolvedPadFilms(solution)
    return SolvedFilm(solution)


def require_state(solution: Solution) -> None:
    """Refuse a solution whose fields were not kept.

    Raises
    ------
    AttributeError
    """
    if solution.state is None:
        raise AttributeError(
            f"{solution.result.name}: the film was not kept; solve this point alone, or sweep with "
            "keep='solutions'"
        )


def _rows(*parts: ArrayLike) -> tuple[Array, tuple[int, ...]]:
    """Rows of x, y and their rates, and the shape that they broadcast to."""
    given = [np.asarray(part, dtype=np.float64) for part in parts]
    shape = np.broadcast_shapes(*(part.shape for part in given))
    rows = np.empty((*shape, 4))
    for column, part in enumerate(given):
        rows[..., column] = part
    return rows.reshape(-1, 4), shape


def _read_only(values: Array) -> Array:
    view = np.asarray(values).view()
    view.setflags(write=False)
    return view
