"""The bearings of the marine reverse gear as design cases, from inferred inputs.

The study prints results and hardly any dimensions. What was inferred stands in ``data/reverse_gear.json`` with a
statement that says so; nothing of it stands anywhere else.
"""

from __future__ import annotations

import math
from typing import Any

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.iso7902.model import Bearing, DesignCase, Friction, OilSupply, PrescribedLoad
from babbitt.kinds.journal.iso7902.supply import Arrangement, HalfCircumferentialGroove, Pockets, SupplyElement
from babbitt.kinds.shaft.overhung_coupling import MeshForce, OverhungCoupling, bearing_loads
from babbitt.properties.lubricants import lubricant
from babbitt.validation.reference_data import reference_data

_JOURNAL_STEEL = 11e-6  # 1/K, textbook value; only the difference to the bearing matters


def published() -> dict[str, Any]:
    """What the study prints."""
    printed: dict[str, Any] = reference_data("reverse_gear")["published"]
    return printed


def inferred() -> dict[str, Any]:
    """What is inferred from it."""
    inputs: dict[str, Any] = reference_data("reverse_gear")["inferred"]
    return inputs


def inferred_bearing(name: str) -> dict[str, Any]:
    """Inferred dimensions and speed of one bearing."""
    found: dict[str, Any] = next(bearing for bearing in inferred()["bearings"] if bearing["name"] == name)
    return found


def load(name: str) -> float:
    """Load in N: published load per area times inferred area; of the output wheel that of its shaft, Table 3."""
    if name == "Output wheel":
        return bearing_loads(output_wheel_shaft(MeshForce.DOWNWARD)).reaction_2
    bearing, rows = inferred_bearing(name), published()["tables_4_and_5"]["rows"]
    pressure: float = next(row["specific_load_MPa"] for row in rows if row["name"] == name)
    return pressure * float(bearing["diameter_mm"]) ** 2 * float(bearing["width_ratio"])


def output_wheel_shaft(direction: MeshForce) -> OverhungCoupling:
    """The shaft of the output wheel as Table 3 gives it."""
    table = published()["table_3"]
    return OverhungCoupling(
        mesh_force=1e3 * table["mesh_force_kN"],
        mesh_angle=math.radians(table["mesh_angle_deg"]),
        mesh_direction=direction,
        bearing_distance=1e-3 * table["bearing_distance_mm"],
        gear_mass=1e3 * table["gear_mass_t"],
        coupling_mass=1e3 * table["coupling_mass_t"],
        flange_distance=1e-3 * table["flange_distance_mm"],
        coupling_length=1e-3 * table["coupling_length_mm"],
    )


def design_case(
    name: str, *, span: int | None = None, friction: Friction | None = None, friction_factor: float | None = None
) -> DesignCase:
    """One bearing of the gear.

    Parameters
    ----------
    name : str
        As in the table of the study.
    span : int, optional
        In degrees; the inferred one when omitted.
    friction : Friction, optional
        The friction curve of the full bearing when omitted, which is what the study appears to have used.
    friction_factor : float, optional
        The one that reproduces Table 2 when omitted.

    Returns
    -------
    DesignCase
    """
    bearing, common = inferred_bearing(name), inferred()["common"]
    diameter = 1e-3 * bearing["diameter_mm"]
    width = diameter * bearing["width_ratio"]
    return DesignCase(
        name=name,
        bearing=Bearing(
            diameter=diameter,
            width=width,
            relative_clearance=1e-3 * bearing["relative_clearance_permille"],
            span=span or bearing["span_deg"],
            expansion_bearing=_JOURNAL_STEEL + 1e-6 * common["expansion_bearing_less_journal_1e6_per_K"],
            expansion_journal=_JOURNAL_STEEL,
            supply_element=_supply_element(bearing, width),
        ),
        duty=PrescribedLoad(load(name)),
        journal_speed=2.0 * bearing["surface_speed_m_s"] / diameter,
        lubricant=lubricant(common["lubricant"]),
        oil_supply=OilSupply(common["inlet_temperature_C"] + ZERO_CELSIUS, 1e6 * common["element_pressure_MPa"]),
        friction=friction or Friction(common["friction"]),
        friction_factor=friction_factor or common["friction_factor"],
        assumptions=(inferred()["statement"],),
    )


def _supply_element(bearing: dict[str, Any], width: float) -> SupplyElement:
    if bearing["supply_element"] == "groove":
        return HalfCircumferentialGroove(inferred()["common"]["groove_width_ratio"] * width)
    return Pockets(bearing["pocket_width_ratio"] * width, Arrangement.BOTH_SIDES)
