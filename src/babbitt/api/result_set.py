"""The results of one bearing over one or several parameters, as arrays."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

from babbitt.api.results import BearingResult
from babbitt.core.nearest_name import unknown_name
from babbitt.core.notices import InputError
from babbitt.core.optional_package import optional_package
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Verdict

if TYPE_CHECKING:
    import pandas
    import xarray

    from babbitt.export import CoefficientTable

__all__ = ["ResultSet"]

Array = NDArray[Any]

KEEP = ("results", "solutions")
"""What of each point is kept: its values, or its film, too."""


class ResultSet:
    """Results over parameters: ``table["stiffness"]`` has the shape of the parameters, then that of the matrix.

    Parameters
    ----------
    parameters : mapping
        Names and values of what was varied. Either one array along each axis of the shape, in their order (a
        product), or arrays that broadcast to the shape.
    results : sequence of BearingResult
        One for each point, the last axis varying fastest.
    shape : tuple of int
        Of the points.
    keep : {"results", "solutions"}
        Films take memory; by default they are not kept.
    about : mapping, optional
        By the name of a parameter, its ``units`` and ``long_name``.

    Raises
    ------
    ValueError
        Where results or parameters do not fit the shape, or `keep` is something else.
    """

    def __init__(
        self,
        parameters: Mapping[str, Any],
        results: Sequence[BearingResult],
        shape: tuple[int, ...],
        keep: str = "results",
        about: Mapping[str, Mapping[str, str]] | None = None,
    ) -> None:
        if keep not in KEEP:
            raise ValueError(f"keep is {keep!r}; allowed: {', '.join(KEEP)}")
        if len(results) != int(np.prod(shape)):
            raise ValueError(f"{len(results)} results do not fill the shape {shape}")
        self._shape = tuple(int(size) for size in shape)
        self._results = tuple(one if keep == "solutions" else one.without_state() for one in results)
        given = {name: np.asarray(values) for name, values in parameters.items()}
        self._is_product = len(given) == len(self._shape) and all(
            values.shape == (size,) for values, size in zip(given.values(), self._shape, strict=True)
        )
        self._given = given
        self._about = {name: dict((about or {}).get(name, {})) for name in given}
        self._parameters = {
            name: self._broadcast(name, values, axis) for axis, (name, values) in enumerate(given.items())
        }

    @property
    def parameters(self) -> Mapping[str, Array]:
        """What was varied, every array of the shape of the set, read-only."""
        return MappingProxyType(self._parameters)

    @property
    def results(self) -> tuple[BearingResult, ...]:
        """All results, the last axis varying fastest."""
        return self._results

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the points."""
        return self._shape

    @property
    def solved(self) -> NDArray[np.bool_]:
        """Where there is an operating point."""
        return np.array([one.solved for one in self._results], dtype=bool).reshape(self._shape)

    @property
    def within_limits(self) -> NDArray[np.bool_]:
        """Where the bearing passes; False where it is not solved."""
        return np.array([one.within_limits for one in self._results], dtype=bool).reshape(self._shape)

    @property
    def verdicts(self) -> NDArray[np.object_]:
        """The `babbitt.core.result.Verdict` of every point."""
        verdicts = np.empty(len(self._results), dtype=object)
        verdicts[:] = [one.verdict for one in self._results]
        return verdicts.reshape(self._shape)

    @property
    def names(self) -> tuple[str, ...]:
        """Quantities that at least one point has, values before arrays."""
        values = [name for one in self._results for name in one.result.values]
        arrays = [name for one in self._results for name in one.result.arrays]
        return tuple(dict.fromkeys((*values, *arrays)))

    @overload
    def __getitem__(self, key: str) -> Array: ...
    @overload
    def __getitem__(self, key: int | tuple[int, ...]) -> BearingResult: ...

    def __getitem__(self, key: str | int | tuple[int, ...]) -> Array | BearingResult:
        """A quantity or a parameter of all points by name, or the result of one point by its place.

        Raises
        ------
        KeyError
            For a name that no point has.
        IndexError
            For a place that there is not, or that is not one point.
        """
        if isinstance(key, str):
            return self._parameters[key] if key in self._parameters else self._array(key)
        place = key if isinstance(key, tuple) else (key,)
        if len(place) != len(self._shape):
            raise IndexError(
                f"{len(self._shape)} numbers name a point of the shape {self._shape}, not {len(place)}"
            )
        numbers = np.arange(len(self._results)).reshape(self._shape)[place]
        if np.ndim(numbers) != 0:
            raise IndexError("a place is whole numbers, one for each axis; iterate for several points")
        return self._results[int(numbers)]

    def __iter__(self) -> Iterator[BearingResult]:
        return iter(self._results)

    def __len__(self) -> int:
        return len(self._results)

    def to_xarray(self) -> xarray.Dataset:
        """Every quantity over the parameters, with ``units`` and ``long_name``; the parameters are coordinates.

        Raises
        ------
        InputError
            E007 where xarray is not installed.
        """
        from babbitt.api.tables import attributes_of, axes_of
        from babbitt.report.fields import require_package

        package = require_package("xarray")
        axes = self._axis_names()
        coordinates: dict[str, Any] = {
            name: ((axes[number],) if self._is_product else axes, values, attributes_of(name) | self._about[name])
            for number, (name, values) in enumerate(
                (self._given if self._is_product else self._parameters).items()
            )
        }
        variables: dict[str, Any] = {
            "solved": (axes, self.solved, {}),
            "verdict": (axes, np.array([one.verdict.key for one in self._results]).reshape(self._shape), {}),
        }
        for name in self.names:
            if name == "wall_time" or name in coordinates:
                continue
            array = self._array(name)
            dimensions, own = axes_of(name, array.shape[len(axes) :]) if array.ndim > len(axes) else ((), {})
            variables[name] = ((*axes, *dimensions), array, attributes_of(name))
            coordinates |= own
        made: xarray.Dataset = package.Dataset(variables, coords=coordinates)
        return made

    def to_dataframe(self) -> pandas.DataFrame:
        """A row for each point: parameters, status and verdict, values, entries of matrices.

        ``frame.attrs["units"]`` has the units of the columns.

        Raises
        ------
        InputError
            E007 where pandas is not installed.
        """
        from babbitt.api.tables import frame_of

        flat = {name: values.ravel() for name, values in self._parameters.items()}
        leading = [{name: values[row] for name, values in flat.items()} for row in range(len(self))]
        return frame_of(
            leading, self._results, {name: one["units"] for name, one in self._about.items() if "units" in one}
        )

    def coefficient_table(self) -> CoefficientTable:
        """Stiffness and damping over speed, of a sweep over speed alone.

        Raises
        ------
        InputError
            E003 for unsolved or equal speeds, E004 for methods and bearings without such a table.
        """
        from babbitt.api.coefficients import coefficients_of

        return coefficients_of(self._results)

    def export(self, path: str | Path, format: str, *, version: int | None = None) -> None:
        """Write stiffness and damping over speed for another program.

        Parameters
        ----------
        path : str or Path
        format : str
            One of `babbitt.export.FORMATS`, or ``ross`` with its version.
        version : {2, 3}, optional
            Major version of ROSS that reads the file; for ROSS alone.

        Raises
        ------
        InputError
            E003 for ROSS without its version or another format with one, E005 for an unknown format; what the
            format and `coefficient_table` refuse.
        """
        from babbitt.export import FORMATS, export

        if format == "ross" and version not in (2, 3):
            raise InputError("E003", "files for ROSS say for which: version=2 or version=3")
        if format != "ross" and version is not None:
            raise InputError("E003", f"version is said of format='ross' alone, not of {format!r}")
        name = f"ross{version}" if format == "ross" else format
        if name not in FORMATS:
            raise InputError("E005", unknown_name(format, ("ross", *FORMATS), "a format"))
        export(self.coefficient_table(), path, name)

    def to_ross(self, n: int, tag: str | None = None) -> Any:
        """A bearing element of the ROSS that is installed, over the speed of the journal.

        Parameters
        ----------
        n : int
            Node of the rotor.
        tag : str, optional
            By default the name of the bearing.

        Returns
        -------
        ross.BearingElement

        Raises
        ------
        InputError
            E007 where ROSS is not installed; E003 for a clockwise table, and what `coefficient_table` refuses.
        """
        from babbitt.export import for_rotor_programs
        from babbitt.export.ross import RossVersion, bearing_element

        table = for_rotor_programs(self.coefficient_table())
        ross = optional_package("ross", "bearing elements", "Install it with: pip install ross-rotordynamics")
        version = RossVersion(2 if str(ross.__version__).startswith("2.") else 3)
        element = bearing_element(table, version, n)
        del element["babbitt"]
        return ross.BearingElement(**element | {"tag": tag or table.name})

    def __repr__(self) -> str:
        if not self._results:
            return "no results"
        over = ", ".join(
            f"{name} ({values.size})" if self._is_product else f"{name} {values.shape}"
            for name, values in self._given.items()
        )
        counts = {one: sum(result.verdict is one for result in self._results) for one in Verdict}
        counted = ", ".join(f"{count} {verdict.value}" for verdict, count in counts.items() if count)
        first = self._results[0]
        return (
            f"{first.name}  ({first.kind}, {first.method}): {len(self)} points over {over}\n"
            f"  {counted}\n"
            f"  {len(self.names)} quantities by name in .names, such as table[{self.names[0]!r}]"
            if self.names
            else f"{first.name}: {len(self)} points over {over}, {counted}"
        )

    def _axis_names(self) -> tuple[str, ...]:
        if self._is_product:
            return tuple(self._given)
        return ("point",) if len(self._shape) == 1 else tuple(f"axis_{axis}" for axis in range(len(self._shape)))

    def _broadcast(self, name: str, values: Array, axis: int) -> Array:
        along = values
        if self._is_product:
            along = values.reshape([-1 if number == axis else 1 for number in range(len(self._shape))])
        try:
            return np.broadcast_to(along, self._shape)  # read-only
        except ValueError:
            raise ValueError(f"the parameter {name} has shape {values.shape}, the results {self._shape}") from None

    def _array(self, name: str) -> Array:
        if name not in self.names:
            if name in QUANTITIES and not self.solved.any():
                return _frozen(np.full(self._shape, np.nan))
            what = "a quantity of these results or a parameter"
            raise KeyError(unknown_name(name, (*self.names, *self._parameters), what))
        rows = [one.arrays.get(name) for one in self._results]
        shapes = {row.shape for row in rows if row is not None}
        if not any(name in one.result.values for one in self._results):
            shapes = shapes or {
                np.shape(one.result.arrays[name]) for one in self._results if name in one.result.arrays
            }
            if len(shapes) > 1:
                raise KeyError(f"{name} has another shape from point to point; iterate over the results")
            (shape,) = shapes
            made = np.full((len(rows), *shape), np.nan)
            for number, row in enumerate(rows):
                if row is not None:
                    made[number] = row
            return _frozen(made.reshape(*self._shape, *shape))
        numbers = [one.values.get(name, np.nan) for one in self._results]
        return _frozen(np.array(numbers, dtype=np.float64).reshape(self._shape))


def _frozen(values: Array) -> Array:
    values.setflags(write=False)
    return values
