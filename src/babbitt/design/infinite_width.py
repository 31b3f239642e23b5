"""What a film without sides says about a bearing that has some: it carries more, so that its film is too thick."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from babbitt.core.notices import Notice
from babbitt.design.bounds import FILM_CHECKS, Bounds
from babbitt.design.conditions import CheckedProblem, PrescribedLoad

__all__ = ["WIDE_FROM", "warnings_about_width", "flattered_films"]

WIDE_FROM = 2.0
"""B/D from which textbooks take a bearing for infinitely wide: A. Z. Szeri, Fluid Film Lubrication: Theory and
Design, Cambridge 1998; B. J. Hamrock, Fundamentals of Fluid Film Lubrication, New York 1994."""


def flattered_films(values: Mapping[str, float]) -> Bounds:
    """Film thicknesses that follow from a load that no bearing of finite width carries in so thick a film."""
    ratio, film = values["width_ratio"], values["minimum_film_thickness"]
    return {
        code: Notice(code, "infinite_width", {"width_ratio": ratio, "minimum_film_thickness": film})
        for code in FILM_CHECKS
    }


def warnings_about_width(case: CheckedProblem, values: Mapping[str, float]) -> Iterator[Notice]:
    """Whether a bearing is so narrow that oil leaves by its sides rather than around the journal."""
    ratio = values["width_ratio"]
    if ratio >= WIDE_FROM:
        return
    shown = "film" if isinstance(case.duty, PrescribedLoad) else "load"
    yield Notice("W158", shown, {"width_ratio": ratio, "limit": WIDE_FROM})
