"""What a file can hold, by its `kind`: models and templates of the registered kinds."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping
from typing import Annotated, Any, Union, get_args

from pydantic import Discriminator

from babbitt.case.case_file import CaseFile
from babbitt.case.error_messages import nearest, shown
from babbitt.core import kind as registry
from babbitt.core.notices import InputError

__all__ = ["KINDS", "any_case", "kinds", "template"]


class Kinds(Mapping[str, type[CaseFile]]):
    """The case model of every kind, imported when it is first asked for."""

    def __getitem__(self, name: str) -> type[CaseFile]:
        found = registry.find_kind(name)
        if found is None:
            raise KeyError(name)
        model: type[CaseFile] = found.load_model()
        if not (isinstance(model, type) and issubclass(model, CaseFile)):
            raise registry.kind_mistake(name, f"{found.model} is not a class of CaseFile")
        if "kind" not in model.model_fields or get_args(model.model_fields["kind"].annotation) != (name,):
            raise registry.kind_mistake(name, f'the field kind of {found.model} is not Literal["{name}"]')
        return model

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and registry.find_kind(name) is not None

    def __iter__(self) -> Iterator[str]:
        return iter(registry.kinds())

    def __len__(self) -> int:
        return len(registry.kinds())


KINDS = Kinds()


def any_case() -> Any:
    """The case of any kind in one type, discriminated by `kind`; imports the models of all kinds.

    A kind whose model cannot be used is left out, with a warning.
    """
    found = []
    for name in KINDS:
        try:
            found.append(KINDS[name])
        except InputError as error:
            warnings.warn(f"left out: {error.message}", stacklevel=2)
    models = tuple(found)
    return Annotated[Union[models], Discriminator("kind")]  # noqa: UP007 - the models are known at run time only


def kinds() -> Mapping[str, str]:
    """Give the kinds of case and what each describes.

    >>> list(kinds())
    ['journal', 'machine', 'shaft', 'overhung_coupling', 'screw_heel', 'hydrostatic_pad',
    'hydrostatic_thrust_ring', 'hydrostatic_journal', 'jacking_pocket', 'thrust', 'thrust_line',
    'tilting_pad_journal']
    """
    return {name: kind.description for name, kind in registry.kinds().items()}


def template(kind: str) -> str:
    """Give the commented case file of a kind.

    Parameters
    ----------
    kind : str
        One of `kinds`.

    Raises
    ------
    InputError
        E005 for another kind.
    """
    found = registry.find_kind(kind)
    if found is None:
        hint = nearest(kind, kinds())
        says = f"{shown(kind)} is not a kind of case; allowed: {', '.join(kinds())}"
        raise InputError("E005", f"{says}; {hint}" if hint else says)
    return found.read_template()
