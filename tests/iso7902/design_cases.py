"""Design cases that several tests share."""

import math

from babbitt.kinds.journal.iso7902.model import Bearing, DesignCase, Friction, OilSupply, PrescribedLoad
from babbitt.kinds.journal.iso7902.supply import Arrangement, Holes, Pockets
from babbitt.properties.lubricants import Lubricant, OilProperties, lubricant_from_points

RPM = math.pi / 30.0


def oil(nu40: float, nu100: float, density: float) -> Lubricant:
    """An oil by two viscosities in mm²/s and its density at 20 °C, with the usual ρc."""
    properties = OilProperties(
        density=density, density_temperature=293.15, density_slope=-0.63, volumetric_heat_capacity=1.8e6
    )
    return lubricant_from_points("test oil", (313.15, nu40 * 1e-6), (373.15, nu100 * 1e-6), properties)


CASE_A = DesignCase(
    name="A",
    bearing=Bearing(0.120, 0.060, 1.12e-3, 360, 23e-6, 11e-6, Holes(0.005, Arrangement.OPPOSITE)),
    duty=PrescribedLoad(36e3),
    journal_speed=2000 * RPM,
    lubricant=oil(46.0, 6.8, 870.0),
    oil_supply=OilSupply(331.15, 0.5e6),
)
CASE_C = DesignCase(
    name="C",
    bearing=Bearing(0.300, 0.200, 1.2e-3, 120, 11e-6, 11e-6, Pockets(0.146, Arrangement.BOTH_SIDES)),
    duty=PrescribedLoad(150e3),
    journal_speed=1400 * RPM,
    lubricant=oil(46.0, 6.8, 870.0),
    oil_supply=OilSupply(323.15, 0.15e6),
    friction=Friction.ARC,
)
