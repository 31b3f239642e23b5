"""The case language: what an engineer writes, read from YAML, checked, and turned into design cases."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from babbitt.cases.build import case_hash, design_cases
from babbitt.cases.kinds import KINDS
from babbitt.cases.loading import case_from_dict, check_files, load_case, load_cases, located, parse_case
from babbitt.cases.machine import JournalCase, Machine
from babbitt.cases.problems import CaseError, Problem
from babbitt.cases.schema import case_schema
from babbitt.cases.templates import kinds, template
from babbitt.files.reading import Reach

if TYPE_CHECKING:
    from babbitt.cases.every_kind import AnyCase, Case
    from babbitt.cases.overhung_coupling import OverhungCouplingCase
    from babbitt.cases.screw_heel import ScrewHeelCase
    from babbitt.cases.thrust import ThrustCase
    from babbitt.cases.thrust_line import ThrustLineCase

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
    "AnyCase": "every_kind",
    "Case": "every_kind",
    "OverhungCouplingCase": "overhung_coupling",
    "ScrewHeelCase": "screw_heel",
    "ThrustCase": "thrust",
    "ThrustLineCase": "thrust_line",
}


def __getattr__(name: str) -> Any:
    """Import what a file seldom holds when it is first asked for."""
    from importlib import import_module

    if name not in _HOMES:
        raise AttributeError(f"module 'babbitt.cases' has no attribute {name!r}")
    return getattr(import_module(f"babbitt.cases.{_HOMES[name]}"), name)
