"""Symbols of the vocabulary as nodes of typeset mathematics."""

from __future__ import annotations

import unicodedata

from babbitt.report.expression import Node

MACRON = "\u0304"

UPRIGHT = ("So", "Re")
"""Dimensionless numbers with two letters."""


def symbol_node(symbol: str) -> Node:
    """Take a symbol in plain Unicode apart.

    >>> symbol_node("ψ_eff"), symbol_node("Q₃*")
    (['sym', 'ψ', 'eff', '', False], ['sym', 'Q', '3', '*', False])
    >>> symbol_node("p̄")
    ['sym', 'p', '', '', True]
    >>> symbol_node("B/D")
    ['row', [['sym', 'B', '', '', False], ['op', '/'], ['sym', 'D', '', '', False]]]
    """
    if "/" in symbol:
        above, below = symbol.split("/")
        return ["row", [symbol_node(above), ["op", "/"], symbol_node(below)]]
    stem, _, subscript = symbol.partition("_")
    superscript = "*" if stem.endswith("*") or subscript.endswith("*") else ""
    stem, subscript = stem.removesuffix("*"), subscript.removesuffix("*")
    letters: list[str] = []
    barred: set[int] = set()
    for character in unicodedata.normalize("NFD", stem):
        decomposed = unicodedata.normalize("NFKD", character)
        if character == MACRON:
            barred.add(len(letters) - 1)
        elif decomposed.isdigit() and decomposed != character:
            subscript += decomposed
        else:
            letters.append(character)
    if "".join(letters) in UPRIGHT or len(letters) == 1:
        return ["sym", "".join(letters), subscript, superscript, 0 in barred]
    parts: list[Node] = []
    for place, letter in enumerate(letters):
        last = place == len(letters) - 1
        letter_node = ["sym", letter, subscript if last else "", superscript if last else "", place in barred]
        parts += [letter_node] if not parts else [["op", ""], letter_node]
    return ["row", parts]
