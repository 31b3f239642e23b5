"""The page of notices: every code with its meaning and remedy."""

from __future__ import annotations

from babbitt.notices import EXPLANATIONS
from babbitt_pages.markdown import anchor, text

FAMILIES = {
    "E": ("Unusable input", "Exit status 2. Nothing was computed and nothing was written."),
    "S": ("No solution", "Exit status 3. The message of the case says how far it came."),
    "W": ("Doubts", "They ride along with a result and name the numbers that raise the doubt."),
    "C": (
        "Checks",
        "Comparisons of a value with a limit, each with its source. A missed check that is *advice only* does not "
        "count as a violated limit.",
    ),
}
"""First letter of a code, the heading of its kind, and what the kind means for a run."""


def page() -> str:
    """Markdown of all codes, one section a kind."""
    parts = []
    for letter, (heading, meaning) in FAMILIES.items():
        parts.append(f"## {heading}\n\n{meaning}\n")
        parts += [_entry(code) for code in sorted(EXPLANATIONS) if code.startswith(letter)]
    return "\n".join(parts)


def _entry(code: str) -> str:
    found = EXPLANATIONS[code]
    return (
        f"{anchor(code.lower())}### {code} {text(found.title)}\n\n{text(found.meaning)}\n\n"
        f"*What to do:* {text(found.remedy)}\n"
    )
