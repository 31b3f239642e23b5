"""Heat given off by the housing: the emitting surface and the heat transfer coefficient.

The formulas are those in general use with ISO 7902 and DIN 31652; both standards call them estimates.
"""

from __future__ import annotations

import math

STILL_AIR_COEFFICIENT = 15.0
"""W/(m² K). The standards name 15 to 20 for a housing in still or little moved air; textbook value."""

MOVING_AIR_FROM = 1.2
"""Air speed in m/s above which the formula of moving air holds."""

MACHINE_SURFACE_FACTORS = (15.0, 20.0)
"""Emitting surface of a bearing inside a machine over B D; textbook values."""


def heat_transfer_coefficient(air_speed: float) -> float:
    """Heat transfer coefficient of a housing in moving air.

    ``k_A = 7 + 12 sqrt(w)``, in W/(m² K), for more than 1.2 m/s; below, the value of still air.

    Parameters
    ----------
    air_speed : float
        w in m/s.

    Examples
    --------
    >>> heat_transfer_coefficient(4.0), heat_transfer_coefficient(0.5)
    (31.0, 15.0)
    """
    return 7.0 + 12.0 * math.sqrt(air_speed) if air_speed > MOVING_AIR_FROM else STILL_AIR_COEFFICIENT


def cylindrical_housing_surface(housing_diameter: float, housing_width: float, diameter: float) -> float:
    """Surface in m² of a cylindrical housing: two faces and the mantle.

    ``A = (π/2)(D_H² - D²) + π D_H B_H``

    Parameters
    ----------
    housing_diameter, housing_width, diameter : float
        D_H, B_H and the bearing diameter D, in m.

    Examples
    --------
    A thin shell has the mantle only:

    >>> round(cylindrical_housing_surface(0.2, 0.1, 0.2) / math.pi, 12)
    0.02
    """
    faces = math.pi / 2.0 * (housing_diameter**2 - diameter**2)
    return faces + math.pi * housing_diameter * housing_width


def pedestal_surface(height: float, housing_width: float) -> float:
    """Surface in m² of a pedestal bearing.

    ``A = π H (B_H + H/2)``

    Parameters
    ----------
    height, housing_width : float
        H and B_H in m.

    Examples
    --------
    >>> round(pedestal_surface(1.0, 0.5) / math.pi, 12)
    1.0
    """
    return math.pi * height * (housing_width + height / 2.0)


def surface_in_machine(width: float, diameter: float, factor: float = MACHINE_SURFACE_FACTORS[0]) -> float:
    """Surface in m² that a bearing inside a machine gives heat through, ``A = (15 ... 20) B D``.

    The smaller factor is the safe one.

    Examples
    --------
    >>> round(surface_in_machine(0.1, 0.2), 12)
    0.3
    """
    return factor * width * diameter
