"""Why a thrust bearing has no film to answer with."""

from __future__ import annotations

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
    outcome : Outcome
    said : str
        Why, and what to try.
    """

    outcome = Outcome.NOT_CONVERGED
    said = ""

    def __init__(self) -> None:
        super().__init__(self.outcome)

    def __str__(self) -> str:
        return self.said


class ThermalRunawayError(NoPadFilmError):
    """No balance up to the highest temperature."""

    outcome = Outcome.THERMAL_RUNAWAY
    said = (
        "friction outruns the oil up to 300 °C; less thrust, cooler or thinner oil, less of it carried over, or a "
        "straighter housing where one leans"
    )


class OpenHeatBalanceError(NoPadFilmError):
    """The search for the temperature of the pads ended without it."""

    said = "the temperature at which oil carries the friction heat away was not found; less thrust, or a given one"


class UnsettledPadError(NoPadFilmError):
    """Film, temperatures and tilt of a pad went on to change each other."""

    said = (
        "film, temperatures and tilt of a pad did not come to rest; less thrust or a straighter housing; thermal: "
        "global may have an answer"
    )


class UnsettledFeedError(NoPadFilmError):
    """Pads that take in the hot oil of their neighbour went on to change each other."""

    said = (
        "films and temperatures of pads that take in the hot oil of the pad before did not come to rest; less "
        "thrust, or a straighter housing"
    )


class OverloadedPadsError(NoPadFilmError):
    """The pads carry less than the thrust, however thin their films."""

    outcome = Outcome.OVERLOADED

    def __init__(self, thrust: float, carried: float, stepped: bool = False) -> None:
        bound = "in front of a deep step the pressure has a bound; a shallower step, " if stepped else ""
        self.said = (
            f"the pads carry at most {carried / 1e3:.4g} kN of {thrust / 1e3:.4g} kN: {bound}less thrust, more "
            "viscous oil, more speed, or larger pads"
        )
        super().__init__()


class ConcavePadError(NoPadFilmError):
    """A hollow pad has no balance on a film so thin.

    Attributes
    ----------
    crown : float
        Of the pad, m, negative.
    most : float
        Largest load that it carries, N.
    """

    outcome = Outcome.OVERLOADED

    def __init__(self, crown: float, most: float, thrust: float = 0.0, number: int = 0) -> None:
        self.crown, self.most = crown, most
        carried = f"a pad carries at most {most / 1e3:.3g} kN"
        if number:
            carried = f"the pads carry at most {number * most / 1e3:.3g} kN of {thrust / 1e3:.4g} kN"
        self.said = (
            f"{carried}: the pads are hollow (crown {crown * 1e6:g} µm), and on a thinner film no tilt balances a "
            "hollow pad on its pivot; plane or crowned pads, or less thrust, more viscous oil, or more speed"
        )
        super().__init__()


class PadsTouchError(NoPadFilmError):
    """Tilt and heights bring a pad on a rigid ring through the mean film that is given."""

    outcome = Outcome.OUTSIDE_CLEARANCE

    def __init__(self, film: float, nearer: float, pad: int) -> None:
        self.said = (
            f"tilt and heights bring pad {pad} {nearer * 1e6:.1f} µm nearer to the collar than the mean film of "
            f"{film * 1e6:.1f} µm: it stands in the collar; a thicker film, a ring that gives way, or the "
            "thrust in place of the film"
        )
        super().__init__()


class TiltedPadsTouchError(NoPadFilmError):
    """Faces that are held at a slope touch the collar before the pads carry the thrust.

    Attributes
    ----------
    pad : int
        From 1.
    """

    outcome = Outcome.OVERLOADED

    def __init__(self, pad: int, carried: float) -> None:
        self.pad = pad
        self.said = (
            f"the face of pad {pad} leans with the housing and touches the collar while the pads carry "
            f"{carried / 1e3:.4g} kN; a straighter housing, less thrust, a ring that gives way, or pads on point "
            "pivots"
        )
        super().__init__()


class TiltedPadsTouchAtFilmError(NoPadFilmError):
    """Faces that are held at a slope touch the collar at the mean film that is given."""

    outcome = Outcome.OUTSIDE_CLEARANCE

    def __init__(self, pad: int, film: float) -> None:
        self.said = (
            f"the face of pad {pad} leans with the housing and touches the collar at the mean film of "
            f"{film * 1e6:.1f} µm; less tilt of the housing, a thicker film, or pads on point pivots"
        )
        super().__init__()


class TiltedPadError(NoPadFilmError):
    """A pad whose face is held at a slope does not come to rest.

    Attributes
    ----------
    pad : int or None
        From 1; None: all.
    thinnest : float or None
        Film at its pivot below which no tilt balances it, m, where that is known.
    """

    def __init__(self, pad: int | None = None, thinnest: float | None = None) -> None:
        self.pad, self.thinnest = pad, thinnest
        self.said = (
            f"{_unbalanced(pad, thinnest)}, and the thrust asks for less film; a straighter housing, less thrust, "
            "a ring that gives way, or pads on point pivots"
        )
        super().__init__()


class TiltedPadAtFilmError(NoPadFilmError):
    """A pad whose face is held at a slope does not come to rest at the mean film that is given."""

    def __init__(self, pad: int | None, film: float, thinnest: float | None = None) -> None:
        self.said = (
            f"{_unbalanced(pad, thinnest)}, at a mean film of {film * 1e6:.1f} µm; less tilt of the housing, a "
            "thicker film, or pads on point pivots"
        )
        super().__init__()


def _unbalanced(pad: int | None, thinnest: float | None) -> str:
    if pad is None:
        return "the pads do not come to rest with faces that lean with the housing"
    if thinnest is None:
        return f"pad {pad} does not come to rest with a face that leans with the housing"
    return (
        f"the face of pad {pad} leans with the housing, and where the film at its pivot is thinner than "
        f"{thinnest * 1e6:.1f} µm the pad falls over: no tilt balances it"
    )
