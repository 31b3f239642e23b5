"""What all tests share, those in the docstrings included."""

import gc
import os

# Tests run side by side, a process on each core: threads of linear algebra would only wait for each other.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

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
