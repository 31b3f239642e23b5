"""Conduction and bending of pads: closed forms."""

import math

import numpy as np
import pytest

from babbitt.reynolds.tilting_pads.pad_bending import (
    bending_matrices,
    deflection_matrix,
    moments_ahead,
    moments_behind,
)
from babbitt.reynolds.tilting_pads.pad_conduction import pad_conduction
from babbitt.reynolds.tilting_pads.pad_heat import PadBending, PadWalls

RADIUS, THICKNESS, EXTENT, INTERVALS = 0.05, 0.02, math.radians(75.0), 48
WALLS = PadWalls(back_coefficient=500.0, edge_coefficient=0.0)


def conduction(walls=WALLS, fraction=0.5):
    return pad_conduction(RADIUS, THICKNESS, EXTENT, fraction, INTERVALS, walls)


def test_even_flux_through_a_pad_with_insulated_edges():
    """q R_p ln(R_o/R_p)/k + q (R_p/R_o)/h above the back."""
    drives = np.concatenate([np.full(INTERVALS + 1, 1e4), [0.0, 0.0, 300.0]])
    outer = RADIUS + THICKNESS
    rise = 1e4 * RADIUS * math.log(outer / RADIUS) / 50.0 + 1e4 * RADIUS / outer / 500.0
    assert conduction().bore @ drives == pytest.approx(np.full(INTERVALS + 1, 300.0 + rise), rel=1e-9)


def test_surroundings_of_one_temperature_warm_the_whole_pad():
    walls = PadWalls(back_coefficient=300.0, edge_coefficient=700.0)
    found = conduction(walls)
    drives = np.concatenate([np.zeros(INTERVALS + 1), np.full(3, 330.0)])
    assert found.bore @ drives == pytest.approx(np.full(INTERVALS + 1, 330.0), rel=1e-9)
    assert found.difference @ drives == pytest.approx(np.zeros(INTERVALS + 1), abs=1e-7)
    assert found.pivot @ drives == pytest.approx(330.0, rel=1e-9)
    assert found.mean @ drives == pytest.approx(330.0, rel=1e-9)


def test_heat_into_one_place_comes_out_again():
    """At the back, and reciprocally: what flux at i warms at j, flux at j warms at i."""
    found, width = conduction(), np.full(INTERVALS + 1, EXTENT / INTERVALS)
    width[[0, -1]] *= 0.5
    per_heat = found.bore[:, : INTERVALS + 1] / width
    assert per_heat == pytest.approx(per_heat.T, rel=1e-9)


def test_temperature_difference_of_a_thin_pad_is_that_of_the_flux():
    thin = pad_conduction(RADIUS, 1e-4, EXTENT, 0.5, INTERVALS, WALLS)
    drives = np.concatenate([np.full(INTERVALS + 1, 1e4), np.zeros(3)])
    assert thin.difference @ drives == pytest.approx(np.full(INTERVALS + 1, 1e4 * 1e-4 / 50.0), rel=2e-3)


@pytest.mark.parametrize("fraction", [0.5, 0.57])
def test_even_curvature_widens_the_radius(fraction):
    """C11: w = g (1 - cos phi), wherever the pivot stands."""
    angles = np.linspace(-fraction * EXTENT, (1.0 - fraction) * EXTENT, INTERVALS + 1)
    assert deflection_matrix(angles) @ np.ones(angles.size) == pytest.approx(1.0 - np.cos(angles), abs=1e-8)


@pytest.mark.parametrize("fraction", [0.5, 0.57])
def test_moment_of_even_pressure(fraction):
    """int sin(phi' - phi) from phi to the free end: 1 - cos of the angle between them."""
    start, end = -fraction * EXTENT, (1.0 - fraction) * EXTENT
    angles = np.linspace(start, end, INTERVALS + 1)
    even = np.ones(angles.size)
    assert moments_ahead(angles) @ even == pytest.approx(1.0 - np.cos(end - angles), abs=1e-8)
    assert moments_behind(angles) @ even == pytest.approx(1.0 - np.cos(angles - start), abs=1e-8)


@pytest.mark.parametrize("fraction", [0.5, 0.57, 0.625])
def test_deflection_under_even_pressure(fraction):
    """w = (p R_p rho^3/(E I/L)) [1 - cos phi - (sin b sin phi - phi sin(b - phi))/2], b the free arc on either
    side: the beam of Timoshenko, with the pivot between two lines or on one."""
    by_pressure, _ = bending_matrices(RADIUS, THICKNESS, EXTENT, fraction, INTERVALS, PadBending())
    angles = np.linspace(-fraction * EXTENT, (1.0 - fraction) * EXTENT, INTERVALS + 1)
    free, phi = np.where(angles < 0.0, fraction, 1.0 - fraction) * EXTENT, np.abs(angles)
    neutral = RADIUS + 0.5 * THICKNESS
    unit = 1e6 * RADIUS * neutral**3 * 12.0 / (210e9 * THICKNESS**3)
    shape = 1.0 - np.cos(phi) - 0.5 * (np.sin(free) * np.sin(phi) - phi * np.sin(free - phi))
    found = by_pressure @ np.full(INTERVALS + 1, 1e6)
    assert found == pytest.approx(unit * shape, rel=1e-3, abs=1e-3 * unit * shape.max())


def test_plates_are_stiffer_than_beams_and_heat_bends_both_alike():
    beam = bending_matrices(RADIUS, THICKNESS, EXTENT, 0.5, INTERVALS, PadBending())
    plate = bending_matrices(RADIUS, THICKNESS, EXTENT, 0.5, INTERVALS, PadBending(poisson_ratio=0.3))
    assert plate[0] == pytest.approx(beam[0] * 0.91, rel=1e-12)
    assert plate[1] == pytest.approx(beam[1], rel=1e-12)


def test_what_enters_the_bore_of_a_pad_with_an_insulated_back_leaves_over_its_edges():
    found = conduction(PadWalls(back_coefficient=0.0, edge_coefficient=700.0), fraction=0.6)
    flux = 1e4 * (1.0 + np.linspace(0.0, 1.0, INTERVALS + 1) ** 2)
    drives = np.concatenate([flux, [310.0, 330.0, 320.0]])
    width = np.full(INTERVALS + 1, EXTENT / INTERVALS)
    width[[0, -1]] *= 0.5
    assert (found.edges @ drives).sum() == pytest.approx(RADIUS * width @ flux, rel=1e-9)


def test_heat_flows_along_a_pad_from_the_warmer_edge_to_the_colder_one():
    """Without flux into the bore: one resistance at each edge and that of the pad, thin as a rod, between them."""
    thin, coefficient = 1e-4, 700.0
    walls = PadWalls(back_coefficient=0.0, edge_coefficient=coefficient)
    found = pad_conduction(RADIUS, thin, EXTENT, 0.5, INTERVALS, walls)
    drives = np.concatenate([np.zeros(INTERVALS + 1), [300.0, 340.0, 320.0]])
    length = (RADIUS + 0.5 * thin) * EXTENT
    expected = 40.0 * thin / (2.0 / coefficient + length / walls.conductivity)
    assert found.edges @ drives == pytest.approx([expected, -expected], rel=1e-4)
