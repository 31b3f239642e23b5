"""What all tests share, those in the docstrings included."""

import gc

import pytest
from hypothesis import settings

# No test depends on the clock: a loaded machine is slow, not wrong.
settings.register_profile("babbitt", deadline=None)
settings.load_profile("babbitt")


@pytest.hookimpl(trylast=True)
def pytest_collection_finish() -> None:
    """Take the many thousand tests out of what Python's garbage collector looks through again and again."""
    gc.collect()
    gc.freeze()
