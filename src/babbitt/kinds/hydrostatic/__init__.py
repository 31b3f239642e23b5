"""Recessed hydrostatic and hybrid bearings: pads, thrust rings, journal bearings, jacking pockets."""
