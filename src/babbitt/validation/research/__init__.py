"""Research tools that only published cases use."""
