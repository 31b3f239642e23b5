"""Run the command line with ``python -m babbitt``."""

from babbitt.cli import main

main()
