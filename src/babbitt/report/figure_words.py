"""The words and numbers of a finished figure in the language of the report."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING

from matplotlib.text import Text
from matplotlib.ticker import Formatter

from babbitt.core.language import decimal, translated_if_known

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["translate_figure"]


def translate_figure(figure: Figure, own_words: Collection[str] = ()) -> None:
    """Translate the texts of a figure, and give the numbers at its axes the decimal sign of the language.

    Parameters
    ----------
    figure : Figure
    own_words : collection of str
        Lines that stay as they are: words of the case.
    """
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_formatter(_Localised(axis.get_major_formatter()))
    for text in figure.findobj(Text):
        assert isinstance(text, Text)
        lines = text.get_text().split("\n")
        text.set_text("\n".join(line if line in own_words else _line(line) for line in lines))


def _line(said: str) -> str:
    known = translated_if_known(said)
    return known if known != said else _number(said)


def _number(said: str) -> str:
    """Numbers with a decimal comma; in mathematics braces keep it from being set as one between two things.

    >>> from babbitt.core.language import written_in
    >>> with written_in("de"):
    ...     _number("0.5"), _number("$ε = 0.5$ at 2.5 mm")
    ('0,5', '$ε = 0{,}5$ at 2,5 mm')
    """
    parts = re.split(r"(\$[^$]*\$)", said)
    return "".join(
        decimal(part).replace(",", "{,}") if part.startswith("$") and "." in part else decimal(part)
        for part in parts
    )


class _Localised(Formatter):
    """What another formatter writes, with the decimal sign of the language."""

    def __init__(self, inner: Formatter) -> None:
        self._inner = inner

    def __call__(self, number: float, place: int | None = None) -> str:
        return _number(self._inner(number, place))

    def format_ticks(self, values: Sequence[float]) -> list[str]:
        return [_number(said) for said in self._inner.format_ticks(values)]  # type: ignore[arg-type]

    def get_offset(self) -> str:
        return _number(self._inner.get_offset())
