"""Equations as MathML, which browsers draw themselves: pages need no network and no script."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from docutils import nodes
from latex2mathml.converter import convert

if TYPE_CHECKING:
    from sphinx.application import Sphinx
    from sphinx.writers.html5 import HTML5Translator

_OF_A_SIZE = re.compile(r"\\[Bb]igg?([lr])")
"""Brackets of a given size, for which MathML has those that grow with what they hold."""


def inline(translator: HTML5Translator, node: nodes.math) -> None:
    """Write an equation in the line."""
    translator.body.append(_mathml(node.astext(), "inline"))
    raise nodes.SkipNode


def display(translator: HTML5Translator, node: nodes.math_block) -> None:
    """Write an equation on lines of its own."""
    translator.body.append(f'<div class="equation">{_mathml(node.astext(), "block")}</div>')
    raise nodes.SkipNode


def _mathml(latex: str, how: str) -> str:
    growing = _OF_A_SIZE.sub(lambda found: "\\left" if found[1] == "l" else "\\right", latex.strip())
    found = convert(growing, display=how)
    if "\\" in found:
        raise ValueError(f"{latex!r} has a command without MathML")
    return found


def register(app: Sphinx) -> None:
    """Make MathML a renderer that `html_math_renderer` can name."""
    app.add_html_math_renderer("mathml", (inline, None), (display, None))
