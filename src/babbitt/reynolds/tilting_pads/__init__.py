"""Journal bearings of tilting pads: pads and pivots, tilts and position, full and condensed coefficients."""
