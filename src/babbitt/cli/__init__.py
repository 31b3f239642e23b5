"""The command line: solve, check, compare, sweep, export, new, schema, validate, list, explain, cite."""

from babbitt.cli import calculating, telling
from babbitt.cli.app import NO_SOLUTION, NOT_PASSED, SOLVED, UNUSABLE_INPUT, app, main

__all__ = [
    "NOT_PASSED",
    "NO_SOLUTION",
    "SOLVED",
    "UNUSABLE_INPUT",
    "app",
    "calculating",
    "main",
    "telling",
]
