"""The case language: what an engineer writes, read from YAML, checked, and turned into design cases."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from babbitt.case.build import case_hash, design_cases
from babbitt.case.kinds import KINDS
from babbitt.case.loading import case_from_dict, check_files, load_case, load_cases, located, parse_case
from babbitt.case.problems import CaseError, Problem
from babbitt.case.schema import case_schema
from babbitt.case.templates import kinds, template
from babbitt.core.files.reading import Reach
from babbitt.kinds.journal.case.machine import JournalCase, Machine

if TYPE_CHECKING:
    from babbitt.case.every_kind import AnyCase, Case
    from babbitt.kinds.coupling.case.overhung_coupling import OverhungCouplingCase
    from babbitt.kinds.footstep.case.footstep import ScrewHeelCase
    from babbitt.kinds.shaft_line.case.shaft_line import ThrustLineCase
    from babbitt.kinds.thrust.case.thrust import ThrustCase

__all__ = [
    "KINDS",
    "AnyCase",
    "Case",
    "CaseError",
    "JournalCase",
    "Machine",
    "OverhungCouplingCase",
    "Problem",
    "Reach",
    "ScrewHeelCase",
    "ThrustCase",
    "ThrustLineCase",
    "case_from_dict",
    "case_hash",
    "case_schema",
    "check_files",
    "design_cases",
    "kinds",
    "load_case",
    "load_cases",
    "located",
    "parse_case",
    "template",
]

_HOMES = {
    "AnyCase": "babbitt.case.every_kind",
    "Case": "babbitt.case.every_kind",
    "OverhungCouplingCase": "babbitt.kinds.coupling.case.overhung_coupling",
    "ScrewHeelCase": "babbitt.kinds.footstep.case.footstep",
    "ThrustCase": "babbitt.kinds.thrust.case.thrust",
    "ThrustLineCase": "babbitt.kinds.shaft_line.case.shaft_line",
}


def __getattr__(name: str) -> Any:
    """Import what a file seldom holds when it is first asked for."""
    from importlib import import_module

    if name not in _HOMES:
        raise AttributeError(f"module 'babbitt.case' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
