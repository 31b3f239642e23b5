"""What the report holds of shaft lines."""
