"""The vocabulary: each named quantity with its symbol, SI unit, the engineer's unit and one line of meaning.

Tables, reports, plots and the documentation take names and units from here, so that a quantity is called the
same everywhere. Terms follow ISO 4378; symbols follow ISO 7902 where it has one.
"""

from __future__ import annotations

from babbitt.core.quantities.display import SYSTEMS, DisplayUnit, displayed_in
from babbitt.core.quantities.dynamics import DYNAMICS
from babbitt.core.quantities.footstep import FOOTSTEP
from babbitt.core.quantities.hydrostatics import HYDROSTATICS
from babbitt.core.quantities.journal import JOURNAL
from babbitt.core.quantities.one_dimension import ONE_DIMENSION
from babbitt.core.quantities.quantity import AXES, Quantity
from babbitt.core.quantities.shaft_lines import SHAFT_LINES
from babbitt.core.quantities.shafts import SHAFTS
from babbitt.core.quantities.thrust import THRUST
from babbitt.core.quantities.tilting_pads import TILTING_PADS

__all__ = ["AXES", "DisplayUnit", "QUANTITIES", "Quantity", "SYSTEMS", "displayed_in"]

QUANTITIES: dict[str, Quantity] = {
    one.name: one
    for one in (
        *JOURNAL,
        *DYNAMICS,
        *ONE_DIMENSION,
        *FOOTSTEP,
        *HYDROSTATICS,
        *SHAFTS,
        *THRUST,
        *SHAFT_LINES,
        *TILTING_PADS,
    )
}
