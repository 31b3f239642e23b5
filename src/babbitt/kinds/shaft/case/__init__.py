"""The case language of shafts."""
