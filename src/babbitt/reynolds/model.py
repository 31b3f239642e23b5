"""What the film sees: its bore, the oil, the speed, and where and how the film begins and ends."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from enum import Enum
from functools import cached_property

from babbitt.core.notices import InputError
from babbitt.reynolds.bore import END_DAM, Land, Pocket, Step, check_lands, grooved_bore
from babbitt.reynolds.oil.piezoviscosity import PressureViscosity
from babbitt.reynolds.oil.turbulence import FilmTurbulence

__all__ = [
    "END_DAM",
    "Cavitation",
    "FilmStart",
    "JournalFilm",
    "Land",
    "Pocket",
    "Resolution",
    "Step",
    "grooved_bore",
]


class Cavitation(Enum):
    """What the film does where it cannot hold pressure."""

    MASS_CONSERVING = "Jakobsson-Floberg-Olsson: the film breaks up and the streamers conserve the oil"
    REYNOLDS = (
        "Swift-Stieber: pressure and its gradient vanish where the film ends, oil is not accounted for behind"
    )
    HALF_SOMMERFELD = "Gumbel: suctions of the full film count as nothing; no coefficients and no flows"


class FilmStart(Enum):
    """Where the film of a land begins."""

    GROOVE = "at the groove edge the land starts from, flooded at the supply pressure"
    PERIODIC = "nowhere: one land closes the ring and the film follows itself (pockets and holes feed it)"
    WIDEST_GAP = "at the widest gap of an ungrooved round bore, at ambient pressure (Raimondi-Boyd, Butenschoen)"


@dataclass(frozen=True)
class Resolution:
    """Grid of the film: unknowns across half the width and intervals along each land.

    Attributes
    ----------
    axial_unknowns : int
        Nodes of the even polynomial, 1 to 12.
    intervals : int
        Intervals per land, graded where the film is thin.
    coarse_intervals : int
        Intervals of the first search.
    tolerance : float
        Residual force over load at which the journal is in equilibrium.
    """

    axial_unknowns: int = 4
    intervals: int = 96
    coarse_intervals: int = 24
    tolerance: float = 1e-6

    @property
    def ring_intervals(self) -> int:
        """Intervals around the bearing for films that differ across the width."""
        return 2 * self.intervals


DRAFT = Resolution(4, 48)
ENGINEERING = Resolution(4, 96)
REFERENCE = Resolution(8, 384, 48, 1e-9)


Field = tuple[tuple[float, ...], ...]
"""Values once around (rows, the last a step before the first) and from side to side (columns)."""


@dataclass(frozen=True)
class JournalFilm:
    """A film between a journal and its bore.

    Attributes
    ----------
    diameter, width, clearance : float
        m; ``clearance`` is radial, of the assembled bearing.
    viscosity : float
        Pa s.
    angular_speed : float
        rad/s, positive counter-clockwise. Zero: the film is squeezed only.
    lands : tuple of Land
        In any order, not overlapping.
    cavitation : Cavitation
    film_start : FilmStart
    cavitation_pressure : float
        Gauge pressure at which the film breaks, Pa; zero or below.
    pockets : tuple of Pocket
        Supplies of part width.
    misalignment : tuple of float
        Slopes dx/dz and dy/dz of the journal axis against the bore, rad.
    axial_viscosity : tuple of float
        Viscosity over ``viscosity`` at equally spaced places from one side to the other. Empty: uniform.
    viscosity_field : tuple of tuple of float
        Viscosity over ``viscosity`` on the whole film; see ``Field``. Empty: uniform.
    steps : tuple of Step
        Dams, relief tracks and shallow pockets.
    crowning : tuple of float
        What the radius of the journal lacks, m, at equally spaced places from one side to the other.
    displacement : tuple of tuple of float
        What the gap gains by elastic and thermal displacement, m; see ``Field``.
    field_start : float
        Angle of the first row of both fields, and of those by which an elastic bore gives way, rad.
    side_pressures : tuple of float
        Gauge pressures at the sides z = -B/2 and B/2, Pa.
    turbulence : FilmTurbulence or None
        None: laminar.
    pressure_viscosity : PressureViscosity or None
        None: viscosity does not depend on pressure.
    """

    diameter: float
    width: float
    clearance: float
    viscosity: float
    angular_speed: float
    lands: tuple[Land, ...]
    cavitation: Cavitation = Cavitation.MASS_CONSERVING
    film_start: FilmStart = FilmStart.GROOVE
    cavitation_pressure: float = 0.0
    pockets: tuple[Pocket, ...] = ()
    misalignment: tuple[float, float] = (0.0, 0.0)
    axial_viscosity: tuple[float, ...] = ()
    viscosity_field: Field = ()
    steps: tuple[Step, ...] = ()
    crowning: tuple[float, ...] = ()
    displacement: Field = ()
    field_start: float = 0.0
    side_pressures: tuple[float, float] = (0.0, 0.0)
    turbulence: FilmTurbulence | None = None
    pressure_viscosity: PressureViscosity | None = None

    @cached_property
    def land_order(self) -> list[int]:
        """Numbers of the lands by their start angles within a turn."""
        return sorted(range(len(self.lands)), key=lambda number: self.lands[number].start_angle % (2.0 * math.pi))

    @property
    def is_surface(self) -> bool:
        """Whether the film is solved node by node (``surface``); all others separate into modes of the width."""
        return bool(
            not self.is_plain
            or self.film_start is FilmStart.PERIODIC
            or any(land.start_pressure > 0.0 or land.end_pressure > 0.0 for land in self.lands)
            or self.is_starved
        )

    @property
    def is_plain(self) -> bool:
        """Whether nothing but its lands shapes the gap, with one viscosity and both sides at ambient pressure."""
        return not (
            self.pockets
            or self.misalignment != (0.0, 0.0)
            or self.axial_viscosity
            or self.viscosity_field
            or self.steps
            or self.crowning
            or self.displacement
            or self.side_pressures != (0.0, 0.0)
            or self.turbulence
            or self.pressure_viscosity
        )

    @cached_property
    def is_round(self) -> bool:
        """Whether all lands lie on one circle, about which positions count."""
        return all(
            land.clearance in (None, self.clearance) and land.centre == (0.0, 0.0) and not land.profile
            for land in self.lands
        )

    @property
    def is_straight(self) -> bool:
        """Whether the gap is the same all over the width, but for steps and pockets."""
        return self.misalignment == (0.0, 0.0) and not self.crowning and not self.displacement

    @property
    def is_starved(self) -> bool:
        """Whether a groove or pocket fills only part of the gap behind it."""
        return any(land.start_fill < 1.0 for land in self.lands) or any(one.fill < 1.0 for one in self.pockets)

    @cached_property
    def is_symmetric(self) -> bool:
        """Whether both halves of the width are alike."""
        return (
            self.misalignment == (0.0, 0.0)
            and {replace(one, axial_centre=-one.axial_centre) for one in self.pockets} == set(self.pockets)
            and {replace(one, axial_centre=-one.axial_centre) for one in self.steps} == set(self.steps)
            and all(row == row[::-1] for row in (*self.viscosity_field, *self.displacement))
            and self.axial_viscosity == self.axial_viscosity[::-1]
            and self.crowning == self.crowning[::-1]
            and self.side_pressures[0] == self.side_pressures[1]
        )

    def __post_init__(self) -> None:
        for name in ("diameter", "width", "clearance", "viscosity"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0.0):
                raise InputError("E101", f"{name} is {value}; it must be a positive number (SI units).")
        if not math.isfinite(self.angular_speed):
            raise InputError(
                "E101", f"angular_speed is {self.angular_speed}; it must be a finite number in rad/s."
            )
        if self.cavitation_pressure > 0.0:
            raise InputError(
                "E101", f"cavitation_pressure is {self.cavitation_pressure} Pa; it must be zero or below (gauge)."
            )
        check_lands(self.lands, self.cavitation_pressure)
        if self.film_start is FilmStart.WIDEST_GAP:
            check_round(self)
        check_pockets(self)
        check_steps(self)
        if min(self.side_pressures) < self.cavitation_pressure:
            raise InputError("E101", f"side_pressures are {self.side_pressures} Pa; both must be at least the "
                             f"cavitation pressure, {self.cavitation_pressure} Pa.")  # fmt: skip
        if self.cavitation is Cavitation.HALF_SOMMERFELD:
            check_plain_ring(self)
        check_fills(self)


def check_round(film: JournalFilm) -> None:
    """Refuse bores without a single widest gap."""
    land = film.lands[0]
    whole = abs(land.end_angle - land.start_angle - 2.0 * math.pi) < 1e-9
    if len(film.lands) > 1 or not whole or land.profile or land.centre != (0.0, 0.0):
        raise InputError("E101", "this start or end of the film needs one round land of 360 degrees.")
    if not film.is_plain:
        raise InputError(
            "E101",
            "this start or end of the film is for plain bearings: laminar, one viscosity, no pockets, steps, "
            "tilt, crowning, displacement, side pressures; choose another.",
        )


def check_plain_ring(film: JournalFilm) -> None:
    """Refuse half-Sommerfeld films other than the closed, plain, round ring for which the condition is used."""
    if film.film_start is not FilmStart.PERIODIC or film.pockets or film.misalignment != (0.0, 0.0):
        raise InputError("E101", "the half-Sommerfeld condition is for a plain closed ring; choose "
                         "FilmStart.PERIODIC without pockets and tilt, or another condition.")  # fmt: skip
    check_round(film)


def check_pockets(film: JournalFilm) -> None:
    """Refuse pockets outside the bearing or below cavitation pressure, and rings that nothing feeds."""
    for pocket in film.pockets:
        if not (pocket.extent > 0.0 and pocket.axial_length > 0.0):
            raise InputError("E101", "a pocket has no size; extent and axial_length must be positive.")
        if abs(pocket.axial_centre) + 0.5 * pocket.axial_length > 0.5 * film.width * (1.0 + 1e-12):
            raise InputError("E101", f"the pocket or hole at {math.degrees(pocket.centre_angle):.4g} deg reaches "
                             "beyond the width of the bearing.")  # fmt: skip
        if pocket.pressure < film.cavitation_pressure:
            raise InputError("E101", f"a pocket has {pocket.pressure} Pa, less than the cavitation pressure.")
    if film.film_start is FilmStart.PERIODIC:
        extent = film.lands[0].end_angle - film.lands[0].start_angle
        if len(film.lands) > 1 or not math.isclose(extent, 2.0 * math.pi, rel_tol=1e-9):
            raise InputError("E101", "film_start is periodic; that needs one land of 360 degrees.")
        if film.cavitation is Cavitation.MASS_CONSERVING and not film.pockets:
            raise InputError("E101", "nothing feeds this closed ring: a mass-conserving film would run dry. Give "
                             "pockets or holes, or choose Cavitation.REYNOLDS.")  # fmt: skip


FULL = 1.0 - 1e-9
"""Fill from which a supply can stand under pressure."""


def check_fills(film: JournalFilm) -> None:
    """Refuse fills beyond 0 to 1, starved supplies under pressure, starved films that do not count oil."""
    forward = film.angular_speed >= 0.0  # oil enters a land at its end where the journal turns back
    supplies = [(land.start_fill, land.start_pressure if forward else land.end_pressure) for land in film.lands]
    supplies += [(pocket.fill, pocket.pressure) for pocket in film.pockets]
    for fill, pressure in supplies:
        if not 0.0 < fill <= 1.0:
            raise InputError("E101", f"the fill of a groove or pocket is {fill}; it must lie above 0, up to 1.")
        if fill < FULL and pressure > film.cavitation_pressure:
            raise InputError("E101", f"a groove or pocket with a fill of {fill} stands at {pressure} Pa; one "
                             "that is starved is at the cavitation pressure.")  # fmt: skip
    if film.is_starved and film.cavitation is not Cavitation.MASS_CONSERVING:
        raise InputError("E101", "a starved supply needs Cavitation.MASS_CONSERVING, which counts the oil.")


def check_steps(film: JournalFilm) -> None:
    """Refuse steps without size or outside the bearing."""
    for step in film.steps:
        if not (0.0 < step.extent <= 2.0 * math.pi * (1.0 + 1e-12) and step.axial_length > 0.0):
            raise InputError("E101", "a step has no size; extent (to one turn) and axial_length must be positive.")
        if abs(step.axial_centre) + 0.5 * step.axial_length > 0.5 * film.width * (1.0 + 1e-12):
            raise InputError(
                "E101",
                f"the step at {math.degrees(step.centre_angle):.4g} deg reaches beyond the bearing's width.",
            )
