"""Parts of case files that two kinds or more write."""
