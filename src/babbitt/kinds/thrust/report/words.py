"""What quantities mean in a thrust bearing and in a shaft line."""

__all__ = ["OF_THRUST"]

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
