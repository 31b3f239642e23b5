"""What is included, by name: lubricants, materials, published cases, explanations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from babbitt.core.files.printing import printable
from babbitt.core.nearest_name import nearest_names
from babbitt.core.notices import Explanation, InputError, explanations

if TYPE_CHECKING:
    from babbitt.validation.case import Comparison

__all__ = ["explain", "lubricants", "materials", "published_cases", "validate"]


def lubricants() -> tuple[str, ...]:
    """Names of the lubricants in the catalogue; `babbitt.lubricant` gives one of them.

    >>> "ISO VG 46" in lubricants()
    True
    """
    from babbitt.properties.lubricants import catalogue

    return tuple(one.name for one in catalogue())


def materials() -> tuple[str, ...]:
    """Names of the bearing metals and structural materials in the catalogue."""
    from babbitt.properties.materials import bearing_metals, structural_materials

    return (*(one.name for one in bearing_metals()), *(one.name for one in structural_materials()))


def published_cases() -> tuple[str, ...]:
    """Names of the published cases that ship; `babbitt.validate` runs one of them."""
    from babbitt.validation import cases

    return tuple(one.name for one in cases())


def validate(name: str) -> tuple[Comparison, ...]:
    """Run a published case: each printed value beside ours.

    Raises
    ------
    InputError
        E005 for a name that is not among `published_cases`.
    """
    from babbitt.validation import validation_case

    return tuple(validation_case(name).run())


def explain(code: str) -> Explanation:
    """What a code of an error, warning or check means, and what to do about it.

    Raises
    ------
    InputError
        E005 for a code that there is not.

    >>> explain("W101").title == explanations()["W101"].title
    True
    """
    asked = code.strip().upper()
    if asked not in explanations():
        from babbitt.core.kind import kinds

        kinds()  # those of other packages bring codes of their own
    found = explanations().get(asked)
    if found is None:
        near = nearest_names(asked, explanations(), most=4)
        hint = f"did you mean {', '.join(near)}?" if near else f"there are: {', '.join(sorted(explanations()))}"
        raise InputError("E005", f"no code '{printable(code)}'; {hint}")
    return found
