"""Bearing metals with their limits; shaft and housing materials."""
