"""Statics of the shaft: what its bearings have to carry."""

from babbitt.shafts.overhung_coupling import BearingLoads, MeshForce, OverhungCoupling, bearing_loads

__all__ = ["BearingLoads", "MeshForce", "OverhungCoupling", "bearing_loads"]
