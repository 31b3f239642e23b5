"""Bearings to compute: a published reverse gear with inferred inputs (2023 study), and examples beside it."""

from __future__ import annotations

import math
from dataclasses import replace

from babbitt.design.ducts import Duct
from babbitt.kinds.journal.iso7902.model import (
    Bearing,
    DesignCase,
    Friction,
    HousingCooling,
    OilSupply,
    PrescribedEccentricity,
    PrescribedLoad,
    Surfaces,
)
from babbitt.kinds.journal.iso7902.supply import (
    Arrangement,
    CircumferentialGroove,
    HalfCircumferentialGroove,
    Holes,
    Pockets,
)
from babbitt.properties.lubricants import OilProperties, lubricant, lubricant_from_points
from babbitt.properties.materials import bearing_metal

ZERO_CELSIUS = 273.15
RPM = math.pi / 30.0

# name, D m, B/D, U m/s, ψ permille, p̄ MPa, span
GEAR = (
    ("Input pinion, gas turbine", 0.250, 0.604, 45.0, 1.583, 1.24, 180),
    ("First-stage wheel", 0.350, 0.596, 26.1, 1.169, 1.19, 180),
    ("Second-stage pinion (a)", 0.300, 0.770, 22.4, 1.2035, 2.51, 120),
    ("Second-stage pinion (b)", 0.300, 0.770, 22.4, 1.2035, 2.51, 180),
    ("Output wheel", 0.5275, 0.774, 6.6, 0.884, 2.10, 180),
    ("Input pinion, electric motor", 0.250, 0.694, 12.5, 1.592, 1.63, 180),
    ("MRP drive pinion", 0.350, 0.499, 24.1, 1.107, 2.40, 180),
    ("MRP pinion left", 0.350, 0.594, 24.5, 1.168, 1.02, 180),
    ("MRP wheel left", 0.350, 0.628, 23.8, 1.169, 1.87, 180),
    ("MRP wheel right", 0.350, 0.605, 22.7, 1.170, 1.89, 180),
    ("MRP pinion right", 0.350, 0.594, 24.5, 1.168, 1.02, 180),
)


def gear_case(row: tuple[str, float, float, float, float, float, int]) -> DesignCase:
    name, diameter, ratio, speed, psi, pressure, span = row
    width = diameter * ratio
    element = (
        Pockets(0.73 * width, Arrangement.BOTH_SIDES)
        if "Second" in name
        else HalfCircumferentialGroove(0.05 * width)
    )
    bearing = Bearing(
        diameter,
        width,
        psi * 1e-3,
        span,
        11.4e-6,
        14.0e-6,
        element,
        Surfaces(3.2e-6, 1.6e-6, 8e-6, 0.0, 7e-6),
        bearing_metal("B83"),
    )
    return DesignCase(
        name,
        bearing,
        PrescribedLoad(pressure * 1e6 * width * diameter),
        2.0 * speed / diameter,
        lubricant("TP-46 STO upper"),
        OilSupply(50.0 + ZERO_CELSIUS, 0.2e6),
        assumptions=("Dimensions and speeds are inferred from the published tables, not printed there.",),
    )


def gear() -> tuple[DesignCase, ...]:
    return tuple(gear_case(row) for row in GEAR)


OIL = lubricant_from_points(
    "Oil 46/6.8",
    (40.0 + ZERO_CELSIUS, 46e-6),
    (100.0 + ZERO_CELSIUS, 6.8e-6),
    OilProperties(
        density=870.0,
        density_temperature=20.0 + ZERO_CELSIUS,
        density_slope=-0.63,
        volumetric_heat_capacity=1.8e6,
    ),
)

EXAMPLE = DesignCase(
    "Example A",
    Bearing(0.120, 0.060, 1.12e-3, 360, 23e-6, 11e-6, Holes(0.005, Arrangement.OPPOSITE)),
    PrescribedLoad(36e3),
    2000.0 * RPM,
    OIL,
    OilSupply(58.0 + ZERO_CELSIUS, 0.5e6),
)


def varied_cases() -> dict[str, DesignCase]:
    """One case for each way through the procedure."""
    first = gear()[0]
    bearing = EXAMPLE.bearing
    tubes = (Duct(0.024, 3.0, 1.0),)
    holes = (Duct(0.012, 0.02, 1.5, 2.0),)
    supply = OilSupply(58.0 + ZERO_CELSIUS, 0.5e6, tubes, holes)
    cooling = HousingCooling(20.0 + ZERO_CELSIUS, 20.0, 0.4)
    return {
        "full": EXAMPLE,
        "arc": replace(first, friction=Friction.ARC),
        "curve360": replace(first, friction=Friction.CURVE360, friction_factor=1.256),
        "eccentricity": replace(EXAMPLE, duty=PrescribedEccentricity(0.7)),
        "losses": replace(EXAMPLE, oil_supply=supply),
        "pockets": gear()[2],
        "slots": replace(
            EXAMPLE, bearing=replace(bearing, supply_element=Holes(0.019, Arrangement.BOTH_SIDES, 2.0393))
        ),
        "narrow hole": replace(
            EXAMPLE, bearing=replace(bearing, supply_element=Holes(0.002, Arrangement.OPPOSITE))
        ),
        "very wide pocket": replace(
            EXAMPLE, bearing=replace(bearing, supply_element=Pockets(0.056, Arrangement.SIDE))
        ),
        "groove": replace(EXAMPLE, bearing=replace(bearing, supply_element=CircumferentialGroove(0.006))),
        "no element": replace(EXAMPLE, bearing=replace(bearing, supply_element=None)),
        "both": replace(EXAMPLE, cooling=cooling),
        "housing below inlet": replace(
            EXAMPLE,
            cooling=HousingCooling(20.0 + ZERO_CELSIUS, 60.0, 3.0),
            duty=PrescribedLoad(4e3),
            journal_speed=300.0 * RPM,
        ),
        "self-cooled": replace(
            EXAMPLE, oil_supply=None, cooling=cooling, journal_speed=200.0 * RPM, duty=PrescribedLoad(8e3)
        ),
        "surfaces": first,
        "another oil": replace(EXAMPLE, lubricant=lubricant("water"), duty=PrescribedLoad(2e3)),
    }
