"""Studies of footsteps."""
