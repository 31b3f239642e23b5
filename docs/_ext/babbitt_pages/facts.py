"""Numbers that the pages state about the program, taken from the program."""

from __future__ import annotations

from importlib.metadata import metadata

from babbitt.core.notices import explanations
from babbitt.design import heat_balance
from babbitt.kinds.journal.iso7902.characteristics import SPANS_DEGREES, table
from babbitt.properties.lubricants import catalogue
from babbitt.properties.materials import bearing_metals, structural_materials


def facts() -> dict[str, str]:
    """Substitutions for the pages: ``{{ eccentricity_nodes }}`` and so on."""
    nodes = table(360)
    eccentricities, widths = nodes.eccentricity_ratios, nodes.width_ratios
    return {
        "requires_python": metadata("babbitt")["Requires-Python"].removeprefix(">="),
        "spans": ", ".join(f"{span}°" for span in SPANS_DEGREES[:-1]) + f" and {SPANS_DEGREES[-1]}°",
        "eccentricity_nodes": str(len(eccentricities)),
        "width_nodes": str(len(widths)),
        "film_count": str(len(SPANS_DEGREES) * len(eccentricities) * len(widths)),
        "first_eccentricity": f"{eccentricities[0]:g}",
        "last_eccentricity": f"{eccentricities[-1]:g}",
        "first_width": f"{widths[0]:g}",
        "last_width": f"{widths[-1]:g}",
        "lubricant_count": str(len(catalogue())),
        "metal_count": str(len(bearing_metals())),
        "structure_count": str(len(structural_materials())),
        "code_count": str(len(explanations())),
        "ceiling": f"{heat_balance.CEILING - 273.15:.0f} °C",
    }
