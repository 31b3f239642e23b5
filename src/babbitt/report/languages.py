"""Which kinds of bearings a report knows in which language."""

from __future__ import annotations

from collections.abc import Iterable
from importlib.resources import files
from typing import TYPE_CHECKING

from babbitt.core.kind import Kind, find_kind, kinds
from babbitt.core.language import ENGLISH, LANGUAGES, language, read_words
from babbitt.core.nearest_name import unknown_name
from babbitt.core.notices import InputError

if TYPE_CHECKING:
    from babbitt.case.parts.title_block import TitleBlock

__all__ = ["chosen_language", "knows", "require_words"]


def knows(language_code: str, kind: Kind) -> bool:
    """Whether a language has the words of a kind.

    >>> from babbitt.core.kind import kinds
    >>> knows("de", kinds()["journal"]), knows("en", kinds()["thrust"])
    (True, True)
    """
    package = kind.words or ".".join(kind.model.partition(":")[0].split(".")[:3])
    return language_code == ENGLISH or bool(read_words(files(package), language_code))


def chosen_language(block: TitleBlock | None, wanted: Iterable[str], asked: str | None = None) -> str:
    """The language to write in: the one asked for, else that of the title block of a case, else that which is
    written now: English where none was chosen.

    Raises
    ------
    InputError
        E005 for one that is not known, or that lacks the words of one of the kinds that are wanted.
    """
    own = None if block is None else block.language
    chosen = asked or own or language()
    require_words(wanted, chosen)
    return chosen


def require_words(wanted: Iterable[str], language_code: str) -> None:
    """Refuse a language that is not known, or that lacks the words of some kinds.

    Parameters
    ----------
    wanted : iterable of str
        Names of kinds; what is no kind is passed over.
    language_code : str

    Raises
    ------
    InputError
        E005, with the kinds for which the language has words.
    """
    if language_code not in LANGUAGES:
        raise InputError("E005", unknown_name(language_code, LANGUAGES, "a language of reports"))
    for name in dict.fromkeys(wanted):
        kind = find_kind(name)
        if kind is not None and not knows(language_code, kind):
            there = ", ".join(one for one, known in kinds().items() if knows(language_code, known))
            raise InputError(
                "E005",
                f"reports of kind {name} have no words in {LANGUAGES[language_code]} yet; those of {there} have. "
                f"Try: language {ENGLISH}",
            )
