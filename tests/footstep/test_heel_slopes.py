"""Footstep: stability, stiffness, damping, clearances at which states vanish, eccentric heels."""

import math
from dataclasses import replace

import numpy as np
import pytest
from heels import GEOMETRY, OIL, footstep

from babbitt.kinds.footstep.axial import axial_damping, centrifugal_pressure
from babbitt.kinds.footstep.clearances import at_clearance, critical_clearances, fold_clearance
from babbitt.kinds.footstep.eccentric import leak_factor, mean_inverse_gap, side_force_of_leakage
from babbitt.kinds.footstep.model import Wall
from babbitt.kinds.footstep.narrow_groove import NarrowGrooveAnnulus
from babbitt.kinds.footstep.rotating_member import turning_force
from babbitt.kinds.footstep.states import Method, NoSteadyStateError, steady_states


@pytest.mark.parametrize("method", Method)
@pytest.mark.parametrize("grooved", [False, True])
@pytest.mark.parametrize("clearance", [12.0, 20.0, 40.0])
def test_slopes_are_those_of_neighbours(method, grooved, clearance):
    """Stiffness and tolerance of the clearance against states solved anew beside the first."""
    step = footstep(25.0, clearance, wall=Wall(303.15, 8.0), **({} if grooved else {"groove": None}))
    for place, state in enumerate(steady_states(step, method)):
        for field, slope in (("face_gap", -state.axial_stiffness), ("clearance", state.load_over_clearance)):
            size = getattr(step, field)
            less, more = (
                steady_states(replace(step, **{field: size * (1.0 + sign * 1e-3)}), method)[place].load
                for sign in (-1.0, 1.0)
            )
            assert slope == pytest.approx((more - less) / (2e-3 * size), rel=2e-3, abs=2e3)


def test_footsteps_fed_through_the_face_gap_have_negative_stiffness():
    for state in (*steady_states(footstep()), *steady_states(footstep(groove=None))):
        if state.face_flow > 0.0:
            assert state.axial_stiffness < 0.0


def test_damping_of_an_annular_plate_without_bore_flow():
    """Rim at given pressure, recess without depth effect: the squeezed ring of the closed form.

    With dp/dr = (6 mu/(pi r h³)) (pi (r² - r2²) - Q) h' and both edges at given pressure the force is known.
    """
    part = replace(GEOMETRY, recess_radius=5.0001e-3)
    step = footstep(15.0, geometry=part)
    r1, r2, h, mu = part.radius, part.bore_radius, step.face_gap, 0.02
    # both edges held: the force of the squeezed ring, mean of r1² and r2² against their logarithmic mean
    exact = 1.5 * math.pi * mu / h**3 * (r1**4 - r2**4 - (r1**2 - r2**2) ** 2 / math.log(r1 / r2))
    assert axial_damping(step, mu, 1e6) == pytest.approx(exact, rel=1e-3)
    # nothing leaves at the rim: all oil comes from the bore, and the force is larger
    assert axial_damping(step, mu, 0.0) > 2.0 * exact


def test_folds():
    for gap, known in ((5.0, 7.188), (7.0, 8.894), (10.0, 10.305), (12.0, 10.486), (15.0, 10.471)):
        fold = fold_clearance(footstep(gap))
        assert fold == pytest.approx(known * 1e-6, abs=0.01e-6)
        assert len(steady_states(at_clearance(footstep(gap), 1.001 * fold))) == 2
        with pytest.raises(NoSteadyStateError):
            steady_states(at_clearance(footstep(gap), 0.999 * fold))
    assert fold_clearance(footstep(oil=replace(OIL, exponent=0.0))) is None
    assert fold_clearance(footstep(10.0, 5.0)) == pytest.approx(10.305e-6, abs=0.01e-6)  # from below


def test_no_oil_passes_the_face_gap_at_critical_clearance():
    hot, cold = critical_clearances(footstep())
    for found, place in ((hot, 0), (cold, 1)):
        state = steady_states(at_clearance(footstep(50.0), found.clearance))[place]
        assert abs(state.face_flow) < 1e-4 * state.leakage
        assert state.groove_temperature == pytest.approx(found.temperature, abs=0.01)
    assert critical_clearances(footstep(supply_pressure=1.2e6)) == ()


def test_leakage_of_eccentric_heels():
    assert leak_factor(0.5, 0.5) == pytest.approx(1.375, rel=1e-14)
    assert leak_factor(0.5, 0.5 + 1e-9) == pytest.approx(1.375, rel=1e-8)
    assert leak_factor(0.4, -0.4) == leak_factor(-0.4, 0.4)
    assert leak_factor(0.4, -0.4) < 1.0 < leak_factor(0.4, 0.4)  # a wedge in every strip holds back
    centred, aside = (steady_states(footstep(groove=None, eccentricity_ratio=e))[0] for e in (0.0, 0.5))
    assert aside.leakage > centred.leakage
    assert aside.load < centred.load


@pytest.mark.parametrize(("eccentricity", "tilt"), [(0.9, 0.0), (0.3, 3e-4), (0.0, -4e-4)])
def test_friction_of_eccentric_heels(eccentricity, tilt):
    """The mean of 1/h: 1/sqrt(1 - eps²) of a parallel heel, and that of narrow grooves where there are none."""
    centred, aside = (
        footstep(groove=None, eccentricity_ratio=e, tilt=t) for e, t in ((0.0, 0.0), (eccentricity, tilt))
    )
    factor = mean_inverse_gap(aside) * aside.clearance
    if tilt == 0.0:
        assert factor == pytest.approx(1.0 / math.sqrt(1.0 - eccentricity**2), rel=1e-14)
    power, plain = (float(NarrowGrooveAnnulus(one).wall_power(0.0)) for one in (aside, centred))
    assert factor == pytest.approx(power / plain, rel=1e-5)
    shear = [
        steady_states(replace(one, oil=replace(one.oil, exponent=0.0)))[0].friction_power
        for one in (centred, aside)
    ]
    cylinder = 2.0 * math.pi * centred.geometry.length * centred.geometry.radius**3 * centred.angular_speed**2
    more = centred.oil.viscosity * cylinder * (factor - 1.0) / centred.clearance
    assert shear[1] - shear[0] == pytest.approx(more, rel=1e-9)


def test_side_force_of_a_tilted_heel():
    """Against the pressure of the short annulus integrated over the surface; zero without tilt."""
    assert side_force_of_leakage(footstep(eccentricity_ratio=0.6), 0.5e6) == 0.0
    step = footstep(eccentricity_ratio=0.2, tilt=3e-4, groove=None)
    rim, outer = step.end_eccentricities
    theta = 2.0 * math.pi * np.arange(720) / 720
    z = (np.arange(4000) + 0.5) / 4000
    gap = 1.0 - (rim + (outer - rim) * z[None, :]) * np.cos(theta)[:, None]
    resistance = np.cumsum(gap[:, ::-1] ** -3, axis=1)[:, ::-1]
    pressure = 0.4e6 * resistance / resistance[:, :1]
    area = GEOMETRY.radius * GEOMETRY.length * 2.0 * math.pi
    force = -area * float(np.mean(pressure.mean(axis=1) * np.cos(theta)))
    assert side_force_of_leakage(step, 0.501e6) == pytest.approx(force, rel=2e-3)
    assert force > 0.0  # the rim, where the pressure is high, stands near the cup: it is pressed there
    assert side_force_of_leakage(replace(step, tilt=-3e-4), 0.501e6) < 0.0


def test_the_film_of_a_slow_heel_feels_the_leakage_alone():
    """Hardly turning, the film in two dimensions has the side force of the leakage, less for its side flow."""
    step = footstep(eccentricity_ratio=0.1, tilt=3e-4, groove=None, angular_speed=1e-3)
    along, across = turning_force(step, 0.5e6, OIL.viscosity)
    short = side_force_of_leakage(step, 0.5e6)
    assert 0.6 * short < along < short
    assert abs(across) < 0.02 * short


def test_centrifugal_pressure():
    assert centrifugal_pressure(footstep()) == pytest.approx(850.0, rel=2e-3)
