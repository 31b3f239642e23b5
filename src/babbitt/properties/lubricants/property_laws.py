"""Laws for density, heat capacity and conductivity over temperature.

All three are near enough straight lines for liquids between 0 and 150 °C, so the same few laws serve them.
Every law takes kelvin and returns SI.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

from babbitt.properties.lubricants._evaluation import Value, evaluate, require_finite, require_positive


class PropertyLaw(Protocol):
    """A material property over temperature."""

    def __call__(self, temperature: Value) -> Value:
        """Value in SI at a temperature in K; float or array of any shape."""


@dataclass(frozen=True)
class ConstantProperty:
    """The same value at every temperature.

    Parameters
    ----------
    value : float
        In SI.
    """

    value: float

    def __post_init__(self) -> None:
        require_positive("ConstantProperty", value=self.value)

    def __call__(self, temperature: Value) -> Value:
        """Value in SI, shaped like the temperature (K)."""
        return evaluate(self._formula, temperature, above=0.0, law="a constant property")

    def _formula(self, m: Any, temperature: Any) -> Any:
        return self.value + 0.0 * temperature


@dataclass(frozen=True)
class LinearProperty:
    r"""A straight line through a known value.

    .. math:: y = y_\mathrm{ref} + s \, (T - T_\mathrm{ref})

    Parameters
    ----------
    reference_value : float
        Value at the reference temperature, in SI.
    reference_temperature : float
        In K.
    slope : float
        Change per kelvin, in SI.

    Examples
    --------
    Density of TP-46 turbine oil, 895 kg/m³ at 20 °C:

    >>> density = LinearProperty(895.0, 293.15, -0.63)
    >>> round(density(333.15), 1)
    869.8
    """

    reference_value: float
    reference_temperature: float
    slope: float

    def __post_init__(self) -> None:
        require_positive(
            "LinearProperty",
            reference_value=self.reference_value,
            reference_temperature=self.reference_temperature,
        )
        require_finite("LinearProperty", slope=self.slope)

    def __call__(self, temperature: Value) -> Value:
        """Value in SI at a temperature in K; float or array of any shape."""
        return evaluate(self._formula, temperature, above=0.0, law="a linear property law")

    def _formula(self, m: Any, temperature: Any) -> Any:
        return self.reference_value + self.slope * (temperature - self.reference_temperature)


@dataclass(frozen=True)
class ShiftedLaw:
    """A reference law plus a constant, so that it meets one known value.

    What is left to do when one value of an oil is known and the law of a similar oil: keep the temperature
    slope, correct the level.

    Parameters
    ----------
    reference : PropertyLaw
        The law of the similar fluid.
    offset : float
        Constant to add, in SI.

    Examples
    --------
    >>> similar = LinearProperty(901.0, 293.15, -0.63)
    >>> ShiftedLaw.through(similar, 293.15, 895.0).offset
    -6.0
    """

    reference: PropertyLaw
    offset: float

    def __post_init__(self) -> None:
        require_finite("ShiftedLaw", offset=self.offset)

    @classmethod
    def through(cls, reference: PropertyLaw, temperature: float, value: float) -> ShiftedLaw:
        """Shift `reference` so that it gives `value` (SI) at `temperature` (K)."""
        require_positive("ShiftedLaw", temperature=temperature, value=value)
        if isinstance(reference, ShiftedLaw):  # one step instead of a chain keeps evaluation fast
            reference = reference.reference
        return cls(reference, value - reference(temperature))

    def __call__(self, temperature: Value) -> Value:
        """Value in SI at a temperature in K; float or array of any shape."""
        return self.reference(temperature) + self.offset
