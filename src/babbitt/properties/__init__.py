"""Lubricants, materials and fits."""
