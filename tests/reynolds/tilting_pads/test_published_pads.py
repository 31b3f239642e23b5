"""Tilting pads against printed tables and another program."""

import math

import pytest
from scaled_pads import bearing, pad

from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads.dynamics import condensed_at, full_coefficients
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.pivots import RigidPivot, RockerContact, SpringPivot
from babbitt.reynolds.tilting_pads.solution import PadStatus
from babbitt.reynolds.tilting_pads.solve import solve_tilting_pads, tilting_pads_at

# T. Someya (ed.), Journal-Bearing Databook, Springer 1989, p. 83, table 5: four pads, no preload, L/D 0.5, load
# between pads: eccentricity over c_p: S, K c/W, B c omega/W, friction f R/c, flow over the trailing edges over
# N R c L. The arc of the pads is not printed with the table; 80 degrees follow from its friction column. The rows
# below 0.3 and the damping at 1.2 do not fit the others and are left out.
SOMEYA = {
    0.3: (1.59, 1.46, 4.37, 17.7, 4.59),
    0.4: (1.05, 1.68, 3.61, 12.9, 4.09),
    0.5: (0.756, 1.94, 3.33, 10.3, 3.67),
    0.6: (0.550, 2.26, 3.21, 8.39, 3.24),
    0.7: (0.381, 2.65, 3.06, 6.64, 2.82),
    0.8: (0.259, 3.15, 3.01, 5.27, 2.40),
    0.9: (0.168, 3.72, 2.97, 4.10, 1.99),
    1.0: (0.103, 4.47, 2.99, 3.14, 1.59),
    1.1: (0.0576, 5.63, 3.11, 2.34, None),
    1.2: (0.0277, 7.83, None, 1.65, None),
}


@pytest.mark.parametrize("eccentricity", list(SOMEYA))
def test_the_databook_of_someya(eccentricity):
    number, stiffness, damping, friction, flow = SOMEYA[eccentricity]
    chosen = bearing((pad(angle, 80.0) for angle in (-135, -45, 45, 135)), 0.5)
    found = tilting_pads_at(chosen, (0.0, -eccentricity), Resolution(4, 96))
    assert found.loaded == (0, 1)
    load = found.load
    assert 1.0 / (math.pi * load) == pytest.approx(number, rel=0.05)
    condensed = condensed_at(full_coefficients(found), 1.0)
    for axis in (0, 1):
        assert condensed.stiffness[axis, axis] / load == pytest.approx(stiffness, rel=0.06)
        if damping is not None:
            assert condensed.damping[axis, axis] / load == pytest.approx(damping, rel=0.08)
    lower = found.pads[:2]
    assert sum(state.friction_torque for state in lower) / load == pytest.approx(friction, rel=0.05)
    if flow is not None:  # omega R c L is 2 pi N R c L
        out = 2.0 * math.pi * sum(state.outflow for state in lower) / chosen.width
        assert out == pytest.approx(flow, rel=0.055)


def large_bearing(pivot):
    """Five pads of 60 degrees on 400 mm: ``tilt_5pad_isoviscous.json`` and its kin in the tests of ROSS."""
    assembled = 194.564e-6
    pads = tuple(
        TiltingPad(math.radians(angle), math.radians(60.0), assembled / 0.7, assembled, 0.05, pivot=pivot)
        for angle in (54, 126, 198, 270, 342)
    )
    return TiltingPadBearing(0.3999992, 0.263144, 0.0190062, 900.0 * math.pi / 30.0, pads)


# K_xx, K_yy MN/m, C_xx, C_yy MN s/m, displacement of the loaded pivot um. ROSS has 20 x 10 elements on a pad and
# a stiffness that is 3 % lower.
ROSS = {
    "rigid": (RigidPivot(), 322.1, 2571.0, 5.415, 19.39, 0.0),
    "spring": (SpringPivot(17.51e9), 341.4, 2362.0, 5.441, 14.82, 5.855),
    "rocker": (RockerContact(0.263144), 356.2, 2118.0, 5.314, 11.05, 14.39),
}


@pytest.mark.parametrize("name", list(ROSS))
def test_a_large_bearing_of_another_program(name):
    pivot, kxx, kyy, cxx, cyy, way = ROSS[name]
    found = solve_tilting_pads(large_bearing(pivot), (0.0, -112814.90696), Resolution(6, 96))
    assert found.outcome.solved
    condensed = condensed_at(full_coefficients(found), 1.0)
    k, c = condensed.stiffness / 1e6, condensed.damping / 1e6
    assert (k[0, 0], k[1, 1]) == pytest.approx((kxx, kyy), rel=0.05)
    assert (c[0, 0], c[1, 1]) == pytest.approx((cxx, cyy), rel=0.03)
    assert found.pads[3].position.pivot_displacement * 1e6 == pytest.approx(way, rel=0.02)
    assert [state.status for state in found.pads[:2]] == [PadStatus.UNLOADED] * 2


def test_the_place_of_the_large_bearing():
    found = solve_tilting_pads(large_bearing(RigidPivot()), (0.0, -112814.90696), Resolution(6, 96))
    assert found.eccentricity_ratio == pytest.approx(0.61802, rel=5e-3)
    gaps = [1e6 * state.minimum_film_thickness for state in found.pads[2:]]
    assert gaps == pytest.approx([138.651, 61.885, 138.499], rel=5e-3)
    assert found.maximum_pressure == pytest.approx(4.688e6, rel=0.01)
    tilts = [
        state.position.tilt / found.pads[3].position.tilt for state in found.pads[2:]
    ]  # its lever is not told
    assert tilts == pytest.approx([-0.127026 / 0.206829, 1.0, 0.526875 / 0.206829], rel=0.01)
