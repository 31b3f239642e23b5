"""Shafts of which the answers are known."""

from babbitt.kinds.shaft.model import Piece, PointLoad, Shaft, Support

STEEL = 206e9


def weightless(length, diameter=0.1):
    """A uniform piece that weighs nothing."""
    return Piece(length, diameter, modulus=STEEL, density=0.0)


def rigid(*stations, **of_each):
    """Rigid radial supports at some stations."""
    return tuple(Support(f"Bearing {place}", at, **of_each) for place, at in enumerate(stations, start=1))


def on_supports(supports, loads, pieces):
    """A shaft that begins at zero."""
    return Shaft(tuple(supports), tuple(loads), tuple(pieces))


def upward(station, force):
    """A force in y."""
    return PointLoad("Force", station, (0.0, force, 0.0))
