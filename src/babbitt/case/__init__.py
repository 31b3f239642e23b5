"""The case language: what an engineer writes, read from YAML, checked, and turned into problems to solve."""

from babbitt.case.case_file import CaseFile
from babbitt.case.case_hash import case_hash
from babbitt.case.kinds import KINDS, any_case, kinds, template
from babbitt.case.loading import case_from_dict, load_case, load_cases, located, parse_case
from babbitt.case.problems import CaseError, Problem
from babbitt.case.schema import case_schema
from babbitt.core.files.reading import Reach

__all__ = [
    "KINDS",
    "CaseError",
    "CaseFile",
    "Problem",
    "Reach",
    "any_case",
    "case_from_dict",
    "case_hash",
    "case_schema",
    "kinds",
    "load_case",
    "load_cases",
    "located",
    "parse_case",
    "template",
]
