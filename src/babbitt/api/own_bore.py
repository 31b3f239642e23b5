"""A bore of one's own as a function of angle and place, sampled to the table of the case language."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NoReturn

from babbitt.api.given import as_given
from babbitt.api.own_function import failure, named
from babbitt.case.problems import CaseError, Problem
from babbitt.core.units import QuantityError, si

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["Gap", "with_own_bore", "with_own_bore_in_words"]

ANGLES = 180
"""Directions around the bore, 2 degrees apart."""
PLACES = 9
"""Places from side to side."""
TURN = 2.0 * math.pi


@dataclass(frozen=True)
class Gap:
    """A bore of one's own: what the gap gains over the round bore of the clearance.

    A bearing samples it where it is made, 2 degrees apart around and at 9 places from side to side, and keeps the
    table as its `displacement`; the film takes what lies between linearly, so that two waves around are met to
    0.06 % of their height. The bearing needs no function afterwards: it has a hash, pickles, and is written to a
    case file.

    Parameters
    ----------
    gain : callable
        ``gain(angle, z)`` in m, positive where the gap is wider. `angle` counter-clockwise from the x axis in rad
        and `z` from the mid-plane in m are arrays of one shape, which the result has, too. A function that fails
        with arrays, as those of `math` do, is called with one angle and one place at a time.
    describe : str
        What form it is, in a few words: reports and settings name the bore by them.

    Examples
    --------
    >>> import numpy as np
    >>> from babbitt import JournalBearing
    >>> waves = Gap(lambda angle, z: 5e-6 * np.cos(2 * angle), describe="two waves of 5 um")
    >>> bearing = JournalBearing(diameter="200 mm", width="120 mm", method="film", bore=waves)
    >>> bearing.displacement.form, len(bearing.displacement.angles), bearing.displacement.places
    ('two waves of 5 um', 180, (0.0,))
    """

    gain: Callable[[Any, Any], Any]
    describe: str

    def table(self, width: float) -> dict[str, Any]:
        """The table in the words of the case language, in SI; of one place where the gain is the same across.

        Parameters
        ----------
        width : float
            Of the bearing, m.

        Raises
        ------
        CaseError
            For a function that fails, and a result that has another shape or is not finite.
        """
        import numpy as np

        angles = np.arange(ANGLES) * (TURN / ANGLES)
        places = width * (np.arange(PLACES) / (PLACES - 1) - 0.5)
        values = self._sampled(*np.meshgrid(angles, places, indexing="ij"))
        if (values == values[:, :1]).all():
            places, values = np.zeros(1), values[:, :1]
        return {
            "form": self.describe,
            "angles": angles.tolist(),
            "places": places.tolist(),
            "values": values.tolist(),
        }

    def _sampled(self, angle: NDArray[np.float64], z: NDArray[np.float64]) -> NDArray[np.float64]:
        import numpy as np

        shape = angle.shape
        try:
            given = np.asarray(self.gain(angle, z))
            found = given.astype(np.float64, casting="same_kind")  # which no complex number is
        except (TypeError, ValueError):  # a function of single numbers
            pairs = zip(angle.ravel().tolist(), z.ravel().tolist(), strict=True)
            found = np.array([self._one(*pair) for pair in pairs]).reshape(shape)
        except Exception as error:
            _refuse(failure(self.gain, self.describe, f"angle and z of the shape {shape}", error))
        if found.shape != shape:
            _refuse(
                f"{named(self.gain, self.describe)} gives the shape {found.shape} for angles and places of {shape}"
            )
        if not np.isfinite(found).all():
            row, column = np.argwhere(~np.isfinite(found))[0]
            at = f"angle = {angle[row, column]:g} rad, z = {z[row, column]:g} m"
            _refuse(f"{named(self.gain, self.describe)} gives {found[row, column]:g} at {at}")
        return found

    def _one(self, angle: float, z: float) -> float:
        """The gain at one place, m."""
        try:
            return float(self.gain(angle, z))
        except Exception as error:
            _refuse(failure(self.gain, self.describe, f"angle = {angle:g} rad, z = {z:g} m", error))


def with_own_bore_in_words(given: Mapping[str, Any]) -> dict[str, Any]:
    """What a bearing was given, an own bore in it as the table of the case language.

    Raises
    ------
    CaseError
        For a bore without width, or together with a displacement.
    """
    bore = given.get("bore")
    if not isinstance(bore, Gap):
        return dict(given)
    if given.get("displacement") is not None:
        _refuse(
            f"'{bore.describe}' is given with a displacement, which is the same table",
            allowed="one of them",
        )
    rest = {name: value for name, value in given.items() if name != "bore"}
    return {**rest, "displacement": bore.table(_width(given))}


def with_own_bore(given: Mapping[str, Any], bore: Gap) -> dict[str, Any]:
    """What a bearing was given, with an own bore in place of the bore, or own bore, that it had."""
    return with_own_bore_in_words({**without_own_bore(given), "bore": bore})


def without_own_bore(given: Mapping[str, Any]) -> dict[str, Any]:
    """What a bearing was given, without its bore; a displacement that is no form of the bore stays."""
    table = given.get("displacement")
    own = isinstance(table, Mapping) and table.get("form") is not None
    return {
        name: value for name, value in given.items() if name != "bore" and not (own and name == "displacement")
    }


def _width(given: Mapping[str, Any]) -> float:
    """Width of a bearing, m."""
    try:
        if (width := _number(given, "width", "m")) is not None:
            return width
        ratio, diameter = _number(given, "width_ratio", "1"), _number(given, "diameter", "m")
    except QuantityError as error:
        _refuse(f"the width of the bearing cannot be read: {error.says}", error.allowed)
    if ratio is None or diameter is None:
        _refuse(
            "an own bore is sampled across the width, which is missing", allowed="give the width with the bore"
        )
    return ratio * diameter


def _number(given: Mapping[str, Any], name: str, unit: str) -> float | None:
    value = given.get(name)
    return None if value is None else si(unit)(as_given(value, "JournalBearing", (name,)))


def _refuse(
    says: str, allowed: str = "a finite number, in m, for every angle and place, in an array of their shape"
) -> NoReturn:
    raise CaseError([Problem("JournalBearing", 0, "bore", says, allowed=allowed)]) from None
