"""One-dimensional mass-conserving films with exact solutions: a pocketed wedge and a parabolic slider."""

import numpy as np
import pytest

from babbitt.reynolds._structs import LAND_COLUMNS, Bearing
from babbitt.reynolds.lands._equilibrium import evaluate
from babbitt.reynolds.lands._forces import RESULT_SIZE
from babbitt.reynolds.lands._grids import GAUSS, new_film, new_grid, new_lines, uniform_lines
from babbitt.reynolds.lands.operators import kernel_operator


def slide(gap, end_pressure, n):
    """Pressure, void and flux over x from 0 to 1 under a gap function; no side leakage (kappa = 0)."""
    axial = kernel_operator(1)
    lands = np.zeros((1, LAND_COLUMNS))
    lands[0] = [0.0, 1.0, 1.0, 0.0, 0.0, end_pressure, end_pressure]
    bearing = Bearing(lands, np.zeros((1, 0)), 0.0, 1.0, 0.0, True, False, 1.0)
    grid, film, lines = new_grid(1, n, 1), new_film(n), new_lines(n, 1)
    uniform_lines(bearing, grid)
    middle = 0.5 * (grid.theta[0, 1:] + grid.theta[0, :-1])
    grid.gap_a[0], grid.gap_b[0] = gap(middle - GAUSS / n), gap(middle + GAUSS / n)
    result = np.zeros(RESULT_SIZE)
    for _ in range(100):
        if evaluate(axial, bearing, grid, film, lines, 0.0, 0.0, 0.0, 0.0, False, result) == 0:
            break
    else:
        pytest.fail("the wet set did not settle")
    value = grid.value[0, :, 0] / axial.root_weights[0]
    wet = grid.wet[0, :, 0]
    pressure, void = np.where(wet, value, 0.0), np.where(wet, 0.0, value)
    flux = film.couette * (1.0 - void[:-1]) + film.conductance * (pressure[:-1] - pressure[1:])
    if not wet[1]:
        flux[0] = film.inlet[0]
    return grid.theta[0], pressure, void, flux


def test_fowell_pocket():
    """Fowell et al. (2007): inlet suction ahead of and in a pocket; flux and peak pressure in closed form."""
    length, depth, viscosity, speed = 0.01, 1e-6, 0.01, 1.0
    unit = viscosity * speed * length / depth**2

    def gap(x):
        return 1.05 - 0.05 * x + np.where((x > 0.2) & (x < 0.5), 1.0, 0.0)

    x, pressure, _, flux = slide(gap, 1e5 / unit, 400)
    assert np.ptp(flux) < 1e-10
    assert flux[0] == pytest.approx(0.5229635023923445, rel=1e-3)
    assert pressure.max() * unit == pytest.approx(9808818.75, rel=1e-3)
    assert x[pressure.argmax()] == pytest.approx(0.5)


@pytest.mark.parametrize(("n", "tolerance"), [(200, 1e-2), (800, 2e-3)])
def test_parabolic_slider(n, tolerance):
    """Rupture, reformation, peak and flux by exact quadrature for an incompressible liquid, p_cav = 0 absolute."""
    length, thin, viscosity, speed = 0.0762, 2.54e-5, 0.039, 4.57
    unit = viscosity * speed * length / thin**2
    x, pressure, void, flux = slide(lambda x: 1.0 + (2.0 * x - 1.0) ** 2, 101325.0 / unit, n)
    assert np.ptp(flux) < 1e-10
    assert pressure.max() * unit == pytest.approx(3666656.34, rel=tolerance)
    assert flux[0] * speed * thin == pytest.approx(6.557989430475107e-05, rel=tolerance)
    ruptured = x[void > 0.0]
    assert ruptured[0] == pytest.approx(0.6802276710386468, abs=1.5 / n)
    assert ruptured[-1] == pytest.approx(0.992660915982698, abs=1.5 / n)
    assert 1.0 - void.max() == pytest.approx(0.5733175174411375, abs=2.0 / n)
