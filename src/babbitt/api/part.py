"""Parts of a bearing as a program makes them: checked at once, and true to what they were given."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Self

from pydantic import PrivateAttr

from babbitt.api.given import as_given, content_of
from babbitt.api.reading import read_part
from babbitt.api.shown import shown_call
from babbitt.case.aliases import in_todays_words
from babbitt.case.part import Part
from babbitt.case.with_units import with_units

__all__ = ["OwnPart"]


class OwnPart(Part):
    """A part that a program makes; a dict of the same fields does as well in its place."""

    _given: dict[str, Any] = PrivateAttr(default_factory=dict)

    if not TYPE_CHECKING:

        def __init__(self, **given: Any) -> None:
            cls = type(self)
            words = {**_only_kind(cls), **as_given(given, cls.__name__)}
            part = read_part(cls._language_part(), words, cls.__name__)
            for slot in ("__dict__", "__pydantic_fields_set__", "__pydantic_extra__"):
                object.__setattr__(self, slot, getattr(part, slot))
            private = {
                **(part.__pydantic_private__ or {}),
                "_given": with_units(in_todays_words(cls, words), part),
            }
            object.__setattr__(self, "__pydantic_private__", private)

        __init__.__pydantic_base_init__ = True

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """Give a copy with other values, checked where it is used."""
        copied = super().model_copy(update=update, deep=deep)
        if update:
            plain = self._language_part().model_construct(copied.model_fields_set, **vars(copied))
            copied._given = with_units(content_of(plain), copied)
        return copied

    @property
    def given(self) -> dict[str, Any]:
        """What it was given, in the words of a case file; numbers with their units."""
        return copy.deepcopy(self._given)

    @classmethod
    def _language_part(cls) -> type[Part]:
        """The part of the case language that it is."""
        return next(base for base in cls.__mro__ if not issubclass(base, OwnPart) and issubclass(base, Part))

    def __repr__(self) -> str:
        hidden = _only_kind(type(self))
        return shown_call(type(self).__name__, {k: v for k, v in self._given.items() if hidden.get(k) != v})

    __str__ = __repr__


def _only_kind(cls: type[Part]) -> dict[str, Any]:
    """The `kind` of a part that has one kind, which need not be given in Python."""
    field = cls.model_fields.get("kind")
    known: tuple[Any, ...] = getattr(field.annotation, "__args__", ()) if field is not None else ()
    return {"kind": known[0]} if len(known) == 1 else {}
