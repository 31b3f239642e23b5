"""What quantities mean in a thrust bearing and in a shaft line, and what its calculation needs on its way."""

from babbitt.report.local_quantity import MICRO, MILLI, PER_MINUTE, local

__all__ = ["OF_THRUST", "THRUST_WORDS"]

OF_THRUST = {
    "load": "Thrust",
    "specific_load": "Thrust over the area of all pads",
    "angular_speed": "Rotational speed of the collar",
    "surface_speed": "Surface speed of the collar at the mean radius",
    "pressure_speed_product": "Mean pressure of the pad that carries most times that speed",
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

THRUST_WORDS = (
    local("inner_radius", "r_i", "m", "Inner radius of the pads", 5, MILLI),
    local("outer_radius", "r_o", "m", "Outer radius of the pads", 5, MILLI),
    local("mean_radius", "r_m", "m", "Mean radius of the pads", 5, MILLI),
    local("pad_extent", "β_P", "rad", "Angle of a pad", 6),
    local("pad_area", "A_P", "m2", "Area of a pad", 5),
    local("thickest_film", "h_p,max", "m", "Thickest film over a pivot", 5, MICRO),
    local("this_minimum_film", "h_P", "m", "Its thinnest film", 5, MICRO),
    local("film_thickness_ratio", "h_P/h_p", "1", "Film thickness ratio, thinnest over that at the pivot", 5),
    local("friction_of_thrust", "f_T", "1", "Friction coefficient at the mean radius", 5),
    local("carried_flow", "Q_c", "m3/s", "Hot oil carried over", 5, PER_MINUTE),
    local("this_inlet_temperature", "T_1,P", "K", "Temperature of the oil that it takes in", 6),
    local("this_power", "P_P", "W", "Its friction power", 5),
    local("this_trailing_flow", "Q_te,P", "m3/s", "Oil over its trailing edge", 5, PER_MINUTE),
    local("this_side_flow", "Q_s,P", "m3/s", "Oil over its sides", 5, PER_MINUTE),
    local("this_temperature", "T_P", "K", "Temperature of its film", 6),
    local("this_viscosity", "η_P", "Pa s", "Viscosity of its film", 5),
    local("this_trailing_temperature", "T_te,P", "K", "Temperature of the oil at its trailing edge", 6),
    local("passing_warming", "ΔT_z", "K (abs)", "Rise of all oil that passes the films", 5),
)
"""Symbols as in the theory manual."""
