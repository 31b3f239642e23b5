"""What every bearing of the Python front door can do: report what is missing, be changed, solved, written."""

from __future__ import annotations

import copy
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Self

from pydantic import PrivateAttr

from babbitt.api.case_tables import SolvesTables
from babbitt.api.given import as_given, content_of
from babbitt.api.reading import read_case, refuse_incomplete
from babbitt.api.shown import shown_call
from babbitt.case.aliases import in_method_mappings, in_todays_words, todays_path
from babbitt.case.case_file import CaseFile, Origin
from babbitt.case.loading import located
from babbitt.case.named_files import NamedFiles
from babbitt.case.variation import CaseVariation
from babbitt.case.with_units import case_text, with_units
from babbitt.core.files.reading import Reach
from babbitt.core.notices import InputError

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from babbitt.api.comparisons import Comparisons
    from babbitt.api.gradient import Gradient
    from babbitt.api.result_set import ResultSet
    from babbitt.api.studies import Study
    from babbitt.study.size import Size

__all__ = ["Case"]


class Case(SolvesTables, CaseFile):
    """A case that a program makes and changes; the bearings of `babbitt` are of it.

    Its fields are those of the case language. A quantity is text with a unit, a number in SI, or a pint quantity.
    What is wrong is refused when the case is made; what is missing is asked for when it is solved or written.
    """

    model: ClassVar[type[CaseFile]]
    """The case model of which it is."""
    default_name: ClassVar[str]

    _missing: tuple[str, ...] = PrivateAttr(())

    if not TYPE_CHECKING:

        def __init__(self, **given: Any) -> None:
            where = type(self).__name__
            (kind,) = self.model.model_fields["kind"].annotation.__args__
            words = {"kind": kind, "name": self.default_name} | as_given(self.in_words(given), where)
            self._take(*_read(type(self), Origin(words, FilePath(where), Reach.FOLDER)))

        __init__.__pydantic_base_init__ = True  # a case that is validated as a model is read by its fields alone

    def _take(self, part: CaseFile, missing: tuple[str, ...]) -> None:
        """Become what was read."""
        for slot in ("__dict__", "__pydantic_fields_set__", "__pydantic_extra__"):
            object.__setattr__(self, slot, getattr(part, slot))
        private = {**(part.__pydantic_private__ or {}), "_missing": missing}
        object.__setattr__(self, "__pydantic_private__", private)

    @classmethod
    def in_words(cls, given: Mapping[str, Any]) -> dict[str, Any]:
        """What was given, where Python has other words than the case language."""
        return dict(given)

    @classmethod
    def of(cls, case: CaseFile) -> Self:
        """The same case, read from a file or made of the classes of the case language."""
        made = cls.__new__(cls)
        made._take(case.model_copy(), ())
        return made

    @classmethod
    def read(cls, origin: Origin) -> Self:
        """The case of what was given, in the words of a case file.

        Raises
        ------
        CaseError
            With all that is wrong; what is missing is not.
        """
        made = cls.__new__(cls)
        made._take(*_read(cls, origin))
        return made

    def in_language(self) -> CaseFile:
        """The same case as an object of its case model, as the methods read it."""
        plain = self.model.__new__(self.model)
        for slot in ("__dict__", "__pydantic_fields_set__", "__pydantic_extra__"):
            object.__setattr__(plain, slot, getattr(self, slot))
        private = {name: one for name, one in (self.__pydantic_private__ or {}).items() if name != "_missing"}
        object.__setattr__(plain, "__pydantic_private__", {**private, "_text": self.text})
        return plain

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """Give a copy with other values, checked when it is solved or written; `replace` checks them now."""
        copied = super().model_copy(update=update, deep=deep)
        if update:
            copied._origin = None
        return copied

    def _with_other(self, name: str) -> str:
        """How a copy with another value is made."""
        return f"replace({name}=...) gives a changed copy"

    @property
    def missing(self) -> tuple[str, ...]:
        """Paths of the fields without which it cannot be solved; of several that would do, the first."""
        return self._missing if self.origin is not None else self.replace()._missing

    @property
    def given(self) -> dict[str, Any]:
        """What it was given, in the words of a case file; numbers with their units."""
        origin = self.origin
        words = with_units(content_of_fields(self), self) if origin is None else copy.deepcopy(dict(origin.given))
        return dict(in_method_mappings(self.model, in_todays_words(self.model, words)))

    @property
    def text(self) -> str:
        """The text that it was read from, else that of a case file that says the same."""
        return self._text or case_text(self.given)

    def replace(self, changes: Mapping[str, Any] | None = None, /, **fields: Any) -> Self:
        """The same case with other values, checked again.

        Parameters
        ----------
        changes : Mapping, optional
            Values by path, such as ``{"supply.temperature": "50 degC"}``.
        **fields
            Values by the name of the field; None takes the field away.

        Raises
        ------
        CaseError
            With all that is wrong then.
        InputError
            E005 for a path that leads through a value that is no mapping or list.
        """
        given = self.given
        for path, value in self._in_order({**(changes or {}), **fields}).items():
            given = self._given_with(given, path, value)
        return type(self).read(self._origin_of(given))

    __replace__ = replace

    def _in_order(self, changes: Mapping[str, Any]) -> Mapping[str, Any]:
        """Changes in the order in which they are made."""
        return changes

    def _given_with(self, given: dict[str, Any], path: str, value: Any) -> dict[str, Any]:
        """What it would be given with another value in a field."""
        if value is None:
            return _without(in_todays_words(self.model, given), todays_path(self.model, path.split(".")))
        where = type(self).__name__
        words = as_given(self.in_words({path: value})[path], where, (path,))
        return CaseVariation(FilePath(where), given, path).given_with(words)

    def check(self) -> None:
        """Refuse what `solve` would refuse, with at most one film solved.

        Raises
        ------
        CaseError
        """
        from babbitt.solving import refusal_of

        complete = self.complete()
        if (refusal := refusal_of(complete)) is not None:
            raise located(refusal, complete, type(self).__name__)

    def solve(self, changes: Mapping[str, Any] | None = None, /, **fields: Any) -> Any:
        """Solve it, or solve it with other values.

        Parameters
        ----------
        changes, **fields
            As for `replace`. Where one is an array and its field takes one value, arrays are broadcast against
            each other, and each combination is solved.

        Returns
        -------
        BearingResult, MachineResults or ResultSet
            For one bearing at one point, for several, and for arrays.

        Raises
        ------
        CaseError
            With all that is wrong or missing.
        """
        from babbitt.api.answers import answer, solutions_of
        from babbitt.api.sweeping import over_arrays

        values = {**(changes or {}), **fields}
        if (answers := over_arrays(self, values)) is not None:
            return answers
        case = self.replace(values) if values else self
        return answer(solutions_of(case), case)

    def sweep(
        self,
        over: Mapping[str, Any],
        /,
        *,
        workers: int = 1,
        keep: Literal["results", "solutions"] = "results",
    ) -> ResultSet:
        """Solve the product of values in several fields.

        Parameters
        ----------
        over : Mapping
            By the path of each field, its values; the last one varies fastest.
        workers : int
            Processes.
        keep : str
            "solutions" keeps the fields of every film, which take memory.

        Raises
        ------
        CaseError
            Where one of the cases is wrong or incomplete, before any is solved.
        """
        from babbitt.api.sweeping import over_product

        return over_product(self, over, workers, keep)

    def gradient(
        self,
        fields: str | Iterable[str],
        *,
        of: str | Iterable[str],
        steps: Mapping[str, Any] | None = None,
        workers: int = 1,
    ) -> Gradient:
        """Slopes of results over fields, by central differences (`babbitt.api.gradient.gradient_of`).

        Parameters
        ----------
        fields : str or iterable of str
            Paths, such as ``["clearance.mean", "supply.temperature"]``.
        of : str or iterable of str
            Quantities of the result, such as ``["minimum_film_thickness", "stiffness"]``.
        steps : Mapping, optional
            By field, the step to each side in place of 1 % of the value, or of 1 K.
        workers : int
            Processes.

        Raises
        ------
        CaseError, InputError
            For what is no field with a quantity, or no quantity of the result.

        Warns
        -----
        UserWarning
            For slopes that depend on the step.
        """
        from babbitt.api.gradient import gradient_of

        return gradient_of(self, fields, of, steps, workers)

    def size(
        self,
        path: str,
        *,
        within: tuple[Any, Any] | None = None,
        points: int = 64,
        among: Sequence[Any] = (),
        limits: str | Sequence[str] = "all",
        over_tolerance: bool = False,
    ) -> Size:
        """Find the values of a field that keep all limits: every interval, and the check that ends it.

        Parameters
        ----------
        path : str
            Of the field.
        within : tuple, optional
            First and last value of the scan; a decade below and above the value of the case where it is left out.
        points : int
            Values of the scan. An interval narrower than a step of it may be missed.
        among : sequence
            Choices that are held against the limits instead; usual ones of an oil or a tolerance class without it.
        limits : str or sequence of str
            "all", "recommended" (recommendations count too), or the codes of the checks that count.
        over_tolerance : bool
            At the smallest, mean and largest clearance.

        Returns
        -------
        Size
            Its `intervals` hold the ends in SI, to 1e-4 and permitted, and what lies beyond each; its `choices`
            how each choice does.

        Raises
        ------
        CaseError, InputError
            For what is no field, for a range that does not ascend, for codes that no check has, and where the
            case refuses every value.
        """
        from babbitt.api.sizing import sized

        return sized(self.complete(), path, within, points, among, limits, over_tolerance)

    def study(
        self,
        kind: str | None = None,
        vary: Mapping[str, Any] | None = None,
        *,
        outputs: Sequence[str] = (),
        samples: int | None = None,
        out: str | FilePath | None = None,
        workers: int | Executor | str = 1,
        **options: Any,
    ) -> Study:
        """Study many variants: a sweep, map, tolerance, sensitivity, spectrum or optimisation, or the corners.

        Parameters
        ----------
        kind : str, optional
            By default the study that stands in the file of the case.
        vary : Mapping, optional
            By the path of a field a list of values, or a mapping such as ``{"uniform": ["10 kN", "14 kN"]}``;
            numbers are in SI.
        outputs : sequence of str
            Quantities that are kept; by default the key results.
        samples : int, optional
        out : str or Path, optional
            Folder ``name.study`` in which finished rows are kept; the same call goes on.
        workers : int, concurrent.futures.Executor or str
            Processes (a script that starts some guards its own work with ``if __name__ == "__main__"``), an
            executor, or the address of a dask scheduler.
        **options
            What else stands in the block ``study`` of a case file: ``sampling``, ``seed``, ``minimise``, ...

        Raises
        ------
        CaseError, InputError
            With all that makes the study impossible.
        """
        from babbitt.api.studies import studied

        return studied(self, kind, vary, outputs, samples, out, workers, options)

    def compare(self) -> Comparisons:
        """Solve it by every method that knows it, each beside the others.

        Returns
        -------
        Comparisons
            A tuple of one `babbitt.api.comparisons.Comparison` for each bearing, operating point and clearance.
            ``comparison["ISO 7902"]`` is a result as `solve` gives it; `left_out` says which methods do not apply.

        Raises
        ------
        CaseError
            Where it is incomplete, or its kind has one method.
        """
        from babbitt.api.comparisons import compared

        complete = self.complete()
        try:
            return compared(complete)
        except InputError as error:
            raise located(error, complete, type(self).__name__) from None

    def to_yaml(self) -> str:
        """Write it as a case file, quantities with their units; it is read back to the same case.

        Raises
        ------
        CaseError
            With what is missing.
        """
        return self.complete().text

    def complete(self) -> Self:
        """Itself where nothing is missing; values that were copied in unchecked are checked.

        Raises
        ------
        CaseError
            With what is missing.
        """
        origin = self.origin or self._origin_of(self.given)
        if self.missing:
            refuse_incomplete(self.model, origin.given, type(self).__name__, _files(origin))
        return self if self.origin is not None else self.replace()

    def _origin_of(self, given: dict[str, Any]) -> Origin:
        if self.origin is not None:
            return Origin(given, self.origin.file, self.origin.reach)
        return Origin(given, FilePath(type(self).__name__), Reach.FOLDER)

    def __getattr__(self, name: str) -> Any:
        if name in type(self).model_fields:
            raise AttributeError(f"{name} is missing in this {type(self).__name__}", name=name, obj=self)
        return super().__getattr__(name)  # type: ignore[misc]

    def __dir__(self) -> Iterator[str]:
        """Its fields and what it can do, without what is of pydantic."""
        own = (name for cls in type(self).__mro__ if issubclass(cls, Case) for name in vars(cls))
        shown = {name for name in own if not name.startswith(("_", "model_"))}
        return iter(sorted({*type(self).model_fields, *shown, "model_copy"}))

    def __eq__(self, other: object) -> bool:
        """Whether the other case says the same, be it made by a program or read from a file."""
        if not isinstance(other, CaseFile):
            return NotImplemented
        return isinstance(other, self.model) and vars(other) == vars(self)

    def __hash__(self) -> int:
        return hash((self.model, tuple(sorted(vars(self).items(), key=lambda pair: pair[0]))))

    def __repr__(self) -> str:
        given = {name: value for name, value in self.given.items() if name not in ("babbitt", "kind")}
        return shown_call(type(self).__name__, given, self._missing)

    __str__ = __repr__


def content_of_fields(case: Case) -> dict[str, Any]:
    """What stands in the fields of a case that was changed by `model_copy`, which leaves no other trace."""
    plain = case.model.model_construct(case.model_fields_set, **vars(case))
    return content_of(plain)


def _read(cls: type[Case], origin: Origin) -> tuple[CaseFile, tuple[str, ...]]:
    """Read a case and keep what it was given, numbers with their units."""
    part, missing = read_case(cls.model, origin.given, cls.__name__, _files(origin))
    today = in_todays_words(cls.model, origin.given)
    kept = Origin(with_units(today, part), origin.file, origin.reach)
    return part.with_origin(kept), missing


def _files(origin: Origin) -> NamedFiles:
    return NamedFiles(origin.file.parent, origin.reach)


def _without(given: dict[str, Any], steps: Sequence[str]) -> dict[str, Any]:
    """What was given, without the field of a path."""
    left = copy.deepcopy(given)
    place: Any = left
    for step in steps[:-1]:
        place = place[int(step)] if isinstance(place, list) and step.isdecimal() else place.get(step, {})
    if isinstance(place, dict):
        place.pop(steps[-1], None)
    return left
