"""Formulas written once, as Python expressions, and shown three ways: with symbols, with numbers, as a value.

``parse("load / (width * diameter)")`` is turned into a tree of plain lists. The typesetter builds mathematics
from the tree, so that no text is ever interpreted as markup; `value` computes what the same expression says, which
lets a test hold the printed numbers against the printed result.

A node is a list whose first item names its kind:

==========  =============================================
``sym``     base, subscript, superscript, overline (bool)
``num``     digits, power of ten ("" for none)
``frac``    numerator, denominator
``pow``     base, exponent
``root``    radicand
``paren``   body; ``bars`` likewise for an absolute value
``call``    name (a node), list of arguments
``row``     list of nodes and operators
``op``      one of ``+ − × ⋅ /``; ``⋅`` is an implied product, the empty one joins letters of one symbol
==========  =============================================
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

from babbitt.core.language import decimal

Node = list[Any]
Leaf = Callable[[str], Node]

FUNCTIONS: dict[str, Callable[..., float]] = {
    "sqrt": math.sqrt,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "ln": math.log,
    "lg": math.log10,
    "exp": math.exp,
    "abs": abs,
    "max": max,
}
CONSTANTS = {"pi": (math.pi, "π")}

_SUM, _PRODUCT, _POWER, _ATOM = range(4)


@lru_cache(maxsize=256)
def parse(expression: str) -> ast.expr:
    """Parse a formula; cached, since a machine repeats its formulas for every bearing."""
    return ast.parse(expression, mode="eval").body


def names(expression: str) -> list[str]:
    """Quantities in an expression, in the order in which they appear.

    >>> names("load / (width * diameter)")
    ['load', 'width', 'diameter']
    """
    found = [node for node in ast.walk(parse(expression)) if isinstance(node, ast.Name)]
    found.sort(key=lambda node: node.col_offset)
    return list(dict.fromkeys(n.id for n in found if n.id not in FUNCTIONS and n.id not in CONSTANTS))


def value(expression: str, numbers: Mapping[str, float]) -> float:
    """What an expression amounts to.

    >>> value("load / (width * diameter)", {"load": 36e3, "width": 0.06, "diameter": 0.12})
    5000000.0
    """
    return _value(parse(expression), numbers)


def _value(node: ast.expr, numbers: Mapping[str, float]) -> float:
    match node:
        case ast.Constant(value=float() | int() as number):
            return float(number)
        case ast.Name(id=name):
            return CONSTANTS[name][0] if name in CONSTANTS else numbers[name]
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_value(operand, numbers)
        case ast.BinOp(left=left, op=operator, right=right):
            a, b = _value(left, numbers), _value(right, numbers)
            match operator:
                case ast.Add():
                    return a + b
                case ast.Sub():
                    return a - b
                case ast.Mult():
                    return a * b
                case ast.Div():
                    return a / b
                case ast.Pow():
                    return float(a**b)
        case ast.Call(func=ast.Name(id=name), args=arguments):
            return float(FUNCTIONS[name](*(_value(argument, numbers) for argument in arguments)))
    raise ValueError(f"no formula of a report: {ast.unparse(node)}")


def tree(expression: str, leaf: Leaf) -> Node:
    """Lay out an expression, each quantity as `leaf` shows it.

    Parameters
    ----------
    expression : str
    leaf : callable
        Turns the name of a quantity into a node, a symbol or a number.
    """
    return _tree(parse(expression), leaf)[0]


def _tree(node: ast.expr, leaf: Leaf) -> tuple[Node, int]:
    match node:
        case ast.Constant(value=float() | int() as number):
            shown = number_node(float(number), 6)
            return shown, _binding(shown)
        case ast.Name(id=name):
            shown = ["sym", CONSTANTS[name][1], "", "", False] if name in CONSTANTS else leaf(name)
            return shown, _binding(shown)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return ["row", [["op", "−"], _at_least(_PRODUCT, *_tree(operand, leaf))]], _SUM
        case ast.BinOp(left=left, op=operator, right=right):
            return _operation(operator, _tree(left, leaf), _tree(right, leaf))
        case ast.Call(func=ast.Name(id=name), args=arguments):
            bodies = [_tree(argument, leaf) for argument in arguments]
            if name == "sqrt":
                return ["root", bodies[0][0]], _ATOM
            if name == "abs":
                return ["bars", bodies[0][0]], _ATOM
            return ["call", ["sym", name, "", "", False], [body for body, _ in bodies]], _ATOM
    raise ValueError(f"no formula of a report: {ast.unparse(node)}")


def _operation(operator: ast.operator, a: tuple[Node, int], b: tuple[Node, int]) -> tuple[Node, int]:
    match operator:
        case ast.Add():
            return ["row", [a[0], ["op", "+"], _positive(*b)]], _SUM
        case ast.Sub():
            return ["row", [a[0], ["op", "−"], _at_least(_PRODUCT, *b)]], _SUM
        case ast.Mult():
            left, right = _at_least(_PRODUCT, *a), _at_least(_PRODUCT, *b)
            crossed = _opens(right) == "num" or (_ends(left, -1) == "num" and _ends(right, 0) == "num")
            return ["row", [left, ["op", "×" if crossed else "⋅"], right]], _PRODUCT
        case ast.Div():
            return ["frac", a[0], b[0]], _PRODUCT
        case ast.Pow():
            exponent = ["row", [b[0][1], ["op", "/"], b[0][2]]] if b[0][0] == "frac" else b[0]
            return ["pow", _at_least(_ATOM, *a), exponent], _POWER
    raise ValueError(f"no operator of a report: {operator}")


def _ends(node: Node, end: int) -> str:
    """Kind of the first or last thing in a node; a power shows its base."""
    match node:
        case ["row", parts]:
            return _ends(parts[end], end)
        case ["pow" | "paren" | "frac", body, *_]:
            return _ends(body, end)
        case [str() as kind, *_]:
            return kind
    raise ValueError(node)


def _opens(node: Node) -> str:
    """Kind of the first thing printed; a bracket counts as one."""
    match node:
        case ["row", [first, *_]]:
            return _opens(first)
        case ["pow", base, _]:
            return _opens(base)
        case [str() as kind, *_]:
            return kind
    raise ValueError(node)


def _at_least(binding: int, node: Node, own: int) -> Node:
    return node if own >= binding else ["paren", node]


def _positive(node: Node, own: int) -> Node:
    negative = node[0] == "num" and node[1].startswith("−")
    return ["paren", node] if negative else node


def _binding(node: Node) -> int:
    if node[0] == "num":
        return _SUM if node[1].startswith("−") else _PRODUCT if node[2] else _ATOM
    quotient = node[0] == "row" and ["op", "/"] in node[1]  # a symbol such as f/ψ or B/D
    return _SUM if quotient else _ATOM


def number_node(number: float, digits: int = 5) -> Node:
    """A number with a number of significant digits, trailing zeros dropped, thousands apart.

    >>> number_node(46500.0), number_node(0.25), number_node(1.5796e-3)
    (['num', '46\\u2009500', ''], ['num', '0.25', ''], ['num', '1.5796', '−3'])
    """
    if number == 0.0 or not math.isfinite(number):
        return ["num", "0" if number == 0.0 else "–", ""]
    exponent = math.floor(math.log10(abs(float(f"{number:.{digits - 1}e}"))))
    if -3 < exponent < 6:
        return ["num", _grouped(f"{number:.{max(0, digits - 1 - exponent)}f}"), ""]
    mantissa = f"{number / 10.0**exponent:.{digits - 1}f}"
    return ["num", _grouped(mantissa), str(exponent).replace("-", "−")]


def _grouped(text: str) -> str:
    whole, _, rest = text.partition(".")
    rest = rest.rstrip("0")
    digits = whole.lstrip("-")
    if len(digits) > 4:
        digits = f"{int(digits):,}".replace(",", "\u2009")
    sign = "−" if whole.startswith("-") else ""
    return sign + decimal(digits + (f".{rest}" if rest else ""))


def text(node: Node) -> str:
    """A node as one line of text, for screen readers and for tests.

    >>> text(tree("load / (width * diameter)", lambda name: ["sym", name[0], "", "", False]))
    '(l)/(w d)'
    """
    match node:
        case ["sym", base, sub, sup, over]:
            return f"{base}{chr(0x304) if over else ''}{f'_{sub}' if sub else ''}{sup}"
        case ["num", digits, power]:
            return f"{digits}{f'e{power}' if power else ''}".replace("\u2009", "")
        case ["frac", numerator, denominator]:
            return f"({text(numerator)})/({text(denominator)})"
        case ["pow", base, exponent]:
            return f"{text(base)}^{text(exponent)}"
        case ["root", body]:
            return f"sqrt({text(body)})"
        case ["paren", body]:
            return f"({text(body)})"
        case ["bars", body]:
            return f"|{text(body)}|"
        case ["call", name, arguments]:
            return f"{text(name)}({', '.join(text(argument) for argument in arguments)})"
        case ["row", parts]:
            return "".join(text(part) for part in parts)
        case ["op", "⋅"]:
            return " "
        case ["op", "/" | "" | "°" as sign]:
            return f"{sign}"
        case ["op", sign]:
            return f" {sign} "
    raise ValueError(node)
