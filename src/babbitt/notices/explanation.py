"""What a code means."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Effect(Enum):
    """What a warning does to the verdict of the result that carries it."""

    INFORMATION = "listed, changes no verdict"
    QUESTIONS_RESULT = "limits that are kept are kept with remarks"
    NO_VERDICT = "outside the validity of the model: no verdict"


@dataclass(frozen=True)
class Explanation:
    """What a code means, what to do about it and what it does to the verdict."""

    title: str
    meaning: str
    remedy: str
    effect: Effect = Effect.QUESTIONS_RESULT
