"""Clearance from bore and journal: ISO 286 tolerance classes and explicit deviations."""
