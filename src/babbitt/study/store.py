"""The folder of a study: what was asked, and the chunks that are finished, each whole or not there.

``name.study/study.json`` tells the case and the plan; ``name.study/chunks/part-000123.parquet`` holds the rows of
a chunk. A chunk is written under a temporary name, brought to disk, and renamed. Whoever writes holds a lock that
the system drops with the process.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from typing import IO, Any

import numpy as np

from babbitt.core.files.printing import printable
from babbitt.core.files.writing import UNFINISHED, replace_synced
from babbitt.core.notices import InputError
from babbitt.core.optional_package import how_to_install, optional_package
from babbitt.core.quantities import QUANTITIES
from babbitt.study.inputs import Input
from babbitt.study.rows import Columns

__all__ = ["Store", "pyarrow_library"]

SUFFIX = ".study"
DESCRIPTION, CHUNKS, LOCK = "study.json", "chunks", ".lock"

FORMAT = 1
"""Version of the folder."""

COMPARED = {
    "format": "the version of the folder",
    "babbitt": "the version of Babbitt",
    "case_hash": "the case",
    "study": "the study",
    "inputs": "the distributions",
    "outputs": "the outputs",
}
"""What of the description must agree for a study to be resumed, and what to call it."""


class Store:
    """A folder of a study.

    Parameters
    ----------
    folder : Path

    Raises
    ------
    InputError
        E007 where pyarrow is not installed.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.arrow = pyarrow_library()
        self._lock: IO[bytes] | None = None

    @property
    def description(self) -> dict[str, Any]:
        """What stands in ``study.json``.

        Raises
        ------
        InputError
            E007 for a folder that holds no study.
        """
        file = self.folder / DESCRIPTION
        try:
            told = json.loads(file.read_text(encoding="utf-8"))
        except FileNotFoundError:
            raise InputError(
                "E007", f"{printable(self.folder)} holds no study: there is no {DESCRIPTION}"
            ) from None
        except (OSError, ValueError) as error:
            raise InputError("E007", f"{printable(file)} cannot be read: {error}") from None
        if not isinstance(told, dict) or told.get("format") != FORMAT:
            raise InputError("E007", f"{printable(file)} is of another version of Babbitt, or no study")
        return told

    def begin(self, wanted: Mapping[str, Any]) -> dict[str, Any]:
        """Take the folder for writing: make it, or find in it the same study.

        Parameters
        ----------
        wanted : mapping
            The description; what is not compared is taken from the folder where it has been begun.

        Returns
        -------
        dict
            The description that stands in the folder.

        Raises
        ------
        InputError
            E007 for a folder that cannot be written, holds something else, another study, or is in use.
        """
        try:
            self._require_own()
            (self.folder / CHUNKS).mkdir(parents=True, exist_ok=True)
            self._take_lock()
            if (self.folder / DESCRIPTION).exists():
                return self._same(wanted)
            replace_synced(self.folder / DESCRIPTION, (json.dumps(wanted, indent=1) + "\n").encode())
        except OSError as error:
            self.close()
            says = f"cannot write into {printable(self.folder)}: {error.strerror or error}"
            raise InputError("E007", says) from None
        except InputError:
            self.close()
            raise
        return dict(wanted)

    def _require_own(self) -> None:
        """Refuse a folder with something else in it; what a run has left that was killed at once is none."""
        if not self.folder.exists() or (self.folder / DESCRIPTION).exists():
            return
        strange = [one for one in self.folder.iterdir() if one.name not in (CHUNKS, LOCK)]
        if any(not one.name.startswith(UNFINISHED) for one in strange) or any(self.parts):
            raise InputError("E007", f"{printable(self.folder)} exists and holds no study; choose another --out")

    def _same(self, wanted: Mapping[str, Any]) -> dict[str, Any]:
        """The description that stands in the folder, if it is that of the same study."""
        present = self.description
        differ = [
            name for key, name in COMPARED.items() if present.get(key) != json.loads(json.dumps(wanted[key]))
        ]
        if differ:
            said = " and ".join(differ) if len(differ) < 3 else f"{', '.join(differ[:-1])} and {differ[-1]}"
            made = f"made by Babbitt {present.get('babbitt')}"
            hint = "choose another --out, or delete the folder"
            says = f"{printable(self.folder)} ({made}) differs in {said}; {hint}"
            raise InputError("E007", says)
        return present

    def close(self) -> None:
        """Give the lock back."""
        if self._lock is not None:
            self._lock.close()
            self._lock = None

    def part(self, number: int) -> Path:
        """Where a chunk stands."""
        return self.folder / CHUNKS / f"part-{number:06d}.parquet"

    @property
    def parts(self) -> list[Path]:
        """The finished chunks, in their order."""
        return sorted((self.folder / CHUNKS).glob("part-*.parquet"))

    def write(self, number: int, columns: Columns, inputs: tuple[Input, ...]) -> None:
        """Store a chunk.

        Raises
        ------
        InputError
            E007 where it cannot be written, such as on a full disk; what was stored stays readable.
        """
        stream = self.arrow.BufferOutputStream()
        parquet = optional_package("pyarrow.parquet", "stored studies", INSTALL)
        parquet.write_table(self._table(columns, inputs), stream, compression="zstd")
        try:
            replace_synced(self.part(number), stream.getvalue().to_pybytes())
        except InputError as error:
            raise InputError("E007", f"{error.message}; the finished chunks are kept") from None

    def read(self, number: int) -> Columns | None:
        """A finished chunk; None where it is not finished."""
        return self._read(self.part(number)) if self.part(number).is_file() else None

    def table(self) -> Columns:
        """All finished chunks, one below the other.

        Raises
        ------
        InputError
            E007 where there is none.
        """
        parts = [self._read(part) for part in self.parts]
        if not parts:
            raise InputError("E007", f"{printable(self.folder)} has no finished chunk yet")
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}

    def _read(self, part: Path) -> Columns:
        parquet = optional_package("pyarrow.parquet", "stored studies", INSTALL)
        try:
            table = parquet.read_table(part)
        except (OSError, self.arrow.ArrowException) as error:
            raise InputError("E007", f"{printable(part)} cannot be read: {error}") from None
        made: Columns = {}
        for name in table.column_names:
            column = table.column(name)
            if self.arrow.types.is_string(column.type) or self.arrow.types.is_dictionary(column.type):
                made[name] = np.array(column.to_pylist(), object)
            else:
                made[name] = column.to_numpy()
        return made

    def _table(self, columns: Columns, inputs: tuple[Input, ...]) -> Any:
        units = {one.path: one.unit for one in inputs}
        fields, arrays = [], []
        for name, values in columns.items():
            unit = units.get(name, QUANTITIES[name].unit if name in QUANTITIES else "")
            words = values.dtype == object
            of = self.arrow.string() if words else self.arrow.from_numpy_dtype(values.dtype)
            fields.append(self.arrow.field(name, of, metadata={"unit": unit} if unit else None))
            arrays.append(self.arrow.array(values.tolist() if words else values, type=of))
        return self.arrow.Table.from_arrays(arrays, schema=self.arrow.schema(fields))

    def _take_lock(self) -> None:
        lock = (self.folder / LOCK).open("ab+")
        try:
            _lock(lock)
        except OSError:
            lock.close()
            says = f"{printable(self.folder)} is in use: another run writes into it"
            raise InputError("E007", says) from None
        self._lock = lock
        for left in (self.folder / CHUNKS).glob(f"{UNFINISHED}*"):  # of a run that was killed; nobody else writes
            with suppress(OSError):
                left.unlink()


def _lock(file: IO[bytes]) -> None:
    """Lock a file until it is closed, at the latest by the system with the end of the process.

    Raises
    ------
    OSError
        Where another process holds the lock.
    """
    if os.name == "nt":
        locks = import_module("msvcrt")
        file.seek(0)
        locks.locking(file.fileno(), locks.LK_NBLCK, 1)
    else:
        locks = import_module("fcntl")
        locks.flock(file, locks.LOCK_EX | locks.LOCK_NB)


INSTALL = how_to_install("pyarrow", "studies")


def pyarrow_library() -> Any:
    """The package pyarrow.

    Raises
    ------
    InputError
        E007 where it is not installed.
    """
    return optional_package("pyarrow", "stored studies", INSTALL)
