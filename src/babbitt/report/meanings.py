"""What a quantity means where another kind of bearing than the standard's gives it."""

from __future__ import annotations

from babbitt.core.quantities import QUANTITIES

__all__ = ["OF_THRUST", "meaning"]

PUMPED = {
    "total_flow": "Oil through all restrictors",
    "effective_viscosity": "Dynamic viscosity of the oil in the film",
    "supply_pressure": "Gauge pressure before the restrictors",
    "iterations": "Steps of the search",
}
"""Hydrostatic bearings and footsteps: no film flow Q3 and supply flow Qp, no effective temperature."""
OF_THRUST = {
    "load": "Thrust",
    "specific_load": "Thrust over the area of all pads",
    "angular_speed": "Rotational speed of the collar",
    "surface_speed": "Surface speed of the collar at the mean radius",
    "friction_torque": "Friction torque on the collar",
    "side_flow": "Oil over inner and outer edges of the pads",
    "total_flow": "Fresh oil, what is not carried over",
    "outlet_temperature": "Mean temperature of the oil that leaves",
    "supply_temperature": "Temperature of the fresh oil",
    "temperature_rise": "Mean rise of all oil that passes the films",
    "film_reynolds_number": "Reynolds number of the thickest pivot film",
    "effective_viscosity": "Dynamic viscosity of the films",
}
"""What quantities mean in a thrust bearing or its shaft line, which have a collar and no journal."""
JACKING = {"total_flow": "Oil of all pockets", "effective_area": "Load over pocket pressure"}


def meaning(name: str, kind: str) -> str:
    """Give one line on a quantity of a result.

    Parameters
    ----------
    name : str
        Of the vocabulary.
    kind : str
        Of the result.

    Examples
    --------
    >>> meaning("total_flow", "hydrostatic_pad"), meaning("total_flow", "journal_bearing")
    ('Oil through all restrictors', 'Total oil flow Q3 + Qp')
    """
    if kind in ("thrust", "thrust_line") and name in OF_THRUST:
        return OF_THRUST[name]
    if kind == "jacking_pocket" and name in JACKING:
        return JACKING[name]
    pumped = kind in ("screw_heel", "jacking_pocket") or kind.startswith("hydrostatic_")
    return PUMPED[name] if pumped and name in PUMPED else QUANTITIES[name].meaning
