"""What the heat balance by segments needs to know: SI numbers and chosen methods."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass, replace
from enum import Enum

from babbitt.core.notices import InputError
from babbitt.design.conditions import PrescribedEccentricity, PrescribedLoad
from babbitt.kinds.journal.one_dimension import LongFilmProblem, positive
from babbitt.properties.lubricants import Lubricant

FEWEST_CELLS = 180
"""Intervals around the film below which nothing is computed; 720 and more are meant."""


class GrooveKind(Enum):
    """Whether the ends of a groove are open, and so where its pressure comes from.

    THROUGH is open at both ends, or fed at a given pressure; BLIND is closed, its pressure follows
    from continuity.
    """

    THROUGH = "through"
    BLIND = "blind"


class AngleOrigin(Enum):
    """Where the angle of a groove counts from, in the direction of rotation.

    WIDEST_GAP moves the groove with the journal, as the published calculation does; LOAD_LINE leaves it at its
    place in the bush.
    """

    WIDEST_GAP = "widest_gap"
    LOAD_LINE = "load_line"


@dataclass(frozen=True)
class Groove:
    """An axial groove in the film.

    Attributes
    ----------
    angle : float
        Of its centre in the direction of rotation, rad, from its `origin`.
    width : float
        Around the bore, m. 0 cuts the film in two without removing any of it.
    kind : GrooveKind
    mixing_factor : float
        κ, share of fresh oil in what enters the film behind a through groove.
    pressure : float
        Gauge pressure in a through groove, Pa.
    origin : AngleOrigin
    end_land : float or None
        Land at each closed end of a blind groove, m. An infinitely long film has no ends; only a film of finite
        width reads it.
    """

    angle: float
    width: float
    kind: GrooveKind
    mixing_factor: float = 1.0
    pressure: float = 0.0
    origin: AngleOrigin = AngleOrigin.WIDEST_GAP
    end_land: float | None = None

    @property
    def at_place_in_bush(self) -> bool:
        """Whether it keeps its place in the bush, wherever the journal lies."""
        return self.origin is AngleOrigin.LOAD_LINE


@dataclass(frozen=True)
class SegmentFilm:
    """A film with or without a groove, whatever it carries; SI.

    Attributes
    ----------
    diameter, width, clearance : float
        Journal diameter, length, radial clearance.
    surface_speed : float
        Of the journal, positive.
    lubricant : Lubricant
    supply_temperature : float
        K.
    groove : Groove or None
    start : float
        Angle at which the film begins, rad from the widest gap.
    compliance : float
        Elastic displacement of the wall per pressure there, m/Pa (independent columns).
    profile : tuple of (float, float)
        Angles (rad, rising, within one turn) and film thickness (m) in place of an eccentric rigid film.
    cells : int
        Intervals around the film, in addition to the exact edges of the groove.
    """

    diameter: float
    width: float
    clearance: float
    surface_speed: float
    lubricant: Lubricant
    supply_temperature: float
    groove: Groove | None = None
    start: float = 0.0
    compliance: float = 0.0
    profile: tuple[tuple[float, float], ...] = ()
    cells: int = 1000

    def __post_init__(self) -> None:
        for said in issues_of(self):
            raise InputError("E003", f"segments: {said}")

    @property
    def radius(self) -> float:
        """r in m."""
        return 0.5 * self.diameter

    def groove_edges(self) -> tuple[float, float]:
        """Angles of the edges from the widest gap, ``θ_g ∓ b/D``, rad."""
        if self.groove is None or self.groove.at_place_in_bush:
            raise ValueError("a film whose groove has no place in it knows no edges")
        return edges_of(self.groove, self.diameter)

    def without_groove(self) -> SegmentFilm:
        """The same film in one segment."""
        return replace(self, groove=None)

    def cut(self) -> SegmentFilm:
        """The same film cut at the angle of the groove, nothing removed: two mean temperatures in place of one."""
        if self.groove is None:
            return self
        groove = Groove(self.groove.angle, 0.0, GrooveKind.BLIND, origin=self.groove.origin)
        return replace(self, groove=groove)

    def with_groove_at(self, angle: float) -> SegmentFilm:
        """The same film with its groove at an angle from the widest gap, rad."""
        if self.groove is None:
            return self
        return replace(self, groove=replace(self.groove, angle=angle, origin=AngleOrigin.WIDEST_GAP))


def issues_of(film: SegmentFilm) -> tuple[str, ...]:
    """Say what of a film cannot be used, each with its value."""
    found = [*positive(film, "diameter", "width", "clearance", "surface_speed", "supply_temperature")]
    if film.cells < FEWEST_CELLS:
        found.append(f"cells must be at least {FEWEST_CELLS}, given {film.cells}")
    if not 0.0 <= film.compliance < math.inf:
        found.append(f"compliance must not be negative, given {film.compliance!r}")
    if not 0.0 <= film.start < math.pi:
        found.append(f"start must lie from 0 to below 180 deg, given {math.degrees(film.start):.4g} deg")
    if not found and film.groove is not None:
        found += issues_of_groove(film.groove, film.diameter, film.start)
    found += issues_of_profile(film.profile)
    return tuple(found)


def issues_of_groove(groove: Groove, diameter: float, start: float) -> list[str]:
    """Say what of a groove cannot be used in a film that begins at an angle (rad from the widest gap)."""
    found = []
    if not 0.0 <= groove.mixing_factor <= 1.0:
        found.append(f"mixing_factor must lie from 0 to 1, given {groove.mixing_factor!r}")
    if not 0.0 <= groove.pressure < math.inf:
        found.append(f"pressure of the groove must not be negative, given {groove.pressure!r}")
    if not 0.0 <= groove.width < math.inf:
        found.append(f"width of the groove must not be negative, given {groove.width!r}")
        return found
    if groove.at_place_in_bush:  # where in the film it lies follows from the attitude angle
        return found
    before, behind = edges_of(groove, diameter)
    if not start < before <= behind < 2.0 * math.pi:
        edges = f"{math.degrees(before):.4g} to {math.degrees(behind):.4g} deg"
        found.append(f"the groove, {edges}, does not lie inside the film, {math.degrees(start):.4g} to 360 deg")
    return found


def edges_of(groove: Groove, diameter: float) -> tuple[float, float]:
    """Angles of the edges of a groove, ``θ_g ∓ b/D``, rad."""
    half = groove.width / diameter
    return groove.angle - half, groove.angle + half


def issues_of_profile(profile: tuple[tuple[float, float], ...]) -> list[str]:
    """Say what of a given film thickness (angles in rad, thickness in m) cannot be used."""
    if not profile:
        return []
    found = []
    angles = [angle for angle, _ in profile]
    if len(profile) < 8:
        found.append(f"profile needs at least 8 points, given {len(profile)}")
    if any(late <= early for early, late in itertools.pairwise(angles)):
        found.append("the angles of the profile must rise")
    if angles[0] < 0.0 or angles[-1] >= 2.0 * math.pi:
        found.append("the angles of the profile must lie from 0 to below 360 deg")
    thin = min(thickness for _, thickness in profile)
    if not thin > 0.0:
        found.append(f"film thickness in the profile must be above 0, given {thin!r} m")
    return found


@dataclass(frozen=True, kw_only=True)
class SegmentCase(LongFilmProblem):
    """One bearing at one operating point, to be computed by segments; as
    `babbitt.kinds.journal.film.model.FilmCase`.

    `duty` None is a film whose profile is given: its load is found.
    """

    duty: PrescribedLoad | PrescribedEccentricity | None
    groove: Groove | None = None
    start: float = 0.0
    compliance: float = 0.0
    profile: tuple[tuple[float, float], ...] = ()
    cells: int = 1000

    @property
    def film(self) -> SegmentFilm:
        """The film of the case."""
        bearing = self.bearing
        return SegmentFilm(
            bearing.diameter,
            bearing.width,
            self.clearance,
            0.5 * abs(self.journal_speed) * bearing.diameter,
            self.lubricant,
            self.oil_supply.temperature,
            self.groove,
            self.start,
            self.compliance,
            self.profile,
            self.cells,
        )
