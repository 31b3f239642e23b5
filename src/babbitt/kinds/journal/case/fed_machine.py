"""From a machine with an oil system to one problem: its bearings behind their lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from babbitt.core.notices import InputError
from babbitt.core.solution import Calculation
from babbitt.kinds.journal.case.machine import SeveralBearings
from babbitt.kinds.journal.limits_of_clearance import without_limits
from babbitt.kinds.journal.methods import OilBalance
from babbitt.kinds.journal.oil_balance.model import OilSystemProblem

__all__ = ["oil_system_calculation", "refuse_oil_system"]

ASSUMPTIONS = (
    "Oil system: no loss between pump and header, all lines begin at the pressure of the header, and the oil in "
    "them has the temperature of the supply.",
    "What a bearing needs is what its film draws by its own pressure (Q₃); with less it starves.",
)


def oil_system_calculation(case: SeveralBearings, calculations: Sequence[Calculation]) -> Calculation:
    """Put the lines before the supplies of all bearings, and all into one problem."""
    assert case.oil_system is not None
    system = case.oil_system.system([one.name for one in case.bearings])
    fed = []
    for line, one in zip(system.lines, calculations, strict=True):
        problem: Any = one.problem
        supply = problem.oil_supply
        behind = replace(supply, tubes=(*line.ducts, *supply.tubes))
        fed.append(without_limits(replace(one, problem=problem.fed_by(behind))))
    assumed = [
        f"Discharge coefficient of the orifice of {given.bearing}: {given.discharge_coefficient:g} (assumption)."
        for given in case.oil_system.lines
        if given.orifice_diameter is not None and "discharge_coefficient" not in given.model_fields_set
    ]
    problem = OilSystemProblem(
        f"Oil system of {case.name}", case.kind, system, tuple(fed), assumptions=(*ASSUMPTIONS, *assumed)
    )
    return Calculation(problem, OilBalance())


def refuse_oil_system(case: object) -> None:
    """Refuse to compare methods for bearings whose pressures follow from an oil system, with E004."""
    if isinstance(case, SeveralBearings) and case.oil_system is not None:
        raise InputError(
            "E004",
            f"{case.name}: methods are compared at a given pressure, and an oil_system balances all bearings by "
            "one. Give supply.pressure in place of oil_system.",
        )
