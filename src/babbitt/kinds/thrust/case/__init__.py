"""The case language of thrust bearings."""
