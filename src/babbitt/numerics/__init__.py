"""Numerical methods that know nothing of bearings: roots, fixed points and equilibria with a status, splines."""
