"""Numerical methods that know nothing of bearings: roots with a status, splines."""
