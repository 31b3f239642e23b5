"""The double-logarithmic viscosity laws of Ubbelohde-Walther and ASTM D341."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar

from babbitt.core.notices import InputError
from babbitt.numerics.scalar_or_array import functions_for
from babbitt.properties.lubricants._evaluation import (
    Point,
    Value,
    evaluate,
    require_falling,
    require_finite,
    require_positive,
    require_range,
)
from babbitt.properties.lubricants.viscosity_laws import OIL_TEMPERATURE_RANGE, ViscosityKind

_MM2_PER_S = 1e-6


@dataclass(frozen=True)
class Walther:
    r"""Walther's law, the short form of ASTM D341.

    .. math:: \lg\lg(\nu + a) = A - B \lg T, \qquad [\nu] = \mathrm{mm^2/s}, \; [T] = \mathrm{K}

    Parameters
    ----------
    intercept, slope : float
        A and B for ν in mm²/s and T in K.
    additive : float
        The constant a in mm²/s. ASTM D341 uses 0.7 (valid from 2 to 2·10⁷ mm²/s), the DIN 51563 form and many
        textbooks 0.8, Walther's older form and parts of the Russian literature 0.6. Two points fix the law
        with either; between 40 and 100 °C the two then differ by 0.4 % at most, below 2 mm²/s by much more.
    temperature_range : tuple of float
        Where the law holds, in K. The standard says: between cloud point and initial boiling point.

    Notes
    -----
    Source: ASTM D341, "Viscosity-Temperature Equations and Charts for Liquid Petroleum or Hydrocarbon
    Products", equation (1) without the terms C to H; C. Walther, Erdöl und Teer 7 (1931).

    Examples
    --------
    >>> oil = Walther.through((313.15, 63.5e-6), (373.15, 8.0e-6))
    >>> round(oil(323.15) * 1e6, 2)
    39.8
    """

    intercept: float
    slope: float
    additive: float = 0.7
    temperature_range: tuple[float, float] = OIL_TEMPERATURE_RANGE
    kind: ClassVar[ViscosityKind] = ViscosityKind.KINEMATIC

    def __post_init__(self) -> None:
        require_finite("Walther", intercept=self.intercept)
        require_positive("Walther", slope=self.slope)
        if not 0.0 <= self.additive <= 1.0:
            raise InputError("E003", f"Walther: additive must lie in 0 to 1 mm2/s, given {self.additive!r}.")
        require_range("Walther", self.temperature_range)

    @classmethod
    def through(
        cls,
        colder: Point,
        warmer: Point,
        *,
        additive: float = 0.7,
        temperature_range: tuple[float, float] = OIL_TEMPERATURE_RANGE,
    ) -> Walther:
        """Lay the law through two points.

        Parameters
        ----------
        colder, warmer : tuple of float
            Temperature in K and kinematic viscosity in m²/s, usually at 40 and 100 °C; in any order.
        additive, temperature_range
            As of the class.

        Raises
        ------
        InputError
            E003 for a number that is not positive, E006 when the viscosity does not fall with temperature or
            ν + a is not above 1 mm²/s, where the double logarithm ends.
        """
        points = sorted((colder, warmer))
        require_falling("Walther", *points)
        intercept, slope = _line_through(
            *((temperature, nu / _MM2_PER_S + additive) for temperature, nu in points)
        )
        return cls(intercept, slope, additive, temperature_range)

    def __call__(self, temperature: Value) -> Value:
        """Kinematic viscosity in m²/s at a temperature in K; float or array of any shape."""
        return evaluate(self._formula, temperature, above=0.0, law="the Walther law")

    def _formula(self, m: Any, temperature: Any) -> Any:
        z = 10.0 ** (10.0 ** (self.intercept - self.slope * m.log10(temperature)))
        return (z - self.additive) * _MM2_PER_S


@dataclass(frozen=True)
class AstmD341:
    r"""The full law of ASTM D341, for thin oils below 2 mm²/s too.

    .. math:: \lg\lg Z = A - B \lg T, \qquad Z = \nu + 0.7 + \exp(-1.47 - 1.84\,\nu - 0.51\,\nu^2)

    Parameters
    ----------
    intercept, slope : float
        A and B for ν in mm²/s and T in K.
    temperature_range : tuple of float
        Where the law holds, in K.

    Notes
    -----
    Valid from 0.21 to 2·10⁷ mm²/s. Source: ASTM D341-03 and later, equations (2) and (3). The exponential
    stands for the six terms C to H of the older editions. The standard's equation (3) is an approximate
    inverse of (2); here it is only the first guess of a Newton iteration, so that the law passes through its
    points to round-off.

    Examples
    --------
    >>> thin = AstmD341.through((313.15, 2.4e-6), (373.15, 1.0e-6))
    >>> round(thin(373.15) * 1e6, 9)
    1.0
    """

    intercept: float
    slope: float
    temperature_range: tuple[float, float] = OIL_TEMPERATURE_RANGE
    kind: ClassVar[ViscosityKind] = ViscosityKind.KINEMATIC

    def __post_init__(self) -> None:
        require_finite("AstmD341", intercept=self.intercept)
        require_positive("AstmD341", slope=self.slope)
        require_range("AstmD341", self.temperature_range)

    @classmethod
    def through(
        cls,
        colder: Point,
        warmer: Point,
        *,
        temperature_range: tuple[float, float] = OIL_TEMPERATURE_RANGE,
    ) -> AstmD341:
        """Lay the law through two points (K, m²/s); parameters and errors as of `Walther.through`."""
        points = sorted((colder, warmer))
        require_falling("AstmD341", *points)
        intercept, slope = _line_through(*((temperature, _z(nu / _MM2_PER_S)) for temperature, nu in points))
        return cls(intercept, slope, temperature_range)

    def __call__(self, temperature: Value) -> Value:
        """Kinematic viscosity in m²/s at a temperature in K; float or array of any shape."""
        return evaluate(self._formula, temperature, above=0.0, law="the ASTM D341 law")

    def _formula(self, m: Any, temperature: Any) -> Any:
        z = 10.0 ** (10.0 ** (self.intercept - self.slope * m.log10(temperature)))
        w = z - 0.7
        nu = w - m.exp(-0.7487 + w * (-3.295 + w * (0.6119 - w * 0.3193)))
        # Equation (3) is good to 0.0002 mm²/s; two Newton steps on equation (2) bring it to round-off.
        for _ in range(2):
            correction = m.exp(-1.47 - nu * (1.84 + 0.51 * nu))
            nu = nu - (nu + correction - w) / (1.0 - (1.84 + 1.02 * nu) * correction)
        return nu * _MM2_PER_S


def _z(nu: float) -> float:
    """Z of ASTM D341 equation (2), `nu` in mm²/s."""
    return nu + 0.7 + math.exp(-1.47 - nu * (1.84 + 0.51 * nu))


def _line_through(colder: Point, warmer: Point) -> Point:
    """Intercept A and slope B of lg lg Z = A - B lg T through two pairs (T, Z)."""
    (t1, z1), (t2, z2) = colder, warmer
    if z2 <= 1.0:
        raise InputError(
            "E006",
            f"the double-logarithmic law ends where viscosity plus additive is 1 mm2/s, given {z2:.4g} mm2/s at "
            f"{t2:g} K. Viscosities are in m2/s: 46 mm2/s is 46e-6. Use AstmD341 or Vogel for thin fluids.",
        )
    y1, y2 = (functions_for(z).log10(functions_for(z).log10(z)) for z in (z1, z2))
    slope = (y1 - y2) / math.log10(t2 / t1)
    return y1 + slope * math.log10(t1), slope
