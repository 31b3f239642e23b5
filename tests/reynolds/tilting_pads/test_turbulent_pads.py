"""Turbulent films of tilting pads: laminar limit, closed forms of an even gap, the journal film in their place."""

import math
from dataclasses import replace

import numpy as np
import pytest
from fillon_pads import LOAD, fillon_bearing, fillon_heat
from scipy.integrate import cumulative_trapezoid

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.oil.turbulence import CONSTANTINESCU, NG_PAN, FilmTurbulence
from babbitt.reynolds.tilting_pads.dynamics import condensed_at, full_coefficients
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.pad_lands import film_of, pad_positions
from babbitt.reynolds.tilting_pads.solution import PadStatus
from babbitt.reynolds.tilting_pads.solve import fold_of, solve_tilting_pads, tilting_pads_at
from babbitt.reynolds.tilting_pads.thermal_pads import find_thermal_tilting_pads

DENSITY, ONSET = 850.0, 800.0
LAWS = (NG_PAN, CONSTANTINESCU)
GRID = Resolution(4, 48)


def turbulence(law=NG_PAN, onset=ONSET):
    return FilmTurbulence(law, DENSITY, onset, 2.0 * onset)


def fast_bearing(law=NG_PAN, fraction=0.55, **changes):
    """Four pads of 300 mm with thin oil at 9000 rpm: Re about 2600 at the machined clearance."""
    pads = tuple(
        TiltingPad(math.radians(angle), math.radians(75.0), 300e-6, 200e-6, 0.05, fraction)
        for angle in (45.0, 135.0, 225.0, 315.0)
    )
    made = TiltingPadBearing(0.3, 0.2, 0.0139, 300.0 * math.pi, pads, turbulence=turbulence(law))
    return replace(made, **changes)


FAST_LOAD = (8e3, -50e3)


def concentric(width, law=NG_PAN, clearance=300e-6):
    """One pad held concentric with the journal by a stiff flexure: an even gap without pressure."""
    pad = TiltingPad(0.0, 1.2, clearance, clearance, 0.05, rotational_stiffness=1e9)
    return TiltingPadBearing(0.3, width, 0.0139, 300.0 * math.pi, (pad,), turbulence=turbulence(law))


def reynolds(bearing, gap):
    """Local Reynolds number."""
    return DENSITY * bearing.angular_speed * bearing.radius * gap / bearing.viscosity


def test_below_the_onset_a_film_is_laminar():
    thick = fast_bearing(turbulence=turbulence(onset=5000.0))
    found, laminar = (solve_tilting_pads(one, FAST_LOAD, GRID) for one in (thick, replace(thick, turbulence=None)))
    assert reynolds(thick, 1.5 * 300e-6) < 5000.0
    assert found.position == pytest.approx(laminar.position, rel=1e-12)
    for one, other in zip(found.pads, laminar.pads, strict=True):
        assert one.stiffness == pytest.approx(other.stiffness, rel=1e-10)
        assert one.damping == pytest.approx(other.damping, rel=1e-10)
        assert one.friction_torque == pytest.approx(other.friction_torque, rel=1e-11)
        assert (one.inflow, one.outflow, one.side_flow) == pytest.approx(
            (other.inflow, other.outflow, other.side_flow), rel=1e-11
        )


@pytest.mark.parametrize("law", LAWS)
def test_friction_of_an_even_gap_is_that_of_couette(law):
    """Petroff's torque times 1 + 0.0012 Re^0.94, fully turbulent, of a pad that is held and of an unloaded one."""
    held = concentric(0.2, law)
    free = replace(held, pads=(replace(held.pads[0], rotational_stiffness=0.0),))
    number = reynolds(held, 300e-6)
    assert number > 2.0 * ONSET
    petroff = held.viscosity * held.angular_speed * held.radius**3 * held.width * 1.2 / 300e-6
    assert tilting_pads_at(free, (0.0, 0.0), GRID).pads[0].status is PadStatus.UNLOADED
    for bearing in (held, free):
        (pad,) = tilting_pads_at(bearing, (0.0, 0.0), GRID).pads
        assert pad.load == pytest.approx(0.0, abs=1e-6)
        assert pad.friction_torque == pytest.approx(petroff * (1.0 + 0.0012 * number**0.94), rel=1e-9)
        assert pad.shear_torque == pytest.approx(pad.friction_torque, rel=1e-9)
        assert pad.inflow == pytest.approx(0.5 * held.angular_speed * held.radius * 300e-6 * held.width, rel=1e-9)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize(("width", "way"), [(300.0, 0), (3e-4, 1)])
def test_damping_of_an_even_gap_has_the_factor_of_its_direction(law, width, way):
    """Squeezed oil leaves a very wide pad along the motion, a very short one across it: damping grows by k/12.

    The gap narrows by 1e-5 of itself: without pressure the round-off of a film says where it is full.
    """
    bearing = concentric(width, law)
    (even,) = bearing.pads
    bearing = replace(bearing, pads=(replace(even, rest_tilt=1e-5 * even.clearance / bearing.lever(even)),))
    number = reynolds(bearing, 300e-6)
    factor, exponent = (law.along, law.across)[way]
    (turbulent,), (laminar,) = (
        tilting_pads_at(one, (0.0, 0.0), GRID).pads for one in (bearing, replace(bearing, turbulence=None))
    )
    expected = 1.0 + factor * number**exponent / 12.0
    assert turbulent.damping[0, 0] / laminar.damping[0, 0] == pytest.approx(expected, rel=1e-4)
    assert turbulent.damping[1, 1] / laminar.damping[1, 1] == pytest.approx(expected, rel=1e-4)


def test_pressure_along_a_wide_pad_by_quadrature():
    """One dimension, q constant: dp/dtheta = 12 f (h/2 - q)/h^3, in a film in which turbulence sets in."""
    onset, half = 1300.0, 0.6
    wide = replace(concentric(300.0), turbulence=turbulence(onset=onset))
    tilt = 0.35 * wide.pads[0].clearance / wide.lever(wide.pads[0])
    bearing = replace(wide, pads=(replace(wide.pads[0], rest_tilt=tilt, rotational_stiffness=1e15),))
    (state,) = tilting_pads_at(bearing, (0.0, 0.0), GRID).pads
    phi = np.linspace(-half, half, 20001)
    gap = bearing.pads[0].clearance - state.tangential * np.sin(phi)
    number = reynolds(bearing, gap)
    assert number.min() < 1.9 * onset < 2.1 * onset < number.max()
    t = np.clip(number / onset - 1.0, 0.0, 1.0)
    f = 1.0 + t * t * (3.0 - 2.0 * t) * 0.0136 * number**0.9 / 12.0
    speed = bearing.angular_speed * bearing.radius
    flow = 0.5 * speed * np.trapezoid(f / gap**2, phi) / np.trapezoid(f / gap**3, phi)
    slope = 12.0 * bearing.viscosity * bearing.radius * f * (0.5 * speed * gap - flow) / gap**3
    pressure = cumulative_trapezoid(slope, phi, initial=0.0)
    on_lines = np.interp(np.linspace(-half, half, state.angles.size), phi, pressure)
    assert state.pressure[:, 0] == pytest.approx(on_lines, abs=1e-4 * pressure.max())


@pytest.mark.parametrize("law", LAWS)
def test_pads_that_stand_are_a_journal_film_with_fixed_lobes(law):
    """The engine of journal films has turbulence of its own: same places, same forces, flows and friction."""
    found = solve_tilting_pads(fast_bearing(law), FAST_LOAD, Resolution(4, 96))
    assert found.outcome is Outcome.CONVERGED
    film = film_at_position(
        film_of(found.bearing, pad_positions(found)), tuple(found.position), resolution=Resolution(6, 384)
    )
    load = math.hypot(*FAST_LOAD)
    assert film.force == pytest.approx(found.force, abs=2e-3 * load)
    assert film.friction_torque == pytest.approx(found.friction_torque, rel=2e-3)
    assert film.side_flow.sum() == pytest.approx(found.side_flow, rel=5e-3)
    thin = film_of(replace(found.bearing, turbulence=None), pad_positions(found))
    laminar = film_at_position(thin, tuple(found.position), resolution=GRID)
    assert math.hypot(*laminar.force) < 0.8 * load  # turbulence is no small correction here


def test_the_static_stiffness_is_the_slope_of_the_load():
    """Derivatives of the turbulent coefficients, across the range in which turbulence sets in."""
    bearing, grid = fast_bearing(), Resolution(4, 96)
    found = solve_tilting_pads(bearing, FAST_LOAD, grid)
    static = condensed_at(full_coefficients(found), 0.0).stiffness
    step = 1e-7
    for axis in range(2):
        way = step * np.eye(2)[axis]
        ahead, behind = (tilting_pads_at(bearing, tuple(found.position + s * way), grid).force for s in (1, -1))
        assert static[:, axis] == pytest.approx(
            -(ahead - behind) / (2.0 * step), rel=5e-3, abs=2e-3 * static.max()
        )


def test_turbulence_carries_more_and_costs_more():
    at = (10e-6, -60e-6)
    turbulent, laminar = (
        tilting_pads_at(one, at, GRID) for one in (fast_bearing(), fast_bearing(turbulence=None))
    )  # fmt: skip
    assert turbulent.friction_power > 1.5 * laminar.friction_power
    for one, other in zip(turbulent.pads, laminar.pads, strict=True):
        assert one.load > 1.1 * other.load
        assert one.inflow == pytest.approx(one.outflow + one.side_flow, rel=1e-9)


def test_every_pad_has_the_reynolds_number_of_its_own_oil():
    thin = replace(fast_bearing().pads[3], viscosity=0.008)
    bearing = fast_bearing(pads=(*fast_bearing().pads[:3], thin))
    at = (20e-6, -60e-6)
    mixed, alone = (
        tilting_pads_at(one, at, GRID).pads[3]
        for one in (bearing, fast_bearing(viscosity=0.008))
    )  # fmt: skip
    assert mixed.load == pytest.approx(alone.load, rel=1e-9)
    assert mixed.friction_torque == pytest.approx(alone.friction_torque, rel=1e-9)


def test_a_fold_is_that_of_the_turbulent_film():
    turbulent, laminar = (
        fold_of(one, 0, GRID) for one in (fast_bearing(), fast_bearing(turbulence=None))
    )  # fmt: skip
    assert turbulent.outcome is laminar.outcome is Outcome.CONVERGED
    assert turbulent.load > 1.2 * laminar.load
    assert fold_of(fast_bearing(fraction=0.5), 0, GRID).eccentricity_ratio == 0.0


def test_a_centred_turbulent_pad_unloads_at_zero():
    """As a laminar one: found by a search that does not know it, of a bore given by a profile of zeros."""
    pads = tuple(replace(pad, profile=(0.0, 0.0)) for pad in fast_bearing(fraction=0.5).pads)
    fold = fold_of(fast_bearing(pads=pads), 0, GRID)
    assert fold.eccentricity_ratio == pytest.approx(0.0, abs=1e-4)


def test_films_with_their_own_temperatures_are_laminar():
    with pytest.raises(InputError, match="turbulence"):
        find_thermal_tilting_pads(replace(fillon_bearing(), turbulence=turbulence()), LOAD, fillon_heat("B"))
