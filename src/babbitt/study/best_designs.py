"""The best designs of a study as case files that run."""

from __future__ import annotations

from pathlib import Path

from babbitt.case.with_units import case_text
from babbitt.core.files.writing import replace_synced
from babbitt.study import design, optimum
from babbitt.study.study import Study, case_of

__all__ = ["DESIGNS", "reasons_of", "write_designs"]

DESIGNS = "designs"
"""Folder of the best designs, in that of their study."""


def write_designs(study: Study, folder: Path | None = None) -> tuple[Path, ...]:
    """Write the best designs of a study, each as a case file that runs; where they are.

    Parameters
    ----------
    study : Study
        Nothing is written of kinds that seek no designs.
    folder : Path, optional
        By default `DESIGNS` in the folder of the study; nothing is written where it is not stored.
    """
    rows = _best_rows(study)
    folder = folder or (None if study.folder is None else study.folder / DESIGNS)
    if folder is None or rows is None:
        return ()
    folder.mkdir(parents=True, exist_ok=True)
    for left in (one for name in rows for one in folder.glob(f"{name.rpartition('-')[0]}-*.yaml")):
        left.unlink(missing_ok=True)
    for name, (row, said) in rows.items():
        case = case_of(study, row)
        assert case.origin is not None, "it was read just now"
        heads = "".join(f"# {line}\n" for line in (f"Row {row} of the study of {case.name}", *said))
        replace_synced(folder / f"{name}.yaml", f"{heads}{case_text(case.origin.given)}".encode())
    return tuple(folder / f"{name}.yaml" for name in rows)


def _best_rows(study: Study) -> dict[str, tuple[int, tuple[str, ...]]] | None:
    """By the name of a file the row of a best design, and what is said of it; None for kinds without designs."""
    match study.kind:
        case "optimise":
            return {f"design-row-{row}": (row, ()) for row in optimum.optimum_of(study).rows}
        case "design":
            found = enumerate(design.designs_of(study).proposals, 1)
            return {f"proposal-{place}": (one.row, reasons_of(study, one)) for place, (one, _) in found}
    return None


def reasons_of(study: Study, one: design.Candidate) -> tuple[str, ...]:
    """Why a proposed design is as it is."""
    limits = {check["code"]: check["limit"] for check in study.description["checks"]}
    return tuple(design.rules_of(study.description["kind"]).reasons(one.values, limits))
