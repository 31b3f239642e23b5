"""What a code means."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Effect(Enum):
    """What a warning does to the verdict of the result that carries it."""

    INFORMATION = "listed, changes no verdict"
    QUESTIONS_RESULT = "limits that are kept are kept with remarks"
    NO_VERDICT = "outside the validity of the model: no verdict"


class Subject(Enum):
    """What a bearing cannot be passed without a check of."""

    FILM_THICKNESS = "film thickness"
    TEMPERATURE = "temperature"
    SPECIFIC_LOAD = "specific load"
    PROBE_TEMPERATURE = "temperature of a probe"


@dataclass(frozen=True)
class Explanation:
    """What a code means, what to do about it and what it does to the verdict.

    Attributes
    ----------
    title, meaning, remedy : str
        What it is, what it says in general, and what can be done.
    effect : Effect
        Of a warning.
    subject : Subject or None
        Of a check: which of these it is one of. Where a kind lists such a check as not made, and no other of
        the same subject was made, there is no verdict.
    """

    title: str
    meaning: str
    remedy: str
    effect: Effect = Effect.QUESTIONS_RESULT
    subject: Subject | None = None
