"""The case language of footsteps."""
