"""Film of a thrust pad: closed forms on the sector, and what the metric must leave true."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from babbitt.core.notices import InputError
from babbitt.reynolds.model import Cavitation
from babbitt.reynolds.sector.sector import PlaneMotion, SectorPad, sector_film

PAD = SectorPad(0.1, 0.2, math.radians(45.0), 0.03, 100.0)
TILTED = PlaneMotion(100e-6, 0.0, -2e-4)


def squeeze_force(pad: SectorPad, gap: float) -> float:
    """Force over closing speed of parallel faces: div grad p = 12 mu h' / h^3 by a sine series in theta."""
    inner, outer, source = pad.inner_radius, pad.outer_radius, 12.0 * pad.viscosity / gap**3
    total = 0.0
    for k in range(1, 400, 2):
        power, weight = k * math.pi / pad.extent, 4.0 * source / (k * math.pi)
        # r^2 R'' + r R' - power^2 R = -weight r^2 with R = 0 at both radii, powers of r/outer against overflow
        particular = weight / (power**2 - 4.0)
        ratio = inner / outer
        matrix = np.array([[1.0, ratio**power], [ratio**power, 1.0]])
        rising, falling = np.linalg.solve(matrix, -particular * np.array([outer**2, inner**2]))
        radial = particular * (outer**4 - inner**4) / 4.0
        radial += rising * outer**2 * (1.0 - ratio ** (power + 2.0)) / (power + 2.0)
        radial += falling * inner**2 * (1.0 - ratio ** (power - 2.0)) / (power - 2.0)
        total += radial * 2.0 / power
    return total


def test_squeezed_parallel_faces_have_the_damping_of_the_sine_series():
    still = SectorPad(0.1, 0.2, math.radians(45.0), 0.03, 1e-6)
    film = sector_film(still, PlaneMotion(100e-6), intervals=128, degree=12)
    assert film.damping[0, 0] == pytest.approx(squeeze_force(still, 100e-6), rel=2e-4)


@settings(max_examples=15)
@given(tilt=st.floats(-0.7, -0.2), twist=st.floats(-0.25, 0.25))
def test_a_film_of_one_shape_carries_with_the_square_of_its_thickness(tilt, twist):
    """F(s a) = F(a) / s^2, so that K a = 2 F: at equilibrium K = 2 W / h."""
    slope_y = tilt * 100e-6 / 0.15
    gap = PlaneMotion(100e-6, twist * 100e-6 / 0.2, slope_y)
    film = sector_film(PAD, gap)
    motion = np.array([gap.height, gap.slope_x, gap.slope_y])
    assert film.stiffness @ motion == pytest.approx(2.0 * film.forces, rel=1e-9)


def test_coefficients_are_the_derivatives_of_the_forces():
    film = sector_film(PAD, TILTED)
    base = np.array([TILTED.height, TILTED.slope_x, TILTED.slope_y])
    for axis, step in enumerate((1e-8, 1e-7, 1e-7)):
        change = np.eye(3)[axis] * step
        above, below = (sector_film(PAD, PlaneMotion(*(base + side * change))).forces for side in (1.0, -1.0))
        assert film.stiffness[:, axis] == pytest.approx((below - above) / (2.0 * step), rel=1e-6)
        above, below = (sector_film(PAD, TILTED, PlaneMotion(*(side * change))).forces for side in (1.0, -1.0))
        assert film.damping[:, axis] == pytest.approx((below - above) / (2.0 * step), rel=1e-9)


def test_load_converges_with_the_square_of_the_step():
    loads = [sector_film(PAD, TILTED, intervals=n, degree=12).load for n in (16, 32, 64)]
    assert (loads[1] - loads[0]) / (loads[2] - loads[1]) == pytest.approx(4.0, rel=0.03)


def test_oil_is_conserved():
    film = sector_film(PAD, TILTED)
    out = film.inner_flow + film.outer_flow + film.trailing_flow
    assert out == pytest.approx(film.leading_flow, rel=1e-12)
    assert film.mass_balance_error < 1e-12


def test_plane_faces_in_parallel_carry_nothing_and_shear_like_couette():
    film = sector_film(PAD, PlaneMotion(100e-6))
    polar = PAD.extent * (PAD.outer_radius**4 - PAD.inner_radius**4) / 4.0
    assert abs(film.load) < 1e-9 * sector_film(PAD, TILTED).load
    assert film.friction_torque == pytest.approx(PAD.viscosity * PAD.angular_speed * polar / 100e-6, rel=1e-12)


def test_a_thin_ring_far_out_is_a_plane_slider():
    """Length 20 mm, width 20 mm, gap 2 : 1; the plane pad of the journal engine's tests in rectangular limit."""
    radius, length = 20.0, 0.02
    extent = length / radius
    pad = SectorPad(radius - 0.01, radius + 0.01, extent, 0.03, 5.0 / radius)
    slope = -20e-6 / length
    # h = 40 um at the leading edge, 20 um at the trailing edge; Y = r sin(theta) is the way along the pad
    film = sector_film(pad, PlaneMotion(40e-6, 0.0, slope), intervals=96, degree=12)
    assert film.load * (20e-6 / length) ** 2 / (0.03 * 5.0 * 0.02) == pytest.approx(square_slider(2.0), rel=5e-4)


def square_slider(ratio: float) -> float:
    """Load W h_2^2 / (mu U L^2 B) of a square plane slider, by a Fourier series across and a dense solve along."""
    n, total = 2000, 0.0
    x = np.linspace(0.0, 1.0, n + 1)
    h = ratio - (ratio - 1.0) * x
    face = (0.5 * (h[1:] + h[:-1])) ** 3
    from scipy.linalg import solve_banded

    for k in range(1, 40, 2):
        wave = (k * math.pi) ** 2
        bands = np.zeros((3, n - 1))
        bands[1] = (face[1:] + face[:-1]) * n**2 + wave * h[1:-1] ** 3
        bands[0, 1:] = bands[2, :-1] = -face[1:-1] * n**2
        right = 6.0 * (ratio - 1.0) * np.ones(n - 1) * 4.0 / (k * math.pi)
        total += solve_banded((1, 1), bands, right).sum() / n * 2.0 / (k * math.pi)
    return total


def test_a_diverging_pad_breaks_its_film_and_keeps_its_oil():
    pad = SectorPad(0.1, 0.2, math.radians(45.0), 0.03, 100.0, cavitation=Cavitation.MASS_CONSERVING,
                    leading_pressure=1e5)  # fmt: skip
    film = sector_film(pad, PlaneMotion(60e-6, 0.0, 4e-4))
    assert film.liquid_fraction.min() < 0.9
    assert film.pressure.min() >= 0.0
    assert film.inner_flow + film.outer_flow + film.trailing_flow == pytest.approx(film.leading_flow, rel=1e-10)


def test_touching_faces_are_refused():
    with pytest.raises(InputError, match="touch"):
        sector_film(PAD, PlaneMotion(10e-6, 0.0, -2e-4))


def test_oil_pressed_in_over_the_leading_edge_does_not_depend_on_the_grid():
    pad = SectorPad(0.1, 0.2, math.radians(45.0), 0.03, 100.0, leading_pressure=2e6)
    flows = [
        sector_film(pad, TILTED, intervals=n, degree=d).leading_flow for n, d in ((64, 8), (128, 12), (256, 16))
    ]
    assert abs(flows[2] - flows[1]) < 0.6 * abs(flows[1] - flows[0])
    assert flows[1] == pytest.approx(flows[2], rel=0.01)


def test_a_diverging_pad_draws_in_nothing_at_its_sides_and_tells_what_it_invents():
    diverging = PlaneMotion(60e-6, 0.0, 4e-4)
    kept, invented = (
        sector_film(SectorPad(0.1, 0.2, math.radians(45.0), 0.03, 100.0, cavitation=rule), diverging)
        for rule in (Cavitation.MASS_CONSERVING, Cavitation.REYNOLDS)
    )
    for film in (kept, invented):
        assert min(film.inner_flow, film.outer_flow) >= -1e-15
    out = kept.inner_flow + kept.outer_flow + kept.trailing_flow
    assert out == pytest.approx(kept.leading_flow, rel=1e-10)
    assert invented.trailing_flow == pytest.approx(invented.leading_flow, rel=1e-6)
    assert invented.friction_torque == pytest.approx(kept.friction_torque, rel=0.02)
