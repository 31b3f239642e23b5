"""What the report holds of tilting-pad journal bearings."""
