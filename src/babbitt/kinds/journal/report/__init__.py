"""What the report holds of journal bearings."""
