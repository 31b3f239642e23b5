"""Names short enough to stand beside a symbol and a formula."""

from __future__ import annotations

from babbitt.core.language import ENGLISH, language, translated, translated_if_known
from babbitt.core.quantities import AXES
from babbitt.report.meanings import meaning, own_meaning
from babbitt.report.vocabulary import VOCABULARY

SHORT = {
    "diameter": "Bearing diameter",
    "width_ratio": "Relative width",
    "angular_span": "Angular span",
    "specific_load": "Specific load",
    "angular_speed": "Speed of the journal",
    "hydrodynamic_speed": "Hydrodynamic speed",
    "surface_speed": "Surface speed",
    "pressure_speed_product": "Specific load × speed",
    "eccentricity_ratio": "Relative eccentricity",
    "attitude_angle": "Attitude angle",
    "narrowest_gap_angle": "Direction of the narrowest gap",
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
    "maximum_temperature": "Hottest place of the film",
    "hot_spot_angle": "Hottest place, direction",
    "hot_spot_position": "Hottest place, axial",
    "groove_temperature": "Warmest groove",
    "mean_bush_temperature": "Bore, mean temperature",
    "maximum_bush_temperature": "Bush, highest temperature",
    "mean_wall_temperature": "Film at the bore, mean",
    "maximum_wall_temperature": "Film at the bore, hottest",
    "returned_flow": "Oil back into supplies",
    "heat_returned": "Heat back into supplies",
    "film_dissipation": "Heat generated in the film",
    "heat_film_to_bush": "Heat to the bush",
    "heat_film_to_journal": "Heat to the journal",
    "effective_viscosity": "Dynamic viscosity",
    "effective_kinematic_viscosity": "Kinematic viscosity",
    "density": "Density",
    "volumetric_heat_capacity": "Heat capacity per volume",
    "heat_to_oil": "Heat to the oil",
    "heat_to_surroundings": "Heat to the surroundings",
    "supply_pressure": "Supply pressure (gauge)",
    "element_pressure": "Pressure at the supply element",
    "empirical_film_limit": "Least film by experience",
    "geometric_film_limit": "Least film by surface geometry",
    "transition_film_thickness": "Film thickness at transition",
    "transition_speed": "Speed of transition",
    "asperity_transition_speed": "Speed at 1 % on asperities",
    "asperity_load_share": "Load on asperities",
    "film_parameter": "Least gap over roughness",
    "mixed_friction_coefficient": "Friction with asperities",
    "least_friction_coefficient": "Least friction coefficient",
    "least_friction_speed": "Speed of least friction",
    "composite_roughness": "Composite roughness",
    "contact_modulus": "Modulus of the asperities",
    "stability_relative_clearance": "Least clearance against whirl",
    "recommended_relative_clearance": "Recommended clearance",
    **{f"stiffness_{axes}": "Film stiffness" for axes in AXES},
    **{f"damping_{axes}": "Film damping" for axes in AXES},
    **{f"tilt_stiffness_{axes}": "Tilt stiffness" for axes in AXES},
    **{f"tilt_damping_{axes}": "Tilt damping" for axes in AXES},
    "film_moment_x": "Moment of the film",
    "film_moment_y": "Moment of the film",
    "rotor_mass": "Mass of the rotor",
    "critical_mass": "Critical mass",
    "least_stable_mass": "Least stable mass",
    "whirl_frequency_ratio": "Whirl frequency over speed",
    "threshold_speed": "Threshold speed of whirl",
    "critical_mass_elastic": "Critical mass, elastic shaft",
    "threshold_speed_elastic": "Threshold, elastic shaft",
    "preload": "Preload of the lobes",
    "lobe_clearance": "Clearance of the lobes",
    "mass_balance_error": "Oil lost in the film",
    "minimum_film_thickness_error": "Grid error of the film thickness",
    "position_error": "Grid error of the position",
    "load_error": "Grid error of the load",
    "stiffness_error": "Grid error of the stiffness",
    "damping_error": "Grid error of the damping",
    "mean_pressure_ratio": "Mean pressure ratio",
    "recess_pressure": "Recess pressures",
    "pressure_ratio": "Pressure ratios",
    "restrictor_flow": "Flows of the restrictors",
    "pumping_power": "Pumping power",
    "pump_power": "Power of the pump",
    "power_ratio": "Friction over pumping power",
    "temperature_rise": "Rise between manifold and drain",
    "gap_stiffness": "Stiffness of the pad",
    "gap_damping": "Damping of the pad",
    "least_tilt_stiffness": "Least tilt stiffness",
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
    "restrictor_reynolds_number": "Reynolds number in the capillaries",
    "edge_inertia": "Inertia at the recess edge",
    "least_power_viscosity": "Viscosity of least power",
}


def told_meaning(name: str, kind: str) -> str:
    """What a quantity means; its short name in a language that has no words for the meaning.

    >>> told_meaning("total_flow", "journal")
    'Total oil flow Q3 + Qp'
    """
    said = meaning(name, kind)
    known = translated_if_known(said)
    return known if known != said or language() == ENGLISH else label(name, kind)


def label(name: str, kind: str = "") -> str:
    """Short name of a quantity; its meaning where the vocabulary's own is short enough.

    >>> label("specific_load"), label("minimum_film_thickness")
    ('Specific load', 'Minimum film thickness')
    >>> label("angular_speed", "thrust")
    'Rotational speed of the collar'
    """
    if own := own_meaning(name, kind):
        return translated(own)
    if name in SHORT:
        return translated(SHORT[name])
    return translated(VOCABULARY[name].meaning) if name in VOCABULARY else name
