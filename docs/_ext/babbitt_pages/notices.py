"""The page of notices: every code with its meaning and remedy."""

from __future__ import annotations

from babbitt.core.notices import explanations
from babbitt_pages.markdown import anchor, text

FAMILIES = {
    "E": ("Unusable input", "Exit status 2. Nothing was computed and nothing was written."),
    "S": ("No solution", "Exit status 3. The message of the case says how far it came."),
    "W": (
        "Warnings",
        "They stand beside a result, name the numbers that raise them, and each says what it does to the verdict.",
    ),
    "C": (
        "Checks",
        "Comparisons of a value with a limit, each with its source. A missed recommendation or screening "
        "indicator changes no verdict.",
    ),
}
"""First letter of a code, the heading of its kind, and what the kind means for a run."""


def page() -> str:
    """Markdown of all codes, one section a kind."""
    parts = []
    for letter, (heading, meaning) in FAMILIES.items():
        parts.append(f"## {heading}\n\n{meaning}\n")
        parts += [_entry(code) for code in sorted(explanations()) if code.startswith(letter)]
    return "\n".join(parts)


def _entry(code: str) -> str:
    found = explanations()[code]
    return (
        f"{anchor(code.lower())}### {code} {text(found.title)}\n\n{text(found.meaning)}\n\n"
        f"*What to do:* {text(found.remedy)}\n" + _effect(code)
    )


def _effect(code: str) -> str:
    return f"\n*Verdict:* {explanations()[code].effect.value}.\n" if code.startswith("W") else ""
