"""Turbulent flow and viscosity under pressure."""
