"""The two file formats of ROSS, JSON and TOML: named blocks of numbers, texts and lists."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from babbitt.core.files.bounded_text import loads_json, loads_toml
from babbitt.core.files.reading import read_text
from babbitt.core.files.writing import write_text
from babbitt.core.notices import InputError

Block = dict[str, Any]


def write_blocks(path: Path, blocks: dict[str, Block]) -> None:
    """Write blocks in the format of the suffix.

    Raises
    ------
    InputError
        E003 for another suffix, E007 when the file cannot be written.
    """
    if _is_json(path):
        write_text(path, json.dumps(blocks, indent=2, ensure_ascii=False, allow_nan=False) + "\n")
    else:
        write_text(
            path, "\n".join("\n".join(_toml_lines(_key(name), block)) + "\n" for name, block in blocks.items())
        )


def read_blocks(path: Path) -> dict[str, Any]:
    """Everything in a file, by the name of its block.

    Raises
    ------
    InputError
        E001 for an unreadable file, E003 for another suffix or for text that is not of the format.
    """
    load = loads_json if _is_json(path) else loads_toml
    text = read_text(path)
    try:
        content = load(text)
    except ValueError as error:
        raise InputError("E003", f"{path}: not {path.suffix[1:].upper()} ({error})") from None
    return content if isinstance(content, dict) else {}


def _is_json(path: Path) -> bool:
    if path.suffix.lower() not in (".json", ".toml"):
        raise InputError("E003", f"{path}: ROSS tells its formats by the suffix; use .json or .toml")
    return path.suffix.lower() == ".json"


_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


def _key(name: str) -> str:
    return name if _BARE_KEY.fullmatch(name) else json.dumps(name, ensure_ascii=False)


def _toml_lines(path: str, block: Block) -> list[str]:
    """A block and the blocks inside it; JSON spells texts, numbers and lists as TOML does."""
    lines = [f"[{path}]"]
    inner = {name: value for name, value in block.items() if isinstance(value, dict)}
    for name, value in block.items():
        if name not in inner and value is not None:
            lines.append(f"{_key(name)} = {json.dumps(value, ensure_ascii=False)}")
    for name, value in inner.items():
        lines += ["", *_toml_lines(f"{path}.{_key(name)}", value)]
    return lines
