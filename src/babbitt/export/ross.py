"""Bearing elements of ROSS (rotordynamic open source software) as JSON or TOML, for its versions 2 and 3.

A file holds ``BearingElement_<tag>``: node, axis, and one list for each coefficient in N/m, N s/m and kg, axis in
rad/s, x horizontal, y vertical, speed positive from x towards y. What differs is the name of the axis. Version 2
calls the axis of rotor speed ``frequency``; version 3 calls it ``speed`` and keeps ``frequency`` for the whirl
frequency. With both axes, the lists of version 3 are lists of lists, a row for each speed. Version 3 loads a file
for version 2 without a issue and takes its speeds for whirl frequencies, so the version is never guessed here,
neither when writing nor when reading.

References
----------
ROSS documentation, https://ross.readthedocs.io, class BearingElement in versions 2.3 and 3.1.
"""

from __future__ import annotations

from enum import IntEnum
from pathlib import Path
from typing import Any

import numpy as np

from babbitt.core.notices import InputError
from babbitt.core.quantities import AXES
from babbitt.export.coefficients import Array, CoefficientTable
from babbitt.export.frame import Frame, declaration
from babbitt.export.frames import for_rotor_programs
from babbitt.export.json_file import frame_from, frame_record, static_from, static_record, temperatures_record
from babbitt.export.questioned import warnings_from, warnings_record
from babbitt.export.ross_file import read_blocks, write_blocks
from babbitt.export.whirl import OverFrequency

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
            f"{table.name}: ROSS {wanted} interpolates by {wanted.interpolation}, for which {table.speeds.size} "
            f"speed(s) are few; compute at least {minimum_speeds} over the range the rotor is analysed for (10 to "
            f"20 are better), or accept what it makes of them with minimum_speeds={table.speeds.size}",
        )
    element = bearing_element(for_rotor_programs(table), wanted, node)
    block = f"{BLOCK}{table.name}"
    write_blocks(path, {block: element})


def read_ross(
    path: str | Path, *, version: RossVersion | int, tag: str | None = None, load_angle: float | None = None
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
    load_angle : float, optional
        Direction of the load in a file that does not tell, counter-clockwise from x, rad.

    Returns
    -------
    CoefficientTable
        Axial coefficients (kzz, czz, mzz) are not part of it.

    Raises
    ------
    InputError
        E001 for an unreadable file; E003 when it holds no such bearing, a table over whirl frequency, or one of
        the other version; E004 when its lists do not fit each other.
    """
    wanted, path = _version(version), Path(path)
    block, element = _chosen(path, read_blocks(path), tag)
    where = f"{path}: {block}"
    origin = element.get("babbitt") or {}
    if origin and origin.get("ross_version") != wanted:
        raise InputError(
            "E003", f"{where}: was written for ROSS {origin.get('ross_version')}; read it with that version"
        )
    speeds = _axis(where, element, wanted)
    over = _over_frequency(where, element, speeds) if element.get("frequency") and element.get("speed") else None

    def matrix(letter: str) -> Array:
        if over is not None:
            return synchronous(over.stiffness if letter == "k" else over.damping, over.frequencies, speeds)
        values = [_list(where, element, letter + name, speeds.size) for name in AXES]
        return np.array(values).T.reshape(-1, 2, 2)

    mass = matrix("m") if "mxx" in element and over is None else None
    return CoefficientTable(
        name=str(element.get("tag") or block.removeprefix(BLOCK)),
        speeds=speeds,
        stiffness=matrix("k"),
        damping=matrix("c"),
        mass=None if mass is None or not np.any(mass) else mass,
        frame=frame_from(where, origin) if origin else Frame(load_angle=load_angle),
        static=static_from(origin.get("static", {})),
        method=str(origin.get("method", "")),
        temperatures=str(origin.get("temperatures", "")),
        over_frequency=over,
        warnings=warnings_from(where, origin),
    )


def _over_frequency(where: str, element: dict[str, Any], speeds: Array) -> OverFrequency:
    """Coefficients over both axes of ROSS 3: a row for each speed."""
    frequencies = np.array(element["frequency"], dtype=np.float64)

    def matrix(letter: str) -> Array:
        values = np.array([element.get(letter + name) for name in AXES], dtype=np.float64)
        if values.shape != (4, speeds.size, frequencies.size):
            due = f"{speeds.size} rows of {frequencies.size}"
            raise InputError("E004", f"{where}: {letter}xx, {letter}xy, {letter}yx and {letter}yy must have {due}")
        return np.moveaxis(values, 0, -1).reshape(speeds.size, frequencies.size, 2, 2)

    try:
        return OverFrequency(frequencies, matrix("k"), matrix("c"))
    except (TypeError, ValueError):
        raise InputError("E003", f"{where}: coefficients over speed and frequency must be numbers") from None


def synchronous(values: Array, frequencies: Array, speeds: Array) -> Array:
    """Coefficients at the frequency of the rotation, by piecewise cubics (PCHIP) as of ROSS 3; ends are kept."""
    if frequencies.size == 1:
        return np.asarray(values[:, 0])
    from scipy.interpolate import PchipInterpolator

    at = np.clip(speeds, frequencies[0], frequencies[-1])
    return np.array(
        [PchipInterpolator(frequencies, row, axis=0)(one) for row, one in zip(values, at, strict=True)]
    )


def _version(version: RossVersion | int) -> RossVersion:
    try:
        return RossVersion(version)
    except ValueError:
        raise InputError(
            "E003", f"version is {version!r}; give the major version of the ROSS that reads the file, 2 or 3"
        ) from None


def bearing_element(table: CoefficientTable, version: RossVersion, node: int) -> dict[str, Any]:
    """The arguments of the constructor, and under ``babbitt`` what ROSS has no place for and passes over."""
    element: dict[str, Any] = {"n": node, "tag": table.name, "scale_factor": 1, "color": "#355d7a"}
    element[version.axis] = table.speeds.tolist()
    over = table.over_frequency if version is RossVersion.THREE else None
    matrices: tuple[Array | None, ...] = (table.stiffness, table.damping, table.mass)
    if over is not None:
        element["frequency"] = over.frequencies.tolist()
        matrices = (over.stiffness, over.damping, None)
    for letter, values in zip("kcm", matrices, strict=True):
        if values is not None:
            columns = np.moveaxis(values.reshape(*values.shape[:-2], 4), -1, 0)
            element.update({letter + name: column.tolist() for name, column in zip(AXES, columns, strict=True)})
    element["babbitt"] = {
        "ross_version": int(version),
        "frame": declaration(table.frame),
        **{key: value for key, value in frame_record(table.frame).items() if value is not None},
        "method": table.method,
        **temperatures_record(table),
        **warnings_record(table),
        "static": static_record(table),
    }
    return element


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
    if version is RossVersion.THREE and frequency is not None and speed is None:
        raise InputError(
            "E003",
            f"{where}: has the axis 'frequency', in ROSS 3 the whirl frequency, and only tables over rotor speed "
            "can be read; if ROSS 2 wrote the file, read it with version=2",
        )
    axis = frequency if version is RossVersion.TWO else speed
    if not isinstance(axis, list):
        raise InputError("E003", f"{where}: no list '{version.axis}'; constant coefficients belong to no speed")
    return np.array(axis, dtype=np.float64)


def _list(where: str, element: dict[str, Any], name: str, count: int) -> list[float]:
    """A coefficient as a list: a single number holds for all speeds, one left out is what ROSS takes for it."""
    value = element.get(name)
    if value is None:
        value = element.get(name[0] + "xx") if name.endswith("yy") else 0.0
    if value is None or (name.endswith("xx") and name not in element):
        raise InputError("E003", f"{where}: no '{name}'")
    listed = value if isinstance(value, list) else [value] * count
    if len(listed) != count:
        raise InputError("E004", f"{where}: '{name}' has {len(listed)} values for {count} speeds")
    return listed
