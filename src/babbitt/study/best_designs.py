"""The best designs of a study as case files that run."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path

from babbitt.case.with_units import case_text
from babbitt.core.check_text import distance
from babbitt.core.files.marks import is_output, sealed
from babbitt.core.files.printing import printable
from babbitt.core.files.writing import replace_synced, require_folder
from babbitt.core.language import translated
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Verdict
from babbitt.study import design, optimum
from babbitt.study.candidates import Candidate
from babbitt.study.study import Study, case_of

__all__ = [
    "DESIGNS",
    "edges",
    "reasons_of",
    "recommendation",
    "require_designs",
    "require_stored_designs",
    "texts_of_best",
    "verdict_said",
    "write_designs",
]

SAME = 1e-6
"""Relative difference of what counts as one value."""

ALL_KEPT = "keeps every recommendation and usual rule"

DESIGNS = "designs"
"""Folder of the best designs, in that of their study."""

_NAMES = re.compile(r"(?:proposal|design-row)-\d+\.yaml")


def require_designs(folder: Path, option: str) -> None:
    """Find out before any work is done whether designs can be written into a folder, which need not exist.

    Raises
    ------
    InputError
        E007 if it is a file, or holds a case file of the name of a design that Babbitt did not write, or that was
        edited; `option` is named in it.
    """
    require_folder(folder, option)
    theirs = sorted(path.name for path in _designs_in(folder) if not is_output(path))
    if theirs:
        says = f"{printable(', '.join(theirs))} there was edited or is no output of Babbitt; nothing was written"
        raise InputError(
            "E007",
            f"cannot write designs into {printable(folder)}: {says}. "
            f"Name another folder for {option}, or move these files away.",
        )


def _designs_in(folder: Path) -> list[Path]:
    return [path for path in folder.glob("*.yaml") if _NAMES.fullmatch(path.name)]


def require_stored_designs(study: Path | None) -> None:
    """`require_designs` of the folder in which a study is kept, where there is one."""
    if study is not None and (study / DESIGNS).is_dir():
        require_designs(study / DESIGNS, "--out")


def write_designs(study: Study, folder: Path | None = None) -> tuple[Path, ...]:
    """Write the best designs of a study, each as a case file that runs; where they are.

    Parameters
    ----------
    study : Study
        Nothing is written of kinds that seek no designs.
    folder : Path, optional
        By default `DESIGNS` in the folder of the study; nothing is written where it is not stored. Designs of an
        earlier run that nobody has edited are replaced.

    Raises
    ------
    InputError
        E007 as `require_designs`.
    """
    rows = _best_rows(study)
    option = "--out" if folder is None else "--out-dir"
    folder = folder or (None if study.folder is None else study.folder / DESIGNS)
    if folder is None or rows is None:
        return ()
    require_designs(folder, option)
    folder.mkdir(parents=True, exist_ok=True)
    for earlier in _designs_in(folder):
        earlier.unlink()
    texts, asked = texts_of_best(study), study.description["name"]
    for name, (row, said) in rows.items():
        heads = "".join(f"# {line}\n" for line in (f"Row {row} of the study of {asked}", *said))
        replace_synced(folder / f"{name}.yaml", sealed(f"{heads}{texts[name]}"))
    return tuple(folder / f"{name}.yaml" for name in rows)


def texts_of_best(study: Study) -> dict[str, str]:
    """The best designs of a study as texts of cases, by their names, which end with the number in its table."""
    texts = {}
    for name, (row, _) in (_best_rows(study) or {}).items():
        case = case_of(study, row)
        assert case.origin is not None, "it was read just now"
        texts[name] = case_text(case.origin.given)
    return texts


def _best_rows(study: Study) -> dict[str, tuple[int, tuple[str, ...]]] | None:
    """By the name of a file the row of a best design, and what is said of it; None for kinds without designs."""
    match study.kind:
        case "optimise":
            return {f"design-row-{row}": (row, ()) for row in optimum.optimum_of(study).rows}
        case "design":
            found = enumerate(design.designs_of(study).proposals, 1)
            return {f"proposal-{place}": (one.row, _heads(study, place, one, by)) for place, (one, by) in found}
    return None


def _heads(study: Study, place: int, one: Candidate, again: Candidate) -> tuple[str, ...]:
    """What stands above the case of a proposal: whether it is the recommended one, verdicts, and reasons."""
    first, second = design.rules_of(study.description["kind"]).METHODS
    head = (f"Recommended: {recommendation(study)}",) if place == 1 else ()
    verdicts = f"by {first}: {verdict_said(one)}; by {second}: {verdict_said(again)}"
    return (*head, verdicts, *reasons_of(study, one))


def recommendation(study: Study) -> str:
    """The first proposal in one line: its margins, its power, its remarks."""
    (one, again), *_ = design.designs_of(study).proposals
    first, second = design.rules_of(study.description["kind"]).METHODS
    power = QUANTITIES["friction_power"].with_unit(one.power)
    margins = f" {translated('and')} ".join(
        translated(
            "{margin} ({code}) by {method}",
            margin=distance(each.margin, each.kelvin),
            code=each.code,
            method=method,
        )
        for each, method in ((one, first), (again, second))
    )
    remarks = ", ".join(dict.fromkeys((*one.remarks, *again.remarks)))
    passes = translated("passes without remarks")
    if remarks:
        passes = translated("passes with remarks ({codes})", codes=remarks)
    missed = (
        translated("misses {codes}", codes=", ".join(one.departures)) if one.departures else translated(ALL_KEPT)
    )
    return translated(
        "no. 1 {passes}, margin {margins}, friction {power}; it {missed}",
        passes=passes,
        margins=margins,
        power=power,
        missed=missed,
    )


def verdict_said(one: Candidate) -> str:
    """The verdict of a design, with the codes of its remarks.

    >>> verdict_said(Candidate(0, {}, "remarks", "C104", 0.2, 1.0, 1.0, ({},), ("W190",), ()))
    'pass with remarks W190'
    """
    said = translated(Verdict[one.verdict.upper()].value)
    return f"{said} {', '.join(one.remarks)}".strip() if one.within else said


def edges(study: Study) -> Iterator[str]:
    """Which proposals lie at an end of what was tried, and what sets that end."""
    found = design.designs_of(study)
    reasons = {one["path"]: one["reason"] for one in study.inputs}
    for path, (quantity, least, most) in design.rules_of(study.description["kind"]).EDGES.items():
        tried = [value for one in found.tried if math.isfinite(value := one.values[quantity])]
        if path not in reasons or not tried or math.isclose(min(tried), max(tried), rel_tol=SAME):
            continue
        for word, end in ((least, min(tried)), (most, max(tried))):
            at = [
                str(place)
                for place, (one, _) in enumerate(found.proposals, 1)
                if math.isclose(one.values[quantity], end, rel_tol=SAME)
            ]
            if at:
                name = path.rpartition(".")[2].replace("_", " ")
                yield translated(
                    "No. {numbers}: the {end} that was tried ({reason})",
                    numbers=", ".join(at),
                    end=translated(f"{word} {name}"),
                    reason=translated(reasons[path]),
                )


def reasons_of(study: Study, one: Candidate) -> tuple[str, ...]:
    """Why a proposed design is as it is."""
    limits = {check["code"]: check["limit"] for check in study.description["checks"]}
    return tuple(design.rules_of(study.description["kind"]).reasons(one.lines, limits))
