"""Design procedures of the standards."""
