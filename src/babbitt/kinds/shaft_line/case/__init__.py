"""The case language of shaft lines."""
