"""Equilibrium of the shaft, and the published case."""

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.kinds.shaft.overhung_coupling import MeshForce, OverhungCoupling, bearing_loads

# Table 3 of a published gearbox study (2023); the reactions follow from statics and are not printed there
OUTPUT_WHEEL = OverhungCoupling(
    mesh_force=815e3,
    mesh_angle=math.radians(22.4),
    mesh_direction=MeshForce.UPWARD,
    bearing_distance=1.120,
    gear_mass=7109.0,
    coupling_mass=1550.0,
    flange_distance=0.513,
    coupling_length=1.070,
)


def test_the_published_output_wheel():
    up = bearing_loads(OUTPUT_WHEEL)
    down = bearing_loads(replace(OUTPUT_WHEEL, mesh_direction=MeshForce.DOWNWARD))
    assert OUTPUT_WHEEL.coupling_arm == pytest.approx(0.7805)
    found = [up.reaction_1, up.reaction_2, up.reaction_without_coupling]
    assert found == pytest.approx([380.34e3, 363.80e3, 375.51e3], abs=10.0)
    found = [down.reaction_1, down.reaction_2, down.reaction_without_coupling]
    assert found == pytest.approx([434.98e3, 452.02e3, 439.93e3], abs=10.0)


@given(
    force=st.floats(0.0, 1e6),
    angle=st.floats(0.0, 1.5),
    gear=st.floats(0.0, 1e4),
    coupling=st.floats(0.0, 1e4),
    arm=st.floats(0.0, 2.0),
)
def test_forces_and_moments_balance(force, angle, gear, coupling, arm):
    shaft = replace(
        OUTPUT_WHEEL,
        mesh_force=force,
        mesh_angle=angle,
        gear_mass=gear,
        coupling_mass=coupling,
        flange_distance=arm,
        mesh_direction=MeshForce.DOWNWARD,
    )
    loads = bearing_loads(shaft)
    vertical_1 = loads.reaction_1 * math.cos(loads.angle_1)
    vertical_2 = loads.reaction_2 * math.cos(loads.angle_2)
    half_coupling, weight = coupling * 9.80665 / 2, gear * 9.80665
    mesh = force * math.cos(angle)
    assert vertical_1 + vertical_2 == pytest.approx(mesh + weight + half_coupling, abs=1e-6)
    about_bearing_1 = (mesh + weight) * 0.56 + half_coupling * (1.12 + shaft.coupling_arm)
    assert vertical_2 * 1.12 == pytest.approx(about_bearing_1, abs=1e-6)
    for reaction, turn in ((loads.reaction_1, loads.angle_1), (loads.reaction_2, loads.angle_2)):
        assert reaction * math.sin(turn) == pytest.approx(force * math.sin(angle) / 2, abs=1e-6)


def test_without_coupling_both_bearings_share_alike():
    loads = bearing_loads(replace(OUTPUT_WHEEL, coupling_mass=0.0))
    assert loads.reaction_1 == pytest.approx(loads.reaction_2, rel=1e-14)
    assert loads.reaction_1 == pytest.approx(loads.reaction_without_coupling, rel=1e-14)
