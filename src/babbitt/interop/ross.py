"""Bearing elements of ROSS (rotordynamic open source software) as JSON or TOML, for its versions 2 and 3.

A file holds ``BearingElement_<tag>``: node, axis, and one list for each coefficient in N/m, N s/m and kg, axis in
rad/s, x horizontal, y vertical, speed positive from x towards y. What differs is the name of the axis. Version 2
calls the axis of rotor speed ``frequency``; version 3 calls it ``speed`` and keeps ``frequency`` for the whirl
frequency. A file of one version loaded by the other is read without a complaint and puts the dependence on the wrong
axis, or drops it, so the version is never guessed here, neither when writing nor when reading.

References
----------
ROSS documentation, https://ross.readthedocs.io, class BearingElement in versions 2.3 and 3.1.
"""

from __future__ import annotations

import json
import re
import tomllib
from enum import IntEnum
from pathlib import Path
from typing import Any

import numpy as np

from babbitt.interop.coefficients import NAMES, Array, CoefficientTable
from babbitt.interop.files import read_text, write_text
from babbitt.interop.frame import Frame, declaration, settled
from babbitt.interop.frames import for_rotor_programs
from babbitt.interop.json_file import frame_from, frame_record, static_from, static_record
from babbitt.notices import InputError

BLOCK = "BearingElement_"
RECOMMENDED_SPEEDS = 5
"""Fewest speeds for which ROSS 3 does not warn about its interpolation."""


class RossVersion(IntEnum):
    """Major version of ROSS a file is meant for."""

    TWO = 2
    THREE = 3

    @property
    def axis(self) -> str:
        """Key of the axis of rotor speed."""
        return "frequency" if self is RossVersion.TWO else "speed"

    @property
    def interpolation(self) -> str:
        """How ROSS fills the space between the rows."""
        return "a smoothing spline" if self is RossVersion.TWO else "piecewise cubics (PCHIP)"


def write_ross(
    table: CoefficientTable,
    path: str | Path,
    *,
    version: RossVersion | int,
    node: int = 0,
    minimum_speeds: int = RECOMMENDED_SPEEDS,
) -> None:
    """Write a bearing element that ``ross.BearingElement.load`` reads.

    Parameters
    ----------
    table : CoefficientTable
        Counter-clockwise; axes that are not x right, y up are turned back.
    path : str or Path
        ``.json`` or ``.toml``; ROSS tells them apart by the suffix.
    version : {2, 3}
        Major version of ROSS that shall read the file.
    node : int
        Node of the rotor, counted from zero.
    minimum_speeds : int
        Fewest speeds that are accepted.

    Raises
    ------
    InputError
        E003 for another version, suffix or node, for a clockwise table and for too few speeds; E007 when the file
        cannot be written.
    """
    wanted, path = _version(version), Path(path)
    if node < 0:
        raise InputError("E003", f"node is {node}; ROSS counts nodes from 0")
    if table.speeds.size < minimum_speeds:
        raise InputError(
            "E003",
            f"{table.name}: {table.speeds.size} speed(s), and ROSS {wanted} runs {wanted.interpolation} through them; "
            f"compute at least {minimum_speeds} over the range the rotor is analysed for (10 to 20 are better), "
            f"or accept what it makes of them with minimum_speeds={table.speeds.size}",
        )
    element = _element(for_rotor_programs(table), wanted, node)
    block = f"{BLOCK}{table.name}"
    if _is_json(path):
        text = (
            json.dumps({block: {**element, "n_link": None}}, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
        )
    else:
        text = _toml(block, element)
    write_text(path, text)


def read_ross(
    path: str | Path, *, version: RossVersion | int, tag: str | None = None, frame: Frame | None = None
) -> CoefficientTable:
    """Read a bearing element from a file of ROSS or of `write_ross`, also out of a whole rotor.

    Parameters
    ----------
    path : str or Path
        ``.json`` or ``.toml``.
    version : {2, 3}
        Major version of ROSS the file was written by or for.
    tag : str, optional
        Which bearing, where the file holds several.
    frame : Frame, optional
        Load direction of a file that ROSS wrote; axes and rotation sense are those of ROSS.

    Returns
    -------
    CoefficientTable
        Axial coefficients (kzz, czz, mzz) are not part of it.

    Raises
    ------
    InputError
        E001 for an unreadable file; E003 when it holds no such bearing, a table over whirl frequency, or a table of
        the other version; E004 when its lists do not fit each other.
    """
    wanted, path = _version(version), Path(path)
    block, element = _chosen(path, _content(path), tag)
    where = f"{path}: {block}"
    origin = element.get("babbitt") or {}
    if origin and origin.get("ross_version") != wanted:
        raise InputError(
            "E003", f"{where}: was written for ROSS {origin.get('ross_version')}; read it with that version"
        )
    declared = frame_from(where, origin) if origin else None
    speeds = _axis(where, element, wanted)

    def matrix(letter: str) -> Array:
        values = [_list(where, element, letter + name, speeds.size) for name in NAMES]
        return np.array(values).T.reshape(-1, 2, 2)

    mass = matrix("m") if "mxx" in element else None
    return CoefficientTable(
        name=str(element.get("tag") or block.removeprefix(BLOCK)),
        speeds=speeds,
        stiffness=matrix("k"),
        damping=matrix("c"),
        mass=None if mass is None or not np.any(mass) else mass,
        frame=settled(where, declared, frame or (None if declared else Frame(load_angle=None))),
        static=static_from(origin.get("static", {})),
        method=str(origin.get("method", "")),
    )


def _version(version: RossVersion | int) -> RossVersion:
    try:
        return RossVersion(version)
    except ValueError:
        raise InputError(
            "E003", f"version is {version!r}; give the major version of the ROSS that reads the file, 2 or 3"
        ) from None


def _is_json(path: Path) -> bool:
    if path.suffix.lower() not in (".json", ".toml"):
        raise InputError("E003", f"{path}: ROSS tells its formats by the suffix; use .json or .toml")
    return path.suffix.lower() == ".json"


def _element(table: CoefficientTable, version: RossVersion, node: int) -> dict[str, Any]:
    """The arguments of the constructor, and under ``babbitt`` what ROSS has no place for and passes over."""
    element: dict[str, Any] = {"n": node, "tag": table.name, "scale_factor": 1, "color": "#355d7a"}
    element[version.axis] = table.speeds.tolist()
    for letter, values in (("k", table.stiffness), ("c", table.damping), ("m", table.mass)):
        if values is not None:
            columns = values.reshape(-1, 4).T
            element.update({letter + name: column.tolist() for name, column in zip(NAMES, columns, strict=True)})
    element["babbitt"] = {
        "ross_version": int(version),
        "frame": declaration(table.frame),
        **{key: value for key, value in frame_record(table.frame).items() if value is not None},
        "method": table.method,
        "static": static_record(table),
    }
    return element


_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


def _toml(block: str, element: dict[str, Any]) -> str:
    """One table of the element and one below it for each dictionary in it; JSON spells the values as TOML does."""

    def key(name: str) -> str:
        return name if _BARE_KEY.fullmatch(name) else json.dumps(name, ensure_ascii=False)

    def lines(path: str, table: dict[str, Any]) -> list[str]:
        plain = {name: value for name, value in table.items() if not isinstance(value, dict)}
        written = [f"[{path}]"]
        written += [f"{key(name)} = {json.dumps(value, ensure_ascii=False)}" for name, value in plain.items()]
        for name, value in table.items():
            if isinstance(value, dict):
                written += ["", *lines(f"{path}.{key(name)}", value)]
        return written

    return "\n".join(lines(key(block), element)) + "\n"


def _content(path: Path) -> dict[str, Any]:
    text = read_text(path)
    try:
        content = json.loads(text) if _is_json(path) else tomllib.loads(text)
    except ValueError as error:
        raise InputError("E003", f"{path}: not {path.suffix[1:].upper()} ({error})") from None
    return content if isinstance(content, dict) else {}


def _chosen(path: Path, content: dict[str, Any], tag: str | None) -> tuple[str, dict[str, Any]]:
    """The block of the bearing that is meant."""
    blocks = {name: value for name, value in content.items() if name.startswith(BLOCK) and isinstance(value, dict)}
    found = ", ".join(name.removeprefix(BLOCK) for name in blocks) or "none"
    if tag is not None:
        blocks = {name: value for name, value in blocks.items() if name == BLOCK + tag}
    if len(blocks) != 1:
        raise InputError(
            "E003",
            f"{path}: one bearing element is read at a time; there are: {found}; name one of them with tag=",
        )
    return next(iter(blocks.items()))


def _axis(where: str, element: dict[str, Any], version: RossVersion) -> Array:
    """The rotor speeds, from the key that means rotor speed in that version."""
    speed, frequency = element.get("speed"), element.get("frequency")
    if version is RossVersion.TWO and speed is not None:
        raise InputError(
            "E003", f"{where}: has the axis 'speed', which ROSS 2 does not know; read it with version=3"
        )
    if version is RossVersion.THREE and frequency is not None:
        raise InputError(
            "E003",
            f"{where}: has the axis 'frequency', which is whirl frequency in ROSS 3, and this table holds rotor speed; "
            "if ROSS 2 wrote the file, read it with version=2",
        )
    axis = frequency if version is RossVersion.TWO else speed
    if not isinstance(axis, list):
        raise InputError("E003", f"{where}: no list '{version.axis}'; constant coefficients belong to no speed")
    return np.array(axis, dtype=np.float64)


def _list(where: str, element: dict[str, Any], name: str, count: int) -> list[float]:
    """A coefficient as a list; what ROSS takes for one that is absent or a single number."""
    value = element.get(name)
    if value is None:
        value = element.get(name[0] + "xx") if name.endswith("yy") else 0.0
    if value is None:
        raise InputError("E003", f"{where}: no '{name}'")
    listed = value if isinstance(value, list) else [value] * count
    if len(listed) != count:
        raise InputError("E004", f"{where}: '{name}' has {len(listed)} values for {count} speeds")
    return listed
