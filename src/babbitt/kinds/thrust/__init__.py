"""Thrust bearings: pads that tilt on pivots or stand fixed, and how they share a load."""
