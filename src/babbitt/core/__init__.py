"""What every other package stands on: units, quantities, notices, results, files."""
