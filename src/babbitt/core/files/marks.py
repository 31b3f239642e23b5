"""How an earlier output of Babbitt is distinguished from any other file.

Every format that Babbitt writes carries a mark where the format has a place for one, and where it has none a
beginning that Babbitt alone writes:

========== ==========================================================================================
format     mark
========== ==========================================================================================
JSON       begins with the key ``babbitt`` and the version as text, or with ``babbitt_coefficients``
           (the version of a case file is a number)
ROSS       block ``babbitt`` with ``ross_version`` in a bearing element
CSV        names of the first columns, ``..., bearing, status`` or ``bearing, method``; of a study the first
           and the last nine (formerly eight, without codes); a table with a row of units has the line of its
           frame above it
Ansys      the second title declares the frame
HTML       ``<meta name="generator" content="Babbitt ...">`` in the head
PDF        keyword (report) or creator (figure) ``Babbitt`` in the document information
SVG, PNG   creator ``Babbitt`` in the metadata
XLSX       creator ``Babbitt``, and nobody has changed the workbook since
NetCDF     attribute ``source`` of the file
case file  the first line has the digest of all that follows: one of a design that nobody has edited
========== ==========================================================================================

A file without content is no output, nor is one that was written before a format had its mark.
"""

from __future__ import annotations

import hashlib
import mmap
import re
import zipfile
from pathlib import Path

__all__ = ["CREATOR", "is_output", "sealed"]

CREATOR = "Babbitt"
"""What formats with a place for the name of the program get."""

_SEAL = b"# Babbitt, SHA-256 of what follows: "
"""How a case file begins that may be replaced as long as it is as it was written."""

_FRAME = rb"rotation (?:counter-)?clockwise, x axis at "
_START = rb'(?:"[^"\n]*"|[^,"\n]*)'

_MARKS = tuple(
    re.compile(pattern)
    for pattern in (
        rb'\A\{\s*"babbitt":\s*"[^"]*",\s*"case":',
        rb'\A\{\s*"babbitt_coefficients":\s*\d',
        rb'\A\{\s*"BearingElement_[^\0]*?"babbitt":\s*\{\s*"ross_version":',
        rb'\A\[(?:"BearingElement_|BearingElement_)[^\0]*?\.babbitt\]\nross_version = ',
        rb"\A(?:" + _START + rb",){1,20}bearing,status[,\n]",
        rb"\Arow,[^\n]*,margin,group,bearing,verdict,governing_check,failed_checks,(?:codes,)?status,message\n",
        rb"\Abearing,method,(?:temperatures,)?rotation,",
        rb'\ABearing,[^\n]*\nFrame,"' + _FRAME,
        rb"\A[^\n]{0,400}\n" + _FRAME,
        rb'(?s)\A<!DOCTYPE html>.{0,2000}?<meta name="generator" content="Babbitt ',
        rb"(?s)\A<\?xml.{0,2000}?<dc:creator>.{0,200}?<dc:title>Babbitt</dc:title>",
        rb"(?s)\A\x89PNG.{0,2000}?tEXtSoftware\0Babbitt",
        rb"(?s)\A%PDF-.*?/(?:Keywords|Creator) ?\(Babbitt[ )]",
    )
)


def is_output(path: Path) -> bool:
    """Whether a file is an output of Babbitt, by the mark it carries.

    Parameters
    ----------
    path : Path
        Of a regular file; one that cannot be read is taken for somebody else's.
    """
    try:
        with path.open("rb") as file:
            start = file.read(8)
            if not start:
                return False
            if start.startswith(b"PK"):
                return _is_workbook(path)
            if start == _SEAL[: len(start)] and _is_sealed(path):
                return True
            if start == b"\x89HDF\r\n\x1a\n":
                return _is_netcdf(path)
            with mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as content:
                return any(mark.search(content) for mark in _MARKS)
    except (OSError, ValueError):
        return False


def sealed(text: str) -> bytes:
    """A case file whose first line is the digest of the rest: it counts as an output until somebody edits it.

    >>> print(sealed("kind: journal\\n").decode()[:53])
    # Babbitt, SHA-256 of what follows: 84e9daadefe467d9a
    """
    content = text.encode()
    return _SEAL + hashlib.sha256(content).hexdigest().encode() + b"\n" + content


def _is_sealed(path: Path) -> bool:
    """Whether nobody has edited a case file that `sealed` began."""
    first, _, rest = path.read_bytes().partition(b"\n")
    return first == _SEAL + hashlib.sha256(rest).hexdigest().encode()


def _is_workbook(path: Path) -> bool:
    """Whether Babbitt made a workbook and no spreadsheet program has saved it since."""
    try:
        with zipfile.ZipFile(path) as book, book.open("docProps/core.xml") as file:
            core = file.read(10_000)
    except (OSError, EOFError, KeyError, ValueError, RuntimeError, NotImplementedError, zipfile.BadZipFile):
        return False
    made = f"<dc:creator>{CREATOR}</dc:creator>".encode() in core
    return made and b"lastModifiedBy" not in core and b"revision" not in core


def _is_netcdf(path: Path) -> bool:
    try:
        import h5py
    except ImportError:  # without it no NetCDF can be written either
        return False
    try:
        with h5py.File(path, "r") as file:
            source = file.attrs.get("source", b"")
    except (OSError, ValueError, RuntimeError):
        return False
    text = source.decode(errors="replace") if isinstance(source, bytes) else str(source)
    return text.startswith(f"{CREATOR} ")
