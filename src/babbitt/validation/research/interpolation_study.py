"""What interpolating So in a coarse table costs: linear against logarithmic, as a published study did it.

The study (gearbox bearings, 2023) compared two ways of reading Sommerfeld numbers from a table with few
columns: linear interpolation of So, and of ln So, each with its own way back from So to eccentricity. Reading
forth and back does not return to the start, since neither inverse is the inverse of its forward rule. Here
the coarse table is cut from our own, so that the error against the dense solution is seen as well. Our
splines are inverted as they stand; their round trip closes to round-off.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from babbitt.kinds.journal.iso7902.characteristics.tables import curves
from babbitt.numerics.scalar_or_array import Array

ECCENTRICITY_RATIOS = (0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 0.95)
WIDTH_RATIOS = (0.25, 0.5, 0.75, 1.0)


@dataclass(frozen=True, eq=False)
class CoarseTable:
    """A table of So read by straight lines, either in So or in its logarithm.

    Attributes
    ----------
    eccentricity_ratios : ndarray, shape (n,)
        Rows, eps.
    width_ratios : ndarray, shape (m,)
        Columns, B/D.
    levels : ndarray, shape (n, m)
        So, or ln So if the table is read logarithmically.
    """

    eccentricity_ratios: Array
    width_ratios: Array
    levels: Array

    def level(self, eccentricity_ratios: Array, width_ratio: float) -> Array:
        """Forward: a line in eps within every column, then a line in B/D between them."""
        columns = [np.interp(eccentricity_ratios, self.eccentricity_ratios, each) for each in self.levels.T]
        return self._between_columns(np.stack(columns), width_ratio)

    def eccentricity_ratio(self, levels: Array, width_ratio: float) -> Array:
        """Backward, as the study did it: a line in So (ln So) within every column, then a line in B/D."""
        columns = [np.interp(levels, each, self.eccentricity_ratios) for each in self.levels.T]
        return self._between_columns(np.stack(columns), width_ratio)

    def _between_columns(self, columns: Array, width_ratio: float) -> Array:
        right = int(np.clip(np.searchsorted(self.width_ratios, width_ratio), 1, len(self.width_ratios) - 1))
        left_ratio, right_ratio = self.width_ratios[right - 1], self.width_ratios[right]
        share = (width_ratio - left_ratio) / (right_ratio - left_ratio)
        return np.asarray(columns[right - 1] * (1.0 - share) + columns[right] * share)


@dataclass(frozen=True, eq=False)
class InterpolationStudy:
    """Errors of two ways to read So from a coarse table, and of ours.

    Attributes
    ----------
    span_degrees : int
        Angle of the bearing arc [deg].
    width_ratio : float
        B/D at which the table is read.
    column_width_ratios : ndarray
        B/D of the columns.
    sommerfeld_numbers : ndarray, shape (200,)
        So at which the round trip So, eps, So starts.
    round_trip_linear, round_trip_logarithmic, round_trip_spline : ndarray, shape (200,)
        Relative error of the round trip: of both old ways, and of
        `babbitt.kinds.journal.iso7902.characteristics.curves`.
    eccentricity_ratios : ndarray, shape (851,)
        eps at which the forward rules are compared.
    linear, logarithmic, reference : ndarray, shape (851,)
        So by both rules, and by our tables.
    """

    span_degrees: int
    width_ratio: float
    column_width_ratios: Array
    sommerfeld_numbers: Array
    round_trip_linear: Array
    round_trip_logarithmic: Array
    round_trip_spline: Array
    eccentricity_ratios: Array
    linear: Array
    logarithmic: Array
    reference: Array

    @property
    def forward_error_linear(self) -> Array:
        """Relative error of linear interpolation against our tables."""
        return self.linear / self.reference - 1.0

    @property
    def forward_error_logarithmic(self) -> Array:
        """Relative error of logarithmic interpolation against our tables."""
        return self.logarithmic / self.reference - 1.0

    @property
    def ratio(self) -> Array:
        """X, linear over logarithmic So."""
        return self.linear / self.logarithmic

    @property
    def largest_ratio(self) -> float:
        """Largest X."""
        return float(self.ratio.max())

    @property
    def eccentricity_ratio_of_largest_ratio(self) -> float:
        """eps at which X is largest."""
        return float(self.eccentricity_ratios[self.ratio.argmax()])


def coarse_tables(
    span_degrees: int = 360, column_width_ratios: tuple[float, ...] = WIDTH_RATIOS
) -> tuple[CoarseTable, CoarseTable]:
    """The coarse table of the study, read linearly and logarithmically; parameters as of `interpolation_study`."""
    rows, columns = np.array(ECCENTRICITY_RATIOS), np.array(column_width_ratios)
    values = np.stack([curves(span_degrees, x).sommerfeld_number(rows) for x in column_width_ratios], axis=1)
    return CoarseTable(rows, columns, values), CoarseTable(rows, columns, np.log(values))


def interpolation_study(
    span_degrees: int = 360, width_ratio: float = 0.604, column_width_ratios: tuple[float, ...] = WIDTH_RATIOS
) -> InterpolationStudy:
    """Repeat the published study with our own Sommerfeld numbers.

    Parameters
    ----------
    span_degrees : int, optional
        360, 180, 150, 120 or 90.
    width_ratio : float, optional
        B/D at which the coarse table is read; the study took 0.604.
    column_width_ratios : tuple of float, optional
        B/D of the columns of the coarse table, at least two.

    Returns
    -------
    InterpolationStudy

    Examples
    --------
    >>> study = interpolation_study()
    >>> [round(100 * float(abs(e).max()), 1) for e in (study.round_trip_linear, study.round_trip_logarithmic)]
    [11.7, 5.9]
    """
    linear, logarithmic = coarse_tables(span_degrees, column_width_ratios)
    rows = linear.eccentricity_ratios
    dense = curves(span_degrees, width_ratio)

    loads = np.geomspace(0.25, 1.8, 200)
    back_linear = linear.level(linear.eccentricity_ratio(loads, width_ratio), width_ratio)
    back_log = logarithmic.level(logarithmic.eccentricity_ratio(np.log(loads), width_ratio), width_ratio)
    eccentricities = np.linspace(rows[0], rows[-1], 851)
    return InterpolationStudy(
        span_degrees=span_degrees,
        width_ratio=width_ratio,
        column_width_ratios=linear.width_ratios,
        sommerfeld_numbers=loads,
        round_trip_linear=back_linear / loads - 1.0,
        round_trip_logarithmic=np.exp(back_log) / loads - 1.0,
        round_trip_spline=dense.sommerfeld_number(dense.eccentricity_ratio(loads)) / loads - 1.0,
        eccentricity_ratios=eccentricities,
        linear=linear.level(eccentricities, width_ratio),
        logarithmic=np.exp(logarithmic.level(eccentricities, width_ratio)),
        reference=dense.sommerfeld_number(eccentricities),
    )
