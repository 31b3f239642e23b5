"""Bearing kinds, one folder each: case language, calculation, report."""
