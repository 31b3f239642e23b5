"""Kinds name their parts as text: what is named is there."""

from importlib.resources import files

import pytest

from babbitt.case.case_file import CaseFile
from babbitt.core.kind import Kind, LazyFunction, imported, kinds
from babbitt.core.notices import InputError
from babbitt.core.quantities import Quantity
from babbitt.report.view import View

KINDS = list(kinds().values())


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_everything_that_a_kind_names_is_there(kind: Kind) -> None:
    assert issubclass(kind.load_model(), CaseFile)
    package, _, name = kind.template.partition(":")
    assert files(package).joinpath(name).is_file()
    assert kind.views
    views = [imported(view) for view in kind.views.values()]
    assert all(isinstance(view, View) for view in views)
    lazy = [part for view in views for part in vars(view).values() if isinstance(part, LazyFunction)]
    assert all(callable(imported(function.place)) for function in lazy)
    for path in (kind.vocabulary, kind.quantities):
        assert not path or all(isinstance(one, Quantity) for one in imported(path))
    assert not kind.comparison or callable(imported(kind.comparison))
    assert all(isinstance(name, str) for name in kind.load_meanings())


def test_a_part_that_is_not_there_is_noticed() -> None:
    with pytest.raises(InputError, match=r"'a' has a mistake: babbitt.kinds.journal:Missing: AttributeError"):
        Kind("a", "b", model="babbitt.kinds.journal:Missing", template="c").load_model()
