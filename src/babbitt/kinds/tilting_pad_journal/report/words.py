"""What quantities mean in a tilting-pad bearing, and what its calculation needs on its way."""

from __future__ import annotations

from babbitt.core.quantities import AXES, DisplayUnit
from babbitt.core.quantities.display import SI
from babbitt.report.local_quantity import MICRO, local

__all__ = ["OF_PADS", "PAD_WORDS"]

OF_PADS = {
    "diameter": "Diameter of the journal",
    "relative_clearance": "Relative clearance, assembled over radius",
    "eccentricity_ratio": "Relative eccentricity, over the assembled clearance",
    "preload": "Preload, the least of all pads",
    "stiffness": "Synchronous stiffness, pads following",
    "damping": "Synchronous damping, pads following",
    "total_flow": "Fresh oil that the pads draw in",
    "side_flow": "Oil over the sides of the pads",
    "outlet_temperature": "Mean temperature of the oil that leaves",
    "supply_temperature": "Temperature of the fresh oil",
    "effective_viscosity": "Dynamic viscosity of the films",
    "film_reynolds_number": "Reynolds number at the machined clearance",
    "effective_temperature": "Temperature of the films, their mean where they differ",
    "maximum_temperature": "Highest temperature of films and bores",
    "groove_temperature": "Hottest oil in front of a pad, after mixing",
    "rotor_mass": "Mass of the rotor that the bearing carries",
    "shaft_stiffness": "Stiffness of the shaft between rotor and journal",
    "iterations": "Films of the heat balance",
    **{
        f"{name}_{axes}": f"Synchronous {name}, force in {axes[0]} over {motion} in {axes[1]}"
        for name, motion in (("stiffness", "move"), ("damping", "speed"))
        for axes in AXES
    },
}
"""What quantities mean in a bearing of tilting pads."""

STIFF = DisplayUnit("MN/m", 1e-6)

PAD_WORDS = (
    local("eccentric", "e", "m", "Eccentricity of the journal", 5, MICRO),
    local("this_pivot", "θ_p", "rad", "Pivot of the pad that carries most", 6),
    local("this_clearance", "c_p", "m", "Its machined clearance", 5, MICRO),
    local("this_gap", "c_b", "m", "Its assembled clearance", 5, MICRO),
    local("this_preload", "m_p", "1", "Its preload", 5),
    local("this_retreat", "u", "m", "How far its pivot gives way", 5, MICRO),
    local("this_approach", "ξ", "m", "Way of the journal towards its pivot", 5, MICRO),
    local("this_ratio", "ε_p", "1", "Eccentricity ratio at its pivot", 5),
    local("this_film", "h_p", "m", "Film at its pivot", 5, MICRO),
    local("this_radial", "K_ξξ", "N/m", "Stiffness of its film, force and way along the pivot", 5, STIFF),
    local("this_cross", "K_ξη", "N/m", "The same, way along the motion", 5, STIFF),
    local("this_back", "K_ηξ", "N/m", "The same, force along the motion", 5, STIFF),
    local("this_along", "K_ηη", "N/m", "The same, both along the motion", 5, STIFF),
    local("this_stiffness", "k_s", "N/m", "Its static stiffness, free to tilt", 5, STIFF),
    local("this_pivot_stiffness", "k_p", "N/m", "Stiffness of its pivot", 5, STIFF),
    local("this_together", "k", "N/m", "Film and pivot in series", 5, STIFF),
    local("pedestal_stiffness_x", "k_Px", "N/m", "Stiffness of the pedestal along x", 5, STIFF),
    local("pedestal_stiffness_y", "k_Py", "N/m", "Stiffness of the pedestal along y", 5, STIFF),
    local("mode_decay", "σ", "1/s", "Decay of the free motion that decides", 5),
    local("mode_frequency", "ω_d", "rad/s", "Its frequency", 5, SI["Hz"]),
)
"""Symbols as in the theory manual."""
