"""Studies of journal bearings: locus, stability map, coefficients over speed, alternatives."""
