"""What drives a shaft and what it drives: torques of gears and couplings, and their balance."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Annotated, Literal

from pydantic import Field

from babbitt.case.part import Issue, Part, at_most_one, rule
from babbitt.case.parts.fields import Name
from babbitt.core.units import si, written

__all__ = ["PartMass", "Station", "TorquePart", "torque_issues", "torques"]

Station = Annotated[float, si("m", "-500 m", "500 m", "mm")]
PartMass = Annotated[float, si("kg", "0 kg", "10000 t")]

BALANCED = 1e-3
"""Share of the largest torque by which torques may miss their balance: those of a drawing are rounded."""


class TorquePart(Part):
    """A gear or a coupling: what turns the shaft, or what the shaft turns."""

    name: Name = Field(description="Name in tables and figures.")
    station: Station = Field(description="Place along the shaft of the middle of what it carries.")
    role: Literal["driver", "driven"] | None = Field(
        None,
        description="driver: the shaft turns what it meshes or couples with; driven: it is turned by that. Where "
        "it takes the balance of the torques, the role follows.",
    )
    torque: Annotated[float, si("N m", "0 N m", "1e9 N m")] | None = Field(
        None,
        description="Torque that it transmits. One part may leave out torque and power: it takes the balance.",
    )
    power: Annotated[float, si("W", "0 W", "1000 MW")] | None = Field(
        None, description="Power that it transmits, in place of the torque."
    )
    mass: PartMass = Field(0.0, description="Mass that the shaft carries here.")

    @rule
    def _torque_or_power(self) -> Iterator[Issue]:
        yield from at_most_one(self, "torque", "power")

    @rule
    def _role_of_a_torque(self) -> Iterator[Issue]:
        if self.role is None and (self.torque is not None or self.power is not None):
            yield Issue(("role",), "is missing", "driver or driven", code="E003")

    @property
    def takes_the_balance(self) -> bool:
        """Whether neither torque nor power is given."""
        return self.torque is None and self.power is None

    def given_torque(self, speed: float) -> float:
        """Torque on the shaft, positive counter-clockwise, N m; zero for a part that takes the balance."""
        size = self.torque if self.torque is not None else (self.power or 0.0) / abs(speed)
        sense = 1.0 if speed > 0.0 else -1.0
        return sense * size if self.role == "driven" else -sense * size


def torques(parts: Sequence[TorquePart], speed: float) -> tuple[float, ...]:
    """Torque of each part on the shaft, positive counter-clockwise, N m; they add up to zero.

    One part without torque and power takes the balance. Where all are given, a difference within `BALANCED` is
    left to the last of them.
    """
    given = [part.given_torque(speed) for part in parts]
    free = next((k for k, part in enumerate(parts) if part.takes_the_balance), len(parts) - 1)
    if parts:
        given[free] -= sum(given)
    return tuple(given)


def torque_issues(parts: Sequence[tuple[tuple[str | int, ...], TorquePart]], speed: float) -> Iterator[Issue]:
    """Complain about torques that do not balance, or about a role that the balance contradicts.

    Parameters
    ----------
    parts : sequence of (path, TorquePart)
    speed : float
        With the sense of rotation, rad/s.
    """
    free = [(path, part) for path, part in parts if part.takes_the_balance]
    for path, part in free[1:]:
        says = f"{free[0][1].name} has neither torque nor power, too; one part alone takes the balance"
        yield Issue((*path, "torque"), says, f"torque or power of {part.name}")
    given = [part.given_torque(speed) for _, part in parts]
    largest = max((abs(one) for one in given), default=0.0)
    missing = sum(given)
    if parts and not free and abs(missing) > BALANCED * largest:
        path, last = parts[-1]
        says = f"the torques of the shaft do not balance, {written(abs(missing), 'N m')} are left over"
        yield Issue((*path, "torque"), says, "torques that add up to zero", f"leave out the torque of {last.name}")
    if len(free) == 1 and free[0][1].role is not None and abs(missing) > BALANCED * largest:
        path, part = free[0]
        turned = -missing * speed > 0.0
        if turned != (part.role == "driven"):
            role = "driven" if turned else "driver"
            says = f"the balance of the torques, {written(abs(missing), 'N m')}, makes {part.name} a {role} part"
            yield Issue((*path, "role"), says, role, "or exchange driver and driven of the others")
