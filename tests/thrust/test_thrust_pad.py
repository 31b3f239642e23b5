"""Tilting pads: reference values, similarity, the exact stiffness 2 W/h, closed forms of sliders."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from trawler_pads import INERTIA, PAD, SPEED, VISCOSITY, bearing

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.equilibrium import pad_state
from babbitt.kinds.thrust.face import SteppedFace, TaperedFace
from babbitt.kinds.thrust.load_curve import carrying
from babbitt.kinds.thrust.pad import Pivot, ThrustPad
from babbitt.kinds.thrust.state import condensed, face_runout_response, tilt_answer
from babbitt.reynolds.oil.turbulence import NG_PAN, FilmTurbulence
from babbitt.reynolds.sector.sector import PlaneMotion, SectorPad, sector_film


@pytest.fixture(scope="module")
def films():
    return carrying(PAD, VISCOSITY, SPEED)


def test_the_reference_pad(films):
    """A prototype of the same equations on 97 x 129 nodes; 0.5 % (B2)."""
    state = films.state(films.height_for(62.5e3))
    assert films.constant == pytest.approx(1.5597e-4, rel=5e-3)
    assert state.height == pytest.approx(49.96e-6, rel=5e-3)
    assert state.minimum_film_thickness == pytest.approx(30.31e-6, rel=5e-3)
    assert state.maximum_pressure == pytest.approx(4.50e6, rel=5e-3)
    for order, stiffness, damping in ((1, 2.706e9, 1.863e8), (4, 3.585e9, 1.598e8)):
        moving = condensed(state, order * SPEED, INERTIA)
        assert moving.real == pytest.approx(stiffness, rel=5e-3)
        assert moving.imag / (order * SPEED) == pytest.approx(damping, rel=5e-3)


def test_a_pad_lifted_off_carries_nothing_and_does_not_answer(films):
    """Of a collar that tilts by millimetres; without a film nothing holds the tilts either."""
    state = replace(films.state(films.height_for(62.5e3)), stiffness=np.zeros((3, 3)), damping=np.zeros((3, 3)))
    assert condensed(state, 0.0) == 0.0
    assert not tilt_answer(state, 0.0, INERTIA).any()
    assert face_runout_response(state, 0.0, INERTIA) == pytest.approx(np.array([-1.0, 1.0j]) / PAD.pivot_radius)


@settings(max_examples=12)
@given(
    fraction=st.floats(0.55, 0.65),
    width=st.floats(0.6, 1.5),
    extent=st.floats(20.0, 50.0),
    film=st.floats(2e-5, 2e-4),
)
def test_stiffness_at_rest_is_two_loads_over_the_film(fraction, width, extent, film):
    """W ~ 1/h^2 with the tilts free, so that k(0) = 2 W/h (R4), whatever the pad."""
    angle = math.radians(extent)
    half = 0.5 * width * 0.28 * angle
    inner, outer = 0.28 - half, 0.28 + half
    centroid = 2.0 / 3.0 * (outer**3 - inner**3) / (outer**2 - inner**2)
    pad = ThrustPad(inner, outer, angle, centroid, fraction)
    state = pad_state(pad, film, VISCOSITY, SPEED)
    assert condensed(state, 0.0).real == pytest.approx(2.0 * state.load / film, rel=1e-6)


def test_a_scaled_film_is_the_film_solved_there(films):
    scaled = films.at(0.02, 2.0 * SPEED).state(30e-6)
    solved = pad_state(PAD, 30e-6, 0.02, 2.0 * SPEED)
    for name in (
        "load",
        "slope_x",
        "slope_y",
        "minimum_film_thickness",
        "maximum_pressure",
        "leading_flow",
        "trailing_flow",
        "side_flow",
        "friction_torque",
    ):
        assert getattr(scaled, name) == pytest.approx(getattr(solved, name), rel=1e-8), name
    assert scaled.stiffness == pytest.approx(solved.stiffness, rel=1e-7)
    assert scaled.damping == pytest.approx(solved.damping, rel=1e-7)
    assert scaled.pressure() == pytest.approx(solved.film.pressure, abs=1e-7 * solved.maximum_pressure)


def test_the_mesh_leaves_two_parts_in_a_thousand_on_the_load():
    usual = pad_state(PAD, 50e-6, VISCOSITY, SPEED)
    fine = [pad_state(PAD, 50e-6, VISCOSITY, SPEED, intervals=n, degree=12).load for n in (64, 128)]
    limit = fine[1] + (fine[1] - fine[0]) / 3.0
    assert usual.load == pytest.approx(limit, rel=2e-3)


def test_a_line_pivot_keeps_the_radial_slope_and_balances_about_the_line():
    line = ThrustPad(0.19, 0.375, math.radians(36.0), 0.29, 0.6, Pivot.LINE)
    state = pad_state(line, 50e-6, VISCOSITY, SPEED)
    moments = line.from_pivot().T @ state.film.forces
    assert state.slope_x == 0.0
    assert abs(moments[2]) < 1e-9 * state.load
    assert condensed(state, 0.0).real == pytest.approx(2.0 * state.load / 50e-6, rel=1e-6)


def test_heavy_pads_do_not_tilt_and_light_ones_follow(films):
    """With much inertia the tilts stand still and the pad has the stiffness of its height alone."""
    from babbitt.kinds.thrust.state import TiltInertia

    state = films.state(50e-6)
    still = condensed(state, 4.0 * SPEED, TiltInertia(1e9, 1e9))
    assert still.real == pytest.approx(state.stiffness[0, 0], rel=1e-4)
    assert still.imag == pytest.approx(4.0 * SPEED * state.damping[0, 0], rel=1e-4)


@pytest.mark.parametrize("fraction", [0.3, 0.45, 0.5])
def test_a_plane_pad_with_its_pivot_not_behind_the_middle_is_refused(fraction):
    with pytest.raises(InputError) as refused:
        carrying(ThrustPad(0.19, 0.375, math.radians(36.0), 0.29, fraction), VISCOSITY, SPEED)
    assert refused.value.code == "E202"


def test_a_crowned_pad_balances_in_the_middle():
    """Crowned pads carry both ways round; flat ones do not."""
    pad = ThrustPad(0.19, 0.375, math.radians(36.0), 0.287, 0.5, crown=15e-6)
    films = carrying(pad, VISCOSITY, SPEED)
    state = films.state(films.height_for(20e3))
    assert state.load == pytest.approx(20e3, rel=1e-8)
    assert state.minimum_film_thickness > 0.0
    assert float(films.load(np.array(state.height))) == pytest.approx(20e3, rel=1e-3)


@pytest.mark.parametrize("fraction", [0.5, 0.6])
@pytest.mark.parametrize("pivot", [Pivot.POINT, Pivot.LINE])
def test_a_crowned_pad_balances_at_films_thinner_than_its_crown(pivot, fraction):
    """There the plane of the pad cuts the runner at a corner and its face does not; loads rise as films thin."""
    pad = replace(PAD, crown=20e-6, pivot=pivot, pivot_fraction=fraction)
    states = [pad_state(pad, height, VISCOSITY, SPEED) for height in (50e-6, 20e-6, 10e-6, 5e-6)]
    for state in states:
        forces = pad.from_pivot().T @ state.film.forces
        moments = forces[list(pad.free_tilts)]
        assert np.abs(moments).max() < 1e-9 * state.load * (pad.outer_radius - pad.inner_radius)
        assert state.minimum_film_thickness > 0.0
    thin = states[-1]
    assert (pad.corners() @ np.array([thin.height, thin.slope_x, thin.slope_y])).min() < 0.0
    loads = [state.load for state in states]
    assert loads == sorted(loads)


@pytest.mark.parametrize("face", [TaperedFace(40e-6, 0.7), SteppedFace(40e-6, 0.7)])
def test_a_fixed_pad_carries_one_way_and_mirrored_the_other(face):
    pad = ThrustPad(0.19, 0.375, math.radians(36.0), 0.29, 0.5, Pivot.FIXED, face)
    films = carrying(pad, VISCOSITY, SPEED)
    state = films.state(films.height_for(30e3))
    assert state.load == pytest.approx(30e3, rel=1e-8)
    assert state.minimum_film_thickness == pytest.approx(state.height, rel=1e-9)
    assert condensed(state, 0.0).real == pytest.approx(-float(films.slope(np.array(state.height))), rel=5e-3)
    again = pad.mirrored().mirrored()
    assert pad_state(again, state.height, VISCOSITY, SPEED).load == pytest.approx(30e3, rel=1e-8)
    assert pad_state(pad.mirrored(), state.height, VISCOSITY, SPEED).load < 0.2 * 30e3


def test_a_wide_step_pad_has_the_load_of_rayleigh():
    """Optimum step: h1/h2 = 1.866 over 0.718 of the length, W h2^2/(mu U B^2 L) = 0.2063 (Rayleigh 1918)."""
    radius, length, land, ratio, share = 20.0, 0.02, 20e-6, 1.866, 0.718
    pad = ThrustPad(
        radius - 0.2,
        radius + 0.2,
        length / radius,
        radius,
        0.5,
        Pivot.FIXED,
        SteppedFace((ratio - 1.0) * land, share),
    )
    film = pad_state(pad, land, 0.03, 5.0 / radius, degree=24).film
    middle = film.pressure[:, film.radius.size // 2]
    found = np.trapezoid(middle, film.theta * radius) * land**2 / (0.03 * 5.0 * length**2)
    # two straight slopes meet at the step, where the flow of both gaps is the same
    k, s, n = ratio, share, 1.0 - share
    summit = 6.0 * (k - 1.0) * s * n / (k**3 * n + s)
    assert found == pytest.approx(0.5 * summit, rel=2e-3)
    assert 0.5 * summit == pytest.approx(0.2063, rel=3e-4)


def test_the_wide_plane_pad_has_the_load_of_the_closed_form():
    """T11: W h2^2/(mu U B^2 L) = 6 [ln(1 + K) - 2 K/(K + 2)]/K^2 at mid radius, 0.160243 for h1/h2 = 2.19."""
    radius, length, land, ratio = 50.0, 0.02, 20e-6, 2.19
    pad = SectorPad(radius - 0.3, radius + 0.3, length / radius, 0.03, 5.0 / radius)
    slope = -(ratio - 1.0) * land / length
    film = sector_film(pad, PlaneMotion(ratio * land, 0.0, slope), intervals=256, degree=24)
    middle = film.pressure[:, film.radius.size // 2]
    found = np.trapezoid(middle, film.theta * radius) * land**2 / (0.03 * 5.0 * length**2)
    k = ratio - 1.0
    closed = 6.0 * (math.log(ratio) - 2.0 * k / (k + 2.0)) / k**2
    assert closed == pytest.approx(0.160243, abs=1e-6)
    assert found == pytest.approx(closed, rel=1e-4)


def exponential_load(intervals: int) -> float:
    """T12: square pad under h = h1 e^(-a x), h1/h2 = 2.2, as a thin ring far out; W h2^2/(mu U B^2 L)."""
    radius, length, land, ratio = 50.0, 0.02, 20e-6, 2.2
    along = np.linspace(0.0, 1.0, 8 * intervals + 1)
    rows = land * (ratio ** (1.0 - along) - 1.0)
    pad = SectorPad(
        radius - length / 2,
        radius + length / 2,
        length / radius,
        0.03,
        5.0 / radius,
        form=tuple((float(value), float(value)) for value in rows),
    )
    film = sector_film(pad, PlaneMotion(land), intervals=intervals, degree=12)
    return film.load * land**2 / (0.03 * 5.0 * length**3)


def exponential_series() -> float:
    """Fourier series across, exact along: P'' - 3 a P' - k^2 P = -(6 mu U a/h1^2) c_n e^(2 a x)."""
    a, total = math.log(2.2), 0.0
    for n in range(1, 400, 2):
        k, c = n * math.pi, 4.0 * (-1.0) ** ((n - 1) // 2) / (n * math.pi)
        particular = -6.0 * a * c / 2.2**2 / (4.0 * a * a - 6.0 * a * a - k * k)
        root = math.sqrt(9.0 * a * a + 4.0 * k * k)
        up, down = 0.5 * (3.0 * a + root), 0.5 * (3.0 * a - root)
        # grow = A e^(up (x - 1)), fall = B e^(down x); P(0) = P(1) = 0
        matrix = np.array([[math.exp(-up), 1.0], [1.0, math.exp(down)]])
        grow, fall = np.linalg.solve(matrix, -particular * np.array([1.0, math.exp(2.0 * a)]))
        along = grow * (1.0 - math.exp(-up)) / up + fall * (math.exp(down) - 1.0) / down
        along += particular * (math.exp(2.0 * a) - 1.0) / (2.0 * a)
        total += along * 2.0 * (-1.0) ** ((n - 1) // 2) / k
    return total


def test_the_exponential_film_meets_its_series_with_second_order():
    exact = exponential_series()
    assert exact == pytest.approx(0.074707, abs=2e-6)
    loads = [exponential_load(n) for n in (16, 32, 64)]
    assert loads[1] == pytest.approx(exact, rel=6e-3)
    assert (loads[1] - loads[0]) / (loads[2] - loads[1]) == pytest.approx(4.0, rel=0.1)
    assert loads[2] + (loads[2] - loads[1]) / 3.0 == pytest.approx(exact, rel=2e-4)


def test_turbulence_carries_more_and_stiffness_stays_the_derivative():
    fast = 40.0 * SPEED
    law = FilmTurbulence(NG_PAN, 870.0, 500.0, 1000.0)
    laminar = pad_state(PAD, 120e-6, 0.01, fast)
    turbulent = ThrustPad(0.19, 0.375, math.radians(36.0), 0.29, 0.6, turbulence=law)
    state = pad_state(turbulent, 120e-6, 0.01, fast)
    assert state.load > 1.1 * laminar.load
    assert state.friction_torque > 1.1 * laminar.friction_torque
    step = 1e-8
    above, below = (pad_state(turbulent, 120e-6 + side * step, 0.01, fast).load for side in (1.0, -1.0))
    assert condensed(state, 0.0).real == pytest.approx((below - above) / (2.0 * step), rel=1e-4)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"inner_radius": 0.4}, "radii"),
        ({"extent": 0.0}, "extent"),
        ({"pivot_radius": 0.18}, "pivot_radius"),
        ({"pivot_fraction": 1.0}, "pivot_fraction"),
    ],
)
def test_pads_that_cannot_be_are_refused(change, says):
    whole = {
        "inner_radius": 0.19,
        "outer_radius": 0.375,
        "extent": 0.6,
        "pivot_radius": 0.29,
        "pivot_fraction": 0.6,
    }
    with pytest.raises(InputError, match=says):
        ThrustPad(**(whole | change))


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        (lambda: replace(PAD, inner_radius=0.4), "radii of the pad"),
        (lambda: replace(PAD, extent=7.0), "extent of the pad"),
        (lambda: replace(PAD, pivot_radius=0.18), "it must lie on the pad"),
        (lambda: replace(PAD, pivot_fraction=1.2), "pivot_fraction is 1.2"),
        (lambda: replace(bearing(), number=1), "a whole number from 2"),
        (lambda: replace(bearing(), number=10), "10 pads of 36 deg overlap"),
        (lambda: bearing(ring=0.0), "stiffness of the ring"),
        (lambda: bearing(tilt=-1e-6), "tilt of the housing"),
        (lambda: bearing(height_errors=(1e-6,)), "1 pad heights are given for 8 pads"),
        (lambda: pad_state(PAD, 0.0, VISCOSITY, SPEED), "film at the pivot is 0 m"),
    ],
)
def test_pads_that_cannot_be_laid_out_are_refused(wrong, said):
    """Case files are refused before, with the line of the field; this is what programs meet."""
    with pytest.raises(InputError, match=said) as caught:
        wrong()
    assert caught.value.code == "E201"


def test_pads_that_just_fit_are_laid_out():
    assert replace(bearing(), number=9).number == 9
