"""Pads whose films have their own temperatures: balances, limits, and beside the global heat balance."""

from dataclasses import replace

import numpy as np
import pytest
from trawler_pads import PAD, SPEED

from babbitt.case import case_from_dict
from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.kinds.thrust.bearing import HousingTilt, ThrustBearing
from babbitt.kinds.thrust.check import thrust_check
from babbitt.kinds.thrust.design import (
    Oil,
    PrescribedFilm,
    PrescribedThrust,
    ThrustDesign,
    bearing_state,
    operating_state,
)
from babbitt.kinds.thrust.equilibrium import pad_state
from babbitt.kinds.thrust.face import SteppedFace, TaperedFace
from babbitt.kinds.thrust.failures import ThermalRunawayError
from babbitt.kinds.thrust.load_curve import carrying
from babbitt.kinds.thrust.pad import Pivot
from babbitt.kinds.thrust.pad_attitude import attitude_at_rest
from babbitt.kinds.thrust.thermal import PadOil, thermal_pad
from babbitt.properties.lubricants import ConstantViscosity, OilProperties, lubricant, lubricant_from_law
from babbitt.solving import solve

VG_100 = lubricant("ISO VG 100")
OIL = PadOil(VG_100, 318.15, 0.75)
LOAD = 62.5e3
TAPER = replace(PAD, pivot=Pivot.FIXED, face=TaperedFace(40e-6, 0.7))
STEP = replace(PAD, pivot=Pivot.FIXED, face=SteppedFace(40e-6, 0.6))


@pytest.mark.parametrize(
    ("pad", "resolved"),
    [
        (PAD, False),
        (PAD, True),
        (replace(PAD, pivot=Pivot.LINE), False),
        (replace(PAD, crown=10e-6), False),
        (TAPER, True),
        (STEP, False),
    ],
    ids=["point", "resolved", "line", "crown", "taper", "step"],
)
def test_energy_oil_moments_and_load_are_balanced(pad, resolved):
    state = thermal_pad(pad, replace(OIL, resolved=resolved), SPEED, 50e-6, LOAD).state
    assert state.heat.heat.balance_error < 1e-8
    assert state.film.mass_balance_error < 1e-9
    assert state.load == pytest.approx(LOAD, rel=1e-8)
    moments = (pad.from_pivot().T @ state.film.forces)[list(pad.free_tilts)]
    assert np.abs(moments).max(initial=0.0) < 1e-9 * LOAD * 0.185
    assert state.heat.heat.dissipation == pytest.approx(state.friction_power, rel=1e-9)
    assert OIL.supply_temperature < state.heat.inlet < state.heat.trailing < state.heat.maximum


def test_oil_that_hardly_warms_leaves_the_isothermal_pad():
    """A heat capacity without bound: the film of the fresh oil, its tilt and its coefficients."""
    steady = replace(VG_100, fixed_volumetric_heat_capacity=1e14)
    warm = thermal_pad(PAD, PadOil(steady, 318.15, 0.75), SPEED, 50e-6).state
    plain = pad_state(PAD, 50e-6, VG_100.dynamic_viscosity(318.15), SPEED)
    assert warm.heat.maximum - 318.15 < 1e-3
    assert warm.load == pytest.approx(plain.load, rel=1e-3)
    assert warm.slope_y == pytest.approx(plain.slope_y, rel=1e-3)
    assert warm.stiffness == pytest.approx(plain.stiffness, rel=3e-3)
    assert warm.damping == pytest.approx(plain.damping, rel=3e-3)


def design(oil, duty=None, tilt=0.0):
    return ThrustDesign(
        "Block", ThrustBearing(PAD, 8, 2e10, tilt=HousingTilt(tilt)), duty or PrescribedThrust(500e3), SPEED, oil
    )


@pytest.mark.parametrize("carry_over", [0.0, 0.75])
def test_of_one_viscosity_the_drain_is_that_of_the_global_balance(carry_over):
    known = OilProperties(density=880.0)
    steady = lubricant_from_law("steady", ConstantViscosity(0.045), known, source="test")
    steady = replace(steady, fixed_volumetric_heat_capacity=1.7e6)
    own, one = (
        operating_state(design(Oil(steady, None, 318.15, carry_over, own_temperatures=own)))
        for own in (True, False)
    )
    assert own.share.heights == pytest.approx(one.share.heights, rel=1e-3)
    for name in ("drain", "fresh_flow"):
        mine, theirs = (
            getattr(state.temperatures, name) - (318.15 if name == "drain" else 0.0) for state in (own, one)
        )
        assert mine == pytest.approx(theirs, rel=2e-3)
    # the global balance lets the sides go at the mean of inlet and trailing edge; the film knows where they leave
    assert own.temperatures.trailing - 318.15 == pytest.approx(one.temperatures.trailing - 318.15, rel=0.12)


def test_beside_the_global_balance_films_are_thicker_and_energy_is_kept():
    """Cold oil at the leading edge carries more than one mean viscosity knows: drain and film within a quarter."""
    own, one = (
        operating_state(design(Oil(VG_100, None, 318.15, 0.75, own_temperatures=own))) for own in (True, False)
    )
    assert abs(own.temperatures.error) < 1e-8
    assert own.share.heights[0] == pytest.approx(one.share.heights[0], rel=0.25)
    assert own.share.heights[0] > one.share.heights[0]
    assert own.temperatures.drain - 318.15 == pytest.approx(one.temperatures.drain - 318.15, rel=0.27)


def test_more_hot_oil_carried_over_thins_the_film():
    states = [thermal_pad(PAD, replace(OIL, carry_over=c), SPEED, 50e-6, LOAD).state for c in (0.0, 0.5, 0.9)]
    assert states[0].heat.inlet < states[1].heat.inlet < states[2].heat.inlet
    assert states[0].height > states[1].height > states[2].height


def test_the_mean_over_the_width_is_near_the_resolved_film():
    mean, resolved = (thermal_pad(PAD, replace(OIL, resolved=r), SPEED, 50e-6, LOAD).state for r in (False, True))
    assert mean.height == pytest.approx(resolved.height, rel=0.03)
    assert resolved.heat.maximum > mean.heat.maximum  # the outer radius runs faster
    assert mean.heat.trailing - 318.15 == pytest.approx(resolved.heat.trailing - 318.15, rel=0.08)


def test_grid_of_the_pad():
    heights = [thermal_pad(PAD, OIL, SPEED, 50e-6, LOAD, intervals=n).state.height for n in (32, 64, 128)]
    assert abs(heights[2] - heights[1]) < 0.7 * abs(heights[1] - heights[0])
    assert heights[1] == pytest.approx(heights[2], rel=5e-3)


def test_stiffness_at_frozen_temperatures_is_the_derivative_of_the_force():
    """The sector's stiffness against forces of displaced pads whose temperatures are held."""
    found = thermal_pad(PAD, OIL, SPEED, 50e-6, LOAD)
    state, sector = found.state, found.sector
    to_film = PAD.from_pivot()
    motion = np.array([state.height, state.slope_x, state.slope_y])
    for axis, step in enumerate((1e-9, 1e-8, 1e-8)):
        sides = []
        for side in (1.0, -1.0):
            sector.carry(to_film @ (motion + side * step * np.eye(3)[axis]))
            sides.append(to_film.T @ sector.forces)
        slope = (sides[1] - sides[0]) / (2.0 * step)
        assert state.stiffness[:, axis] == pytest.approx(slope, rel=2e-3, abs=2e-3 * np.abs(slope).max())


@pytest.mark.parametrize("tilt", [0.0, 30e-6])
def test_pads_of_their_own_temperatures_share_the_thrust(tilt):
    state = operating_state(design(Oil(VG_100, None, 318.15, 0.75, own_temperatures=True), tilt=tilt))
    assert state.share.loads.sum() == pytest.approx(500e3, rel=1e-4)
    assert abs(state.temperatures.error) < 1e-8
    hottest = int(np.argmax([pad.heat.maximum for pad in state.share.states]))
    assert tilt == 0.0 or hottest == int(state.share.loads.argmax())


def test_heat_evens_out_what_a_tilt_does():
    """A pad pressed closer runs hotter and gives way, whether its film has one temperature or many."""
    of_balance, varied = (Oil(VG_100, None, 318.15, 0.75, own_temperatures=own) for own in (False, True))
    loads = [
        operating_state(design(oil, tilt=30e-6)).share.largest_over_mean
        for oil in (of_balance, varied, Oil(VG_100, 326.0))
    ]
    assert 1.0 < max(loads[:2]) < 0.95 * loads[2]


def test_a_given_film_and_its_thrust_are_one_answer():
    oil = Oil(VG_100, None, 318.15, 0.75, own_temperatures=True)
    level = replace(design(oil, PrescribedFilm(45e-6)), bearing=ThrustBearing(PAD, 8))
    thrust = operating_state(level).share.thrust
    again = operating_state(replace(level, duty=PrescribedThrust(thrust)))
    assert again.share.heights == pytest.approx(45e-6, rel=1e-4)


def test_the_check_tells_temperatures_of_every_pad():
    result = thrust_check(design(Oil(VG_100, None, 318.15, 0.75, own_temperatures=True), tilt=30e-6))
    assert result.outcome.solved
    assert result.values["maximum_temperature"] == max(result.arrays["pad_maximum_temperature"][0])
    assert result.values["energy_balance_error"] < 1e-8
    assert any("own temperatures" in said for said in result.assumptions)


def test_a_film_hotter_than_the_oil_bears_is_a_runaway():
    with pytest.raises(ThermalRunawayError):
        thermal_pad(PAD, OIL, SPEED, 20e-6, 2e6)
    result = thrust_check(design(Oil(VG_100, None, 318.15, 0.75, own_temperatures=True), PrescribedThrust(500e6)))
    assert result.outcome is Outcome.THERMAL_RUNAWAY
    assert not result.values
    assert "friction outruns the oil" in result.message


def test_a_table_begins_where_it_is_asked():
    films = carrying(PAD, OIL.fresh_viscosity, SPEED)
    assert films.height_for(LOAD) > thermal_pad(PAD, OIL, SPEED, 50e-6, LOAD).state.height
    with pytest.raises(InputError, match="positive"):
        thermal_pad(PAD, OIL, SPEED, 0.0)


TILTED = design(Oil(VG_100, None, 318.15, 0.75, own_temperatures=True), tilt=30e-6)


def test_each_pad_takes_in_the_oil_of_the_pad_before():
    """Q_in T_in = lambda Q_t T_t + fresh oil, around the bearing; all energy closes, the thrust is carried."""
    found = bearing_state(TILTED)
    states = found.share.states
    for before, pad in zip((states[-1], *states), states, strict=False):
        carried = 0.75 * before.trailing_flow
        mixed = 318.15 + carried * (before.heat.sent - 318.15) / pad.leading_flow
        assert pad.heat.supply == pytest.approx(mixed, abs=1e-6)
    assert abs(found.temperatures.error) < 1e-8
    assert found.share.loads.sum() == pytest.approx(500e3, rel=1e-5)
    stand = found.share.heights - found.share.loads / 2e10 - TILTED.bearing.departures()
    assert stand == pytest.approx(found.share.approach, abs=1e-5 * found.share.heights.min())


def test_the_pads_after_the_hottest_one_take_in_hotter_oil_than_its_mirror():
    """Pad 1 is pressed closest: pad 2 gets its oil, pad 8 does not; turning the other way exchanges the two."""
    forward = bearing_state(TILTED).share.states
    assert forward[1].heat.inlet > forward[7].heat.inlet
    backward = replace(TILTED, bearing=replace(TILTED.bearing, sense=-1.0))
    mirrored = bearing_state(backward).share.states
    for here, there in zip(mirrored, (forward[0], *forward[:0:-1]), strict=True):
        assert here.heat.inlet == pytest.approx(there.heat.inlet, abs=1e-3)
        assert here.load == pytest.approx(there.load, rel=1e-4)


def test_equal_pads_have_no_other_neighbours_than_their_like():
    even = replace(TILTED, bearing=replace(TILTED.bearing, tilt=HousingTilt()))
    assert bearing_state(even).share.heights == pytest.approx(operating_state(even).share.heights)


def test_a_mean_film_stays_the_one_given_where_pads_warm_their_neighbours():
    """And its thrust has that share: heat capacity is taken at the mean film there, at the mean load here."""
    found = bearing_state(replace(TILTED, duty=PrescribedFilm(50e-6)))
    assert found.share.heights.mean() == pytest.approx(50e-6, rel=1e-6)
    again = bearing_state(replace(TILTED, duty=PrescribedThrust(found.share.thrust)))
    assert again.share.heights == pytest.approx(found.share.heights, rel=2e-3)


@pytest.mark.parametrize("pad", [TAPER, replace(PAD, pivot=Pivot.LINE)], ids=["taper", "line"])
def test_warm_faces_that_lean_share_thrust_and_heat(pad):
    """Held slopes, the thrust, the positions over the ring and the energy, with pads that feed each other."""
    of = replace(design(Oil(VG_100, None, 318.15, 0.75, own_temperatures=True), tilt=30e-6))
    of = replace(of, bearing=replace(of.bearing, pad=pad))
    stands = attitude_at_rest(of.bearing)
    for state, exactly in ((operating_state(of), 1e-5), (bearing_state(of), 1e-6)):
        share = state.share
        assert share.loads.sum() == pytest.approx(500e3, rel=exactly)
        at = share.heights - share.loads / 2e10 - stands.departures
        assert at == pytest.approx(np.full(8, share.approach), abs=exactly * share.heights.max())
        held = [tilt - 1 for tilt in (1, 2) if tilt not in pad.free_tilts]
        slopes = np.array([(one.slope_x, one.slope_y) for one in share.states])
        assert slopes[:, held] == pytest.approx(stands.leans[:, held], abs=1e-15)
    assert abs(state.temperatures.error) < 1e-6


def test_oil_that_hardly_warms_leaves_the_share_of_leaning_pads():
    steady = replace(VG_100, fixed_volumetric_heat_capacity=1e14)
    warm, cold = (
        operating_state(replace(of, bearing=replace(of.bearing, pad=TAPER))).share
        for of in (
            design(Oil(steady, None, 318.15, 0.75, own_temperatures=True), tilt=30e-6),
            design(Oil(VG_100, 318.15), tilt=30e-6),
        )
    )
    assert warm.loads == pytest.approx(cold.loads, rel=2e-3)
    assert warm.moment == pytest.approx(cold.moment, rel=2e-3)


def test_the_heat_balance_of_leaning_pads_is_closed():
    of = design(Oil(VG_100, None, 318.15, 0.75), tilt=30e-6)
    found = operating_state(replace(of, bearing=replace(of.bearing, pad=TAPER)))
    assert attitude_at_rest(found.share.bearing).is_tilted
    assert found.share.loads.sum() == pytest.approx(500e3, rel=1e-5)
    assert abs(found.temperatures.error) < 1e-9


def test_pads_whose_films_come_back_no_nearer_are_found_in_every_frame():
    """Of three pads one stands nearest; films of the others repeat to 2e-7 alone, not to the 1e-7 asked for.

    In one frame the search ended by chance, in the other it did not ("film, temperatures and tilt of a pad did not
    converge").
    """
    case = {
        "kind": "thrust", "name": "Pads", "speed": "1132 rpm", "thermal": "adiabatic", "load": "98.9 kN",
        "pads": {"number": 3, "inner_radius": "112 mm", "outer_radius": "194.1 mm", "extent": "72.86 deg",
                 "pivot": {"kind": "point", "radius": "154.7 mm", "fraction": 0.5}},
        "oil": {"kind": "heat_balance", "lubricant": "ISO VG 100", "supply_temperature": "35.6 degC"},
        "ring_stiffness": "1.7090 GN/m",
    }  # fmt: skip
    one, other = (
        solve(case_from_dict(case | {"tilt": {"offset": "11.5 um", "direction": direction}})).results[0]
        for direction in ("-97.8 deg", "22.2 deg")
    )
    assert one.outcome.solved
    assert other.outcome.solved
    assert sum(one.arrays["pad_load"][0]) == pytest.approx(98.9e3, rel=1e-5)
    assert np.roll(one.arrays["pad_load"][0], 1) == pytest.approx(other.arrays["pad_load"][0], rel=1e-5)
