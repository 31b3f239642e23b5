"""The case language of tilting-pad journal bearings."""
