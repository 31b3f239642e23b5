"""What comes out: tables, figures, PDF and HTML."""

from babbitt.report.outputs import outputs
from babbitt.report.table import print_machine

__all__ = ["outputs", "print_machine"]
