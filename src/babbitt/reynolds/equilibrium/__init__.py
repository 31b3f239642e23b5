"""The doors of the film engine: the place where a film carries its load, and the film at a place."""
