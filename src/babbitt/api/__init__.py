"""The Python front door: bearings as objects, results with arrays."""
