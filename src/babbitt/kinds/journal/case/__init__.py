"""The case language of journal bearings."""
