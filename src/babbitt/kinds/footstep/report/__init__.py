"""What the report holds of footsteps."""
