"""The one way in which files are written: whole or not at all, and only over an earlier output of Babbitt."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path

from babbitt.core.files.marks import is_output
from babbitt.core.files.printing import printable
from babbitt.core.notices import InputError

__all__ = [
    "create_file",
    "UNFINISHED",
    "discard_unfinished",
    "replace_synced",
    "require_distinct",
    "require_folder",
    "require_writable",
    "write_file",
    "write_files",
    "write_text",
]

UNFINISHED = ".babbitt-"
"""How the name of a file begins while its content is still being written."""

_UNFINISHED: set[Path] = set()
"""Files beside their target whose content is still being written."""


def write_file(path: str | Path, content: bytes) -> None:
    """Write a file so that it is there complete or, after any failure, as it was before.

    Parameters
    ----------
    path : str or Path
        Its folder must exist. An output of an earlier run is replaced; a link stays a link, and what it points to
        is written. A device or a pipe takes the content as it comes.
    content : bytes

    Raises
    ------
    InputError
        E007 as `require_writable`, or naming what the operating system says.
    """
    path = Path(path)
    require_writable(path)
    target = path.resolve()
    if target.exists() and not target.is_file():
        _write_through(target, content)
        return
    unfinished = _write_beside(target, path, content)
    try:
        unfinished.replace(target)
    except OSError as error:
        raise _cannot_write(path, error) from None
    finally:
        _discard(unfinished)


def write_text(path: str | Path, text: str) -> None:
    """Write a UTF-8 file with the line ends as they stand in the text; raises as `write_file`."""
    write_file(path, text.encode())


def replace_synced(path: Path, content: bytes) -> None:
    """Write a file of a folder that is Babbitt's own: beside its place, brought to disk, then renamed.

    After a kill or a loss of power the file is there complete, or as it was before.

    Raises
    ------
    InputError
        E007 naming what the operating system says, such as of a full disk.
    """
    unfinished = _write_beside(path, path, content)
    try:
        with unfinished.open("rb+") as file:
            os.fsync(file.fileno())
        unfinished.replace(path)
        _sync_folder(path.parent)
    except OSError as error:
        raise _cannot_write(path, error) from None
    finally:
        _discard(unfinished)


def _sync_folder(folder: Path) -> None:
    """Bring a renaming to disk; some systems know no such thing of folders."""
    with suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def create_file(path: str | Path, content: bytes) -> None:
    """Write a file that does not exist yet: it is there complete or, after any failure, not at all.

    Parameters
    ----------
    path : str or Path
        Its folder must exist. Nothing of that name may exist, not even a link that leads nowhere.
    content : bytes

    Raises
    ------
    InputError
        E007 for a path that exists or cannot be written.
    """
    path = Path(path)
    _require_folder(path)
    exists = InputError("E007", f"{printable(path)} exists already; nothing was overwritten. Choose another name.")
    if os.path.lexists(path):
        raise exists
    unfinished = _write_beside(path, path, content)
    try:
        try:
            os.link(unfinished, path)  # unlike a move it fails where something has come to stand there meanwhile
        except FileExistsError:
            raise exists from None
        except OSError:  # a file system without links
            _create_in_place(path, content, exists)
    finally:
        _discard(unfinished)


def write_files(folder: Path, files: Mapping[str, bytes]) -> tuple[Path, ...]:
    """Write files into a folder, which is made if it does not exist and there are any; where they are now.

    Raises
    ------
    InputError
        E007 if the folder cannot be made or one of the files cannot be written; none is written where one may not
        be replaced.
    """
    if not files:
        return ()
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        says = error.strerror or error
        raise InputError("E007", f"cannot make the folder {printable(folder)}: {says}") from None
    paths = tuple(folder / name for name in files)
    for path in paths:
        require_writable(path)
    for path, content in zip(paths, files.values(), strict=True):
        write_file(path, content)
    return paths


def require_writable(path: Path) -> None:
    """Find out before any work is done whether a file can be written.

    Raises
    ------
    InputError
        E007 if the folder does not exist or may not be written to, if the path is a folder, or if a file stands
        there that is no output of Babbitt or may not be changed.
    """
    _require_folder(path)
    if path.is_dir():
        raise InputError("E007", f"cannot write {printable(path)}: it is a folder; name a file in it")
    if not path.is_file():
        return
    if not is_output(path):
        raise InputError(
            "E007",
            f"cannot write {printable(path)}: a file of that name exists and is no output of Babbitt; nothing was "
            "written. Choose another name, or move that file away.",
        )
    if not os.access(path, os.W_OK):
        raise InputError("E007", f"cannot write {printable(path)}: the file is read-only")


def require_folder(folder: Path, option: str) -> None:
    """Find out before any work is done whether files can be written into a folder, which need not exist.

    Raises
    ------
    InputError
        E007 if a file stands there or on the way, or nothing can be written; `option` is named in it.
    """
    found = folder
    while not found.exists() and found != found.parent:
        found = found.parent
    if found.exists() and not found.is_dir():
        it = "it" if found == folder else printable(found)
        raise InputError("E007", f"cannot write {printable(folder)}: {it} is a file; {option} names a folder")
    _require_folder(found / "file")


def require_distinct(targets: Iterable[Path], inputs: Mapping[Path, str]) -> None:
    """Refuse an output that would replace an input or another output of the same run.

    Parameters
    ----------
    targets : iterable of Path
        Each output.
    inputs : mapping of Path to str
        Each file that the run reads, and what it is, such as "a case file".

    Raises
    ------
    InputError
        E007 naming the path and what it is.
    """
    taken = {_identity(path): what for path, what in inputs.items()}
    for path in targets:
        identity = _identity(path)
        if identity in taken:
            what = taken[identity]
            raise InputError(
                "E007",
                f"cannot write {printable(path)}: it is {what}; nothing was written. Give each output, and each "
                "input, a name of its own.",
            )
        taken[identity] = "the target of another output"


def discard_unfinished() -> None:
    """Remove what an interrupted run has begun to write."""
    for path in tuple(_UNFINISHED):
        _discard(path)


def _identity(path: Path) -> Path | tuple[int, int]:
    """The file itself where there is one, whatever leads to it; else the place that the name means."""
    try:
        found = path.stat()
    except (OSError, ValueError):
        return path.resolve()
    return (found.st_dev, found.st_ino)


def _require_folder(path: Path) -> None:
    if "\0" in str(path):
        raise InputError("E007", f"cannot write {printable(path)}: the name holds a null character")
    if not path.parent.is_dir():
        folder = printable(path.parent)
        says = f"{folder} is a file, no folder" if path.parent.exists() else f"the folder {folder} does not exist"
        raise InputError("E007", f"cannot write {printable(path)}: {says}")
    if path.exists() and not path.is_file():
        return  # a folder is refused elsewhere; a device or a pipe needs no place beside it
    try:  # nothing else tells of permissions, full disks and odd file systems at once
        with tempfile.TemporaryFile(dir=path.resolve().parent):
            pass
    except OSError as error:
        raise _cannot_write(path, error) from None


def _write_beside(target: Path, named: Path, content: bytes) -> Path:
    """A file with the content in the folder of the target, of a name that nobody else uses."""
    unfinished: Path | None = None
    try:
        handle, name = tempfile.mkstemp(prefix=UNFINISHED, dir=target.parent)
        unfinished = Path(name)
        _UNFINISHED.add(unfinished)
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        unfinished.chmod(0o666 & ~_umask())
    except OSError as error:
        if unfinished is not None:
            _discard(unfinished)
        raise _cannot_write(named, error) from None
    except BaseException:
        if unfinished is not None:
            _discard(unfinished)
        raise
    return unfinished


def _create_in_place(path: Path, content: bytes, exists: InputError) -> None:
    try:
        file = path.open("xb")
    except FileExistsError:
        raise exists from None
    except OSError as error:
        raise _cannot_write(path, error) from None
    try:
        with file:
            file.write(content)
    except BaseException as error:  # closed by now: some systems remove no file that is open
        _discard(path)
        if isinstance(error, OSError):
            raise _cannot_write(path, error) from None
        raise


def _write_through(path: Path, content: bytes) -> None:
    try:
        with path.open("wb") as file:
            file.write(content)
    except OSError as error:
        raise _cannot_write(path, error) from None


def _discard(path: Path) -> None:
    with suppress(OSError):
        path.unlink()
    _UNFINISHED.discard(path)


def _cannot_write(path: Path, error: OSError) -> InputError:
    return InputError("E007", f"cannot write {printable(path)}: {error.strerror or error}")


def _umask() -> int:
    """Permissions that the user withholds; reading them means setting them, so they are set back at once."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask
