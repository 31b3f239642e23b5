"""Why a thrust bearing has no film to answer with."""

from __future__ import annotations

from babbitt.core.notices import Notice
from babbitt.core.result import Outcome
from babbitt.design.heat_balance import NoFilmError

__all__ = [
    "ConcavePadError",
    "TiltedPadAtFilmError",
    "TiltedPadError",
    "TiltedPadsTouchAtFilmError",
    "TiltedPadsTouchError",
    "NoPadFilmError",
    "OpenHeatBalanceError",
    "OverloadedPadsError",
    "PadsTouchError",
    "ThermalRunawayError",
    "UnsettledFeedError",
    "UnsettledPadError",
]


class NoPadFilmError(NoFilmError):
    """There is no film to answer with.

    Attributes
    ----------
    failure : Notice
        Why, and what to try.
    """

    def __init__(self, failure: Notice) -> None:
        super().__init__(Outcome.of(failure))
        self.failure = failure

    def __str__(self) -> str:
        return self.failure.message


class ThermalRunawayError(NoPadFilmError):
    """No balance up to the highest temperature."""

    def __init__(self) -> None:
        super().__init__(Notice("S002", "pads"))


class OpenHeatBalanceError(NoPadFilmError):
    """The search for the temperature of the pads ended without it."""

    def __init__(self) -> None:
        super().__init__(Notice("S004", "heat_balance"))


class UnsettledPadError(NoPadFilmError):
    """Film, temperatures and tilt of a pad went on to change each other."""

    def __init__(self) -> None:
        super().__init__(Notice("S004", "pad"))


class UnsettledFeedError(NoPadFilmError):
    """Pads that take in the hot oil of their neighbour went on to change each other."""

    def __init__(self) -> None:
        super().__init__(Notice("S004", "fed_pads"))


class OverloadedPadsError(NoPadFilmError):
    """The pads carry less than the thrust, however thin their films."""

    def __init__(self, thrust: float, carried: float, stepped: bool = False) -> None:
        variant = "stepped_pads" if stepped else "pads"
        super().__init__(Notice("S001", variant, {"carried": carried, "thrust": thrust}))


class ConcavePadError(NoPadFilmError):
    """A concave pad has no balance on a film so thin.

    Attributes
    ----------
    crown : float
        Of the pad, m, negative.
    most : float
        Largest load that it carries, N.
    """

    def __init__(self, crown: float, most: float, thrust: float = 0.0, number: int = 0) -> None:
        self.crown, self.most = crown, most
        carried = Notice("S001", "of_pad", {"most": most})
        if number:
            carried = Notice("S001", "of_pads", {"most": number * most, "thrust": thrust})
        super().__init__(Notice("S001", "concave_pads", {"carried": carried, "crown": crown}))


class PadsTouchError(NoPadFilmError):
    """Tilt and heights bring a pad on a rigid ring through the mean film that is given."""

    def __init__(self, film: float, nearer: float, pad: int) -> None:
        super().__init__(Notice("S006", "pads", {"pad": pad, "nearer": nearer, "film": film}))


class TiltedPadsTouchError(NoPadFilmError):
    """Faces that are held at a slope touch the collar before the pads carry the thrust.

    Attributes
    ----------
    pad : int
        From 1.
    """

    def __init__(self, pad: int, carried: float) -> None:
        self.pad = pad
        super().__init__(Notice("S001", "tilted_pads", {"pad": pad, "carried": carried}))


class TiltedPadsTouchAtFilmError(NoPadFilmError):
    """Faces that are held at a slope touch the collar at the mean film that is given."""

    def __init__(self, pad: int, film: float) -> None:
        super().__init__(Notice("S006", "tilted_pads", {"pad": pad, "film": film}))


class TiltedPadError(NoPadFilmError):
    """A pad whose face is held at a slope finds no equilibrium.

    Attributes
    ----------
    pad : int or None
        From 1; None: all.
    thinnest : float or None
        Film at its pivot below which no tilt balances it, m, where that is known.
    """

    def __init__(self, pad: int | None = None, thinnest: float | None = None) -> None:
        self.pad, self.thinnest = pad, thinnest
        super().__init__(Notice("S004", "under_thrust", {"which": _unbalanced(pad, thinnest)}))


class TiltedPadAtFilmError(NoPadFilmError):
    """A pad whose face is held at a slope finds no equilibrium at the mean film that is given."""

    def __init__(self, pad: int | None, film: float, thinnest: float | None = None) -> None:
        super().__init__(Notice("S004", "at_film", {"which": _unbalanced(pad, thinnest), "film": film}))


def _unbalanced(pad: int | None, thinnest: float | None) -> Notice:
    if pad is None:
        return Notice("S004", "all_pads")
    if thinnest is None:
        return Notice("S004", "one_pad", {"pad": pad})
    return Notice("S004", "thin_pad", {"pad": pad, "thinnest": thinnest})
