"""The toy kind is registered for a test, and with all that the test registers forgotten after it."""

import plane_slider
import pytest

from babbitt.core import kind as registry
from babbitt.core import language
from babbitt.core.notices import words
from babbitt.core.quantities import QUANTITIES

__all__ = ["TABLES", "forget_words", "registered", "unregistered"]

TABLES = (registry._REGISTERED, QUANTITIES)


def forget_words():
    language._OTHERS.clear()
    language.read_again()
    words.words.cache_clear()


@pytest.fixture(autouse=True)
def registered():
    registry.kinds()
    before = [set(table) for table in TABLES]
    registry.register(plane_slider.KIND)
    yield
    for table, names in zip(TABLES, before, strict=True):
        for name in set(table) - names:
            del table[name]
    forget_words()


@pytest.fixture
def unregistered():
    """The toy kind as a package that is not installed; what of it is changed is another kind then."""
    del registry._REGISTERED["plane_slider"]
    del QUANTITIES["film_ratio"]
    forget_words()
