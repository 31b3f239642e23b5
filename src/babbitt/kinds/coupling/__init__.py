"""Statics of the shaft: what its bearings have to carry."""

from babbitt.kinds.coupling.statics import BearingLoads, MeshForce, OverhungCoupling, bearing_loads

__all__ = ["BearingLoads", "MeshForce", "OverhungCoupling", "bearing_loads"]
