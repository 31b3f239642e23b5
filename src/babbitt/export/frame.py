"""The frame of a coefficient table: axes, load direction, rotation sense, and how a file says so."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from enum import Enum

from babbitt.core.notices import InputError


class Rotation(Enum):
    """Sense in which the journal turns, as seen in the frame of the table."""

    COUNTER_CLOCKWISE = "counter-clockwise"
    CLOCKWISE = "clockwise"

    @property
    def opposite(self) -> Rotation:
        """The other sense."""
        return Rotation.CLOCKWISE if self is Rotation.COUNTER_CLOCKWISE else Rotation.COUNTER_CLOCKWISE


@dataclass(frozen=True)
class Frame:
    """Axes x and y (y a quarter turn counter-clockwise from x), and what the bearing does in them.

    Attributes
    ----------
    rotation : Rotation
        Counter-clockwise turns x towards y.
    load_angle : float or None
        Direction of the load on the journal, counter-clockwise from x, rad, in (-pi, pi]. None where a file does
        not tell.
    x_axis_angle : float
        Direction of the x axis, counter-clockwise from the horizontal to the right, rad, in (-pi, pi].

    Raises
    ------
    InputError
        E003 for an angle that is not finite.

    Notes
    -----
    The default is the frame of Babbitt: x right, y up, counter-clockwise rotation, load downwards.
    """

    rotation: Rotation = Rotation.COUNTER_CLOCKWISE
    load_angle: float | None = -0.5 * math.pi
    x_axis_angle: float = 0.0

    def __post_init__(self) -> None:
        for field in ("load_angle", "x_axis_angle"):
            angle = getattr(self, field)
            if angle is not None:
                if not math.isfinite(angle):
                    raise InputError("E003", f"frame: {field} is {angle}; give a finite angle in rad")
                object.__setattr__(self, field, wrapped(angle))


def wrapped(angle: float) -> float:
    """The same direction within (-pi, pi].

    >>> wrapped(-math.pi) == math.pi, wrapped(0.5)
    (True, 0.5)
    """
    if -math.pi < angle <= math.pi:
        return angle  # untouched, so that an angle survives any number of files to the last digit
    turned = math.remainder(angle, 2.0 * math.pi)
    return math.pi if turned == -math.pi else turned


def declaration(frame: Frame) -> str:
    """The frame in one line that a person and `declared` can read.

    >>> declaration(Frame())
    'rotation counter-clockwise, x axis at 0 deg, load at -90 deg'
    """
    load = "not declared" if frame.load_angle is None else _degrees(frame.load_angle)
    return f"rotation {frame.rotation.value}, x axis at {_degrees(frame.x_axis_angle)}, load at {load}"


def load_direction(angle: float) -> float:
    """Direction in rad of a load that was found as the force of a film, to a thousandth of a degree.

    The force meets the load to the tolerance of the solver, which is no more.
    """
    return math.radians(round(math.degrees(angle), 3))


def _degrees(angle: float) -> str:
    """Degrees to ten decimals, without a tail of zeros or a minus before zero."""
    return f"{round(math.degrees(angle), 10) + 0.0:.13g} deg"


_NUMBER = r"[-+]?\d+(?:\.\d*)?(?:e[-+]?\d+)?"
_DECLARATION = re.compile(
    rf"rotation (counter-clockwise|clockwise), x axis at ({_NUMBER}) deg, load at (?:({_NUMBER}) deg|not declared)"
)


def declared(text: str) -> Frame | None:
    """The frame that `declaration` wrote somewhere in a text, or None where there is no declaration.

    >>> declared("Gear side; rotation clockwise, x axis at 0 deg, load at not declared").rotation.value
    'clockwise'
    """
    found = _DECLARATION.search(text)
    if found is None:
        return None
    rotation, axis, load = found.groups()
    return Frame(
        rotation=Rotation(rotation),
        load_angle=None if load is None else math.radians(float(load)),
        x_axis_angle=math.radians(float(axis)),
    )


def settled(where: str, from_file: Frame | None, given: Frame | None) -> Frame:
    """The frame of a table that was read: what the file says, or what the caller says where the file is silent.

    Parameters
    ----------
    where : str
        Name of the file, for messages.
    from_file, given : Frame or None
        What each of them says.

    Raises
    ------
    InputError
        E003 when neither says it, E004 when they contradict each other.
    """
    if from_file is None:
        if given is None:
            raise InputError(
                "E003",
                f"{where}: the file does not say in which frame its coefficients are written, and cross-coupling "
                "changes its sign with the rotation sense; give frame=Frame(rotation=..., load_angle=...)",
            )
        return given
    if given is not None and declaration(given) != declaration(from_file):
        raise InputError(
            "E004",
            f"{where}: the file says '{declaration(from_file)}', but the frame given is '{declaration(given)}'; "
            "leave out frame= to take the word of the file",
        )
    return from_file
