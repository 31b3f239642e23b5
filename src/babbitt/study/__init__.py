"""Sweeps over operating points and tolerances."""
