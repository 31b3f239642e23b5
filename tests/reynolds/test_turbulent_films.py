"""Turbulent films: limits, constants, consistent derivatives, and where the work of the journal goes."""

import math
from dataclasses import replace

import numpy as np
import pytest
from ring_differences import assert_consistent

from babbitt.core.notices import InputError
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land, Pocket, Resolution, grooved_bore
from babbitt.reynolds.oil._turbulent_oil import thickened
from babbitt.reynolds.oil.turbulence import CONSTANTINESCU, NG_PAN, FilmTurbulence, TurbulenceLaw
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.surface.surface_equilibrium import ring_at
from babbitt.reynolds.surface.surface_solution import friction

CLEARANCE, VISCOSITY, SPEED = 1e-4, 0.004, 600.0
TWO = grooved_bore((0.0, math.pi), 0.3)
FINE = Resolution(5, 96, 24, 1e-12)
FULLY = {"onset": 1e-6, "end": 2e-6}
STEADY = TurbulenceLaw("factors that do not depend on the gap", (12.0, 0.0), (12.0, 0.0), (1.0, 0.0), "test")


def turbulent(law=NG_PAN, density=880.0, onset=500.0, end=1000.0):
    return FilmTurbulence(law, density, onset, end)


def bearing(lands=TWO, **more):
    return JournalFilm(0.1, 0.08, CLEARANCE, VISCOSITY, SPEED, lands, **more)


def test_a_factor_without_exponent_is_a_thicker_oil():
    """12 + 12 Re^0 = 24 along and across, twice the shear: the laminar film of twice the viscosity."""
    load = (300.0, -4000.0)
    doubled = solve_journal(bearing(turbulence=turbulent(STEADY, **FULLY)), load)
    thick = solve_journal(replace(bearing(axial_viscosity=(1.0, 1.0)), viscosity=2.0 * VISCOSITY), load)
    np.testing.assert_allclose(doubled.position, thick.position, rtol=1e-9)
    np.testing.assert_allclose(doubled.stiffness, thick.stiffness, rtol=1e-7)
    np.testing.assert_allclose(doubled.damping, thick.damping, rtol=1e-7)
    assert doubled.friction_torque == pytest.approx(thick.friction_torque, rel=1e-9)
    assert doubled.side_flow.sum() == pytest.approx(thick.side_flow.sum(), rel=1e-9)


def test_below_its_onset_the_film_is_laminar():
    load = (0.0, -4000.0)
    laminar = solve_journal(bearing(axial_viscosity=(1.0, 1.0)), load)
    below = solve_journal(bearing(turbulence=turbulent(onset=1e6, end=2e6)), load)
    np.testing.assert_array_equal(below.position, laminar.position)
    assert below.friction_torque == laminar.friction_torque


@pytest.mark.parametrize("law", [NG_PAN, CONSTANTINESCU])
def test_centred_journal_feels_turbulent_couette_shear(law):
    """Petroff's torque times the shear factor at the Reynolds number of the clearance."""
    film = bearing((Land(0.0, 2.0 * math.pi),), film_start=FilmStart.PERIODIC, cavitation=Cavitation.REYNOLDS,
                   turbulence=turbulent(law, **FULLY))  # fmt: skip
    found = film_at_position(film, (0.0, 0.0))
    reynolds = 880.0 * SPEED * 0.05 * CLEARANCE / VISCOSITY
    petroff = 2.0 * math.pi * VISCOSITY * SPEED * 0.05**3 * film.width / CLEARANCE
    assert found.friction_torque == pytest.approx(petroff * (1.0 + 0.0012 * reynolds**0.94), rel=1e-12)


@pytest.mark.parametrize(("law", "along", "across"), [
    (NG_PAN, 12.0 + 0.0136 * 2000.0**0.9, 12.0 + 0.0043 * 2000.0**0.96),
    (CONSTANTINESCU, 12.0 + 0.0260 * 2000.0**0.8265, 12.0 + 0.0198 * 2000.0**0.741),
])  # fmt: skip
def test_long_slot_and_short_slot_have_the_published_factors(law, along, across):
    """What a pocket at pressure drives out along and across a uniform, fully turbulent gap."""
    ring = Land(0.0, 2.0 * math.pi)
    density = 2000.0 * VISCOSITY / (SPEED * 0.05 * CLEARANCE)
    film = bearing((ring,), film_start=FilmStart.PERIODIC, pockets=(Pocket(0.0, 2.0 * math.pi, 0.04, 0.0, 1e5),),
                   turbulence=turbulent(law, density, **FULLY))  # fmt: skip
    out = film_at_position(film, (0.0, 0.0)).side_flow.sum()
    slot = 2.0 * (2.0 * math.pi * 0.05) * CLEARANCE**3 / (across * VISCOSITY) * 1e5 / 0.02
    assert out == pytest.approx(slot, rel=1e-9)
    surface = ring_at(film, Scales.of(film, SPEED).pressure, np.zeros(2), np.zeros(2), FINE).sample.ring.surface
    row = surface.turbulence
    assert thickened.py_func(row, row[0], 0)[0] == pytest.approx(along / 12.0, rel=1e-12)


def test_long_turbulent_film_obeys_its_one_dimensional_equation():
    """q = h/2 - h^3/(k Re) dp/dtheta is constant along a long film; checked against quadrature."""
    film = JournalFilm(0.1, 100.0, CLEARANCE, VISCOSITY, SPEED, (Land(0.0, 2.0 * math.pi),), Cavitation.REYNOLDS,
                       film_start=FilmStart.PERIODIC, cavitation_pressure=-1e12,
                       turbulence=turbulent(NG_PAN, **FULLY))  # fmt: skip
    eps = 0.6
    found = film_at_position(film, (eps * CLEARANCE, 0.0), resolution=Resolution(4, 384))
    t = np.linspace(0.0, 2.0 * math.pi, 40001)
    h = 1.0 - eps * np.cos(t)
    reynolds = 880.0 * SPEED * 0.05 * CLEARANCE / VISCOSITY * h
    k = 12.0 + 0.0136 * reynolds**0.9
    flow = np.trapezoid(0.5 * k / h**2, t) / np.trapezoid(k / h**3, t)
    slope = k * (0.5 / h**2 - flow / h**3)
    pressure = np.concatenate(([0.0], np.cumsum(0.5 * (slope[1:] + slope[:-1]) * np.diff(t))))
    unit = VISCOSITY * SPEED * (0.05 / CLEARANCE) ** 2
    seen = found.pressure[0, :, 0]
    wanted = np.interp(found.angles[0] % (2.0 * math.pi), t, pressure) * unit
    assert np.abs((seen - seen[0]) - (wanted - wanted[0])).max() < 5e-4 * np.ptp(wanted)


@pytest.mark.parametrize("law", [NG_PAN, CONSTANTINESCU])
@pytest.mark.parametrize("at", [(0.41, -0.34), (0.1, -0.75)])
@pytest.mark.parametrize("breaks_at", [-2e8, 0.0])
def test_coefficients_are_derivatives_of_turbulent_forces(law, at, breaks_at):
    """The local Reynolds numbers run through the transition; full and ruptured films."""
    assert_consistent(bearing(turbulence=turbulent(law), cavitation_pressure=breaks_at), at)


def test_work_of_the_pressure_is_dissipated_across_the_gap():
    """Hydraulic friction power is what the pressure flow dissipates, less what the supplies bring: none here.

    The wall shear of the linearised theory is its own law; this part follows from the flow factors alone.
    """
    film = bearing(turbulence=turbulent(), cavitation_pressure=-1e12)
    settled = ring_at(
        film, Scales.of(film, SPEED).pressure, np.array([0.3, -0.5]), np.zeros(2), Resolution(6, 384)
    )
    work, coefficients, surface = settled.sample.work, settled.sample.film, settled.sample.ring.surface
    journal, shell, _ = friction(settled)
    gradient = work.pressure @ surface.slope.T
    along = (coefficients.conductance * np.diff(work.pressure, axis=0) ** 2).sum()
    across = surface.kappa * (coefficients.cubed * gradient**2 @ surface.share).sum()
    assert 0.5 * (journal - shell) == pytest.approx(along + across, rel=2e-4)


def test_turbulence_carries_more_and_rubs_more():
    laminar = solve_journal(bearing(axial_viscosity=(1.0, 1.0)), (0.0, -4000.0))
    for law in (NG_PAN, CONSTANTINESCU):
        found = solve_journal(bearing(turbulence=turbulent(law)), (0.0, -4000.0))
        assert found.outcome.solved
        assert found.minimum_film_thickness > laminar.minimum_film_thickness
        assert found.friction_torque > laminar.friction_torque


def test_reversal_mirrors_a_turbulent_film():
    forward = solve_journal(bearing(turbulence=turbulent()), (300.0, -4000.0))
    backward = solve_journal(replace(bearing(turbulence=turbulent()), angular_speed=-SPEED), (-300.0, -4000.0))
    np.testing.assert_allclose(backward.position, forward.position * [-1.0, 1.0], rtol=1e-6)


@pytest.mark.parametrize("wrong", [{"density": 0.0}, {"onset": 0.0}, {"onset": 1000.0, "end": 1000.0}])
def test_nonsense_is_refused(wrong):
    with pytest.raises(InputError, match="turbulence"):
        turbulent(**wrong)


def test_a_film_from_the_widest_gap_is_laminar():
    with pytest.raises(InputError, match="laminar"):
        bearing((Land(0.0, 2.0 * math.pi),), cavitation=Cavitation.REYNOLDS, film_start=FilmStart.WIDEST_GAP,
                turbulence=turbulent())  # fmt: skip
