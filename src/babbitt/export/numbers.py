"""Numbers and units that other programs write."""

from __future__ import annotations

import math

from babbitt.core.notices import InputError

RPM = math.pi / 30.0
"""rad/s."""

POUND_PER_INCH = 0.45359237 * 9.80665 / 0.0254
"""N/m, exact by definition of pound and inch; also what turns lb s/in into N s/m and lb s2/in into kg."""

ROUND_OFF = 1e-15
"""Share of a speed by which programs that count a turn in another order differ."""


def rounded_rpm(speed: float) -> float:
    """A speed in rad/s as rpm, with no more digits than bring back the same speed but for round-off.

    >>> 6000.0 * RPM / RPM, rounded_rpm(6000.0 * RPM)
    (6000.000000000001, 6000.0)
    """
    rounded = (float(f"{speed / RPM:.{digits}g}") for digits in (12, 15))
    return next((rpm for rpm in rounded if math.isclose(rpm * RPM, speed, rel_tol=ROUND_OFF)), speed / RPM)


def number(where: str, text: object) -> float:
    """A number from a cell of a table.

    Parameters
    ----------
    where : str
        Which cell, for the message.
    text : object
        The cell: text or already a number. Fortran's exponent letter D is understood.

    Raises
    ------
    InputError
        E003 when it is not a number; a decimal comma is named as such.

    >>> number("cell", " 1.5D+03"), number("cell", 2)
    (1500.0, 2.0)
    """
    written = str(text).strip()
    try:
        return float(written.replace("D", "E").replace("d", "e"))
    except ValueError:
        hint = "; write the decimals with a point" if "," in written else ""
        raise InputError("E003", f"{where}: '{written}' is not a number{hint}") from None
