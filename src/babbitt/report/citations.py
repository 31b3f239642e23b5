"""What to cite for the methods that a case uses."""

from __future__ import annotations

from babbitt import __version__
from babbitt.cases import Case, design_cases
from babbitt.standards.iso7902.model import Curves

BABBITT = f"The Babbitt developers: Babbitt {__version__}, calculation and design of fluid-film bearings, 2026."
ISO_7902 = (
    "ISO 7902-1, ISO 7902-2, ISO 7902-3: Hydrodynamic plain journal bearings under steady-state conditions, "
    "circular cylindrical bearings (procedure; the characteristics are computed by Babbitt, not copied)."
)
REYNOLDS = (
    "O. Reynolds: On the theory of lubrication and its application to Mr. Beauchamp Tower's experiments. "
    "Philosophical Transactions of the Royal Society 177 (1886) 157-234 (equation and rupture condition)."
)
DIN_31652 = (
    "DIN 31652-2: Plain bearings, hydrodynamic plain journal bearings, functions (closed-form approximations)."
)
VISCOSITY = "ASTM D341: Viscosity-temperature equations and charts for liquid petroleum or hydrocarbon products."


def citations_of(case: Case) -> tuple[str, ...]:
    """References for the software, the procedure, the characteristics and the lubricant of a case."""
    found = [BABBITT]
    designs = design_cases(case)
    if designs:
        found.append(ISO_7902)
    kinds = {design.curves for design in designs}
    if Curves.COMPUTED in kinds:
        found.append(REYNOLDS)
    if Curves.CLOSED_FORM in kinds:
        found.append(DIN_31652)
    oils = {design.lubricant.name: design.lubricant for design in designs}
    found += [f"{oil.name}: {oil.source}" for oil in oils.values()]
    return tuple(found)
