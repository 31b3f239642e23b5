"""Footsteps that cannot be laid out are refused by the name of the quantity."""

import math
from dataclasses import fields, replace

import pytest
from heels import GEOMETRY, GROOVE, OIL, footstep

from babbitt.core.notices import InputError
from babbitt.kinds.footstep.model import FootstepOptions, Wall

UNUSABLE = (0.0, -1.0, math.nan, math.inf)


def refused(make, *words):
    with pytest.raises(InputError) as caught:
        make()
    assert caught.value.code == "E130"
    for word in words:
        assert word in caught.value.message


@pytest.mark.parametrize("value", UNUSABLE)
@pytest.mark.parametrize("name", [field.name for field in fields(GEOMETRY)])
def test_lengths(name, value):
    refused(lambda: replace(GEOMETRY, **{name: value}), name, "positive")


@pytest.mark.parametrize("value", UNUSABLE)
@pytest.mark.parametrize("name", ["viscosity", "temperature", "heat_capacity", "density"])
def test_oil(name, value):
    refused(lambda: replace(OIL, **{name: value}), name)


@pytest.mark.parametrize("value", UNUSABLE)
@pytest.mark.parametrize("name", ["angular_speed", "supply_pressure", "ambient_pressure", "face_gap", "clearance"])
def test_operation(name, value):
    refused(lambda: footstep(**{name: value}) if name not in ("face_gap", "clearance")
            else replace(footstep(), **{name: value}), name)  # fmt: skip


@pytest.mark.parametrize("value", [-1e-9, math.nan])
def test_exponents_and_factors(value):
    refused(lambda: replace(OIL, exponent=value), "exponent")
    refused(lambda: FootstepOptions(speed_reduction=value), "speed_reduction")
    refused(lambda: FootstepOptions(entry_loss=value), "entry_loss")
    refused(lambda: Wall(300.0, value), "conductance")


def test_radii_out_of_order():
    for changes in ({"bore_radius": 0.014}, {"recess_radius": 0.0218}, {"recess_radius": 0.03}):
        refused(lambda changes=changes: replace(GEOMETRY, **changes), "bore_radius", "recess_radius")


@pytest.mark.parametrize("angle", [0.0, 0.5 * math.pi, -0.2, math.nan])
def test_angle_of_the_groove(angle):
    refused(lambda: replace(GROOVE, angle=angle), "angle", "between 0 and 90")


@pytest.mark.parametrize("starts", [0, -3, 2.5, math.nan, math.inf])
def test_starts(starts):
    refused(lambda: replace(GROOVE, starts=starts), "starts", "whole number")


def test_supply_at_or_below_ambient():
    refused(lambda: footstep(supply_pressure=0.101e6), "supply_pressure", "ambient_pressure", "absolute")


def test_grooves_that_do_not_close():
    wide = replace(GROOVE, land_width=3.75e-3)
    assert wide.misfit(GEOMETRY.radius) == pytest.approx(0.0403, abs=1e-3)
    refused(lambda: footstep(groove=wide), "+4.1 %", "3 %", "normal to the groove")
    assert footstep(groove=wide, options=FootstepOptions(any_pitch=True)).groove is wide
    assert abs(GROOVE.misfit(GEOMETRY.radius)) == pytest.approx(0.0048, abs=1e-4)  # the published pump


def test_heels_beyond_their_cup():
    refused(lambda: footstep(eccentricity_ratio=1.0), "eccentricity_ratio")
    refused(lambda: footstep(eccentricity_ratio=0.5, tilt=1e-3), "tilt", "both ends")
