"""Figures, tables and calculation of shafts."""
