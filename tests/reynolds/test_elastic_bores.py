"""Compliances of bores against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from babbitt.core.notices import InputError
from babbitt.reynolds.deformation.compliance import BoreGrid, ColumnLiner, as_field, total_displacement
from babbitt.reynolds.deformation.compliance_matrix import ComplianceMatrix
from babbitt.reynolds.deformation.elastic_ring import ElasticRing, RingSupport
from babbitt.reynolds.deformation.half_space import HalfSpace, patch_displacement
from babbitt.reynolds.heat.heat_model import BushRing
from babbitt.reynolds.heat.thermal_growth import RingGrowth
from babbitt.reynolds.model import JournalFilm, grooved_bore
from babbitt.reynolds.surface.unwrapped_mesh import field_at

E, NU = 2.1e11, 0.3
A, B = 0.05, 0.07
BORE = BoreGrid(A, 0.04, 180, 9)


def wave(harmonic: int) -> np.ndarray:
    return np.repeat(np.cos(harmonic * BORE.theta)[:, None], BORE.columns, axis=1)


def test_grid_is_that_of_the_film() -> None:
    film = JournalFilm(2 * A, 0.04, 5e-5, 0.02, 100.0, grooved_bore((0.0,), 0.3))
    values = np.cos(BORE.theta)[:, None] + BORE.z[None, :]
    assert field_at(film, as_field(values), BORE.theta, BORE.z) == pytest.approx(values, abs=1e-15)
    assert (BORE.z == -BORE.z[::-1]).all()
    assert BORE.shares.sum() == pytest.approx(1.0)


def test_liner_in_uniaxial_strain() -> None:
    """With nu = 0 a column is a bar; the constrained modulus is lambda + 2 mu."""
    assert ColumnLiner.of_layer(2e-3, 5e10, 0.0).compliance == pytest.approx(2e-3 / 5e10)
    lam, mu = E * NU / ((1 + NU) * (1 - 2 * NU)), E / (2 * (1 + NU))
    assert ColumnLiner.of_layer(1e-3, E, NU).compliance == pytest.approx(1e-3 / (lam + 2 * mu))


def test_ring_under_even_pressure_is_that_of_lame() -> None:
    free = (1 + NU) / E * A / (B**2 - A**2) * ((1 - 2 * NU) * A**2 + B**2)
    assert ElasticRing(A, B, E, NU).response(0) == pytest.approx(free, rel=1e-12)
    lam, mu = E * NU / ((1 + NU) * (1 - 2 * NU)), E / (2 * (1 + NU))
    factor = 1.0 / (2 * (lam + mu) / B**2 + 2 * mu / A**2)
    clamped = factor * (1 / A - A / B**2)
    assert ElasticRing(A, B, E, NU, RingSupport.CLAMPED).response(0) == pytest.approx(clamped, rel=1e-12)


@pytest.mark.parametrize("harmonic", [2, 3, 5])
def test_thin_ring_bends_as_a_curved_beam(harmonic: int) -> None:
    """u = q R^4 / (D (n^2 - 1)^2), inextensional (Timoshenko); the error falls with h/R."""
    errors = []
    for thin in (0.02, 0.01, 0.005):
        radius, thickness = A * (1 + thin / 2), A * thin
        plate = E * thickness**3 / (12 * (1 - NU**2))
        beam = (A / radius) * radius**4 / (plate * (harmonic**2 - 1) ** 2)
        errors.append(ElasticRing(A, A + thickness, E, NU).response(harmonic) / beam - 1.0)
    assert abs(errors[-1]) < 0.01
    assert abs(errors[2]) < 0.6 * abs(errors[1]) < 0.4 * abs(errors[0])


@pytest.mark.parametrize("support", list(RingSupport))
def test_short_waves_see_a_half_plane(support: RingSupport) -> None:
    """Pressure cos(k x) on a half-plane: u = 2 (1 - nu^2) / (E k)."""
    n = 300
    assert ElasticRing(A, B, E, NU, support).response(n) == pytest.approx(2 * (1 - NU**2) * A / (E * n), rel=5e-3)


def test_thin_bonded_ring_is_a_column() -> None:
    ring = ElasticRing(A, A * 1.001, E, NU, RingSupport.CLAMPED)
    column = ColumnLiner.of_layer(A * 1e-3, E, NU).compliance
    for harmonic in (0, 2, 10):
        assert ring.response(harmonic) == pytest.approx(column, rel=5e-3)


def test_clamped_ring_is_the_stiffer_one_and_no_special_material_breaks_it() -> None:
    for nu in (0.0, 0.3, 0.49):  # n = 2 with nu = 0: one balance vanishes at s = 3
        for n in (0, 2, 3, 40):
            free, clamped = (ElasticRing(A, B, E, nu, support).response(n) for support in RingSupport)
            assert 0.0 < clamped <= free * (1 + 1e-9)


def test_ring_with_no_poisson_ratio_is_the_limit_of_a_small_one() -> None:
    small, none = (ElasticRing(A, B, E, nu).response(2) for nu in (1e-7, 0.0))
    assert none == pytest.approx(small, rel=1e-5)


def test_load_alone_only_shifts_the_ring() -> None:
    assert np.abs(ElasticRing(A, B, E, NU).displacement(BORE, 1e6 * wave(1))).max() < 1e-18


def test_ring_displaces_harmonic_by_harmonic_and_by_the_mean_over_the_width() -> None:
    ring = ElasticRing(A, B, E, NU)
    parabola = 1.0 - (2 * BORE.z / BORE.width) ** 2
    found = ring.displacement(BORE, 1e6 * wave(3) * parabola[None, :])
    assert found == pytest.approx(1e6 * ring.response(3) * wave(3) * float(parabola @ BORE.shares), abs=1e-15)


@settings(max_examples=25)
@given(st.lists(st.floats(-1.0, 1.0), min_size=6, max_size=6), st.sampled_from(range(4)))
def test_pressure_does_work_on_whatever_gives_way(heights: list[float], which: int) -> None:
    """And displacements are linear in it."""
    around = sum(height * np.cos(n * BORE.theta + n) for n, height in enumerate(heights))
    pressure = 1e6 * around[:, None] * (1.1 - (2 * BORE.z / BORE.width) ** 2)[None, :]
    model = (
        ColumnLiner(1e-13), ElasticRing(A, B, E, NU), ElasticRing(A, B, E, NU, RingSupport.CLAMPED),
        HalfSpace(E, NU),
    )[which]  # fmt: skip
    found = model.displacement(BORE, pressure)
    assert (pressure * found * BORE.shares).sum() >= -1e-12
    assert model.displacement(BORE, -2.0 * pressure) == pytest.approx(-2.0 * found, abs=1e-18)


def test_square_on_a_half_space() -> None:
    """Love: 8 a ln(1 + sqrt 2) in the middle of a square of side 2 a, half of it at its corners."""
    half = np.array(0.01)
    middle, corner = (float(patch_displacement(np.array(at), np.array(at), 0.01, half)) for at in (0.0, 0.01))
    assert middle == pytest.approx(0.08 * math.log(1 + math.sqrt(2)), rel=1e-12)
    assert corner == pytest.approx(0.5 * middle, rel=1e-12)
    far = float(patch_displacement(np.array(0.0), np.array(3.0), 0.01, half))
    assert far == pytest.approx(0.02**2 / 3.0, rel=1e-5)  # a point load
    assert patch_displacement(np.array(-0.2), np.array(0.1), 0.01, half) == pytest.approx(
        patch_displacement(np.array(0.2), np.array(-0.1), 0.01, half), rel=1e-10
    )


def test_half_space_adds_up_its_patches() -> None:
    pressure = np.zeros((BORE.rows, BORE.columns))
    pressure[0, 4] = pressure[50, 0] = 1e6  # one in the middle, one at the side: half as wide
    found = HalfSpace(E, NU).displacement(BORE, pressure)
    unit, step = (1 - NU**2) / (math.pi * E), A * BORE.theta[1]
    cell = BORE.width / (BORE.columns - 1)
    row, column = 170, 6
    here = patch_displacement(
        np.array(A * BORE.theta[10]), BORE.z[column] - BORE.z[4], step / 2, np.array(cell / 2)
    )
    side = patch_displacement(
        np.array(A * BORE.theta[60]), BORE.z[column] - BORE.z[0] - cell / 4, step / 2, np.array(cell / 4)
    )
    assert found[row, column] == pytest.approx(1e6 * unit * float(here + side), rel=1e-9)


def test_even_pressure_all_around_is_one_rectangle() -> None:
    found = HalfSpace(E, NU).displacement(BORE, np.full((BORE.rows, BORE.columns), 1e6))
    whole = float(patch_displacement(np.array(0.0), np.array(0.0), math.pi * A, np.array(0.5 * BORE.width)))
    assert found[:, BORE.columns // 2] == pytest.approx(1e6 * (1 - NU**2) / (math.pi * E) * whole, rel=1e-4)


def test_matrix_of_a_ring_acts_as_the_ring() -> None:
    ring, count = ElasticRing(A, B, E, NU), 60
    angles = np.arange(count) * (2 * math.pi / count) + 0.01
    apart = angles[:, None] - angles[None, :]
    rows = sum(_sector(n, count) * ring.response(n) * np.cos(n * apart) for n in range(60))
    matrix = ComplianceMatrix(tuple(angles), tuple(map(tuple, rows)))
    pressure = 1e6 * (1.0 + wave(2) + 0.5 * wave(3))
    own, given_ = ring.displacement(BORE, pressure), matrix.displacement(BORE, pressure)
    assert given_ == pytest.approx(own, abs=0.01 * np.abs(own).max())


def _sector(n: int, count: int) -> float:
    """Harmonic of a unit pressure on one of equal sectors."""
    return 1.0 / count if n == 0 else 2.0 / (math.pi * n) * math.sin(math.pi * n / count)


def test_matrix_takes_the_mean_over_its_sectors() -> None:
    uneven = ComplianceMatrix((0.1, 1.0, 2.5, 4.0), tuple(tuple(np.eye(4)[i] * 1e-12) for i in range(4)))
    even = uneven.displacement(BORE, np.full((BORE.rows, BORE.columns), 2e6))
    assert even == pytest.approx(np.full_like(even, 2e-6), rel=1e-12)


@pytest.mark.parametrize(
    ("angles", "rows"),
    [((0.0, 1.0, 2.0), ((0.0,) * 3,) * 2), ((0.0, 2.0, 1.0), ((0.0,) * 3,) * 3),
     ((0.0, 3.0, 7.0), ((0.0,) * 3,) * 3), ((0.0, 1.0, 2.0), ((0.0, 0.0, math.nan),) * 3)],
)  # fmt: skip
def test_unusable_matrices(angles: tuple[float, ...], rows: tuple[tuple[float, ...], ...]) -> None:
    with pytest.raises(InputError):
        ComplianceMatrix(angles, rows)


@pytest.mark.parametrize(("modulus", "ratio"), [(0.0, 0.3), (math.nan, 0.3), (1e11, 0.5), (1e11, -0.1)])
def test_unusable_solids(modulus: float, ratio: float) -> None:
    for make in (lambda: ColumnLiner.of_layer(1e-3, modulus, ratio), lambda: HalfSpace(modulus, ratio),
                 lambda: ElasticRing(A, B, modulus, ratio)):  # fmt: skip
        with pytest.raises(InputError):
            make()


def test_compliances_add_up() -> None:
    pressure = 1e6 * (1.0 + wave(2))
    both = (ColumnLiner(1e-13), ElasticRing(A, B, E, NU))
    apart = sum(one.displacement(BORE, pressure) for one in both)
    assert total_displacement(both, BORE, pressure) == pytest.approx(apart, rel=1e-12)
    assert not total_displacement((), BORE, pressure).any()


BUSH = BushRing((A, B), (50.0,), 200.0, 293.15)
UNEVEN = 80.0 + 30.0 * np.cos(BORE.theta) + 20.0 * np.cos(2 * BORE.theta) + 5.0 * np.sin(3 * BORE.theta + 0.4)


def flux_into(walls: BushRing, temperature: np.ndarray) -> np.ndarray:
    """Harmonics from 1 on of the heat flux into a bore, W/m2."""
    harmonics = np.fft.rfft(temperature)
    harmonics[0] = 0.0
    harmonics[1:] /= walls.impedances(harmonics.size - 1)[1:]
    return np.fft.irfft(harmonics, temperature.size)


def curvature(u: np.ndarray) -> np.ndarray:
    """Change of the curvature of a circle by u, times its radius squared."""
    second = np.fft.irfft(-np.fft.rfft(u) * np.arange(u.size // 2 + 1) ** 2, u.size)
    return u + second


def above_first(values: np.ndarray) -> np.ndarray:
    """Harmonics from 2 on."""
    harmonics = np.fft.rfft(values)
    harmonics[:2] = 0.0
    return np.fft.irfft(harmonics, values.size)


def test_free_ring_bends_by_its_temperature_gradient() -> None:
    """A strip without stress: its curvature changes by (u + u'') / a^2 = alpha (T / a - dT/dr)."""
    u = RingGrowth(BUSH, 0, 1.2e-5).distortion(BORE, UNEVEN)[:, 0]
    bent = 1.2e-5 * (UNEVEN / A + flux_into(BUSH, UNEVEN) / 50.0)
    assert curvature(u) / A**2 == pytest.approx(above_first(bent), abs=1e-10)
    assert np.abs(np.fft.rfft(u)[:2]).max() < 1e-15  # neither mean nor shift


def test_bush_behind_its_liner_bends_by_the_gradient_that_the_liner_leaves() -> None:
    """Through the liner T = P r^m + Q r^-m from temperature and flux of the bore; the bush then as above."""
    walls = BushRing((A, 0.052, B, 0.09), (12.0, 50.0, 15.0), 200.0, 293.15)
    u = RingGrowth(walls, 1, 1.2e-5).distortion(BORE, UNEVEN)[:, 0]
    hot, passing = np.fft.rfft(UNEVEN), np.fft.rfft(flux_into(walls, UNEVEN))
    m = np.arange(1, 6)
    s, a, k = m * math.log(0.052 / A), A, 12.0
    behind, beyond = np.zeros_like(hot), np.zeros_like(hot)
    behind[1:6] = hot[1:6] * np.cosh(s) - passing[1:6] * a / (k * m) * np.sinh(s)
    beyond[1:6] = (passing[1:6] * a * np.cosh(s) - hot[1:6] * k * m * np.sinh(s)) / 0.052
    inside, flux = (np.fft.irfft(one, BORE.rows) for one in (behind, beyond))
    bent = 1.2e-5 * (inside / 0.052 + flux / 50.0)
    assert curvature(u) / 0.052**2 == pytest.approx(above_first(bent), abs=1e-10)


def test_rings_within_pass_on_what_conduction_leaves() -> None:
    walls = BushRing((A, 0.052, B), (12.0, 50.0), 200.0, 293.15)
    shares, impedances = walls.behind(1, 40)
    assert impedances == pytest.approx(BushRing((0.052, B), (50.0,), 200.0, 293.15).impedances(40))
    resistance = 0.052 * math.log(0.052 / A) / 12.0  # of the liner for the mean, over the flux behind it
    assert shares[0] == pytest.approx(impedances[0] / (impedances[0] + resistance), rel=1e-12)
    assert (np.diff(shares[1:]) < 0.0).all()
    assert (BUSH.behind(0, 5)[0] == 1.0).all()
    insulated = BushRing((A, 0.052, B), (12.0, 50.0), 0.0, 293.15)
    assert insulated.behind(1, 3)[0][0] == 1.0  # no mean flux, no drop
    thick = BushRing((1e-4, 0.2, 0.3), (1.0, 50.0), 200.0, 293.15).behind(1, 120)[0]
    assert np.isfinite(thick).all()


@pytest.mark.parametrize("conductivity", [1.0, 10.0, 400.0])
def test_bush_is_bent_by_its_own_conductivity_and_hardly_by_a_skin(conductivity: float) -> None:
    """A thin layer outside or inside: the distortion tends to that without it in proportion to its thickness."""
    alone = RingGrowth(BUSH, 0, 1.2e-5).distortion(BORE, UNEVEN)
    around, within = [], []
    for skin in (5e-4, 5e-5, 5e-6):
        housing = BushRing((A, B, B + skin), (50.0, conductivity), 200.0, 293.15)
        liner = BushRing((A, A + skin, B), (conductivity, 50.0), 200.0, 293.15)
        around.append(np.abs(RingGrowth(housing, 0, 1.2e-5).distortion(BORE, UNEVEN) - alone).max())
        within.append(np.abs(RingGrowth(liner, 1, 1.2e-5).distortion(BORE, UNEVEN) - alone).max())
    largest = np.abs(alone).max()
    assert around[0] < 0.2 * largest
    assert within[0] < 0.6 * largest  # 0.5 mm of 1 W/(m K) are 25 mm of the bush
    for off in (around, within):
        assert off[2] < 0.15 * off[1] < 0.15 * 0.2 * max(off[0], 1e-12)


def test_unusable_growth() -> None:
    for ring, expansion in ((1, 1e-5), (-1, 1e-5), (0, math.nan)):
        with pytest.raises(InputError):
            RingGrowth(BUSH, ring, expansion)
