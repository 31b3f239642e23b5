"""Films that differ little, one after the other: each is sought where the last one converged.

As where clearance, supply pressure or bore settle with the temperatures: every film is close to the last one, and
stands on the same lines, so that it changes as smoothly as what it is asked for. On lines drawn anew it would jump
by the error of the grid.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, replace

from babbitt.reynolds.heat.following_clearance import FollowingClearance, with_clearance
from babbitt.reynolds.heat.globalisation import accelerated_equilibrium, stabilised
from babbitt.reynolds.heat.heat_model import THERMAL_ENGINEERING, FilmHeat
from babbitt.reynolds.heat.thermal_equilibrium import Posed, answer, directly, posed, search
from babbitt.reynolds.heat.thermal_film_state import ThermalFilmState
from babbitt.reynolds.heat.thermal_passes import (
    CLOSER,
    SETTLED,
    ThermalEquilibrium,
    continued,
    find_thermal_equilibrium,
    fresh_ring,
)
from babbitt.reynolds.heat.thermal_solution import ThermalFilm
from babbitt.reynolds.lands._equilibrium import CONVERGED, NO_FILM, THINNEST, TOO_MANY_STEPS
from babbitt.reynolds.model import JournalFilm, Resolution
from babbitt.reynolds.surface.mesh_lines import Density
from babbitt.reynolds.surface.surface_equilibrium import line_density

__all__ = ["ThermalTrail"]


@dataclass
class ThermalTrail:
    """Films under a load that change from one to the next.

    Attributes
    ----------
    last : ThermalEquilibrium or None
        Where the last film that was found converged.
    """

    last: ThermalEquilibrium | None = None

    def solve(
        self,
        film: JournalFilm,
        heat: FilmHeat,
        load: tuple[float, float],
        resolution: Resolution = THERMAL_ENGINEERING,
    ) -> ThermalFilm:
        """Film under a load, as `solve_thermal_journal` finds it, but from the last one."""
        begun, asked = time.perf_counter(), posed(film, load)
        found = None if self.last is None else _continued_from(self.last, asked, heat, resolution)
        if found is None or found.status != CONVERGED:
            found = search(asked.seen, heat, asked.scales, asked.load, resolution)
        return self._noted(asked, found, begun)

    def solve_growing(
        self,
        film: JournalFilm,
        heat: FilmHeat,
        load: tuple[float, float],
        resolution: Resolution,
        growth: FollowingClearance,
    ) -> ThermalFilm:
        """Film whose clearance follows its temperatures, one that `keeps_its_ring`; at its own where none does."""
        begun, asked = time.perf_counter(), posed(film, load)
        found = _with_a_gap(directly(asked.seen, heat, asked.scales, asked.load, resolution, growth))
        if found.status == CONVERGED:
            grown = posed(with_clearance(film, growth.now.clearance), load)
            solved = self._noted(grown, found, begun)
            if solved.film.outcome.solved:
                return solved
        growth.begin()
        return self.solve(film, heat, load, resolution)

    def climb(
        self,
        film: JournalFilm,
        heat: FilmHeat,
        load: tuple[float, float],
        resolution: Resolution = THERMAL_ENGINEERING,
    ) -> ThermalFilm:
        """Film under a load that differs more, on lines drawn for the last one; unsolved where the way is lost.

        It tells how far a bearing can be loaded without the long search that a film which is not there takes.
        """
        if self.last is None:
            return self.solve(film, heat, load, resolution)
        begun, asked = time.perf_counter(), posed(film, load)
        density = line_density(asked.seen, self.last.position, self.last.gap)
        thermal = _continued(self.last, asked, heat, resolution, density)
        if thermal is None:
            return self.solve(film, heat, load, resolution)
        found = find_thermal_equilibrium(thermal, asked.load, self.last.position, resolution.tolerance, SETTLED)
        return self._noted(asked, _with_a_gap(stabilised(found, resolution, SETTLED)), begun)

    def _noted(self, asked: Posed, found: ThermalEquilibrium, begun: float) -> ThermalFilm:
        if found.status == CONVERGED:
            self.last = found
        return answer(asked.frame, asked.seen, asked.scales, found, begun)


def _continued_from(
    last: ThermalEquilibrium, asked: Posed, heat: FilmHeat, resolution: Resolution
) -> ThermalEquilibrium | None:
    """Equilibrium of a film close to the last one, on its lines; None where it has other nodes across."""
    thermal = _continued(last, asked, heat, resolution, last.thermal.density)
    if thermal is None:
        return None
    if last.mixed:
        return _with_a_gap(
            accelerated_equilibrium(thermal, asked.load, last.position, resolution.tolerance, SETTLED)
        )
    found = find_thermal_equilibrium(thermal, asked.load, last.position, resolution.tolerance, CLOSER)
    if found.status == TOO_MANY_STEPS:  # as streamers that flicker for ever: it may converge less closely
        found = find_thermal_equilibrium(thermal, asked.load, found.position, resolution.tolerance, SETTLED)
    return _with_a_gap(stabilised(found, resolution, SETTLED))


def _continued(
    last: ThermalEquilibrium, asked: Posed, heat: FilmHeat, resolution: Resolution, density: Density | None
) -> ThermalFilmState | None:
    """Ring with the temperatures of the last film; None where the nodes across are others.

    As beside a groove around the bore, which makes lands of its own under pressure, and none without.
    """
    lines = fresh_ring(asked.seen, heat, asked.scales, 2 * resolution.intervals, resolution, density)
    if lines.sample.ring.mesh.nodes.size != last.thermal.sample.ring.mesh.nodes.size:
        return None
    thermal = continued(lines, last.thermal)
    thermal.relaxation = last.thermal.relaxation  # it swings as the last one did
    return thermal


def _with_a_gap(found: ThermalEquilibrium) -> ThermalEquilibrium:
    return replace(found, status=NO_FILM) if found.gap < THINNEST else found
