"""What every method of a design check shares: conditions, heat balance, limits, verdicts, warnings."""
