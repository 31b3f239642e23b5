"""What comes out: tables, figures, PDF and HTML."""
