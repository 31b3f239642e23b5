"""A journal bearing by every method and option that applies, side by side."""
