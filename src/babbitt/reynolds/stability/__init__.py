"""Stability of a rotor in its film, and coefficients held against the slope of the load."""
