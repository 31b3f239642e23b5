"""Tilting pads against closed forms, other engines, symmetries and their own derivatives."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scaled_pads import (
    FIVE_LOAD,
    FOUR_LOAD,
    LEVER,
    bearing,
    directed,
    five_pads,
    four_pads,
    one_pad,
    pad,
    turned,
)

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads.dynamics import condensed_at, full_coefficients
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.pad_lands import film_of, pad_positions
from babbitt.reynolds.tilting_pads.pivots import (
    LineContact,
    PointContact,
    RockerContact,
    SpringPivot,
    TablePivot,
    displacement_of,
)
from babbitt.reynolds.tilting_pads.solution import PadStatus
from babbitt.reynolds.tilting_pads.solve import fold_of, solve_tilting_pads, tilting_pads_at

GRID = Resolution(4, 96)


def coefficients(bearing_, load, grid=GRID):
    return full_coefficients(solve_tilting_pads(bearing_, load, grid))


def squeeze_series(extent, width_ratio, terms=60, points=4000):
    """Damping of a concentric full film along and across its middle: Fourier series across the width.

    p'' + (D/L)^2 p_zz = 12 f(phi) with p = 0 on all edges, C = -Int p f over angle and mean width; every harmonic
    cos((2 j - 1) pi z / 2) has an equation of its own along phi, solved by finite differences.
    """
    half = 0.5 * extent
    phi = np.linspace(-half, half, points + 1)
    step = phi[1] - phi[0]
    found = []
    for form in (np.cos(phi), np.sin(phi)):
        total = 0.0
        for j in range(1, terms + 1):
            wave = (2 * j - 1) * 0.5 * math.pi
            share = (-1) ** (j + 1) * 2.0 / wave  # of the harmonic in 1; its mean is (-1)^(j+1)/wave
            rate = wave / width_ratio
            right = 12.0 * share * form[1:-1]
            diagonal = np.full(points - 1, -2.0 / step**2 - rate**2)
            p = tridiagonal(diagonal, 1.0 / step**2, right)
            total -= float((p * form[1:-1]).sum() * step) * (-1) ** (j + 1) / wave
        found.append(total)
    return found


def tridiagonal(diagonal, beside, right):
    from scipy.linalg import solve_banded

    bands = np.zeros((3, diagonal.size))
    bands[0, 1:] = bands[2, :-1] = beside
    bands[1] = diagonal
    return solve_banded((1, 1), bands, right)


def test_a_concentric_pad_of_a_full_film():
    state = tilting_pads_at(
        one_pad(1.0, rotational_stiffness=1e6 * LEVER**2), (0.0, 0.0), Resolution(8, 192)
    ).pads[0]  # a stiff flexure keeps eta at zero
    (kxx, kxy), (kyx, kyy) = state.stiffness
    (cxx, cxy), (_, cyy) = state.damping
    along, across = squeeze_series(math.radians(80.0), 1.0)
    assert cxx == pytest.approx(along, rel=1e-4)
    assert cyy == pytest.approx(across, rel=2e-4)
    assert (kxy, kyx) == pytest.approx((0.5 * cxx, -0.5 * cyy), rel=1e-6)
    assert (kxx, kyy, cxy) == pytest.approx((0.0, 0.0, 0.0), abs=1e-6)


@pytest.mark.parametrize(("ratio", "damping"), [(1.0, 1.052046), (0.5, 0.0), (0.25, -4.208183)])
def test_a_concentric_pad_is_damped_above_half_the_speed_only(ratio, damping):
    stiff = tilting_pads_at(one_pad(1.0, rotational_stiffness=1e6 * LEVER**2), (0.0, 0.0), GRID)
    pads = (replace(stiff.pads[0], status=PadStatus.LOADED),)  # its film is full, but carries nothing
    free = replace(stiff, bearing=one_pad(1.0), pads=pads)
    condensed = condensed_at(full_coefficients(free), ratio)
    assert condensed.damping[0, 0] == pytest.approx(damping, rel=2e-4, abs=1e-6)
    along = stiff.pads[0].damping[0, 0]
    assert condensed.damping[0, 0] == pytest.approx(along * (1.0 - 0.25 / ratio**2), abs=1e-6)
    assert condensed.stiffness == pytest.approx(np.zeros((2, 2)), abs=1e-6)


def test_pads_where_they_stand_are_a_bearing_of_lobes():
    grid = Resolution(4, 192)
    found = solve_tilting_pads(four_pads(), FOUR_LOAD, grid)
    film = film_of(four_pads(), pad_positions(found))
    lobed = film_at_position(film, tuple(found.position), resolution=grid)
    assert lobed.force == pytest.approx(found.force, abs=2e-4)
    rows = [np.array([p.normal(), p.tangent()]) for p in found.bearing.pads]
    for own, whole in (("stiffness", lobed.stiffness), ("damping", lobed.damping)):
        total = sum(b.T @ getattr(state, own) @ b for b, state in zip(rows, found.pads, strict=True))
        assert total == pytest.approx(whole, rel=2e-3, abs=2e-3)
    assert sum(state.friction_torque for state in found.pads) == pytest.approx(lobed.friction_torque, rel=1e-3)
    assert sum(state.side_flow for state in found.pads) == pytest.approx(float(lobed.side_flow.sum()), rel=2e-3)


def test_wedged_pads_where_they_stand_are_a_film_node_by_node():
    """Profiles that fall from the leading edges on, with another engine that samples them by itself."""
    grid = Resolution(8, 192)
    wedge = tuple(np.linspace(0.15, 0.0, 9) ** 1.5)
    chosen = bearing((pad(angle, 75.0, 0.55, 0.4, profile=wedge) for angle in (-90, 0, 90, 180)), 0.7)
    found = solve_tilting_pads(chosen, FOUR_LOAD, grid)
    assert found.loaded == (0, 1, 2, 3)
    film = replace(film_of(chosen, pad_positions(found)), crowning=(0.0, 0.0, 0.0))
    assert film.is_surface
    other = film_at_position(film, tuple(found.position), resolution=grid)
    assert other.force == pytest.approx(found.force, abs=3e-4 * found.load)
    plain = solve_tilting_pads(four_pads(), FOUR_LOAD, grid)
    for bent, straight in zip(found.pads, plain.pads, strict=True):  # the wedge counts
        assert abs(bent.tangential - straight.tangential) > 5e-3


def test_every_pad_conserves_its_oil():
    for state in solve_tilting_pads(four_pads(), FOUR_LOAD, GRID).pads:
        assert state.inflow == pytest.approx(state.outflow + state.side_flow, rel=1e-9)


def test_films_carry_the_load_without_moment():
    found = solve_tilting_pads(four_pads(), FOUR_LOAD, GRID)
    assert found.force == pytest.approx(-np.asarray(FOUR_LOAD), abs=4e-6)
    assert found.residual < 4e-6
    for state in found.pads:
        assert abs(state.force[1]) < 1e-7 * state.load


@pytest.mark.parametrize("load", [FIVE_LOAD, directed(2.0, 90.0)], ids=["between pads", "on a pad"])
def test_a_load_on_a_line_of_symmetry_finds_no_cross_coupling(load):
    found = solve_tilting_pads(five_pads(), load, GRID)
    loads = [state.load for state in found.pads]
    assert found.position[0] == pytest.approx(0.0, abs=1e-9)
    assert loads == pytest.approx([loads[1], loads[0], loads[4], loads[3], loads[2]], rel=1e-6, abs=1e-9)
    condensed = condensed_at(full_coefficients(found), 1.0)
    assert [*np.diag(condensed.stiffness[::-1]), *np.diag(condensed.damping[::-1])] == pytest.approx(
        [0.0] * 4, abs=1e-6
    )


@pytest.mark.parametrize("direction", [0.0, 33.0, 45.0, 100.0, 217.0])
def test_four_pads_at_right_angles_find_no_cross_coupling_in_any_direction(direction):
    condensed = condensed_at(coefficients(four_pads(), directed(3.0, direction)), 1.0)
    assert condensed.stiffness[0, 1] == pytest.approx(0.0, abs=1e-10)
    assert condensed.stiffness[1, 0] == pytest.approx(0.0, abs=1e-10)


def test_pads_without_inertia_push_along_their_pivots():
    found = solve_tilting_pads(five_pads(), directed(2.0, -60.0), GRID)
    w, total = 0.7, np.zeros((2, 2), dtype=complex)
    for own, state in zip(found.bearing.pads, found.pads, strict=True):
        if state.status is PadStatus.LOADED:
            z = state.stiffness + 1j * w * state.damping
            total += (z[0, 0] - z[0, 1] * z[1, 0] / z[1, 1]) * np.outer(own.normal(), own.normal())
    condensed = condensed_at(full_coefficients(found), w)
    assert condensed.stiffness + 1j * w * condensed.damping == pytest.approx(total, rel=1e-12)
    assert condensed.stiffness[0, 1] == pytest.approx(condensed.stiffness[1, 0], rel=1e-12)


def test_a_stiff_pivot_is_as_a_rigid_one():
    rigid, stiff = coefficients(four_pads(), FOUR_LOAD), coefficients(four_pads(law=SpringPivot(1e9)), FOUR_LOAD)
    for ratio in (0.0, 1.0):
        first, second = condensed_at(rigid, ratio), condensed_at(stiff, ratio)
        assert second.stiffness == pytest.approx(first.stiffness, rel=1e-6, abs=1e-6)
        assert second.damping == pytest.approx(first.damping, rel=1e-6, abs=1e-6)


LAWS = {
    "rigid": {},
    "spring": {"law": SpringPivot(20.0)},
    "table": {"law": TablePivot((0.5, 2.0, 5.0), (0.02, 0.06, 0.1))},
    "flexure": {"rotational_stiffness": 0.8 * LEVER**2, "rest_tilt": 0.05},
    "flexure, soft along tau": {
        "rotational_stiffness": 0.8 * LEVER**2, "tangential_stiffness": 3.0, "law": SpringPivot(20.0)
    },
}  # fmt: skip


@pytest.mark.parametrize("name", list(LAWS))
def test_static_stiffness_is_the_slope_of_the_load(name):
    chosen = four_pads(**LAWS[name])
    found = solve_tilting_pads(chosen, FOUR_LOAD, Resolution(4, 96, tolerance=1e-9))
    assert found.outcome.solved
    step, columns = 1e-4, []
    for way in np.eye(2) * step:
        ahead, behind = (tilting_pads_at(chosen, tuple(found.position + s * way), GRID) for s in (1.0, -1.0))
        columns.append(-(ahead.force - behind.force) / (2.0 * step))
    static = condensed_at(full_coefficients(found), 0.0).stiffness
    assert static == pytest.approx(np.array(columns).T, rel=1e-3, abs=4e-3)
    slow = condensed_at(full_coefficients(found), 1e-4)
    assert slow.stiffness == pytest.approx(static, rel=1e-6, abs=1e-6)
    assert slow.damping == pytest.approx(condensed_at(full_coefficients(found), 0.0).damping, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize("name", list(LAWS))
def test_pivots_and_flexures_balance_the_film(name):
    found = solve_tilting_pads(four_pads(**LAWS[name]), FOUR_LOAD, GRID)
    for own, state in zip(found.bearing.pads, found.pads, strict=True):
        lever = found.bearing.lever(own)
        radial = float(found.position @ own.normal()) - state.position.pivot_displacement
        along = (
            float(found.position @ own.tangent()) - state.position.tangential_displacement
            + lever * state.position.tilt
        )  # fmt: skip
        assert (state.radial, state.tangential) == pytest.approx((radial, along), abs=1e-9)
        assert state.position.pivot_displacement == pytest.approx(displacement_of(own.pivot, state.load), abs=1e-7)
        moment = lever * state.force[1] - own.rotational_stiffness * (state.position.tilt - own.rest_tilt)
        assert moment == pytest.approx(0.0, abs=1e-6)
        if math.isfinite(own.tangential_stiffness):
            along = own.tangential_stiffness * state.position.tangential_displacement
            assert along == pytest.approx(-state.force[1], abs=1e-9)


STEEL = {
    "ball": PointContact(0.200, 0.201),
    "cylinder": LineContact(0.200, 0.250, 0.06, 0.02, 0.02),
    "rocker": RockerContact(0.06),
    "ball in a soft housing": PointContact(0.200, 0.201, housing_stiffness=3e8),
}


@pytest.mark.parametrize("law", list(STEEL))
@pytest.mark.parametrize("load", [100.0, 40e3])
def test_pads_of_steel_in_si(law, load):
    pads = tuple(
        TiltingPad(math.radians(angle), math.radians(60.0), 150e-6, 100e-6, 0.02, pivot=STEEL[law])
        for angle in (54, 126, 198, 270, 342)
    )
    chosen = TiltingPadBearing(0.2, 0.1, 0.02, 300.0, pads)
    found = solve_tilting_pads(chosen, (0.0, -load), GRID)
    assert found.outcome.solved
    assert found.force == pytest.approx([0.0, load], abs=2e-6 * load)
    for state in found.pads:
        assert state.position.pivot_displacement == pytest.approx(
            displacement_of(STEEL[law], state.load), rel=1e-4, abs=1e-13
        )


def test_the_place_does_not_depend_on_the_start():
    rng = np.random.default_rng(5)
    for chosen, load in ((five_pads(), FIVE_LOAD), (four_pads(), FOUR_LOAD)):
        first = solve_tilting_pads(chosen, load, GRID).position
        for _ in range(12):
            start = directed(0.55 * math.sqrt(rng.random()), 360.0 * rng.random())
            again = solve_tilting_pads(chosen, load, GRID, start=start)
            assert again.outcome.solved
            assert again.position == pytest.approx(first, abs=5e-7)


def test_turning_and_relabelling_turns_the_answer():
    angle = math.radians(37.0)
    first = solve_tilting_pads(four_pads(inertia=0.05 * LEVER**2), FOUR_LOAD, GRID)
    pads = [replace(own, pivot_angle=own.pivot_angle + angle) for own in first.bearing.pads]
    moved = replace(first.bearing, pads=(*pads[2:], *pads[:2]))
    second = solve_tilting_pads(moved, tuple(turned(FOUR_LOAD, angle)), GRID)
    assert second.position == pytest.approx(turned(first.position, angle), abs=1e-12)
    assert [state.load for state in second.pads] == pytest.approx(
        [first.pads[k].load for k in (2, 3, 0, 1)], rel=1e-12
    )
    turn = np.array([turned((1.0, 0.0), angle), turned((0.0, 1.0), angle)]).T
    one, two = (condensed_at(full_coefficients(found), 0.8) for found in (first, second))
    assert two.stiffness == pytest.approx(turn @ one.stiffness @ turn.T, rel=1e-9, abs=1e-9)
    assert two.damping == pytest.approx(turn @ one.damping @ turn.T, rel=1e-9, abs=1e-9)


def test_a_mirror_reverses_everything():
    profile = (0.0, 0.01, 0.05)
    more = {
        "inertia": 0.05 * LEVER**2,
        "mass": 0.1,
        "mass_offset": 0.3,
        "mass_inset": 0.2,
        "law": SpringPivot(15.0),
    }
    flexed = {"rotational_stiffness": 0.3 * LEVER**2, "tangential_stiffness": 5.0}
    first = bearing(
        (pad(a, 75.0, 0.55, 0.4, profile=profile, rest_tilt=0.03, **more, **flexed) for a in (-90, 0, 90, 180)),
        0.7,
    )
    second = bearing(
        (
            pad(-a, 75.0, 0.55, 0.4, profile=profile[::-1], rest_tilt=-0.03, **more, **flexed)
            for a in (-90, 0, 90, 180)
        ),
        0.7,
        speed=-1.0,
    )
    one = solve_tilting_pads(first, FOUR_LOAD, GRID)
    two = solve_tilting_pads(second, (FOUR_LOAD[0], -FOUR_LOAD[1]), GRID)
    mirror = np.array([1.0, -1.0])
    assert one.outcome.solved
    assert two.position == pytest.approx(mirror * one.position, abs=1e-12)
    assert two.force == pytest.approx(mirror * one.force, abs=1e-12)
    for left, right in zip(one.pads, two.pads, strict=True):
        assert right.position.tilt == pytest.approx(-left.position.tilt, abs=1e-12)
        assert right.force == pytest.approx(mirror * left.force, abs=1e-12)
    full_one, full_two = full_coefficients(one), full_coefficients(two)
    sign = np.diag([1.0, -1.0, *(1.0 if name.endswith("pivot") else -1.0 for name in full_one.labels[2:])])
    for name in ("mass", "damping", "stiffness"):
        assert getattr(full_two, name) == pytest.approx(sign @ getattr(full_one, name) @ sign, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("speed", [1.0, -1.0])
def test_the_mass_matrix_is_the_kinetic_energy_of_a_rigid_pad(speed):
    """m v^2/2 of the centre of gravity and J_cg delta'^2/2, its velocity from turning it about the pivot."""
    own = {"inertia": 0.9, "mass": 2.0, "mass_offset": 0.3, "mass_inset": 0.5}
    elastic = {"law": SpringPivot(15.0), "rotational_stiffness": 0.3 * LEVER**2, "tangential_stiffness": 5.0}
    chosen = bearing((pad(30.0, 75.0, 0.55, 0.4, **own, **elastic),), 0.7, speed)
    found = tilting_pads_at(chosen, (0.2, 0.1), Resolution(4, 48))
    full = full_coefficients(found)
    assert full.labels[2:] == ("pad 1 tilt", "pad 1 pivot", "pad 1 tangential")
    n, tau = chosen.pads[0].normal(), chosen.pads[0].tangent()
    arm = -0.5 * n + speed * 0.3 * tau  # from the pivot to the centre of gravity
    for s, u, v in np.random.default_rng(2).normal(size=(5, 3)):
        turning = s / chosen.lever(chosen.pads[0])
        velocity = u * n + v * tau + turning * np.array([-arm[1], arm[0]])
        energy = 0.5 * 2.0 * velocity @ velocity + 0.5 * (0.9 - 2.0 * arm @ arm) * turning**2
        rate = np.array([0.0, 0.0, s, u, v])
        assert 0.5 * rate @ full.mass @ rate == pytest.approx(energy, rel=1e-12)


@pytest.mark.parametrize("pressure", [0.05, 1.0])
def test_loaded_pads_between_full_grooves_are_a_bearing_of_lobes(pressure):
    fed, grid = replace(four_pads(), groove_pressure=pressure), Resolution(4, 192)
    found = solve_tilting_pads(fed, FOUR_LOAD, grid)
    assert found.loaded == (0, 1, 2, 3)
    lobed = film_at_position(film_of(fed, pad_positions(found)), tuple(found.position), resolution=grid)
    assert lobed.force == pytest.approx(found.force, abs=3e-4 * found.load)


def test_a_centred_pad_without_preload_unloads_at_the_root_of_its_eccentricity():
    shallow, deep = (tilting_pads_at(one_pad(), (e, 0.0), GRID).pads[0].load for e in (0.001, 0.01))
    assert (shallow * math.pi, deep * math.pi) == pytest.approx((0.018722, 0.060436), rel=5e-3)
    assert deep / shallow == pytest.approx(math.sqrt(10.0), rel=0.03)
    beyond = tilting_pads_at(one_pad(), (-1e-6, 0.0), GRID)
    assert beyond.pads[0].status is PadStatus.UNLOADED
    assert math.isnan(beyond.pads[0].position.tilt)
    assert beyond.pads[0].inflow == pytest.approx(0.5 * beyond.pads[0].minimum_film_thickness)
    assert fold_of(one_pad(), 0).eccentricity_ratio == 0.0


def test_a_position_beyond_a_pivot_has_no_film():
    found = tilting_pads_at(four_pads(), (0.0, -0.7), GRID)
    assert found.outcome is Outcome.OUTSIDE_CLEARANCE
    with pytest.raises(InputError, match="not solved"):
        full_coefficients(found)


def test_oil_under_pressure_between_the_pads_pushes_the_journal():
    three = bearing((pad(angle, 60.0, 0.5, 0.3) for angle in (-90, 0, 90)), 0.5)
    fed = replace(three, groove_pressure=0.2)
    found = solve_tilting_pads(fed, (0.0, -1.0), GRID)
    # between the ends of the pads at 120 and 240 degrees, and of two gaps of 30 degrees
    gaps = ((-60, -30), (30, 60), (120, 240))
    push = -0.2 * sum(
        np.array([math.sin(b) - math.sin(a), math.cos(a) - math.cos(b)]) for a, b in np.radians(gaps)
    )
    films = sum(
        state.force[0] * own.normal() + state.force[1] * own.tangent()
        for own, state in zip(fed.pads, found.pads, strict=True)
    )
    assert found.force == pytest.approx(films + push, abs=1e-6)
    assert found.force == pytest.approx([0.0, 1.0], abs=2e-6)
    assert found.pads[0].pressure[[0, -1], 0] == pytest.approx([0.2, 0.2])


def test_a_wider_and_a_more_viscous_pad_carries_more():
    plain, thick = one_pad(0.5), one_pad(0.5, viscosity=2.0)
    first, second = (tilting_pads_at(one, (0.5, 0.0), GRID).pads[0] for one in (plain, thick))
    assert second.load == pytest.approx(2.0 * first.load)  # mu L = 1, L = 1
    assert second.friction_torque == pytest.approx(2.0 * first.friction_torque)
    assert second.maximum_pressure == pytest.approx(2.0 * first.maximum_pressure)
    assert second.inflow == pytest.approx(first.inflow)
    wide = tilting_pads_at(one_pad(0.5, width=1.4), (0.5, 0.0), GRID).pads[0]
    alone = tilting_pads_at(replace(plain, width=1.4), (0.5, 0.0), GRID).pads[0]
    for name in ("load", "friction_torque", "maximum_pressure", "inflow", "side_flow", "tangential"):
        assert getattr(wide, name) == pytest.approx(getattr(alone, name), rel=1e-9)


def test_the_first_orders_of_the_grid():
    loads = [tilting_pads_at(one_pad(), (0.5, 0.0), Resolution(4, n)).pads[0].load for n in (48, 96, 192, 384)]
    steps = np.diff(loads)
    assert steps[:-1] / steps[1:] == pytest.approx([4.0, 4.0], rel=0.15)


def test_a_load_that_is_no_number_is_refused():
    with pytest.raises(InputError, match="load"):
        solve_tilting_pads(four_pads(), (0.0, math.nan))
