"""Temperature in the film of a thrust pad: the energy kernels in the metric of a ring."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.core.notices import InputError
from babbitt.reynolds.heat.heat_model import FilmHeat, HeatGrid
from babbitt.reynolds.oil.turbulence import NG_PAN, FilmTurbulence
from babbitt.reynolds.sector.sector import PlaneMotion, SectorPad, sector_film
from babbitt.reynolds.sector.thermal_sector import ThermalSectorState

COLD, CAPACITY = 318.15, 1.7e6
PAD = SectorPad(0.1, 0.2, math.radians(45.0), 0.03, 100.0)
ONE_VISCOSITY = FilmHeat(lambda t: 0.03 + 0.0 * t, CAPACITY, 0.13, COLD, carry_over=0.0)
TILTED = np.array([100e-6, 0.0, -2e-4])


def settled(pad, heat, motion, intervals=64, degree=8):
    sector = ThermalSectorState.of(pad, heat, motion[0], intervals, degree)
    for _ in range(80):
        if sector.advance(motion) < 1e-7:
            break
    return sector.finish(motion)


def test_oil_between_parallel_faces_warms_with_the_square_of_the_radius():
    """Bulk temperature dT/d theta = 2 mu omega r^2 / (rho c h^2): friction mu U^2/h over the flow U h/2."""
    heat = replace(ONE_VISCOSITY, grid=HeatGrid(resolved=True))
    film, warmth, _ = settled(PAD, heat, np.array([100e-6, 0.0, 0.0]))
    layer = heat.grid.thicknesses()
    carried = 2.0 * warmth.layers * layer  # share of each layer in the flow of a runner past a pad
    bulk = warmth.temperature @ carried
    rise = (bulk[-10] - bulk[10]) / (film.theta[-10] - film.theta[10])
    closed = 2.0 * 0.03 * 100.0 * warmth.radius**2 / (CAPACITY * 100e-6**2)
    assert rise[1:-1] == pytest.approx(closed[1:-1], rel=1e-6)  # the outer columns have the sides with them
    friction = 0.03 * 100.0**2 / 100e-6 * PAD.extent * (0.2**4 - 0.1**4) / 4.0
    assert film.friction_torque * 100.0 == pytest.approx(friction, rel=1e-9)
    assert warmth.heat.dissipation == pytest.approx(friction, rel=1e-9)
    assert warmth.heat.balance_error < 1e-10


@pytest.mark.parametrize("resolved", [False, True])
def test_columns_share_the_area_of_the_pad(resolved):
    """They weigh conduction across the gap: the integral of r dr over the square of the outer radius."""
    heat = replace(ONE_VISCOSITY, grid=HeatGrid(resolved=resolved))
    columns = ThermalSectorState.of(PAD, heat, 100e-6).thermal.columns
    assert columns.size.size == (7 if resolved else 1)
    assert columns.size.sum() == pytest.approx(0.5 * (0.2**2 - 0.1**2) / 0.2**2, rel=1e-12)


@pytest.mark.parametrize("resolved", [False, True])
def test_one_viscosity_leaves_film_and_friction_of_the_isothermal_pad(resolved):
    heat = replace(ONE_VISCOSITY, grid=HeatGrid(resolved=resolved))
    film, warmth, _ = settled(PAD, heat, TILTED, 128, 10)
    plain = sector_film(PAD, PlaneMotion(*TILTED), intervals=128, degree=10)
    assert film.forces == pytest.approx(plain.forces, rel=1e-3)
    assert film.stiffness == pytest.approx(plain.stiffness, rel=2e-3)
    assert film.friction_torque == pytest.approx(plain.friction_torque, rel=1e-4)
    assert warmth.effective_viscosity == pytest.approx(0.03, rel=0.05)  # what friction by shear alone would have
    assert film.mass_balance_error < 1e-12
    # all oil that enters leaves at temperatures that take the whole friction along
    taken = film.trailing_flow * (warmth.trailing - COLD) + (film.inner_flow + film.outer_flow) * (
        warmth.side - COLD
    )
    lost = 0.02 * film.friction_torque * 100.0  # born in the halves of the edge cells, goes to the grooves at once
    assert taken * CAPACITY == pytest.approx(film.friction_torque * 100.0, abs=lost)
    assert warmth.heat.balance_error < 1e-8


def test_temperature_converges_with_the_grid():
    oil = replace(ONE_VISCOSITY, viscosity=lambda t: 0.03 * np.exp(-0.03 * (np.asarray(t) - COLD)))
    found = [settled(PAD, oil, TILTED, n) for n in (32, 64, 128)]
    for values in (
        [film.load for film, _, _ in found],
        [warmth.trailing - COLD for _, warmth, _ in found],
    ):
        assert abs(values[2] - values[1]) < 0.7 * abs(values[1] - values[0])
        assert values[1] == pytest.approx(values[2], rel=0.01)


def test_hot_oil_carried_over_is_mixed_with_fresh_oil():
    """Q_in T_in = lambda Q_t T_t + (Q_in - lambda Q_t) T_s."""
    film, warmth, _ = settled(PAD, replace(ONE_VISCOSITY, carry_over=0.8), TILTED)
    mixed = COLD + 0.8 * film.trailing_flow * (warmth.trailing - COLD) / film.leading_flow
    assert warmth.inlet == pytest.approx(mixed, abs=0.02 * (warmth.trailing - COLD))
    assert warmth.heat.balance_error < 1e-8


@pytest.mark.parametrize(
    ("pad", "heat", "says"),
    [
        (replace(PAD, turbulence=FilmTurbulence(NG_PAN, 870.0, 500.0, 1000.0)), ONE_VISCOSITY, "laminar"),
        (replace(PAD, leading_pressure=1e5), ONE_VISCOSITY, "open"),
    ],
)
def test_what_a_thermal_pad_film_does_not_know_is_refused(pad, heat, says):
    with pytest.raises(InputError, match=says):
        ThermalSectorState.of(pad, heat, 1e-4)
