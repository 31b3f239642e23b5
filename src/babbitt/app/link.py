"""A case in the fragment of an address: compressed, and stored nowhere else."""

from __future__ import annotations

import base64
import binascii
import zlib

from babbitt.case.loading import LARGEST_FILE

__all__ = ["case_of", "link_of"]

MARK = "case="


def link_of(text: str) -> str:
    """The fragment of an address that holds a case.

    >>> case_of("#" + link_of("kind: journal"))
    'kind: journal'
    """
    return MARK + base64.urlsafe_b64encode(zlib.compress(text.encode(), 9)).decode().rstrip("=")


def case_of(fragment: str) -> str | None:
    """The case of a fragment; None where it holds none that can be read."""
    packed = fragment.removeprefix("#")
    if not packed.startswith(MARK):
        return None
    packed = packed.removeprefix(MARK)
    try:
        opened = zlib.decompressobj()
        text = opened.decompress(base64.urlsafe_b64decode(packed + "=" * (-len(packed) % 4)), LARGEST_FILE + 1)
        return text.decode() if opened.eof and len(text) <= LARGEST_FILE else None
    except (binascii.Error, zlib.error, ValueError):
        return None
