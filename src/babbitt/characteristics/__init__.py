"""Dimensionless characteristics of circular bearings: load, attitude, flow, friction."""
