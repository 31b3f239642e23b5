"""The registry of bearing kinds: what a program must know of a kind before it imports its calculation.

The kinds that ship stand in ``babbitt.kinds``. Other packages add theirs by the entry-point group
``babbitt.kinds``, whose entries name a `Kind`, or by `register`.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import import_module
from importlib.metadata import entry_points
from importlib.resources import files
from types import MappingProxyType
from typing import Any

from babbitt.core.notices import InputError
from babbitt.core.notices.words import add_words
from babbitt.core.quantities import QUANTITIES

__all__ = ["Kind", "LazyFunction", "find_kind", "imported", "kind_mistake", "kinds", "register"]

SHIPPED = "babbitt.kinds"
"""Package whose ``KINDS`` are those that ship, and the group of entry points for all others."""


SPEED_AND_LOAD = (("speed",), ("load",))
"""Axes of a map of most kinds."""


def imported(path: str) -> Any:
    """Import what a text names: a module and, behind a colon, what stands in it.

    >>> imported("math:pi")
    3.141592653589793
    """
    module, _, name = path.partition(":")
    return getattr(import_module(module), name)


@dataclass(frozen=True)
class LazyFunction:
    """A function that a text names as for `imported`, and that is imported when it is first called.

    >>> LazyFunction("math:sqrt")(4.0)
    2.0
    """

    place: str

    def __call__(self, *given: Any) -> Any:
        """Import and call it."""
        return imported(self.place)(*given)


@dataclass(frozen=True)
class Kind:
    """One kind of case; modules are named, and imported when they are first needed.

    Attributes
    ----------
    name : str
        What a case file says under ``kind``.
    description : str
        One line for lists.
    model : str
        Its case model, as ``module:Class``.
    template : str
        A commented case file to begin with, as ``package:file``.
    views : Mapping[str, str]
        By the name of each method, where its `babbitt.report.view.View` stands, as ``module:NAME``.
    comparison : str
        A function from a case to comparisons of its methods, as ``module:name``; empty where there is one method.
    one_method : str
        What to tell whoever compares a kind that has one method.
    no_coefficients : str
        What to tell whoever exports dynamic coefficients of a kind that has none to export.
    meanings : str
        What quantities mean in this kind, a mapping, as ``module:NAME``; empty for their usual meaning.
    vocabulary : str
        Quantities that occur in its calculation sheets only, as ``module:NAME``.
    quantities : str
        Quantities of its results that no other kind has, as ``module:NAME``; they join the vocabulary.
    words : str
        Package in whose folder ``words.en.toml`` has the texts of its codes (`babbitt.core.notices.words`). Kinds
        that ship name none: theirs are found in their folders.
    solve_many : str
        A function from a case and columns of values to columns of answers (`babbitt.study.rows.SolvesMany`), as
        ``module:name``; empty where rows are solved case by case.
    first_design : str
        What it says of first designs from a duty (`babbitt.study.design.FirstDesign`), as ``package:module``;
        empty where it has no rules for them.
    study_results : tuple of str
        Results that a study keeps besides the usual ones, where it names none.
    envelope : tuple of tuple of str
        Fields over which a map is drawn that names none, across and up: of each the first that the case gives.
        Of ``speed``, ``load`` and ``power`` those of all bearings, gears and operating points go together.
    """

    name: str
    description: str
    model: str
    template: str
    views: Mapping[str, str] = field(default_factory=dict)
    comparison: str = ""
    one_method: str = ""
    no_coefficients: str = ""
    meanings: str = ""
    vocabulary: str = ""
    quantities: str = ""
    words: str = ""
    solve_many: str = ""
    first_design: str = ""
    study_results: tuple[str, ...] = ()
    envelope: tuple[tuple[str, ...], tuple[str, ...]] = SPEED_AND_LOAD

    def load(self, path: str) -> Any:
        """Import a part that it names.

        Raises
        ------
        InputError
            E008 where it is not there, or fails while it is imported.
        """
        try:
            return imported(path)
        except Exception as error:  # whatever another package does wrong
            raise kind_mistake(self.name, f"{path}: {type(error).__name__}: {error}") from error

    def load_model(self) -> Any:
        """Import the case model."""
        return self.load(self.model)

    def read_template(self) -> str:
        """Read the case file to begin with."""
        package, _, name = self.template.partition(":")
        try:
            return files(package).joinpath(name).read_text(encoding="utf-8")
        except (ImportError, OSError, ValueError) as error:
            raise kind_mistake(self.name, f"{self.template}: {type(error).__name__}: {error}") from error

    def load_meanings(self) -> Mapping[str, str]:
        """Import what quantities mean in this kind."""
        meanings: Mapping[str, str] = self.load(self.meanings) if self.meanings else {}
        return meanings


def kind_mistake(kind: str, says: str) -> InputError:
    """What to raise where a kind does not hold what is asked of it."""
    return InputError("E008", f"the bearing kind {kind!r} has a mistake: {says}")


_REGISTERED: dict[str, Kind] = {}


def register(kind: Kind) -> None:
    """Add a kind to those that case files may name, and its quantities and codes to those of all.

    Raises
    ------
    ValueError
        Where another kind has the name, or a quantity or code of it has another meaning already; nothing is added.
    """
    _load_shipped()
    _add(kind)


def _add(kind: Kind) -> None:
    own_quantities = {one.name: one for one in imported(kind.quantities)} if kind.quantities else {}
    _require_unused(kind, _REGISTERED, {kind.name: kind})
    _require_unused(kind, QUANTITIES, own_quantities)
    if kind.words:
        add_words(kind.words)
    QUANTITIES.update(own_quantities)
    _REGISTERED[kind.name] = kind


def _require_unused(kind: Kind, known: Mapping[str, Any], own: Mapping[str, Any]) -> None:
    taken = [name for name in own if known.get(name, own[name]) != own[name]]
    if taken:
        raise ValueError(f"the kind {kind.name!r} gives another meaning to {', '.join(taken)}")


def find_kind(name: str) -> Kind | None:
    """The kind of a name; None where there is none. Other packages are asked for names that do not ship."""
    _load_shipped()
    if name not in _REGISTERED:
        _load_others()
    return _REGISTERED.get(name)


def kinds() -> Mapping[str, Kind]:
    """All kinds by name: those that ship in their order, then those of other packages.

    >>> list(kinds())[:4]
    ['journal', 'machine', 'shaft', 'overhung_coupling']
    """
    _load_shipped()
    _load_others()
    return MappingProxyType(_REGISTERED)


@cache
def _load_shipped() -> None:
    for kind in imported(f"{SHIPPED}:KINDS"):
        _add(kind)


@cache
def _load_others() -> None:
    """Look up the kinds of other packages, once; a broken one is named and leaves the others usable."""
    for entry in entry_points(group=SHIPPED):
        try:
            _add(entry.load())
        except Exception as error:  # whatever another package does wrong
            why = f"{type(error).__name__}: {error}"
            warnings.warn(f"the bearing kind {entry.name!r} cannot be used: {why}", stacklevel=2)
