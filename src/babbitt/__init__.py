"""Babbitt computes and designs fluid-film (plain) bearings."""

__version__ = "0.1.0"
