"""The range in which a size is sought, as the command line takes it."""

from __future__ import annotations

from babbitt.case.variation import CaseVariation
from babbitt.core.notices import InputError
from babbitt.core.units.kinds import kind_of
from babbitt.study.size import DECADE, Scan, scan_values
from babbitt.study.sweep_values import values_of

__all__ = ["range_of"]


def range_of(variation: CaseVariation, first: str | None, last: str | None, points: int) -> Scan:
    """Read the ends of a range; each that is not given lies a decade from what the case has in the field.

    Raises
    ------
    InputError
        E003 for ends that are no quantities of one kind, and where one is needed: the case has no positive number
        in the field, or a temperature, of which a decade means nothing.
    """
    path, own = variation.path, variation.present
    given = "" if own is None or isinstance(own, dict | list | bool) else str(own).strip()
    text = first or last or given
    if not text:
        raise InputError("E003", f"the case has no number in '{path}'; give --from and --to")
    read = values_of(f"{first or text}, {last or text}")
    if read.numbers is None:
        says = f"'{text}' in '{path}' is no quantity"
        raise InputError("E003", f"{says}; give --from and --to, or words with --among")
    present = read.number_of(given) if given else None
    kind = kind_of(read.unit) if read.unit else None
    decade = present if present is not None and present > 0.0 and not (kind and kind.offsets) else None
    if decade is None and (first is None or last is None):
        raise InputError("E003", f"a decade about the value of '{path}' means nothing; give --from and --to")
    low = read.numbers[0] if first is not None else (decade or 0.0) / DECADE
    high = read.numbers[1] if last is not None else (decade or 0.0) * DECADE
    unit = read.unit
    return Scan(scan_values(low, high, points), unit, present, lambda value: f"{value:.15g} {unit}".strip())
