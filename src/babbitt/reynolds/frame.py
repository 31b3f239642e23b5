"""The frame in which a film is solved: its load points down, and no round-off of a turn decides over the way.

A search that starts in the middle can end at another place, or on another grid, when a number differs in its last
digit, and every turn of the axes changes last digits. Therefore a film is turned until its load points to -y (in
the mirror, if it turns clockwise and is solved there), and its numbers are rounded far below anything that a film
feels: a bearing turned with its load is the same film, digit by digit. Fields over the bore (``displacement``,
``viscosity_field``) turn by the angle of their first row, which is the one behind -pi.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.model import Field, FilmStart, JournalFilm, Land, Pocket, Step
from babbitt.reynolds.solution import FilmSolution

__all__ = ["LoadFrame"]

Array = NDArray[np.float64]
Vector = tuple[float, float]
TURN = 2.0 * math.pi

Turned = TypeVar("Turned", JournalFilm, Land, Pocket, Step, FilmSolution)

ANGLE_DIGITS = 12
"""Decimals of an angle in rad, and of fields in their units."""

DIGITS = 13
"""Significant digits of every other number."""

FORM = f"%.{DIGITS - 1}e"


@dataclass(frozen=True, eq=False)
class LoadFrame:
    """A film under a load as it is solved, and how its answer is turned back.

    Attributes
    ----------
    given, film : JournalFilm
        As given, and with its load pointing down.
    load : tuple of float
        N, on ``film``.
    angle : float
        By which ``film`` is turned against ``given``, rad.
    """

    given: JournalFilm
    film: JournalFilm
    load: Vector
    angle: float

    @classmethod
    def of(cls, film: JournalFilm, load: Vector) -> LoadFrame:
        """Frame of a film; that of the film itself where it cannot be turned or its load points down already."""
        size, down = math.hypot(*load), math.copysign(1.0, film.angular_speed)
        if film.film_start is FilmStart.WIDEST_GAP or size == 0.0 or not math.isfinite(size):
            return cls(film, film, load, 0.0)
        angle = math.remainder(-0.5 * math.pi * down - math.atan2(load[1], load[0]), TURN)
        first, field_start = first_row(film, angle, down)
        turned = _with(
            film,
            diameter=rounded(film.diameter),
            width=rounded(film.width),
            clearance=rounded(film.clearance),
            viscosity=rounded(film.viscosity),
            angular_speed=rounded(film.angular_speed),
            lands=tuple(turned_land(land, angle, down) for land in film.lands),
            pockets=tuple(
                _with(
                    one, centre_angle=turned_angle(one.centre_angle, angle, down), pressure=rounded(one.pressure)
                )
                for one in film.pockets
            ),
            steps=tuple(
                _with(one, centre_angle=turned_angle(one.centre_angle, angle, down)) for one in film.steps
            ),
            cavitation_pressure=rounded(film.cavitation_pressure),
            side_pressures=(rounded(film.side_pressures[0]), rounded(film.side_pressures[1])),
            misalignment=turned_vector(film.misalignment, angle, down),
            viscosity_field=rounded_field(film.viscosity_field, 1.0, first),
            displacement=rounded_field(film.displacement, decimal_unit(film.clearance), first),
            field_start=field_start,
        )
        return cls(film, turned, (0.0, -down * rounded(size)), angle)

    def back(self, found: FilmSolution) -> FilmSolution:
        """A film that was solved in this frame, in the frame in which it was given."""
        if self.film is self.given:
            return found
        if self.angle == 0.0:
            return _with(
                found, film=self.given, supply_flow=found.supply_flow[self.supplies(found.supply_flow.size)]
            )
        c, s = math.cos(self.angle), math.sin(self.angle)
        turn = np.array([[c, s], [-s, c]])  # by -angle
        order = self.supplies(found.supply_flow.size)
        return _with(
            found,
            film=self.given,
            position=turn @ found.position,
            force=turn @ found.force,
            stiffness=turn @ found.stiffness @ turn.T,
            damping=turn @ found.damping @ turn.T,
            angles=found.angles - self.angle,
            supply_flow=found.supply_flow[order],
        )

    def supplies(self, count: int) -> list[int]:
        """Where each of ``count`` supplies of the film as given stands among those of the turned film."""
        if self.film.film_start is FilmStart.PERIODIC:
            return list(range(count))
        turned = self.film.land_order
        return [turned.index(land) for land in self.given.land_order] + list(range(len(turned), count))

    def place(self, position: Vector) -> Vector:
        """A position as given, in this frame."""
        c, s = math.cos(self.angle), math.sin(self.angle)
        return c * position[0] - s * position[1], s * position[0] + c * position[1]

    def start(self, position: Vector) -> Vector:
        """A position from which to search, in this frame."""
        x, y = (round(part / self.film.clearance, ANGLE_DIGITS) for part in self.place(position))
        return x * self.film.clearance, y * self.film.clearance


def _with(given: Turned, **changes: Any) -> Turned:
    """A copy of what holds its limits already, with the fields that a turn changes."""
    made, values = object.__new__(type(given)), given.__dict__
    names = type(given).__dataclass_fields__
    if len(values) > len(names):  # what was cached is of the given one
        values = {name: values[name] for name in names}
    made.__dict__.update(values)
    made.__dict__.update(changes)
    return made


def rounded(value: float) -> float:
    """A number to ``DIGITS`` significant digits."""
    return float(FORM % value) if value else value


def rounded_field(field: Field, unit: float, first: int) -> Field:
    """A field to ``ANGLE_DIGITS`` decimals of a unit, from a row on."""
    if not field:
        return field
    values = np.round(np.asarray(field) / unit, ANGLE_DIGITS) * unit
    return tuple(map(tuple, np.roll(values, -first, axis=0).tolist()))


def decimal_unit(size: float) -> float:
    """Power of ten at or below a size: a table of few decimals lies far from where rounding in it turns over."""
    return 10.0 ** math.floor(math.log10(size))


def first_row(film: JournalFilm, angle: float, sense: float) -> tuple[int, float]:
    """Row of the fields that is the first one of the turned film, behind -pi, and its angle, rad."""
    counts = {len(field) for field in (film.viscosity_field, film.displacement) if field}
    if len(counts) != 1:  # no field, or two that have no row in common
        return 0, turned_angle(film.field_start, angle, sense)
    (count,) = counts
    step = TURN / count
    behind = math.floor((sense * (film.field_start + angle) + math.pi) / step + 1e-9)
    row = int(-sense * behind) % count
    return row, turned_angle(film.field_start + row * step, angle, sense)


def turned_angle(given: float, angle: float, sense: float) -> float:
    """An angle, turned, within (-pi, pi], rad; in the mirror for a clockwise film, as its image."""
    turned = sense * (given + angle)
    return sense * round(turned - TURN * math.ceil((turned - math.pi) / TURN - 1e-9), ANGLE_DIGITS)


def turned_vector(given: Vector, angle: float, sense: float) -> Vector:
    """A vector, turned."""
    size = rounded(math.hypot(*given))
    if size == 0.0:
        return given
    towards = turned_angle(math.atan2(given[1], given[0]), angle, sense)
    return size * math.cos(towards), size * math.sin(towards)


def turned_land(land: Land, angle: float, sense: float) -> Land:
    """A land, turned; its other end follows from that at which the film begins, at the end of a clockwise one."""
    extent = land.end_angle - land.start_angle
    spanned = TURN if math.isclose(extent, TURN, rel_tol=1e-9) else round(extent, ANGLE_DIGITS)
    first = turned_angle(land.start_angle if sense > 0.0 else land.end_angle, angle, sense)
    start, end = sorted((first, first + sense * spanned))
    return _with(
        land,
        start_angle=start,
        end_angle=end,
        clearance=land.clearance if land.clearance is None else rounded(land.clearance),
        centre=turned_vector(land.centre, angle, sense),
        start_pressure=rounded(land.start_pressure),
        end_pressure=rounded(land.end_pressure),
    )
