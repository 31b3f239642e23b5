"""Pressure ratio of greatest stiffness, and gap or viscosity of least power.

Pumping power grows with h^3/mu, friction power of the lands with mu/h, that of the recesses with mu. Least total
power: P_f/P_p = 3 where the gap is free, with the friction of the lands alone, and 1 where the viscosity is;
either rule costs about 15 % where the other holds, so anything from 1 to 3 will do.
"""

from __future__ import annotations

import math

from babbitt.kinds.hydrostatic.geometry import RecessedJournal
from babbitt.kinds.hydrostatic.lumped import land_interaction
from babbitt.kinds.hydrostatic.restrictors import Capillary, CheckValve, Orifice, Restrictor, Slot

__all__ = ["least_power_gap", "least_power_viscosity", "stiffest_ratio"]


def stiffest_ratio(restrictor: Restrictor, journal: RecessedJournal | None = None) -> float | None:
    """Pressure ratio of greatest stiffness at a given gap, the restrictor being free.

    Parameters
    ----------
    restrictor : Restrictor
    journal : RecessedJournal or None
        With capillaries the lands between its recesses raise the ratio a little, unless grooves drain them.

    Returns
    -------
    float or None
        None for laws without such a ratio.

    Examples
    --------
    >>> round(stiffest_ratio(Orifice(0.4e-3, 870.0)), 6)
    0.585786
    """
    law = restrictor.restrictor if isinstance(restrictor, CheckValve) else restrictor
    if isinstance(law, Orifice):
        return 2.0 - math.sqrt(2.0)
    if not isinstance(law, Capillary | Slot):
        return None
    if journal is None or journal.count < 3 or journal.groove_extent > 0.0:
        return 0.5
    share = land_interaction(journal) * (1.0 - math.cos(2.0 * math.pi / journal.count))
    return ((1.0 + share) - math.sqrt(1.0 + share)) / share


def least_power_gap(gap: float, pumping_power: float, land_friction_power: float) -> float:
    """Gap at which the sum of both powers is least for the same pressures, restrictors made to suit, m.

    Parameters
    ----------
    gap : float
        At which the powers are known, m.
    pumping_power, land_friction_power : float
        W. Friction in the recesses does not depend on the gap.
    """
    return float(gap * (land_friction_power / (3.0 * pumping_power)) ** 0.25)


def least_power_viscosity(viscosity: float, pumping_power: float, friction_power: float) -> float:
    """Viscosity at which the sum of both powers is least at the same gap, Pa s."""
    return viscosity * math.sqrt(pumping_power / friction_power)
