"""Files: read with bounds, written whole, and never over anything that Babbitt did not write itself."""
