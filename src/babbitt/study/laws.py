"""How the values of a field are distributed: each law by its quantiles, with the least and the largest value."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator
from scipy.special import ndtr, ndtri

__all__ = [
    "Choices",
    "Difference",
    "HalfNormal",
    "Law",
    "Listed",
    "Normal",
    "Triangular",
    "Uniform",
]

Array = NDArray[np.float64]

CUT = 3.0
"""Standard deviations to each side at which a normal law ends, unless another number is given."""


class Law(Protocol):
    """A distribution of one number."""

    @property
    def support(self) -> tuple[float, float]:
        """Smallest and largest value, both possible."""

    @property
    def words(self) -> str:
        """Its name."""

    def quantiles(self, share: Array) -> Array:
        """The values below which the shares of all lie, for shares in [0, 1]; shape (n,)."""


@dataclass(frozen=True)
class Uniform:
    """All values between two equally likely."""

    least: float
    most: float
    words: str = "uniform"

    @property
    def support(self) -> tuple[float, float]:
        """Smallest and largest value."""
        return self.least, self.most

    def quantiles(self, share: Array) -> Array:
        """Values at shares of the distribution, shape (n,)."""
        return self.least + (self.most - self.least) * share


@dataclass(frozen=True)
class Normal:
    """The normal law, cut off at so many standard deviations to each side and scaled to one again.

    >>> law = Normal(10.0, 2.0)
    >>> law.support, float(law.quantiles(np.array([0.5]))[0])
    ((4.0, 16.0), 10.0)
    """

    mean: float
    deviation: float
    cut: float = CUT

    @property
    def words(self) -> str:
        """Its name."""
        return f"normal, truncated at ±{self.cut:g}σ"

    @property
    def support(self) -> tuple[float, float]:
        """Smallest and largest value."""
        return self.mean - self.cut * self.deviation, self.mean + self.cut * self.deviation

    def quantiles(self, share: Array) -> Array:
        """Values at shares of the distribution, shape (n,)."""
        outside = ndtr(-self.cut)
        found: Array = self.mean + self.deviation * ndtri(outside + share * (1.0 - 2.0 * outside))
        return np.asarray(np.clip(found, *self.support))

    def density(self, value: Array) -> Array:
        """Density at values within the support, 1/unit."""
        reduced = (value - self.mean) / self.deviation
        mass = 1.0 - 2.0 * ndtr(-self.cut)
        return np.asarray(np.exp(-0.5 * reduced**2) / (math.sqrt(2.0 * math.pi) * self.deviation * mass))

    def share_below(self, value: Array) -> Array:
        """Share of the distribution below values, shape of the values."""
        outside = ndtr(-self.cut)
        found = (ndtr((value - self.mean) / self.deviation) - outside) / (1.0 - 2.0 * outside)
        return np.asarray(np.clip(found, 0.0, 1.0))


@dataclass(frozen=True)
class HalfNormal:
    """The magnitude of a normal law about zero, cut off at so many standard deviations."""

    deviation: float
    cut: float = CUT

    @property
    def words(self) -> str:
        """Its name."""
        return f"half-normal, truncated at {self.cut:g}σ"

    @property
    def support(self) -> tuple[float, float]:
        """Smallest and largest value."""
        return 0.0, self.cut * self.deviation

    def quantiles(self, share: Array) -> Array:
        """Values at shares of the distribution, shape (n,)."""
        inside = 1.0 - 2.0 * ndtr(-self.cut)
        return np.asarray(np.clip(self.deviation * ndtri(0.5 * (1.0 + share * inside)), *self.support))


@dataclass(frozen=True)
class Triangular:
    """Density rising from the smallest to the most likely value and falling to the largest."""

    least: float
    likely: float
    most: float
    words: str = "triangular"

    @property
    def support(self) -> tuple[float, float]:
        """Smallest and largest value."""
        return self.least, self.most

    def quantiles(self, share: Array) -> Array:
        """Values at shares of the distribution, shape (n,)."""
        width = self.most - self.least
        rising = self.least + np.sqrt(share * width * (self.likely - self.least))
        falling = self.most - np.sqrt((1.0 - share) * width * (self.most - self.likely))
        return np.where(share * width <= self.likely - self.least, rising, falling)


@dataclass(frozen=True)
class Difference:
    """A size of one zone less one of another: the clearance of bore and journal, which are independent.

    Attributes
    ----------
    larger, smaller : Normal or Uniform
        How the sizes of bore and journal lie in their zones.
    words : str
    """

    larger: Normal | Uniform
    smaller: Normal | Uniform
    words: str = "difference of two sizes"

    @property
    def support(self) -> tuple[float, float]:
        """Smallest and largest value."""
        (low, high), (least, most) = self.larger.support, self.smaller.support
        return low - most, high - least

    def quantiles(self, share: Array) -> Array:
        """Values at shares of the distribution, shape (n,)."""
        found: Array = self._inverse(share)
        return np.clip(found, *self.support)

    @cached_property
    def _inverse(self) -> PchipInterpolator:
        """Value over share: the convolution of both laws by Gauss-Legendre quadrature over quantiles of the one.

        F(c) is the mean over all bores b of the share of journals above b - c.
        """
        knots, weights = np.polynomial.legendre.leggauss(POINTS)
        bores = self.larger.quantiles(0.5 * (1.0 + knots))
        low, high = self.support
        # Denser towards both ends, where the share rises slowly.
        values = low + (high - low) * 0.5 * (1.0 - np.cos(np.linspace(0.0, math.pi, TABLE)))
        above = 1.0 - _share_below(self.smaller, bores[None, :] - values[:, None])
        shares = above @ (0.5 * weights)
        shares[0], shares[-1] = 0.0, 1.0
        rises = np.concatenate(([True], np.diff(np.maximum.accumulate(shares)) > 0.0))
        table = values[rises]
        table[-1] = high
        return PchipInterpolator(shares[rises], table)


POINTS, TABLE = 200, 1001
"""Points of the quadrature over one zone, and entries of the table of quantiles."""


def _share_below(law: Normal | Uniform, value: Array) -> Array:
    if isinstance(law, Normal):
        return law.share_below(value)
    return np.clip((value - law.least) / (law.most - law.least), 0.0, 1.0)


@dataclass(frozen=True)
class Listed:
    """Numbers, all equally likely, in the order given."""

    values: tuple[float, ...]
    words: str = "values"

    @property
    def support(self) -> tuple[float, float]:
        """Smallest and largest value."""
        return min(self.values), max(self.values)

    def quantiles(self, share: Array) -> Array:
        """Values at shares of the list, shape (n,)."""
        return np.array(self.values)[_places(share, len(self.values))]


@dataclass(frozen=True)
class Choices:
    """Words, all equally likely."""

    values: tuple[str, ...]
    words: str = "choices"

    def chosen(self, share: Array) -> NDArray[np.object_]:
        """Words at shares of the list, shape (n,)."""
        return np.array(self.values, object)[_places(share, len(self.values))]


def _places(share: Array, count: int) -> NDArray[np.intp]:
    return np.minimum((share * count).astype(np.intp), count - 1)
