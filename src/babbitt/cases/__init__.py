"""The case language: what an engineer writes, read from YAML, checked, and turned into design cases."""

from babbitt.cases.build import case_hash, design_cases
from babbitt.cases.loading import KINDS, case_from_dict, check_files, load_case, load_cases, parse_case
from babbitt.cases.machine import AnyCase, Case, JournalCase, Machine
from babbitt.cases.overhung_coupling import OverhungCouplingCase
from babbitt.cases.problems import CaseError, Problem
from babbitt.cases.schema import case_schema
from babbitt.cases.screw_heel import ScrewHeelCase
from babbitt.cases.templates import kinds, template
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
    "parse_case",
    "template",
]
