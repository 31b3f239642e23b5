"""Pads that bend along one mode: tables of an independent program of the same equations, beams, limits, frames."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scaled_pads import FOUR_LOAD, four_pads, one_pad

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.oil.turbulence import NG_PAN, FilmTurbulence
from babbitt.reynolds.tilting_pads.bending_mode import (
    BendingMode,
    bending_stiffness,
)
from babbitt.reynolds.tilting_pads.dynamics import condensed_at, full_coefficients
from babbitt.reynolds.tilting_pads.flexible_pads import bent_bearing
from babbitt.reynolds.tilting_pads.model import TiltingPad
from babbitt.reynolds.tilting_pads.pad_bending import bending_matrices
from babbitt.reynolds.tilting_pads.pad_heat import PadBending
from babbitt.reynolds.tilting_pads.pad_lands import pad_gaps
from babbitt.reynolds.tilting_pads.pedestal import Pedestal, on_pedestal
from babbitt.reynolds.tilting_pads.solution import PadStatus
from babbitt.reynolds.tilting_pads.solve import solve_tilting_pads, tilting_pads_at

FINE, COARSE = Resolution(6, 192), Resolution(4, 48)

# k_q: eta, q, W, K(0), K(1), C(1), K(1/2), C(1/2) of a centred pad at xi 0.5, grid 6 x 192
CENTRED = {
    0.1: (0.306313, 0.043626, 0.618681, 3.27224, 2.26486, 2.64646, 2.93108, 2.15640),
    0.03: (0.310958, 0.145963, 0.622866, 3.29427, 2.31198, 2.62117, 2.96002, 2.13467),
    math.inf: (0.304326, 0.0, 0.616855, 3.26233, 2.24395, 2.65699, 2.91816, 2.16550),
}
STIFFNESS = [[2.902996, 2.495667, -0.071989], [-0.075737, 0.523956, -0.023841], [-0.017381, -0.020918, 0.000787]]
DAMPING = [[5.076505, 0.628511, -0.041968], [0.628511, 0.381046, -0.008178], [-0.041968, -0.008178, 0.000479]]


def seen(solution, ratio):
    """Condensed stiffness and damping along the pivot of a single pad."""
    found = condensed_at(full_coefficients(solution), ratio)
    return found.stiffness[0, 0], found.damping[0, 0]


@pytest.mark.parametrize("stiffness", CENTRED)
def test_a_centred_pad_that_bends(stiffness):
    eta, bend, load, *moving = CENTRED[stiffness]
    found = tilting_pads_at(one_pad(bending_stiffness=stiffness), (0.5, 0.0), FINE)
    (state,) = found.pads
    assert found.outcome is Outcome.CONVERGED
    assert state.tangential == pytest.approx(eta, rel=2e-5)
    assert (state.bend.deflection if state.bend else 0.0) == pytest.approx(bend, rel=2e-5)
    assert state.load == pytest.approx(load, rel=1e-5)
    assert seen(found, 0.0)[0] == pytest.approx(moving[0], rel=1e-4)
    assert (*seen(found, 1.0), *seen(found, 0.5)) == pytest.approx(tuple(moving[1:]), rel=1e-4)


def test_an_offset_pad_that_bends():
    found = tilting_pads_at(one_pad(0.7, 75.0, 0.55, 0.4, bending_stiffness=0.1), (0.0, 0.0), FINE)
    assert found.pads[0].load == pytest.approx(0.648621, rel=1e-5)
    assert seen(found, 1.0) == pytest.approx((2.16815, 2.78596), rel=1e-4)


def test_the_film_of_a_bent_pad_in_three_motions():
    (state,) = tilting_pads_at(one_pad(bending_stiffness=0.1), (0.5, 0.0), FINE).pads
    assert state.bend.stiffness == pytest.approx(np.array(STIFFNESS), rel=2e-4, abs=1e-6)
    assert state.bend.damping == pytest.approx(np.array(DAMPING), rel=2e-4, abs=1e-6)
    assert state.bend.damping == pytest.approx(state.bend.damping.T, rel=1e-6)


def test_the_film_answers_bending_as_differences_of_its_pressure_do():
    """dF/dq at a place that stands: pads with bores bent by a little more and less, held by a stiff flexure."""
    held = one_pad(bending_stiffness=0.1, rotational_stiffness=1e9)
    (state,) = tilting_pads_at(held, (0.5, 0.0), FINE).pads
    step = 1e-4
    ends = [
        tilting_pads_at(
            replace(bent, pads=(replace(bent.pads[0], bending_stiffness=math.inf),)), (0.5, 0.0), FINE
        ).pads[0]
        for bent in (bent_bearing(held, np.array([state.bend.deflection + way])) for way in (step, -step))
    ]  # fmt: skip
    slope = -(ends[0].force - ends[1].force) / (2.0 * step)
    assert state.bend.stiffness[:2, 2] == pytest.approx(slope, rel=2e-3)


def test_a_pad_of_infinite_stiffness_is_rigid():
    rigid, stiff = (
        solve_tilting_pads(four_pads(bending_stiffness=one), FOUR_LOAD, COARSE) for one in (math.inf, 1e9)
    )
    assert all(state.bend is None for state in rigid.pads)
    assert stiff.position == pytest.approx(rigid.position, rel=1e-7)
    for ratio in (0.0, 0.5, 1.0):
        one, other = (condensed_at(full_coefficients(found), ratio) for found in (stiff, rigid))
        assert one.stiffness == pytest.approx(other.stiffness, rel=1e-6, abs=1e-7)
        assert one.damping == pytest.approx(other.damping, rel=1e-6, abs=1e-7)


@pytest.mark.parametrize("softness", [0.3, 0.03, 0.003])
def test_at_rest_the_spring_of_the_mode_bears_the_pressure(softness):
    """k_q q = int p psi dA, by another rule, of every pad of a bearing under a load; the film carries the load."""
    bearing = four_pads(bending_stiffness=softness)
    found = solve_tilting_pads(bearing, FOUR_LOAD, COARSE)
    assert found.outcome is Outcome.CONVERGED
    assert found.force == pytest.approx(-np.array(FOUR_LOAD), rel=1e-5)
    for pad, state in zip(found.bearing.pads, found.pads, strict=True):
        phi = state.angles - pad.pivot_angle
        places, side = np.linspace(0.0, 1.0, 201) ** 2, state.axial_positions[-1]
        even = [
            np.polynomial.Polynomial.fit((state.axial_positions / side) ** 2, row, 4) for row in state.pressure
        ]
        mean = np.trapezoid([row(places) for row in even], np.sqrt(places))
        pushed = np.trapezoid(mean * BendingMode.of(pad).shape(phi), phi)
        pushed *= bearing.radius * bearing.width
        assert softness * state.bend.deflection == pytest.approx(pushed, rel=5e-3)
        assert state.bend.deflection > 0.0  # pressure opens a pad


def test_the_static_stiffness_is_the_slope_of_the_load_with_bending_free():
    bearing = one_pad(bending_stiffness=0.03)
    ahead, behind = (tilting_pads_at(bearing, (0.5 + way, 0.0), FINE).pads[0].load for way in (1e-4, -1e-4))
    slope = (ahead - behind) / 2e-4
    assert seen(tilting_pads_at(bearing, (0.5, 0.0), FINE), 0.0)[0] == pytest.approx(slope, rel=1e-4)


def test_softer_pads_open_more_and_damp_less():
    bends, damping = [], []
    for stiffness in (0.3, 0.1, 0.03):
        found = tilting_pads_at(one_pad(bending_stiffness=stiffness), (0.5, 0.0), COARSE)
        bends.append(found.pads[0].bend.deflection)
        damping.append(seen(found, 1.0)[1])
    assert bends == sorted(bends)
    assert damping == sorted(damping, reverse=True)


@pytest.mark.parametrize("fraction", [0.5, 0.625])
def test_the_mode_is_the_beam_under_even_pressure(fraction):
    pad = TiltingPad(0.0, math.radians(75.0), 1e-4, 1e-4, 0.02, fraction)
    radius, modulus, pressure, lines = 0.05, 210e9, 4e6, 192
    by_pressure, _ = bending_matrices(radius, pad.thickness, pad.extent, fraction, lines, PadBending(modulus))
    beam = by_pressure @ np.full(lines + 1, pressure)
    mode = BendingMode.of(pad)
    phi = np.linspace(-fraction * pad.extent, (1.0 - fraction) * pad.extent, lines + 1)
    pushed = pressure * radius * 0.07 * np.trapezoid(mode.shape(phi), phi)
    q = pushed / bending_stiffness(pad, radius, 0.07, modulus)
    assert q * mode.shape(phi) == pytest.approx(beam, rel=2e-3, abs=1e-3 * beam.max())
    assert mode.energy == pytest.approx(np.trapezoid(mode.shape(phi), phi), rel=1e-3)  # work of the even pressure


def test_a_pad_of_20_mm_of_steel():
    """0.52 MN/m for 100 mm of bore, 75 degrees and 70 mm of width."""
    pad = TiltingPad(0.0, math.radians(75.0), 148e-6, 78e-6, 0.02)
    assert bending_stiffness(pad, 0.05, 0.07, 210e9) == pytest.approx(0.52e6, rel=0.01)
    thin = replace(pad, thickness=0.01)
    ratio = bending_stiffness(pad, 0.05, 0.07, 210e9) / bending_stiffness(thin, 0.05, 0.07, 210e9)
    assert ratio == pytest.approx(8.0 * (0.055 / 0.06) ** 3, rel=1e-12)


@pytest.mark.parametrize(("fraction", "least", "most"), [(0.5, 0.92, 0.98), (0.6, 0.84, 0.94)])
def test_the_mode_has_most_of_the_compliance_of_the_beam(fraction, least, most):
    """Under the pressure of a film: work of the pressure by the mode over that by the beam."""
    pad = TiltingPad(0.0, math.radians(75.0), 1.0, 0.6, 0.1, fraction)
    (state,) = tilting_pads_at(one_pad(0.7, 75.0, fraction, 0.4), (0.2, 0.0), FINE).pads
    mean = state.pressure[:, 0]
    phi, mode = state.angles, BendingMode.of(pad)
    by_pressure, _ = bending_matrices(1.0, pad.thickness, pad.extent, fraction, phi.size - 1, PadBending(1.0))
    by_beam = np.trapezoid(mean * (by_pressure @ mean), phi)
    pushed = np.trapezoid(mean * mode.shape(phi), phi)
    by_mode = pushed**2 / bending_stiffness(pad, 1.0, 1.0, 1.0)
    assert least < by_mode / by_beam < most


def test_the_mass_of_the_mode():
    bearing = one_pad(bending_stiffness=0.1, mass=3.0)
    full = full_coefficients(tilting_pads_at(bearing, (0.5, 0.0), COARSE))
    assert full.labels == ("x", "y", "pad 1 tilt", "pad 1 bending")
    phi = np.linspace(-math.radians(40.0), math.radians(40.0), 2001)
    shape = BendingMode.of(bearing.pads[0]).shape(phi)
    assert full.mass[3, 3] == pytest.approx(3.0 * np.trapezoid(shape**2, phi) / (phi[-1] - phi[0]), rel=1e-5)
    assert not full.mass[3, :3].any()
    heavy = full_coefficients(tilting_pads_at(one_pad(bending_stiffness=0.1, mass=3e6), (0.5, 0.0), COARSE))
    held = replace(heavy, labels=heavy.labels[:3], levers=heavy.levers[:3], **{
        name: getattr(heavy, name)[:3, :3] for name in ("mass", "damping", "stiffness")
    })  # fmt: skip
    one, other = (condensed_at(it, 1.0) for it in (heavy, held))  # inertia holds the mode
    assert one.stiffness[0, 0] == pytest.approx(other.stiffness[0, 0], rel=1e-5)
    assert one.damping[0, 0] == pytest.approx(other.damping[0, 0], rel=1e-5)
    housed = on_pedestal(full, bearing, Pedestal((1.0, 1.0)))
    assert not housed.mass[3, 4:].any()


def test_the_other_sense_of_rotation_is_the_mirror():
    one = one_pad(0.7, 75.0, 0.55, 0.4, bending_stiffness=0.05)
    (ahead,) = tilting_pads_at(one, (0.1, 0.05), COARSE).pads
    (mirrored,) = tilting_pads_at(replace(one, angular_speed=-1.0), (0.1, -0.05), COARSE).pads
    side = np.array([1.0, -1.0, 1.0])
    assert mirrored.load == pytest.approx(ahead.load, rel=1e-9)
    assert mirrored.bend.deflection == pytest.approx(ahead.bend.deflection, rel=1e-8)
    assert mirrored.bend.stiffness == pytest.approx(ahead.bend.stiffness * np.outer(side, side), rel=1e-6)
    assert mirrored.bend.damping == pytest.approx(ahead.bend.damping * np.outer(side, side), rel=1e-6)


@pytest.mark.parametrize("own", [{"width": 0.5}, {"viscosity": 2.0}])
def test_pads_of_their_own_width_and_oil(own):
    """A pad alone has the answers of a bearing of that width or oil."""
    bearing = one_pad(bending_stiffness=0.1)
    whole = replace(bearing, **own)
    pad = replace(bearing, pads=(replace(bearing.pads[0], **own),))
    (one,), (other,) = (tilting_pads_at(it, (0.5, 0.0), COARSE).pads for it in (pad, whole))
    assert one.bend.deflection == pytest.approx(other.bend.deflection, rel=1e-9)
    assert one.bend.stiffness == pytest.approx(other.bend.stiffness, rel=1e-7)


def test_turbulent_films_of_pads_that_bend():
    law = FilmTurbulence(NG_PAN, 1.0, 1e-3, 2e-3)
    thick = FilmTurbulence(NG_PAN, 3e3, 1e-3, 2e-3)
    bends = {}
    for name, turbulence in (("laminar", None), ("hardly", law), ("turbulent", thick)):
        found = tilting_pads_at(replace(one_pad(bending_stiffness=0.1), turbulence=turbulence), (0.5, 0.0), COARSE)
        bends[name] = found.pads[0].bend
        assert found.outcome is Outcome.CONVERGED
    assert bends["hardly"].deflection == pytest.approx(bends["laminar"].deflection, rel=0.01)
    assert bends["turbulent"].deflection > 1.2 * bends["laminar"].deflection
    assert bends["turbulent"].stiffness[2, 2] > 1.2 * bends["laminar"].stiffness[2, 2]


def test_gaps_of_bent_pads_hold_their_bending():
    bearing = one_pad(bending_stiffness=0.03)
    found = tilting_pads_at(bearing, (0.5, 0.0), COARSE)
    (state,) = found.pads
    (gap,) = pad_gaps(found)
    phi = state.angles
    straight = 1.0 - state.radial * np.cos(phi) - state.tangential * np.sin(phi)
    assert gap - straight == pytest.approx(state.bend.deflection * BendingMode.of(bearing.pads[0]).shape(phi))
    assert gap.min() == pytest.approx(state.minimum_film_thickness, rel=1e-3)


def test_unloaded_pads_do_not_bend():
    (state,) = tilting_pads_at(one_pad(bending_stiffness=0.1), (-0.5, 0.0), COARSE).pads
    assert state.status is PadStatus.UNLOADED
    assert state.bend is None


def test_a_pad_without_stiffness_is_refused():
    with pytest.raises(InputError, match="bending_stiffness"):
        one_pad(bending_stiffness=0.0)
