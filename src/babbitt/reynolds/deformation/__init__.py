"""Bores that give way to pressure or grow by heat."""
