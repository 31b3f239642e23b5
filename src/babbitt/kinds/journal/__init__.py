"""Journal bearings: case language, methods, report."""
