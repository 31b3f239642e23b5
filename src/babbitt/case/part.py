"""What every piece of a case file is: frozen, without unknown keys, and able to report all that is wrong at once.

Pydantic stops at the fields: rules between fields would only be asked once every field is right. Here the rules
are asked of whatever is right, so that a file with a wrong unit and a bore smaller than its journal hears of both.
"""

from __future__ import annotations

import typing
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache
from types import FunctionType
from typing import Any, ClassVar, Self, TypeVar

from pydantic import (
    BaseModel,
    ConfigDict,
    ModelWrapValidatorHandler,
    PrivateAttr,
    TypeAdapter,
    ValidationError,
    ValidationInfo,
    model_validator,
)
from pydantic_core import ErrorDetails, InitErrorDetails, PydanticCustomError

from babbitt.case.aliases import FormerWords, read_given
from babbitt.case.error_messages import (
    ERROR_TYPE,
    MISSING,
    Path,
    is_echo,
    is_missing,
    metadata_of,
    misspelt,
    refusal,
)
from babbitt.case.grouped_digits import grouped_fields
from babbitt.case.load_components import LoadOrComponents, direction_given_twice, with_direction
from babbitt.case.method_mapping import METHOD, choices_of, every_choice, method_models
from babbitt.case.reading import Reading
from babbitt.case.suggestions import near_typo
from babbitt.core.notices import InputError, Notice


@dataclass(frozen=True)
class Issue:
    """What a rule has to say about a piece of a case.

    Attributes
    ----------
    path : tuple
        From the piece to the field to blame.
    says, allowed, hint : str
        What is wrong, what would do, what to try.
    code : str
        A code of `babbitt.core.notices.explanations`.
    lacks : tuple, optional
        From `path` to the field to add, empty where they are the same. None where something is wrong, unless
        `says` is that it is missing.
    """

    path: Path
    says: str
    allowed: str = ""
    hint: str = ""
    code: str = "E004"
    lacks: Path | None = None

    @property
    def missing(self) -> Path | None:
        """From the field to blame to the one to add; None where more is wrong than that it is missing."""
        return () if self.lacks is None and self.says == MISSING else self.lacks

    def under(self, *path: str | int) -> Issue:
        """Report the same of a piece further down."""
        return replace(self, path=(*path, *self.path))


Rule = Callable[[Any], Iterable[Issue]]
RuleT = TypeVar("RuleT", bound=Rule)
PartT = TypeVar("PartT", bound="Part")


def rule(method: RuleT) -> RuleT:
    """Mark a method of a `Part` that yields the issues about its fields.

    A rule may touch any field: where one it needs is itself unusable, the rule is silently not asked.
    """
    method.__dict__["is_rule"] = True
    return method


class Part(BaseModel):
    """A piece of a case file."""

    model_config = ConfigDict(frozen=True, extra="forbid", coerce_numbers_to_str=True, defer_build=True)
    rules: ClassVar[tuple[Rule, ...]] = ()
    alternatives: ClassVar[tuple[tuple[str, ...], ...]] = ()
    """Fields that stand in place of each other."""
    two_of: ClassVar[tuple[str, ...]] = ()
    """Fields of which two are given, and the others follow."""
    former_words: ClassVar[FormerWords] = {}
    """Paths of words that are still read, and the paths of those of today (`babbitt.case.aliases`)."""
    hints: ClassVar[Mapping[str, str]] = {}
    """What to try where a field of a name is refused, be it a field here or not."""
    example: ClassVar[str] = ""
    """How the piece is written, for messages; empty where that takes more than a line."""

    _grouped: tuple[tuple[str, str], ...] = PrivateAttr(())
    """Quantities whose text may be grouped digits, by field, as they were written."""

    def __eq__(self, other: object) -> bool:
        # How a file wrote its content, which pydantic would compare too, makes no other case of it.
        return isinstance(other, Part) and type(other) is type(self) and vars(other) == vars(self)

    @classmethod
    def __pydantic_init_subclass__(cls, **kwargs: Any) -> None:
        """Collect the rules of the class and its bases."""
        members = {name: member for base in reversed(cls.__mro__) for name, member in vars(base).items()}
        functions = (member for member in members.values() if isinstance(member, FunctionType))
        cls.rules = tuple(function for function in functions if getattr(function, "is_rule", False))

    def __setattr__(self, name: str, value: Any) -> None:
        # A case does not change; pydantic would say so in words of its own.
        if name.startswith("_"):
            super().__setattr__(name, value)
        else:
            raise self._frozen(name, "set")

    def __delattr__(self, name: str) -> None:
        raise self._frozen(name, "deleted")

    def _frozen(self, name: str, done: str) -> AttributeError:
        field = name if name in type(self).model_fields else "field"
        says = f"{name} of a {type(self).__name__} cannot be {done}; {self._with_other(field)}"
        return AttributeError(says, name=name, obj=self)

    def _with_other(self, name: str) -> str:
        """How a copy with another value is made."""
        return f"model_copy(update={{'{name}': ...}}) gives a changed copy"

    @model_validator(mode="wrap")
    @classmethod
    def _report_all(cls, given: Any, handler: ModelWrapValidatorHandler[Self], info: ValidationInfo) -> Self:
        if not isinstance(given, Mapping):
            return cls._with_every_issue(given, handler, info)
        reading = read_given(cls, given)
        in_full, twice = _with_direction(cls, reading.given)
        try:
            part = cls._with_every_issue(in_full, handler, info)
            if not reading.twice and not reading.unknown and not twice:
                return part
            lines = []
        except ValidationError as error:
            lines = [_at_written(one, reading) for one in error.errors(include_url=False)]
        lines += [_line(_given_twice(former, today), given) for former, today in reading.twice]
        lines += [_line(one, given) for one in twice]
        lines += [_line(_no_choice(cls, path, reading.given), given) for path in reading.unknown]
        raise ValidationError.from_exception_data(cls.__name__, lines)

    @classmethod
    def _with_every_issue(cls, given: Any, handler: ModelWrapValidatorHandler[Self], info: ValidationInfo) -> Self:
        """Read the part from the words of today, and report all that is wrong with it."""
        try:
            part = handler(given)
        except ValidationError as error:
            found = [details for details in error.errors(include_url=False) if not is_echo(details)]
            meant = misspelt(cls, given, found)
            lines = [refusal(cls, given, one) for one in found if not is_missing(one, meant)]
            if isinstance(given, Mapping):
                lines += _lines(usable_part(cls, given, info.context, meant), given)
            raise ValidationError.from_exception_data(cls.__name__, lines) from None
        if isinstance(given, Mapping):
            part._grouped = grouped_fields(cls, given)
        if lines := _lines(part, given):
            raise ValidationError.from_exception_data(cls.__name__, lines)
        return part


def as_far_as_usable(issues: Iterable[Issue]) -> Iterator[Issue]:
    """Give issues until they touch a field that is itself unusable, which has been reported already."""
    try:
        yield from issues
    except AttributeError as error:
        if not (isinstance(error.obj, Part) and error.name in type(error.obj).model_fields):
            raise


def refused(path: Path, attempt: Callable[[], object]) -> Iterator[Issue]:
    """Try something that may refuse its input, and give an issue with its message."""
    try:
        attempt()
    except InputError as error:
        yield Issue(path, error.message, code=error.code)


def is_given(part: Part, name: str) -> bool:
    """Whether a field was written in the file, be it usable or not."""
    return name in part.model_fields_set and vars(part).get(name, part) is not None


def given_paths(part: Part, of: str = "") -> Iterator[str]:
    """Paths of the fields that were written, such as ``surfaces.wave_factor``.

    Those of a nameless piece of a list stand with its number, too, such as ``shaft.modulus`` and
    ``shaft.2.modulus``.

    Parameters
    ----------
    part : Part
    of : str
        The name of a problem: of the pieces of a list that have names, those of that bearing and operating point
        alone count.
    """
    for name in part.model_fields_set:
        value = getattr(part, name)
        if value is None:
            continue
        yield name
        for number, piece in enumerate(value if isinstance(value, tuple) else (value,), start=1):
            own = getattr(piece, "name", None)
            if isinstance(piece, Part) and (piece is value or _is_of(own, of)):
                yield from (f"{name}.{path}" for path in given_paths(piece, of))
                if piece is not value and not own:
                    yield from (f"{name}.{number}.{path}" for path in given_paths(piece, of))


def _is_of(name: str | None, problem: str) -> bool:
    """Whether a piece of a list has no name, or that of the bearing or of the operating point of a problem.

    >>> [_is_of(name, "Wheel [ahead] (mean clearance)") for name in ("Wheel", "Wheel 2", "ahead", "astern", None)]
    [True, False, True, False, True]
    """
    return not name or problem == name or problem.startswith((f"{name} [", f"{name} (")) or f"[{name}]" in problem


def not_read(part: Part, why: str, *paths: str) -> Iterator[Notice]:
    """Report fields that are given and that nothing reads.

    Parameters
    ----------
    part : Part
    why : str
        The variant of the message of W183.
    *paths : str
        From the part, such as ``pads.mass``.
    """
    if given := tuple(path for path in paths if _is_given_at(part, path)):
        yield Notice("W183", why, {"fields": given})


def _is_given_at(part: Part, path: str) -> bool:
    """As `is_given`, for a field of a block, too."""
    name, _, rest = path.partition(".")
    return is_given(part, name) and (not rest or _is_given_at(getattr(part, name), rest))


def named_once(names: Iterable[str | None], what: str, field: str) -> Iterator[Issue]:
    """Complain of entries of a list that are named as one before them."""
    seen: set[str] = set()
    for index, name in enumerate(names):
        if name in seen:
            yield Issue((field, index, "name"), f"another {what} is named '{name}' too", "each name once")
        seen |= {name} if name is not None else set()


def exactly_one(part: Part, *names: str) -> Iterator[Issue]:
    """Complain unless exactly one of some fields is given."""
    given = [name for name in names if is_given(part, name)]
    if not given:
        yield Issue(
            (),
            f"none of {', '.join(names)} is given",
            f"exactly one of {', '.join(names)}",
            code="E003",
            lacks=names[:1],
        )
    yield from at_most_one(part, *names)


def at_most_one(part: Part, *names: str) -> Iterator[Issue]:
    """Complain if several of some fields are given."""
    first, *others = [name for name in names if is_given(part, name)] or [""]
    for other in others:
        yield Issue((other,), f"given together with {first}", f"one of {', '.join(names)}", "remove one")


def _lines(part: Part, given: Any) -> list[InitErrorDetails]:
    return [_line(issue, given) for issue in broken_rules(part)]


def broken_rules(part: Part) -> Iterator[Issue]:
    """Ask every rule of a part; what one meets as refused is reported at the part, where no rule reports it at
    its field."""
    said, refusals = set(), {}
    for one in type(part).rules:
        try:
            for issue in as_far_as_usable(one(part)):
                said.add(issue.says)
                yield issue
        except InputError as error:
            refusals[error.message] = Issue((), error.message, code=error.code)
    yield from (issue for message, issue in refusals.items() if message not in said)


def _line(issue: Issue, given: Any) -> InitErrorDetails:
    context: dict[str, Any] = {"says": issue.says, "allowed": issue.allowed, "hint": issue.hint}
    context |= {"code": issue.code, "missing": issue.missing}
    return InitErrorDetails(type=PydanticCustomError(ERROR_TYPE, "{says}", context), loc=issue.path, input=given)


def _at_written(details: ErrorDetails, reading: Reading) -> InitErrorDetails:
    """Report a finding at the word that the file has."""
    context: dict[str, Any] = dict(details["ctx"])
    if remark := reading.remark(details["loc"]):
        context["hint"] = "; ".join(filter(None, (context["hint"], remark)))
    error = PydanticCustomError(ERROR_TYPE, "{says}", context)
    return InitErrorDetails(type=error, loc=reading.as_written(details["loc"]), input=details["input"])


def _with_direction(cls: type[Part], given: Mapping[str, Any]) -> tuple[Mapping[str, Any], list[Issue]]:
    """Set the direction of a load that is given by its components, and complain about another one."""
    if not any(metadata_of(cls, "load", LoadOrComponents)):
        return given, []
    if not direction_given_twice(given):
        return with_direction(given), []
    says = "the components of the load give another direction"
    return given, [Issue(("load_angle",), says, "size and direction of the load, or components", "remove it")]


def _given_twice(former: Path, today: Path) -> Issue:
    word = ".".join(map(str, today))
    says = f"is the former word for what {word} says, which is given, too"
    return Issue(former, says, f"{word} alone", "remove one")


def _no_choice(cls: type[Part], path: Path, given: Mapping[str, Any]) -> Issue:
    """Report a key in the mapping of a method that is no choice of it."""
    method, name = str(given[METHOD]), str(path[-1])
    known = choices_of(cls, method)
    if name in every_choice(cls):
        others = ", ".join(one for one in method_models(cls) if name in choices_of(cls, one))
        return Issue(path, f"is no choice of method {method}", f"kind: {others}, or leave it out", code="E003")
    if name in cls.model_fields:
        return Issue(path, "is no choice of a method", f"{name} next to method", code="E003")
    meant = near_typo(name, known)
    hint = f"did you mean '{meant}'?" if meant else ""
    return Issue(path, "is not a field here", "" if hint else ", ".join(known) or "kind alone", hint, "E003")


def usable_part(
    cls: type[PartT], given: Mapping[str, Any], context: Any, misspelt: frozenset[str] = frozenset()
) -> PartT:
    """Give the piece with its usable fields only; to touch one of the others raises AttributeError.

    Fields whose names were misspelt count as written and not usable.
    """
    values: dict[str, Any] = {}
    unusable = set(misspelt)
    given, _ = _with_direction(cls, read_given(cls, given).given)
    for name, field in cls.model_fields.items():
        if name not in given:
            unusable |= {name} if field.is_required() else set()
            continue
        try:
            values[name] = _adapter(cls, name).validate_python(given[name], context=context)
        except ValidationError:
            pieces = _usable_pieces(field.annotation, given[name], context)
            values |= {name: pieces} if pieces else {}
            unusable |= set() if pieces else {name}
    part: Any = cls.model_construct(_fields_set=({*cls.model_fields} & given.keys()) | misspelt, **values)
    for name in unusable:
        vars(part).pop(name, None)
    return part  # type: ignore[no-any-return]


@cache
def _adapter(cls: type[Part], name: str) -> TypeAdapter[Any]:
    return TypeAdapter(cls.model_fields[name].rebuild_annotation())


def _usable_pieces(annotation: Any, given: Any, context: Any) -> tuple[Part, ...]:
    """Give the pieces of a list, each with its usable fields only; nothing if it is no list of pieces."""
    of = typing.get_args(annotation)[0] if typing.get_origin(annotation) is tuple else None
    if not (isinstance(of, type) and issubclass(of, Part) and isinstance(given, list)):
        return ()
    return tuple(usable_part(of, piece, context) for piece in given if isinstance(piece, Mapping))
