"""Published cases: story, reference, our answer and the figure.

Each case is at once a test (``validation/test_published_cases.py``), a page of the documentation (`page`,
`save_figure`) and a run of ``babbitt validate``.
"""

from babbitt.validation.case import Comparison, Evidence, Story, ValidationCase, Verdict
from babbitt.validation.figure import figure_file, figure_of, save_figure
from babbitt.validation.page import page
from babbitt.validation.registry import cases, cases_of, validation_case
from babbitt.validation.summary import Summary, by_quantity, summary
from babbitt.validation.tolerance import AtLeast, AtMost, SetBy, Tolerance, Within

__all__ = [
    "AtLeast",
    "AtMost",
    "Comparison",
    "Evidence",
    "SetBy",
    "Story",
    "Summary",
    "Tolerance",
    "ValidationCase",
    "Verdict",
    "Within",
    "by_quantity",
    "cases",
    "cases_of",
    "figure_file",
    "figure_of",
    "page",
    "save_figure",
    "summary",
    "validation_case",
]
