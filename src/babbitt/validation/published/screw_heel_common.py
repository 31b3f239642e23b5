"""The footstep of the study, as its data have it."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.footstep.model import Footstep, FootstepGeometry, FootstepOil, ScrewGroove
from babbitt.kinds.footstep.states import Method, SteadyState, steady_states
from babbitt.validation.reference_data import reference_data

MICRO, CUBIC_MILLIMETRE, MEGA = 1e-6, 1e-9, 1e6

SOURCE = (
    "A. S. Kirichenko, *Problems of Tribology* (2011), footstep of the three-screw pump 3V 63/25-1-45/6,3B: "
    "data and "
    "text claims as printed. The curves of the study are not at hand."
)


@lru_cache
def footstep(face_gap: float = 20.0, clearance: float = 20.0) -> Footstep:
    """The grooved footstep at a face gap and a clearance in micrometres."""
    d = reference_data("screw_heel")["case"]
    return Footstep(
        FootstepGeometry(d["length"], d["radius"], d["recess_radius"], d["bore_radius"], d["recess_depth"]),
        FootstepOil(
            d["viscosity"],
            d["temperature_celsius"] + ZERO_CELSIUS,
            d["exponent"],
            d["heat_capacity"],
            d["density"],
        ),
        d["speed_rpm"] * math.pi / 30.0,
        d["supply_pressure"],
        d["ambient_pressure"],
        face_gap * MICRO,
        clearance * MICRO,
        ScrewGroove(math.radians(d["angle_degrees"]), d["depth"], d["groove_width"], d["land_width"], d["starts"]),
    )


def smooth(step: Footstep) -> Footstep:
    """The same without groove."""
    return replace(step, groove=None)


@lru_cache(maxsize=1024)
def states(step: Footstep, method: Method = Method.SUPERPOSITION) -> dict[str, SteadyState]:
    """Steady states of the smooth and of the grooved heel by their names."""
    every = (*steady_states(smooth(step), method), *steady_states(step, method))
    return {state.name.value: state for state in every}
