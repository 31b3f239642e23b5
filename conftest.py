"""What all tests share, those in the docstrings included."""

from hypothesis import settings

# No test depends on the clock: a loaded machine is slow, not wrong.
settings.register_profile("babbitt", deadline=None)
settings.load_profile("babbitt")
