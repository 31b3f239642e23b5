"""The effective temperature of pads that take in what their like send off, mixed with fresh oil.

Of the oil that leaves a pad over its trailing edge the share ``carry_over`` enters the next pad, mixed with fresh
oil of the supply to what the leading edge draws in:

    Q_in T_in = lambda Q_t T_t + (Q_in - lambda Q_t) T_s,    T_t = T_in + dT,
    P = rho c dT (Q_t + Q_s / 2),    T_eff = T_in + dT / 2,

with the side flow Q_s leaving at the mean temperature of the pad; all heat goes with the oil. These are the
balances of M. K. Ghosh, B. C. Majumdar and M. Sarangi, Fundamentals of Fluid Film Lubrication (2014), and of
C. M. Ettles (1969) for the groove. They close the energy of the bearing: P = rho c (Q_in - lambda Q_t)(T_drain -
T_s).
"""

from __future__ import annotations

from dataclasses import dataclass

from babbitt.properties.lubricants import Lubricant

__all__ = ["HeatBalance", "PadTemperatures", "Temperatures", "mixed_temperatures", "pad_temperatures"]


@dataclass(frozen=True)
class PadTemperatures:
    """Temperatures of a pad whose film has one, by its own heat balance, K.

    Attributes
    ----------
    inlet : float
        T_in of the mixture that the pad takes in.
    rise : float
        dT of the oil along the pad.
    """

    inlet: float
    rise: float

    @property
    def trailing(self) -> float:
        """T_t = T_in + dT."""
        return self.inlet + self.rise

    @property
    def effective(self) -> float:
        """T_eff = T_in + dT/2, also of the oil that leaves at the sides."""
        return self.inlet + 0.5 * self.rise


@dataclass(frozen=True)
class HeatBalance:
    """Oil and how it is mixed.

    Attributes
    ----------
    lubricant : Lubricant
    supply_temperature : float
        T_s, K.
    carry_over : float
        lambda, from 0 to 1.
    """

    lubricant: Lubricant
    supply_temperature: float
    carry_over: float


@dataclass(frozen=True)
class Temperatures:
    """Temperatures of the pads, K, and the flow of fresh oil, m3/s.

    ``inlet`` T_in of the pads, ``trailing`` T_t, ``drain`` of all oil that leaves the bearing, ``error`` of the
    energy over the friction power.
    """

    supply: float
    inlet: float
    trailing: float
    effective: float
    drain: float
    fresh_flow: float
    error: float


def pad_temperatures(
    balance: HeatBalance, capacity: float, power: float, trailing: float, side: float, inlet: float | None = None
) -> PadTemperatures:
    """Temperatures of pads that make heat (W) and let oil go over trailing edge and sides (m3/s).

    ``inlet`` is that of the oil taken in, K; None: of a mixture of fresh oil and of what their like send off.
    ``capacity`` is rho c, J/(m3 K).
    """
    rise = power / (capacity * (trailing + 0.5 * side))
    if inlet is None:
        carried = balance.carry_over * trailing
        inlet = balance.supply_temperature + carried * rise / (trailing + side - carried)
    return PadTemperatures(inlet, rise)


def mixed_temperatures(
    balance: HeatBalance, power: float, trailing: float, side: float, effective: float
) -> Temperatures:
    """Temperatures of pads that all are alike, at an effective temperature (K).

    Parameters
    ----------
    balance : HeatBalance
    power : float
        Friction power of all pads, W.
    trailing, side : float
        Flow over all trailing edges and over all sides, m3/s.
    effective : float
        K, at which the heat capacity of the oil is taken.
    """
    heat = float(balance.lubricant.volumetric_heat_capacity(effective))
    carried = balance.carry_over * trailing
    entering = trailing + side
    supply = balance.supply_temperature
    pad = pad_temperatures(balance, heat, power, trailing, side)
    inlet, rise = pad.inlet, pad.rise
    fresh = entering - carried
    drained = side * (inlet + 0.5 * rise) + (trailing - carried) * (inlet + rise)
    drain = drained / (side + trailing - carried)
    error = heat * fresh * (drain - supply) / power - 1.0
    return Temperatures(supply, inlet, inlet + rise, inlet + 0.5 * rise, drain, fresh, error)
