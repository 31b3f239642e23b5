"""Names of results: which bearing, which operating point, which clearance, and how many of them.

`babbitt.cases.design_cases` makes them: ``Bearing``, ``Bearing [point]``, ``Bearing [point] (minimum clearance)``.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from babbitt.report.text import counted, plain_text

NAMES_SHOWN = 2
"""How many bearings a line on the terminal names before it counts the rest."""

FEW = 3
"""How many bearings may be left out of a list that says "all but"."""

_CLEARANCE = re.compile(r" \((minimum|mean|maximum) clearance\)$")
_STATE = re.compile(r" \(((?:\d+\. )?(?:hot|cold|middle|fold) state|(?:smooth|grooved) heel)\)$")
_POINT = re.compile(r" \[.*\]$")


def split_clearance(name: str) -> tuple[str, str]:
    """A name without its clearance, and which clearance that is; empty for none. Steady states of a footstep count
    as clearances do: results of one bearing side by side.

    >>> split_clearance("Fan shaft (minimum clearance)"), split_clearance("Pinion (a)")
    (('Fan shaft', 'minimum'), ('Pinion (a)', ''))
    >>> split_clearance("Footstep (hot state)")
    ('Footstep', 'hot state')
    """
    found = _CLEARANCE.search(name) or _STATE.search(name)
    return (name[: found.start()], found[1]) if found else (name, "")


def worded(members: Sequence[str]) -> str:
    """Say which results of one bearing are meant.

    >>> worded(["minimum", "mean"]), worded(["hot state", "cold state"])
    ('minimum, mean clearance', 'hot state, cold state')
    """
    clearances = all(member in ("minimum", "mean", "maximum") for member in members)
    return ", ".join(members) + (" clearance" if clearances else "")


def bearing_of(name: str) -> str:
    """A name without operating point and clearance.

    >>> bearing_of("Fan shaft [full speed] (minimum clearance)")
    'Fan shaft'
    """
    return _POINT.sub("", split_clearance(name)[0])


def counted_results(names: Sequence[str]) -> str:
    """How many bearings the results of a machine are, or how many cases of how many bearings.

    >>> counted_results(["A", "B"]), counted_results(["A (minimum clearance)", "A (maximum clearance)"])
    ('2 bearings', '2 cases of 1 bearing')
    """
    bearings = len({bearing_of(name) for name in names})
    if bearings == len(names):
        return counted(bearings, "bearing")
    return f"{counted(len(names), 'case')} of {counted(bearings, 'bearing')}"


def listed(names: Sequence[str], of: Sequence[str]) -> str:
    """Every one of some names, as compactly as can be done without leaving one out.

    Parameters
    ----------
    names : sequence of str
        In the order in which they shall stand.
    of : sequence of str
        All results of the machine.

    Examples
    --------
    >>> listed(["C", "A"], ["A", "B", "C", "D"]), listed(["A", "C", "D", "B"], ["A", "B", "C", "D", "E"])
    ('C; A', 'all 5 bearings but E')
    >>> both = ["A (minimum clearance)", "A (mean clearance)"]
    >>> listed(both, [*both, "B"])
    'A (minimum, mean clearance)'
    """
    if _is_whole(names, of):
        return f"all {counted_results(of)}"
    left_out = [name for name in of if name not in names]
    if len(left_out) <= FEW and 2 * len(left_out) < len(names):
        return f"all {counted_results(of)} but {_joined(left_out)}"
    return _joined(names)


def shortened(names: Sequence[str], of: Sequence[str]) -> str:
    """The first of some names and how many more there are, for a line on the terminal.

    >>> shortened(["A", "B", "C"], ["A", "B", "C", "D"])
    'A; B and 1 more'
    """
    if _is_whole(names, of) or len(names) <= NAMES_SHOWN:
        return listed(names, of)
    shown = "; ".join(plain_text(name) for name in names[:NAMES_SHOWN])
    return f"{shown} and {len(names) - NAMES_SHOWN} more"


def _is_whole(names: Sequence[str], of: Sequence[str]) -> bool:
    return len(names) == len(of) > 1


def _joined(names: Sequence[str]) -> str:
    """Names apart by semicolons, since a name may have a comma; clearances of one bearing together."""
    together: dict[tuple[str, bool], list[str]] = {}
    for name in names:
        stem, clearance = split_clearance(plain_text(name))
        together.setdefault((stem, bool(clearance)), []).append(clearance)
    return "; ".join(
        f"{stem} ({worded(clearances)})" if has_clearance else stem
        for (stem, has_clearance), clearances in together.items()
    )
