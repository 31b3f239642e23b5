"""The published cases, one file each."""
