"""The command line: solve, check, compare, sweep, study, export, upgrade, new, schema, validate, list, ...."""

from __future__ import annotations

__all__ = ["main"]


def main() -> None:
    """Run the command line, which exits with its status; an interrupt ends it with one line and status 130."""
    from babbitt.cli.interruption import ended_by_interrupts

    with ended_by_interrupts():
        from babbitt.cli.program import run

        run()
