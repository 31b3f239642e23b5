"""Names of results: which bearing, which operating point, which clearance, and how many of them.

What a name is made of it knows itself (`babbitt.core.result_name`); nothing is read out of its text.
"""

from __future__ import annotations

from collections.abc import Sequence

from babbitt.core.language import translated
from babbitt.core.result_name import ResultName
from babbitt.report.text import counted, plain_text

NAMES_SHOWN = 2
"""How many bearings a line on the terminal names before it counts the rest."""

FEW = 3
"""How many bearings may be left out of a list that says "all but"."""


def split_clearance(name: str) -> tuple[str, str]:
    """A name without its clearance, and which clearance that is; empty for none. Steady states of a footstep count
    as clearances do: results of one bearing side by side.

    >>> split_clearance(ResultName("Fan shaft", clearance="minimum")), split_clearance("Gear (hot state)")
    (('Fan shaft', 'minimum'), ('Gear (hot state)', ''))
    >>> split_clearance(ResultName("Footstep", state="hot state"))
    ('Footstep', 'hot state')
    """
    return (name.whole, name.member) if isinstance(name, ResultName) else (name, "")


def format_members(members: Sequence[str]) -> str:
    """Say which results of one bearing are meant.

    >>> format_members(["minimum", "mean"]), format_members(["hot state", "cold state"])
    ('minimum, mean clearance', 'hot state, cold state')
    """
    clearances = all(member in ("minimum", "mean", "maximum") for member in members)
    listed_ones = ", ".join(map(translated, members))
    return translated("{which} clearance", which=listed_ones) if clearances else listed_ones


def shown_name(name: str) -> str:
    """The name of a result, its clearance or state in the language that is written now.

    >>> shown_name(ResultName("Fan shaft", "full speed", "minimum")), shown_name("Gear (hot state)")
    ('Fan shaft [full speed] (minimum clearance)', 'Gear (hot state)')
    """
    return _joined([name])


def bearing_of(name: str) -> str:
    """A name without operating point and clearance.

    >>> bearing_of(ResultName("Fan shaft", "full speed", "minimum")), bearing_of("Pump [A]")
    ('Fan shaft', 'Pump [A]')
    """
    return name.bearing if isinstance(name, ResultName) else name


def counted_results(names: Sequence[str]) -> str:
    """How many bearings the results of a machine are, or how many cases of how many bearings.

    >>> counted_results(["A", "B"])
    '2 bearings'
    >>> counted_results([ResultName("A", clearance=which) for which in ("minimum", "maximum")])
    '2 cases of 1 bearing'
    """
    bearings = len({bearing_of(name) for name in names})
    if bearings == len(names):
        return counted(bearings, "bearing")
    return translated(
        "{cases} of {bearings}", cases=counted(len(names), "case"), bearings=counted(bearings, "bearing")
    )


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
    >>> both = [ResultName("A", clearance="minimum"), ResultName("A", clearance="mean")]
    >>> listed(both, [*both, "B"])
    'A (minimum, mean clearance)'
    >>> machine = ["Oil system of Pump", "A", "B"]
    >>> listed(machine, machine)
    'all 2 bearings; Oil system of Pump'
    >>> listed(["A", "B"], machine), listed(machine[:2], machine[:2])
    ('all 2 bearings', 'A; Oil system of Pump')
    """
    systems = [name for name in names if name.startswith(OIL_SYSTEM)]
    return "; ".join(filter(None, (_listed(_bearings(names), _bearings(of)), _joined(systems))))


def _bearings(names: Sequence[str]) -> list[str]:
    """Names without those of oil systems."""
    return [name for name in names if not name.startswith(OIL_SYSTEM)]


def _listed(names: Sequence[str], of: Sequence[str]) -> str:
    if _is_whole(names, of):
        return translated("all {bearings}", bearings=counted_results(of))
    left_out = [name for name in of if name not in names]
    if 0 < len(left_out) <= FEW and 2 * len(left_out) < len(names):
        return translated("all {bearings} but {others}", bearings=counted_results(of), others=_joined(left_out))
    return _joined(names)


def shortened(names: Sequence[str], of: Sequence[str]) -> str:
    """The first of some names and how many more there are, for a line on the terminal.

    >>> shortened(["A", "B", "C"], ["A", "B", "C", "D"])
    'A; B and 1 more'
    """
    if _is_whole(_bearings(names), _bearings(of)) or len(names) <= NAMES_SHOWN:
        return listed(names, of)
    shown = "; ".join(plain_text(name) for name in names[:NAMES_SHOWN])
    return translated("{shown} and {number} more", shown=shown, number=len(names) - NAMES_SHOWN)


def _is_whole(names: Sequence[str], of: Sequence[str]) -> bool:
    return len(names) == len(of) > 1


def _joined(names: Sequence[str]) -> str:
    """Names apart by semicolons, since a name may have a comma; clearances of one bearing together."""
    together: dict[tuple[str, bool], list[str]] = {}
    for name in names:
        stem, clearance = split_clearance(name)
        together.setdefault((plain_text(stem), bool(clearance)), []).append(plain_text(clearance))
    return "; ".join(
        f"{_stem(stem)} ({format_members(clearances)})" if has_clearance else _stem(stem)
        for (stem, has_clearance), clearances in together.items()
    )


def _stem(name: str) -> str:
    """A name as the case has it; that of an oil system, which the program makes of it, in the language."""
    _, made, machine = name.partition(OIL_SYSTEM)
    return translated("Oil system of {name}", name=machine) if made and name.startswith(OIL_SYSTEM) else name


OIL_SYSTEM = "Oil system of "
"""How the name of an oil system begins, before that of its machine."""
