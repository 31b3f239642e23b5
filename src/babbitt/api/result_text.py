"""How a result reads in a terminal and in a notebook."""

from __future__ import annotations

import math
from html import escape

from babbitt.core.check_text import comparison, written
from babbitt.core.limited_flow import is_limited, quantity_held
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.labels import label
from babbitt.report.text import plain_text
from babbitt.report.view import view_of

__all__ = ["html_of", "key_values", "text_of"]

SHOWN = 16
"""Results that are listed; all of them stand in ``values``."""

LONGEST = 160
"""Letters of a message that are shown."""


def key_values(result: Result) -> list[tuple[str, str]]:
    """The results that matter most, each with its value and unit, in the order of the report.

    Of a bearing short of oil they are those of the film against which its limits are held.
    """
    wanted = [name for name in view_of(result).key_results if name in result.values] or list(result.values)
    held = [name if is_limited(name) else quantity_held(result, name) for name in wanted]
    known = [name for name in dict.fromkeys(held) if name in QUANTITIES and name != "wall_time"]
    return [
        (label(name, result.kind), written(name, value))
        for name in known
        if math.isfinite(value := result.values.get(name, math.nan))
    ]


def facts_of(result: Result) -> list[tuple[str, str]]:
    """Verdict, governing check, or why there is no operating point."""
    facts = [("verdict", result.verdict.value)]
    if not result.outcome.solved:
        return [*facts, ("outcome", result.outcome.value), ("message", _shortened(result.message))]
    governing = result.governing_check
    if governing is not None:
        facts.append(("governing check", f"{governing.code}  {comparison(governing)}"))
    if result.warnings:
        facts.append(("warnings", ", ".join(dict.fromkeys(one.code for one in result.warnings))))
    return facts


def text_of(result: Result) -> str:
    """Name, verdict, governing check and key results, in fewer than 25 lines."""
    facts = [(heading, value) for heading, value in facts_of(result) if value]
    rows = key_values(result) if result.outcome.solved else []
    shown, left = rows[:SHOWN], len(rows[SHOWN:])
    width = max((len(heading) for heading, _ in (*facts, *shown)), default=0)
    lines = [f"{plain_text(result.name)}  ({result.kind}, {result.method})"]
    lines += [f"  {heading:<{width}}  {_shortened(value)}" for heading, value in (*facts, *shown)]
    return "\n".join([*lines, *([f"  and {left} more in .values"] if left else [])])


def html_of(result: Result) -> str:
    """The same as a table of HTML."""
    rows = key_values(result)[:SHOWN] if result.outcome.solved else []
    facts = [(heading, value) for heading, value in facts_of(result) if value]
    cells = "".join(
        f"<tr><th style='text-align:left'>{escape(heading)}</th><td>{escape(value)}</td></tr>"
        for heading, value in (*facts, *rows)
    )
    heading = f"{escape(plain_text(result.name))} ({escape(result.kind)}, {escape(result.method)})"
    return f"<table><caption>{heading}</caption><tbody>{cells}</tbody></table>"


def _shortened(text: str) -> str:
    line = " ".join(text.split())
    return line if len(line) <= LONGEST else f"{line[: LONGEST - 1]}…"
