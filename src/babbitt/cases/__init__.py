"""The case language: what an engineer writes."""
