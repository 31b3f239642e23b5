"""Temperature of a thermal film, its bush and its housing, wherever it is asked for."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.journal.film.field import FilmField, between, inside, supply_patches
from babbitt.reynolds.heat.heat_model import BushRing
from babbitt.reynolds.heat.thermal_solution import ThermalFilm

__all__ = ["CentreLine", "bush_temperature", "centre_line", "temperature_over", "temperature_through"]

Array = NDArray[np.float64]
TURN = 2.0 * math.pi
AROUND = 720
"""Places around the bore from which the harmonics of its temperature are taken."""
HARMONICS = 32
"""Harmonics of the bore that are followed into the bush; higher ones do not reach deep."""


def temperature_over(thermal: ThermalFilm, field: FilmField) -> Array:
    """Mean temperature across the gap over the unrolled bore, K.

    Parameters
    ----------
    thermal : ThermalFilm
    field : FilmField
        Of the same film; its grid is taken.

    Returns
    -------
    ndarray, shape (theta, z)
        Over grooves, pockets and holes their mixing temperature.
    """
    found = _around(thermal, field.theta, _across_width(thermal, thermal.mean_temperature, field.z))
    for patch, mixed in zip(supply_patches(thermal.film.film), thermal.groove_temperatures, strict=True):
        found[np.ix_(inside(field.theta, patch.theta), between(field.z, patch.z))] = mixed
    return found


def temperature_through(thermal: ThermalFilm, theta: Array, z: float = 0.0) -> Array:
    """Temperature from the bush to the journal, K, shape (theta, layers + 2), at the place of the width next to z.

    Without ``z`` (m) in the middle of the width. Insulated walls are as warm as the oil that touches them.
    """
    column = int(np.abs(thermal.axial_positions - z).argmin())
    lines = thermal.temperature[:, column, :]
    bush, shaft = lines[:, :1], lines[:, -1:]
    if not thermal.insulated:
        bush, shaft = thermal.bush_temperature[:, None], np.full_like(shaft, thermal.journal_temperature)
    return _around(thermal, theta, np.concatenate((bush, lines, shaft), axis=1))


def bush_temperature(bush: BushRing, thermal: ThermalFilm, theta: Array, radii: Array) -> Array:
    """Temperature in bush and housing, K.

    Parameters
    ----------
    bush : BushRing
    thermal : ThermalFilm
        Its bore temperature is the boundary condition.
    theta : ndarray, shape (n,)
        rad, counter-clockwise from +x.
    radii : ndarray, shape (k,)
        m, from the bore to the outside, ascending.

    Returns
    -------
    ndarray, shape (n, k)

    Notes
    -----
    In a ring of conductivity k with temperature T and flux q at its inner radius a, every harmonic m follows
    ``T(r) = T cosh(m x) - q a/(k m) sinh(m x)``, ``r q(r) = a q cosh(m x) - k m T sinh(m x)``, ``x = ln(r/a)``;
    for m = 0 ``T - q a x / k`` and ``a q`` (Laplace's equation in polar coordinates).
    """
    order = np.arange(HARMONICS + 1)
    places = np.arange(AROUND) * TURN / AROUND
    bore = np.fft.rfft(_around(thermal, places, thermal.bush_temperature[:, None])[:, 0])[: HARMONICS + 1] / AROUND
    bore[1:] *= 2.0
    bore[0] -= bush.ambient_temperature
    with np.errstate(divide="ignore"):
        flux = np.where(np.isinf(own := bush.impedances(HARMONICS)), 0.0, bore / own)
    found = np.zeros((order.size, radii.size), dtype=complex)
    level = bore.copy()
    for inner, outer, conductivity in zip(bush.radii[:-1], bush.radii[1:], bush.conductivities, strict=True):
        here = (radii >= inner * (1.0 - 1e-12)) & (radii <= outer * (1.0 + 1e-12))
        found[:, here], _ = _in_ring(level, flux, inner, radii[here], conductivity)
        after, carried = _in_ring(level, flux, inner, np.array([outer]), conductivity)
        level, flux = after[:, 0], carried[:, 0]
    phase = np.exp(1j * np.outer(theta, order))
    return np.asarray(bush.ambient_temperature + (phase @ found).real)


def _in_ring(
    level: NDArray[np.complex128], flux: NDArray[np.complex128], inner: float, radii: Array, conductivity: float
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Harmonics of temperature and flux at radii of a ring, shape (harmonics, radii)."""
    order = np.arange(level.size)[:, None]
    stretch = np.log(radii / inner)[None, :]
    cosh, sinh = np.cosh(order * stretch), np.sinh(order * stretch)
    over_order = np.where(order > 0, sinh / np.maximum(order, 1), stretch)
    temperature = level[:, None] * cosh - flux[:, None] * inner / conductivity * over_order
    carried = (inner * flux[:, None] * cosh - conductivity * order * level[:, None] * sinh) / radii[None, :]
    return temperature, carried


@dataclass(frozen=True, eq=False)
class CentreLine:
    """Film along the middle of the width: rad, Pa, K; each of shape (theta,)."""

    theta: Array
    pressure: Array
    highest: Array
    mean: Array
    bush: Array


def centre_line(thermal: ThermalFilm, field: FilmField) -> CentreLine:
    """Pressure and temperatures along the middle of the width."""
    through = temperature_through(thermal, field.theta)[:, 1:-1]
    middle = temperature_over(thermal, field)[:, field.z.size // 2]
    bore = _around(thermal, field.theta, thermal.bush_temperature[:, None])[:, 0]
    return CentreLine(field.theta, field.mid_plane_pressure, through.max(axis=1), middle, bore)


def _around(thermal: ThermalFilm, theta: Array, rows: Array) -> Array:
    """Linear between the lines of the film, once around; shape (theta, columns of rows)."""
    lines = thermal.film.angles.ravel()[: rows.shape[0]]
    return np.array([np.interp(theta, lines, column, period=TURN) for column in rows.T]).T


def _across_width(thermal: ThermalFilm, rows: Array, z: Array) -> Array:
    """Linear between the columns of the film, level beyond them; shape (lines, z)."""
    places = thermal.axial_positions
    if places.size == 1:
        return np.repeat(rows, z.size, axis=1)
    at = np.abs(z) if places[0] >= -1e-12 else z
    return np.array([np.interp(at, places, line) for line in rows])
