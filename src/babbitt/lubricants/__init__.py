"""Lubricants: viscosity laws, viscosity index, thermal properties and the catalogue."""
