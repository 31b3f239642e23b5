"""Films of thrust pads: annular sectors."""
