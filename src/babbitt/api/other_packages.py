"""Cases of kinds of other packages as objects of the Python front door."""

from __future__ import annotations

from functools import cache
from types import new_class
from typing import Any

from babbitt.api.case import Case
from babbitt.case.case_file import CaseFile

__all__ = ["class_of"]


class OfAnotherPackage(Case):
    """A case of a kind of another package, whose class is made from its case model when a case is read."""

    def __reduce__(self) -> tuple[Any, ...]:
        """A class that was made is found anew by its case model."""
        return _restored, (self.model, self.default_name, self.__getstate__())


@cache
def class_of(model: type[CaseFile], default_name: str) -> type[Case]:
    """The class of a case model of another package, named like it without ``Case``."""
    name = model.__name__.removesuffix("Case") or model.__name__
    said = {"__doc__": model.__doc__, "__module__": model.__module__, "model": model, "default_name": default_name}
    made: type[Case] = new_class(name, (OfAnotherPackage, model), exec_body=lambda space: space.update(said))
    return made


def _restored(model: type[CaseFile], default_name: str, state: dict[Any, Any]) -> Case:
    """A case that was pickled."""
    made = class_of(model, default_name)
    case = made.__new__(made)
    case.__setstate__(state)
    return case
