"""Files are written whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from babbitt.notices import InputError


def write_whole(path: Path, content: bytes) -> None:
    """Write a file so that it is there complete or, after any failure, as it was before.

    Parameters
    ----------
    path : Path
        Its folder must exist.
    content : bytes

    Raises
    ------
    InputError
        E007 naming the path and what the operating system says.
    """
    require_writable(path)
    path = path.resolve()  # a link stays a link; what it points to is written
    if path.exists() and not path.is_file():  # a device or a pipe takes the content as it comes
        _write_through(path, content)
        return
    partial: Path | None = None
    try:
        handle, name = tempfile.mkstemp(prefix=f".{path.name[:40]}.", dir=path.parent)
        partial = Path(name)
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        partial.chmod(0o666 & ~_umask())
        partial.replace(path)
    except OSError as error:
        raise InputError("E007", f"cannot write {path}: {error.strerror or error}") from None
    finally:
        if partial is not None:
            with suppress(OSError):
                partial.unlink()


def write_into(folder: Path, files: Mapping[str, bytes]) -> tuple[Path, ...]:
    """Write files into a folder, which is made if it does not exist and there are any; where they are now.

    Raises
    ------
    InputError
        E007 if the folder cannot be made or a file not be written.
    """
    if not files:
        return ()
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError("E007", f"cannot make the folder {folder}: {error.strerror}") from None
    for name, content in files.items():
        write_whole(folder / name, content)
    return tuple(folder / name for name in files)


def _write_through(path: Path, content: bytes) -> None:
    try:
        with path.open("wb") as file:
            file.write(content)
    except OSError as error:
        raise InputError("E007", f"cannot write {path}: {error.strerror or error}") from None


def _umask() -> int:
    """Permissions that the user withholds; reading them means setting them, so they are set back at once."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask


def require_writable(path: Path) -> None:
    """Find out before any work is done whether a file can be written.

    Raises
    ------
    InputError
        E007 if the folder does not exist or may not be written to, or the path is a folder.
    """
    if not path.parent.is_dir():
        raise InputError("E007", f"cannot write {path}: the folder {path.parent} does not exist")
    if path.is_dir():
        raise InputError("E007", f"cannot write {path}: it is a folder; name a file in it")
    try:  # the one honest answer: permissions, full disks and odd file systems are all in it
        with tempfile.TemporaryFile(dir=path.parent):
            pass
    except OSError as error:
        raise InputError("E007", f"cannot write {path}: {error.strerror or error}") from None
