"""What a viscosity law is, and the laws with few constants: Vogel, Reynolds, power law, constant.

The double-logarithmic laws of ASTM D341 stand in `babbitt.properties.lubricants.walther`. Every law takes kelvin,
returns SI, says whether it gives kinematic or dynamic viscosity (`kind`) and where it holds (`temperature_range`).
Outside this range a law still answers, since an iteration may pass there; who reports the result warns.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import Any, ClassVar, Protocol

from babbitt.core.notices import InputError
from babbitt.core.units import ZERO_CELSIUS
from babbitt.properties.lubricants._evaluation import (
    Point,
    Value,
    evaluate,
    require_falling,
    require_finite,
    require_positive,
    require_range,
)

OIL_TEMPERATURE_RANGE = (253.15, 423.15)
"""−20 to 150 °C: between the pour point and the end of use of common mineral oils (assumption)."""


VOGEL_BELOW, VOGEL_ABOVE = 0.25, 0.5
"""How far Vogel's law through three points reaches beyond them, in spans of the points (assumption): there a point
that is wrong by 1 % is wrong by 8 and 6 %, and oils by Walther are met within 3 % above."""


class ViscosityKind(Enum):
    """Which viscosity a law gives."""

    KINEMATIC = "m2/s"
    DYNAMIC = "Pa s"


class ViscosityLaw(Protocol):
    """Viscosity over temperature."""

    @property
    def kind(self) -> ViscosityKind:
        """Whether the law gives kinematic (m²/s) or dynamic viscosity (Pa s)."""

    @property
    def temperature_range(self) -> tuple[float, float]:
        """Lowest and highest temperature in K for which the law is meant."""

    def __call__(self, temperature: Value) -> Value:
        """Viscosity in SI at a temperature in K; float or array of any shape."""


@dataclass(frozen=True)
class Vogel:
    r"""Vogel's law (Vogel-Fulcher-Tammann), the best with three constants over a wide range.

    .. math:: \eta = a \, \exp\frac{b}{T - c}

    Parameters
    ----------
    factor : float
        a in Pa s.
    activation : float
        b in K.
    pole : float
        c in K, where the viscosity would become infinite; about 178 K (−95 °C) for mineral oils.
    temperature_range : tuple of float
        Where the law holds, in K; interpolation between its points is its use (see `through`).

    Notes
    -----
    Source: H. Vogel, Physikalische Zeitschrift 22 (1921) 645.

    Examples
    --------
    >>> water = Vogel.through((280.0, 1433.7e-6), (320.0, 577.02e-6), (360.0, 326.10e-6))
    >>> round(water(300.0) * 1e6)
    858
    """

    factor: float
    activation: float
    pole: float
    temperature_range: tuple[float, float] = OIL_TEMPERATURE_RANGE
    kind: ClassVar[ViscosityKind] = ViscosityKind.DYNAMIC

    def __post_init__(self) -> None:
        require_positive("Vogel", factor=self.factor, activation=self.activation)
        require_finite("Vogel", pole=self.pole)
        require_range("Vogel", self.temperature_range)

    @classmethod
    def through(
        cls,
        coldest: Point,
        middle: Point,
        warmest: Point,
        *,
        temperature_range: tuple[float, float] | None = None,
    ) -> Vogel:
        """Lay the law through three points (K, Pa s), given in any order.

        It holds from a quarter of their span below them to half of it above, within the range of oils, unless
        `temperature_range` says otherwise.

        Raises
        ------
        InputError
            E003 for a number that is not positive; E006 when the viscosity does not fall, or when ln η over T
            is not convex enough for the law (an exponential law then fits as well).
        """
        points = sorted((coldest, middle, warmest))
        require_falling("Vogel", *points)
        (t1, eta1), (t2, eta2), (t3, eta3) = points
        # b (1/(T1-c) - 1/(T2-c)) = ln(eta1/eta2) and likewise for 2, 3; their ratio is linear in c.
        ratio = math.log(eta1 / eta2) * (t3 - t2) / (math.log(eta2 / eta3) * (t2 - t1))
        pole = (ratio * t1 - t3) / (ratio - 1.0) if ratio > 1.0 else math.inf
        if not pole < t1:
            raise InputError(
                "E006",
                "Vogel: between the three points ln(viscosity) must fall ever more slowly with temperature; the "
                f"ratio of the two mean slopes is {ratio:.4g}, it must be above 1. Use Exponential instead.",
            )
        activation = math.log(eta1 / eta2) * (t1 - pole) * (t2 - pole) / (t2 - t1)
        factor = eta1 * math.exp(-activation / (t1 - pole))
        return cls(factor, activation, pole, temperature_range or _around(t1, t3))

    def __call__(self, temperature: Value) -> Value:
        """Dynamic viscosity in Pa s at a temperature in K; float or array of any shape."""
        return evaluate(self._formula, temperature, above=max(self.pole, 0.0), law="the Vogel law")

    def _formula(self, m: Any, temperature: Any) -> Any:
        return self.factor * m.exp(self.activation / (temperature - self.pole))


def _around(coldest: float, warmest: float) -> tuple[float, float]:
    """Where Vogel's law through points from the coldest to the warmest holds, in K."""
    span, (lowest, highest) = warmest - coldest, OIL_TEMPERATURE_RANGE
    below, above = coldest - VOGEL_BELOW * span, warmest + VOGEL_ABOVE * span
    return min(coldest, max(below, lowest)), max(warmest, min(above, highest))


@dataclass(frozen=True)
class Exponential:
    r"""Reynolds' law, handy in closed-form theory and good over some 20 to 40 K only.

    .. math:: \eta = \eta_0 \, \exp(-\beta (T - T_0))

    Parameters
    ----------
    reference_viscosity : float
        η₀ in Pa s, or in m²/s when `kind` is kinematic.
    reference_temperature : float
        T₀ in K.
    temperature_coefficient : float
        β in 1/K.
    temperature_range : tuple of float
        Where the law holds, in K. No default: it is an interpolation between two temperatures.
    kind : ViscosityKind
        Which viscosity the law gives.

    Notes
    -----
    Source: O. Reynolds, Philosophical Transactions 177 (1886) 157.
    """

    reference_viscosity: float
    reference_temperature: float
    temperature_coefficient: float
    temperature_range: tuple[float, float]
    kind: ViscosityKind = ViscosityKind.DYNAMIC

    def __post_init__(self) -> None:
        require_positive(
            "Exponential",
            reference_viscosity=self.reference_viscosity,
            reference_temperature=self.reference_temperature,
            temperature_coefficient=self.temperature_coefficient,
        )
        require_range("Exponential", self.temperature_range)

    @classmethod
    def through(cls, colder: Point, warmer: Point, *, kind: ViscosityKind = ViscosityKind.DYNAMIC) -> Exponential:
        """Lay the law through two points (K, Pa s or m²/s), in any order; it holds between them.

        Raises
        ------
        InputError
            E003 for a number that is not positive, E006 when the viscosity does not fall with temperature.
        """
        points = sorted((colder, warmer))
        require_falling("Exponential", *points)
        (t1, value1), (t2, value2) = points
        return cls(value1, t1, math.log(value1 / value2) / (t2 - t1), (t1, t2), kind)

    def __call__(self, temperature: Value) -> Value:
        """Viscosity in SI at a temperature in K; float or array of any shape."""
        return evaluate(self._formula, temperature, above=0.0, law="the exponential law")

    def _formula(self, m: Any, temperature: Any) -> Any:
        exponent = -self.temperature_coefficient * (temperature - self.reference_temperature)
        return self.reference_viscosity * m.exp(exponent)


@dataclass(frozen=True)
class PowerLaw:
    r"""The power law of the Russian bearing literature.

    .. math:: \nu = \nu_{50} (50/t)^m \quad\text{or}\quad \eta = \eta_{50} (50/t)^m, \qquad [t] = {}^\circ C

    Parameters
    ----------
    viscosity_at_50 : float
        ν₅₀ in m²/s or η₅₀ in Pa s, the viscosity at 50 °C.
    exponent : float
        m, about 1.8 for oils of 12 mm²/s at 50 °C, 2.6 for 80 mm²/s (textbook values).
    kind : ViscosityKind
        Which viscosity the law gives.
    temperature_range : tuple of float
        Where the law holds, in K; 30 to 100 °C unless stated (assumption).

    Notes
    -----
    Textbook formula of Russian-language machine design; fitted from 30 to 100 °C.
    """

    viscosity_at_50: float
    exponent: float
    kind: ViscosityKind
    temperature_range: tuple[float, float] = (303.15, 373.15)

    def __post_init__(self) -> None:
        require_positive("PowerLaw", viscosity_at_50=self.viscosity_at_50, exponent=self.exponent)
        require_range("PowerLaw", self.temperature_range)

    @classmethod
    def through(cls, colder: Point, warmer: Point, *, kind: ViscosityKind) -> PowerLaw:
        """Lay the law through two points (K, SI) above 0 °C, in any order.

        Raises
        ------
        InputError
            E003 for a number that is not positive, E006 when the viscosity does not fall with temperature or a
            point does not lie above 0 °C.
        """
        points = sorted((colder, warmer))
        require_falling("PowerLaw", *points)
        (t1, value1), (t2, value2) = ((t - ZERO_CELSIUS, value) for t, value in points)
        if t1 <= 0.0:
            raise InputError("E006", f"PowerLaw: points must lie above 0 °C (273.15 K), given {points[0][0]:g} K.")
        exponent = math.log(value1 / value2) / math.log(t2 / t1)
        return cls(value1 * (t1 / 50.0) ** exponent, exponent, kind)

    def __call__(self, temperature: Value) -> Value:
        """Viscosity in SI at a temperature in K; float or array of any shape."""
        return evaluate(self._formula, temperature, above=ZERO_CELSIUS, law="the power law")

    def _formula(self, m: Any, temperature: Any) -> Any:
        return self.viscosity_at_50 * (50.0 / (temperature - ZERO_CELSIUS)) ** self.exponent


@dataclass(frozen=True)
class ConstantViscosity:
    """The same viscosity at every temperature, for isoviscous comparison.

    Parameters
    ----------
    viscosity : float
        In Pa s, or in m²/s when `kind` is kinematic.
    kind : ViscosityKind
        Which viscosity is given.
    temperature_range : tuple of float
        Everywhere, in K, unless stated.
    """

    viscosity: float
    kind: ViscosityKind = ViscosityKind.DYNAMIC
    temperature_range: tuple[float, float] = (0.0, math.inf)

    def __post_init__(self) -> None:
        require_positive("ConstantViscosity", viscosity=self.viscosity)
        require_range("ConstantViscosity", self.temperature_range)

    @classmethod
    def through(cls, point: Point, *, kind: ViscosityKind = ViscosityKind.DYNAMIC) -> ConstantViscosity:
        """Take the viscosity (SI) of one point; its temperature in K does not matter."""
        return cls(point[1], kind)

    def __call__(self, temperature: Value) -> Value:
        """Viscosity in SI, shaped like the temperature (K)."""
        return evaluate(self._formula, temperature, above=0.0, law="a constant viscosity")

    def _formula(self, m: Any, temperature: Any) -> Any:
        return self.viscosity + 0.0 * temperature
