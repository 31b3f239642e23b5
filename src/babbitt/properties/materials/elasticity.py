"""Elastic constants of bearing metals, by their families."""

from __future__ import annotations

from babbitt.properties.materials.bearing_metal import AlloyFamily

__all__ = ["assumed_elasticity"]

_COPPER, _ALUMINIUM = (95e9, 0.34), (70e9, 0.33)

_ELASTICITY = {
    AlloyFamily.TIN: (50e9, 0.35),
    AlloyFamily.LEAD: (30e9, 0.38),
    AlloyFamily.COPPER_LEAD: _COPPER,
    AlloyFamily.COPPER_TIN: _COPPER,
    AlloyFamily.COPPER_ALUMINIUM: (115e9, 0.33),
    AlloyFamily.COPPER_ZINC: (105e9, 0.34),
    AlloyFamily.ALUMINIUM_TIN: _ALUMINIUM,
    AlloyFamily.ALUMINIUM_ZINC: _ALUMINIUM,
    AlloyFamily.ALUMINIUM_SILICON: _ALUMINIUM,
}
"""Young's modulus in Pa and Poisson's ratio. Assumptions: rounded numbers for the whole family, copper-tin as that
of the catalogue's cast bronzes."""


def assumed_elasticity(family: AlloyFamily) -> tuple[float, float] | None:
    """Young's modulus in Pa and Poisson's ratio of a family, None where nothing is known.

    >>> assumed_elasticity(AlloyFamily.TIN)
    (50000000000.0, 0.35)
    """
    return _ELASTICITY.get(family)
