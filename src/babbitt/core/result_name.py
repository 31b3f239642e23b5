"""Names of results that know what they are made of, so that no one has to read it out of their text."""

from __future__ import annotations

from typing import Any

__all__ = ["ResultName"]


class ResultName(str):
    """Name of one result: bearing, operating point, clearance and state, put together as text.

    It is the text ``Bearing [point] (minimum clearance)`` or ``Bearing (hot state)``; a bearing may itself be
    named ``Pump [A]`` or ``Gear (hot state)``.

    Parameters
    ----------
    bearing : str
    point : str
        Operating point; empty for a bearing as such.
    clearance : str
        ``minimum``, ``mean`` or ``maximum``; empty where one clearance alone is computed.
    state : str
        Which of several answers of one bearing; empty for the only one.

    Examples
    --------
    >>> ResultName("Pump [A]", "full", "minimum")
    'Pump [A] [full] (minimum clearance)'
    """

    bearing: str
    point: str
    clearance: str
    state: str

    def __new__(cls, bearing: str, point: str = "", clearance: str = "", state: str = "") -> ResultName:
        """Put the text together."""
        parts = [bearing, f"[{point}]" if point else "", f"({clearance} clearance)" if clearance else ""]
        name = super().__new__(cls, " ".join(part for part in (*parts, f"({state})" if state else "") if part))
        name.bearing, name.point, name.clearance, name.state = bearing, point, clearance, state
        return name

    def __getnewargs__(self) -> tuple[Any, ...]:
        """What a copy is made of."""
        return self.bearing, self.point, self.clearance, self.state

    @property
    def member(self) -> str:
        """What sets the result apart from the others of its bearing and point: clearance, else state."""
        return self.clearance or self.state

    @property
    def whole(self) -> ResultName:
        """The name of what the clearances and states have in common."""
        return ResultName(self.bearing, self.point)
