"""What quantities mean in a tilting-pad bearing, and what its calculation needs on its way."""

from __future__ import annotations

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
    "iterations": "Films of the heat balance",
}
"""What quantities mean in a bearing of tilting pads."""

PAD_WORDS = ()
