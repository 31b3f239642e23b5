"""Films that differ across the width: pockets, holes, misalignment, closed rings."""
