"""Pictures of the films of a tilting-pad bearing on the axes of the user, drawn as the reports draw them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from babbitt.api.drawn import MAP, SQUARE, drawn
from babbitt.core.notices import InputError
from babbitt.core.solution import Solution

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from babbitt.kinds.tilting_pad_journal.check import PadSolutionState
    from babbitt.kinds.tilting_pad_journal.model import PadCase

__all__ = ["PadPlots"]


class PadPlots:
    """Pictures of one tilting-pad bearing: on axes of matplotlib that are given or in a figure that is made.

    Parameters
    ----------
    solution : Solution
        Of a tilting-pad journal bearing, with its state.
    """

    def __init__(self, solution: Solution) -> None:
        self._solution = solution

    def __call__(self, ax: Axes | None = None) -> Axes:
        """The pressure; parameters and errors as `pressure`."""
        return self.pressure(ax)

    def pressure(self, ax: Axes | None = None) -> Axes:
        """Pressure over the unrolled pads; circles are pivots.

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
        from babbitt.kinds.tilting_pad_journal.report.maps import draw_pressure

        return self._drawn(draw_pressure, ax, MAP)

    def gap(self, ax: Axes | None = None) -> Axes:
        """Film thickness of the pads over the angle; parameters and errors as `pressure`."""
        from babbitt.kinds.tilting_pad_journal.report.maps import draw_gaps

        return self._drawn(draw_gaps, ax, MAP)

    def polar(self, ax: Axes | None = None) -> Axes:
        """The bearing seen along the shaft, the films enlarged; parameters and errors as `pressure`."""
        from babbitt.kinds.tilting_pad_journal.report.seen_along import draw_along_shaft

        return self._drawn(draw_along_shaft, ax, SQUARE)

    def temperature(self, ax: Axes | None = None) -> Axes:
        """Temperatures of bores and films over the angle; parameters and errors as `pressure`.

        Raises
        ------
        InputError
            E004 for films of one temperature.
        """
        from babbitt.kinds.tilting_pad_journal.report.temperatures import draw_temperatures

        state, case = self._films()
        thermal = state.films.thermal
        if thermal is None:
            raise InputError(
                "E004", f"{case.name}: the films have one temperature and no picture of it; films with their own "
                "temperatures are solved with thermal: adiabatic or full"
            )  # fmt: skip
        return drawn(lambda panel: draw_temperatures(panel, case, thermal), ax, MAP)

    def _drawn(
        self, draw: Callable[[Any, PadCase, Any], None], ax: Axes | None, size: tuple[float, float]
    ) -> Axes:
        state, case = self._films()
        return drawn(lambda panel: draw(panel, case, state.films.solution), ax, size)

    def _films(self) -> tuple[PadSolutionState, PadCase]:
        from babbitt.api.film import film_of_solution

        film_of_solution(self._solution)  # says what a result without film lacks
        return self._solution.state, self._solution.problem

    def __dir__(self) -> list[str]:
        return [one for one in super().__dir__() if not one.startswith("_")]

    def __repr__(self) -> str:
        return f"plots of {self._solution.result.name}: {', '.join(self.__dir__())}"
