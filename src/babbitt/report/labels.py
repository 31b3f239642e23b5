"""Names short enough to stand beside a symbol and a formula."""

from __future__ import annotations

from babbitt.report.line import VOCABULARY

SHORT = {
    "diameter": "Bearing diameter",
    "width_ratio": "Relative width",
    "angular_span": "Angular span",
    "relative_clearance": "Relative clearance at 20 °C",
    "operating_relative_clearance": "Operating relative clearance",
    "load": "Load",
    "specific_load": "Specific load",
    "angular_speed": "Speed of the journal",
    "hydrodynamic_speed": "Hydrodynamic speed",
    "surface_speed": "Surface speed",
    "pressure_speed_product": "Specific load × speed",
    "eccentricity_ratio": "Relative eccentricity",
    "attitude_angle": "Attitude angle",
    "sommerfeld_number": "Sommerfeld number",
    "friction_number": "Friction number",
    "friction_torque": "Friction torque",
    "friction_power": "Friction power",
    "side_flow_number": "Side-flow number",
    "side_flow": "Side flow",
    "supply_flow_number": "Supply-flow number",
    "supply_flow": "Supply flow",
    "total_flow": "Total flow",
    "film_reynolds_number": "Reynolds number",
    "critical_reynolds_number": "Critical Reynolds number",
    "supply_temperature": "Inlet temperature",
    "outlet_temperature": "Outlet temperature",
    "effective_temperature": "Effective temperature",
    "effective_viscosity": "Dynamic viscosity",
    "effective_kinematic_viscosity": "Kinematic viscosity",
    "density": "Density",
    "volumetric_heat_capacity": "Heat capacity per volume",
    "heat_to_oil": "Heat to the oil",
    "heat_to_surroundings": "Heat to the surroundings",
    "supply_pressure": "Supply pressure",
    "element_pressure": "Pressure at the supply element",
    "empirical_film_limit": "Least film by experience",
    "geometric_film_limit": "Least film by surface geometry",
    "transition_film_thickness": "Film thickness at transition",
    "transition_speed": "Speed of transition",
    "stability_relative_clearance": "Least clearance against whirl",
    "recommended_relative_clearance": "Recommended clearance",
    **{f"stiffness_{axes}": "Film stiffness" for axes in ("xx", "xy", "yx", "yy")},
    **{f"damping_{axes}": "Film damping" for axes in ("xx", "xy", "yx", "yy")},
    "rotor_mass": "Mass of the rotor",
    "critical_mass": "Critical mass",
    "whirl_frequency_ratio": "Whirl frequency over speed",
    "threshold_speed": "Threshold speed of whirl",
    "preload": "Preload of the lobes",
    "lobe_clearance": "Clearance of the lobes",
    "mass_balance_error": "Oil lost in the film",
    "mean_pressure_ratio": "Mean pressure ratio",
    "recess_pressure": "Recess pressures",
    "pressure_ratio": "Pressure ratios",
    "restrictor_flow": "Flows of the restrictors",
    "pumping_power": "Pumping power",
    "pump_power": "Power of the pump",
    "power_ratio": "Friction over pumping power",
    "temperature_rise": "Rise between manifold and drain",
    "pad_stiffness": "Stiffness of the pad",
    "pad_damping": "Damping of the pad",
    "tilt_stiffness": "Tilt stiffness",
    "compressibility_damping_loss": "Damping lost to the oil",
    "network_stability": "Stability of the network",
    "stiffest_pressure_ratio": "Stiffest pressure ratio",
    "least_power_gap": "Gap of least power",
    "cavitated_share": "Lands without film",
    "load_capacity": "Load at the least gap",
    "grid_error": "Error by the grid",
    "breakaway_pressure": "Breakaway, upper bound",
    "lying_pressure": "Breakaway, lower bound",
    "recess_reynolds_number": "Reynolds number in the recess",
}


def label(name: str) -> str:
    """Short name of a quantity; its meaning where the vocabulary's own is short enough.

    >>> label("specific_load"), label("minimum_film_thickness")
    ('Specific load', 'Minimum film thickness')
    """
    if name in SHORT:
        return SHORT[name]
    return VOCABULARY[name].meaning if name in VOCABULARY else name
