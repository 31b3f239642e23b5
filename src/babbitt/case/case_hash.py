"""The hash of a case, the same for files that say the same."""

from __future__ import annotations

import hashlib
import json
from typing import Any

from babbitt.case.aliases import in_former_words
from babbitt.case.case_file import CaseFile
from babbitt.case.part import Part


def case_hash(case: CaseFile) -> str:
    """SHA-256 of a case in canonical JSON: the same for files that differ only in layout, units and defaults.

    A word that took the place of another counts as the former one, so that hashes outlast it.

    Numbers count to twelve significant digits, beyond which a change of units may leave its traces.

    Parameters
    ----------
    case : CaseFile

    Returns
    -------
    str
        64 hexadecimal digits.
    """
    content = _rounded(_content(case))
    canonical = json.dumps(content, sort_keys=True, separators=(",", ":"), ensure_ascii=True, allow_nan=False)
    return hashlib.sha256(canonical.encode("ascii")).hexdigest()


def _content(value: Any) -> Any:
    """Mappings and lists in former words, fields that have their default left out."""
    match value:
        case Part():
            fields, content = type(value).model_fields, vars(value)
            pairs = ((name, _content(content[name]), fields[name]) for name in fields)
            given = {
                name: own
                for name, own, field in pairs
                if field.is_required() or _rounded(own) != _rounded(_content(field.default))
            }
            return in_former_words(type(value), given)
        case tuple():
            return [_content(one) for one in value]
        case _:
            return value


def _rounded(value: Any) -> Any:
    """The same with floats to twelve significant digits."""
    match value:
        case float():
            return float(f"{value:.12g}")
        case dict():
            return {name: _rounded(one) for name, one in value.items()}
        case list():
            return [_rounded(one) for one in value]
        case _:
            return value
