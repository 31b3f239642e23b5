"""The tilt at which the moments about the pivot vanish, and the film that carries a load."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, ClassVar

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.gap import minimum_gap
from babbitt.kinds.thrust.pad import DEGREE, ThrustPad
from babbitt.kinds.thrust.pad_attitude import PARALLEL, PadTilt
from babbitt.kinds.thrust.peak import peak_pressure
from babbitt.kinds.thrust.state import PadState
from babbitt.kinds.thrust.work import COLD_FILM, spend
from babbitt.numerics.damped_newton import damped_newton
from babbitt.reynolds.model import Cavitation

if TYPE_CHECKING:
    from babbitt.reynolds.sector.sector import SectorFilm, SectorPad

__all__ = [
    "UnbalancedPadError",
    "first_motion",
    "first_slopes",
    "leaning_state",
    "pad_state",
    "sector_of",
    "state_of_film",
]

Array = NDArray[np.float64]

MOMENT_TOLERANCE = 1e-10
"""Of the moments over load times width of the pad."""
MOST_STEPS = 25
LEAST_GAP = 0.01
"""Newton steps stop short of films thinner than this share of the height at the pivot; far-off pivots balance on a
few hundredths of it."""
PARTS = (1.0, 0.6, 0.35, 0.2)
"""Of the slope of a level pad, from which that of a leaning one is sought."""
MOST_HALVINGS = 9
"""Of Newton's step before the runner; a smaller one leads nowhere: the balance lies beyond the runner."""
FIRST_RISE = 0.35
"""First guess of the fall of the film from the pivot to the trailing edge, over the height."""


class UnbalancedPadError(InputError):
    """No tilt balances the pad on its pivot."""


def pad_state(
    pad: ThrustPad,
    height: float,
    viscosity: float,
    angular_speed: float,
    guess: tuple[float, float] | None = None,
    intervals: int | None = None,
    degree: int = DEGREE,
    lean: PadTilt = PARALLEL,
) -> PadState:
    """Film of a pad whose pivot stands at a height, at the tilts at which free moments vanish.

    Newton's method with the stiffness of the film.

    Parameters
    ----------
    pad : ThrustPad
    height : float
        Film at the pivot, m.
    viscosity, angular_speed : float
        Pa s, rad/s, positive.
    guess : tuple of float, optional
        Slopes from which to start.
    intervals, degree : int
        Mesh along and across; see `ThrustPad.intervals`.
    lean : tuple of float
        Slopes of the gap that the pivot holds; those of free tilts count for nothing.

    Raises
    ------
    InputError
        E201 if the height is not positive; E202 if no tilt balances the pad, or it leans into the runner.
    """
    if not (np.isfinite(height) and height > 0.0):
        raise InputError("E201", f"film at the pivot is {height:g} m; it must be positive.")
    mesh = (intervals or pad.intervals, degree)
    sector = sector_of(pad, viscosity, angular_speed)
    slopes = guess or first_slopes(pad, height)
    try:
        return _balanced(pad, sector, first_motion(pad, height, slopes, lean), mesh)
    except UnbalancedPadError:
        if not pad.free_tilts:
            raise
    # streamers bend the moments: where they keep Newton's method from the balance, that of the simpler condition
    # of Reynolds is next to it
    simpler = replace(sector, cavitation=Cavitation.REYNOLDS)
    begin = _balanced(pad, simpler, first_motion(pad, height, slopes, lean), mesh)
    return _balanced(pad, sector, begin.motion, mesh)


def _balanced(pad: ThrustPad, sector: SectorPad, motion: Array, mesh: tuple[int, int]) -> PadState:
    """Newton's method on the moments of the free tilts."""
    tilting = _Tilting(pad, sector, mesh)
    ended = damped_newton(tilting, motion, MOST_STEPS, most_halvings=MOST_HALVINGS)
    if not ended.status:
        raise _unbalanced(pad)
    return state_of_film(pad, tilting.film, ended.at, sector.viscosity, sector.angular_speed)


@dataclass(eq=False)
class _Tilting:
    """A pad that is to balance on its pivot; see `babbitt.numerics.damped_newton.NewtonProblem`."""

    pad: ThrustPad
    sector: SectorPad
    mesh: tuple[int, int]
    film: SectorFilm = field(init=False)
    no_room: ClassVar[bool] = False
    too_many_steps: ClassVar[bool] = False

    def room(self, at: Array) -> float:
        """Thinnest film: that of the face, for a crowned pad may lean until its plane would cut the runner."""
        return float(minimum_gap(self.pad, at))

    def kept_room(self, at: Array, room: float) -> float:
        """A share of the height, if the pad tilts at all."""
        return LEAST_GAP * float(at[0])

    def look(self, at: Array, step: int) -> bool | None:
        """The film, and whether its moments vanish."""
        to_film, width = self.pad.from_pivot(), self.pad.outer_radius - self.pad.inner_radius
        self.film = _film(self.sector, to_film @ at, self.mesh)
        forces = to_film.T @ self.film.forces
        missed = np.abs(forces[list(self.pad.free_tilts)]).max(initial=0.0)
        return True if missed <= MOMENT_TOLERANCE * abs(forces[0]) * width else None

    def move(self, at: Array, room: float) -> Array:
        """Newton's step of the free tilts."""
        free, to_film = list(self.pad.free_tilts), self.pad.from_pivot()
        stiffness = to_film.T @ self.film.stiffness @ to_film
        step = np.zeros(3)
        step[free] = np.linalg.solve(stiffness[np.ix_(free, free)], (to_film.T @ self.film.forces)[free])
        return step


def leaning_state(
    pad: ThrustPad, height: float, viscosity: float, angular_speed: float, along: float, lean: PadTilt
) -> PadState:
    """A film that leans; a line pivot that leans much tilts less than a level one, so less is tried in turn.

    Beyond its balance such a pad falls over into a gap that diverges, where nothing moves it any more.

    Parameters
    ----------
    pad : ThrustPad
    height : float
        Film at the pivot, m.
    viscosity, angular_speed : float
        Pa s, rad/s, positive.
    along : float
        Slope along the motion of a level pad, from parts of which that of this one is sought.
    lean : tuple of float
        Slopes of the gap that the pivot holds.

    Raises
    ------
    UnbalancedPadError
        E202 if no tilt balances the pad, or it leans into the runner.
    """
    for part in PARTS[:-1] if pad.free_tilts else ():
        try:
            state = pad_state(pad, height, viscosity, angular_speed, (0.0, part * along), lean=lean)
        except UnbalancedPadError:
            continue
        if state.load > 0.0:
            return state
    state = pad_state(pad, height, viscosity, angular_speed, (0.0, PARTS[-1] * along), lean=lean)
    if pad.free_tilts and not state.load > 0.0:
        raise UnbalancedPadError(
            "E202", f"at a film of {height * 1e6:.2f} µm no tilt balances the pad that leans."
        )
    return state


def _unbalanced(pad: ThrustPad) -> UnbalancedPadError:
    """What to say of a pad that no tilt balances."""
    return UnbalancedPadError(
        "E202",
        f"pads.pivot: at {pad.pivot_fraction:g} of the extent and radius {1e3 * pad.pivot_radius:g} mm no tilt "
        "balances the pad; allowed for a flat pad: a fraction behind its middle, more than 0.5, and a radius near "
        f"the mean one, {500.0 * (pad.inner_radius + pad.outer_radius):g} mm",
    )


def sector_of(pad: ThrustPad, viscosity: float, angular_speed: float) -> SectorPad:
    """The pad as the film engine sees it."""
    from babbitt.reynolds.sector.sector import SectorPad  # numba is imported when the first film is solved

    return SectorPad(
        pad.inner_radius,
        pad.outer_radius,
        pad.extent,
        viscosity,
        angular_speed,
        pad.form(),
        cavitation=Cavitation.MASS_CONSERVING,
        turbulence=pad.turbulence,
    )


def first_slopes(pad: ThrustPad, height: float) -> tuple[float, float]:
    """A first guess of the slopes."""
    behind = pad.pivot_radius * (1.0 - pad.pivot_fraction) * pad.extent
    return (0.0, -FIRST_RISE * height / behind) if 2 in pad.free_tilts else (0.0, 0.0)


def first_motion(pad: ThrustPad, height: float, slopes: tuple[float, float], lean: PadTilt) -> Array:
    """Where a pad is moved from, (height, slope_x, slope_y): held slopes stay, free ones such that it clears.

    Raises
    ------
    UnbalancedPadError
        If the pad leans into the runner.
    """
    free = np.array([False, *(tilt in pad.free_tilts for tilt in (1, 2))])
    motion = np.where(free, [height, *slopes], [height, *lean])
    for _ in range(MOST_STEPS):
        if minimum_gap(pad, motion) > (LEAST_GAP * height if free.any() else 0.0):
            return motion
        motion = np.where(free, 0.5 * motion, motion)
    if minimum_gap(pad, motion) > 0.0:
        return motion
    raise UnbalancedPadError("E202", f"at a film of {height * 1e6:.2f} µm the pad leans into the collar.")


def _film(sector: SectorPad, motion: Array, mesh: tuple[int, int]) -> SectorFilm:
    from babbitt.reynolds.sector.sector import PlaneMotion, sector_film

    spend(COLD_FILM)
    return sector_film(sector, PlaneMotion(*(float(part) for part in motion)), intervals=mesh[0], degree=mesh[1])


def state_of_film(
    pad: ThrustPad, film: SectorFilm, motion: Array, viscosity: float, angular_speed: float
) -> PadState:
    """The state of a film in the frame of the pivot."""
    to_film = pad.from_pivot()
    _, along_radius, along_motion = (float(force) for force in to_film.T @ film.forces)
    return PadState(
        pad=pad,
        film=film,
        scale=(1.0, 1.0, 1.0),
        height=float(motion[0]),
        slope_x=float(motion[1]),
        slope_y=float(motion[2]),
        viscosity=viscosity,
        angular_speed=angular_speed,
        load=film.load,
        moments=(along_radius, along_motion),
        stiffness=to_film.T @ film.stiffness @ to_film,
        damping=to_film.T @ film.damping @ to_film,
        minimum_film_thickness=float(minimum_gap(pad, motion)),
        maximum_pressure=peak_pressure(film),
        leading_flow=film.leading_flow,
        trailing_flow=film.trailing_flow,
        inner_flow=film.inner_flow,
        outer_flow=film.outer_flow,
        friction_torque=film.friction_torque,
    )
