"""What to cite for the methods that a case uses."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from babbitt import __version__
from babbitt.case import CaseFile
from babbitt.core.language import translated_if_known
from babbitt.properties.lubricants import AstmD341, Exponential, TabulatedViscosity, Vogel, Walther
from babbitt.report.view import View, find_view

__all__ = ["JOHNSON", "REVERSE_GEAR", "REYNOLDS", "UNFOUND", "citations_of", "references"]

BABBITT = f"The Babbitt developers: Babbitt {__version__}, calculation and design of fluid-film bearings, 2026."
REYNOLDS = (
    "O. Reynolds: On the theory of lubrication and its application to Mr. Beauchamp Tower's experiments. "
    "Philosophical Transactions of the Royal Society 177 (1886) 157-234 (equation and rupture condition)."
)
WALTHER = "ASTM D341: Viscosity-temperature equations and charts for liquid petroleum or hydrocarbon products."
VOGEL = (
    "H. Vogel: Das Temperaturabhängigkeitsgesetz der Viskosität von Flüssigkeiten. Physikalische Zeitschrift 22 "
    "(1921) 645-646."
)
ISO_2909 = "ISO 2909: Petroleum products, calculation of viscosity index from kinematic viscosity."
JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge University Press (1985)"
UNFOUND = "Author, title and journal could not be looked up: what rests on it alone counts as an assumption."
REVERSE_GEAR = (
    "Marine reverse gear: a study of its bearings, 2023, vol. 15, no. 5, p. 825 ff. of a Russian journal "
    f"(`babbitt validate reverse_gear`). {UNFOUND}"
)
ANDRADE = "E. N. da C. Andrade: The viscosity of liquids. Nature 125 (1930) 309-310."
VISCOSITY_LAWS: dict[type, str] = {
    Walther: WALTHER,
    AstmD341: WALTHER,
    Vogel: VOGEL,
    Exponential: REYNOLDS,
    TabulatedViscosity: ANDRADE,
}
"""Sources of the laws of viscosity over temperature."""


def citations_of(case: CaseFile) -> tuple[str, ...]:
    """References for the software, the methods, their characteristics and the lubricants of a case."""
    return references((one.problem, find_view(one.problem.kind, one.method.name)) for one in case.calculations())


def references(computed: Iterable[tuple[Any, View]]) -> tuple[str, ...]:
    """References for the software, the methods and the lubricants of some problems.

    Parameters
    ----------
    computed : iterable of (Problem, View)
        Each problem with the view of the method that solves it.

    Returns
    -------
    tuple of str
        Each once, those of the lubricants last; notes on lubricants in the language that is written now.
    """
    found, oils = [BABBITT], {}
    for problem, view in computed:
        found += view.citations(problem)
        oil = view.oil(problem)
        if oil is not None:
            found += [VISCOSITY_LAWS[type(oil.viscosity_law)]] if type(oil.viscosity_law) in VISCOSITY_LAWS else []
            found += [ISO_2909] if oil.viscosity_index is not None else []
            oils[oil.name] = oil
    found += [f"{translated_if_known(oil.name)}: {translated_if_known(oil.source)}" for oil in oils.values()]
    return tuple(dict.fromkeys(found))
