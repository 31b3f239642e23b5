"""The case language of overhung couplings."""
