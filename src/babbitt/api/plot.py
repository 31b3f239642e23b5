"""Pictures of a solved film on the axes of the user, drawn as the reports draw them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from babbitt.api.drawn import MAP, SQUARE, drawn
from babbitt.api.film import require_state
from babbitt.core.notices import InputError
from babbitt.core.solution import Solution
from babbitt.kinds.journal.film.field import FilmField, field_of
from babbitt.kinds.journal.film.isothermal import FilmState, under_found_load

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from babbitt.api.pad_plot import PadPlots
    from babbitt.kinds.journal.film.model import FilmCase

__all__ = ["ResultPlots", "plots_of_solution"]


def plots_of_solution(solution: Solution) -> ResultPlots | PadPlots:
    """Pictures of a solution: those of its kind."""
    if solution.result.kind == "tilting_pad_journal":
        from babbitt.api.pad_plot import PadPlots

        return PadPlots(solution)
    return ResultPlots(solution)


class ResultPlots:
    """Pictures of one result: each takes axes of matplotlib or makes a figure, and gives the axes back.

    Parameters
    ----------
    solution : Solution
        Of the method film, with its state.
    """

    def __init__(self, solution: Solution) -> None:
        self._solution = solution

    def __call__(self, ax: Axes | None = None) -> Axes:
        """The orbit of a bearing with a changing load, else the pressure; parameters and errors as `pressure`."""
        return self.orbit(ax) if "orbit" in self._solution.result.arrays else self.pressure(ax)

    def pressure(self, ax: Axes | None = None) -> Axes:
        """Pressure over the unrolled bore; hatched where the film is ruptured.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            A new figure by default.

        Returns
        -------
        matplotlib Axes

        Raises
        ------
        AttributeError
            For a result without film.
        InputError
            E007 where matplotlib is not installed.
        """
        return self._map("pressure_map", ax)

    def gap(self, ax: Axes | None = None) -> Axes:
        """Film thickness over the unrolled bore; parameters and errors as `pressure`."""
        return self._map("thickness_map", ax)

    def polar(self, ax: Axes | None = None) -> Axes:
        """The bearing seen along the shaft, the clearance enlarged; parameters and errors as `pressure`."""
        state, case, field = self._film()

        def draw(panel: Axes) -> None:
            from babbitt.kinds.journal.report.film_polar import seen_along_shaft

            seen_along_shaft(panel, case, state.solution, field)

        return drawn(draw, ax, SQUARE)

    def temperature(self, ax: Axes | None = None) -> Axes:
        """Mean temperature across the gap over the unrolled bore; parameters and errors as `pressure`.

        Raises
        ------
        InputError
            E004 for a film of one temperature.
        """
        state, case, field = self._film()
        thermal = state.thermal
        if thermal is None:
            raise InputError(
                "E004", f"{case.name}: the film has one temperature and no picture of it; one with its own "
                "temperatures is solved with thermal: adiabatic or full"
            )  # fmt: skip

        def draw(panel: Axes) -> None:
            from babbitt.kinds.journal.report import film_maps
            from babbitt.kinds.journal.report.film_temperature import temperature_map

            temperature_map(panel, case, thermal, field)
            panel.set_xlabel(film_maps.AROUND)
            film_maps.rotation(panel, case)

        return drawn(draw, ax, MAP)

    def orbit(self, ax: Axes | None = None) -> Axes:
        """Orbit of the journal in the room that the bore leaves; parameters and errors as `pressure`.

        Raises
        ------
        InputError
            E004 for a bearing without a changing load.
        """
        state, case, _ = self._film()
        result = self._solution.result
        if "orbit" not in result.arrays:
            raise InputError("E004", f"{case.name}: the journal stays in its place; an orbit needs dynamic_load")

        def draw(panel: Axes) -> None:
            from babbitt.kinds.journal.report.film_orbit import orbit_in_clearance

            orbit_in_clearance(panel, state, result)

        return drawn(draw, ax, SQUARE)

    def _map(self, name: str, ax: Axes | None) -> Axes:
        state, case, field = self._film()

        def draw(panel: Axes) -> None:
            from babbitt.kinds.journal.report import film_maps

            getattr(film_maps, name)(panel, case, state.solution, field)
            panel.set_xlabel(film_maps.AROUND)
            film_maps.rotation(panel, case)

        return drawn(draw, ax, MAP)

    def _film(self) -> tuple[FilmState, FilmCase, FilmField]:
        from babbitt.api.film import film_of_solution

        film_of_solution(self._solution)  # says what a result without film lacks
        require_state(self._solution)
        state: FilmState = self._solution.state
        case = under_found_load(self._solution.problem, state)
        return state, case, field_of(state.solution, case.load_angle - math.pi)

    def __dir__(self) -> list[str]:
        return [one for one in super().__dir__() if not one.startswith("_")]

    def __repr__(self) -> str:
        return f"plots of {self._solution.result.name}: {', '.join(self.__dir__())}"
