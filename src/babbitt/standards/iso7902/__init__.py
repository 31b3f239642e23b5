"""ISO 7902: steady-state hydrodynamic plain journal bearings, circular cylindrical."""
