"""JSON: the tables with unit in the key, SI, the frame beside them."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from babbitt.core.files.bounded_text import loads_json
from babbitt.core.files.reading import read_text
from babbitt.core.files.writing import write_text
from babbitt.core.notices import InputError
from babbitt.export.coefficients import CoefficientTable
from babbitt.export.frame import Frame, Rotation
from babbitt.export.questioned import unsolved_from, unsolved_record, warnings_from, warnings_record
from babbitt.export.unit_names import static_column, static_quantity
from babbitt.export.whirl import OverFrequency, SystemMatrices

FORMAT = 1
"""Version of the layout, under the key ``babbitt_coefficients``."""

_MATRICES = {"stiffness": "stiffness_N_per_m", "damping": "damping_N_s_per_m", "mass": "mass_kg"}
_SPEED = "speed_rad_per_s"
_FREQUENCY = "frequency_rad_per_s"


def frame_record(frame: Frame) -> dict[str, Any]:
    """The frame as plain data; a load direction that is not known is null."""
    return {
        "rotation": frame.rotation.value,
        "x_axis_angle_rad": frame.x_axis_angle,
        "load_angle_rad": frame.load_angle,
    }


def frame_from(where: str, record: Any) -> Frame:
    """The frame that `frame_record` wrote.

    Raises
    ------
    InputError
        E003 for anything else.
    """
    try:
        load = record.get("load_angle_rad")  # TOML has no null, so an unknown direction may be absent
        return Frame(
            rotation=Rotation(record["rotation"]),
            load_angle=None if load is None else float(load),
            x_axis_angle=float(record["x_axis_angle_rad"]),
        )
    except (AttributeError, KeyError, TypeError, ValueError):
        raise InputError(
            "E003",
            f"{where}: the frame must be given as rotation (counter-clockwise or clockwise), x_axis_angle_rad and "
            "load_angle_rad",
        ) from None


def static_record(table: CoefficientTable) -> dict[str, list[float]]:
    """The static data of a table under names that carry the unit."""
    return {static_column(name): values.tolist() for name, values in table.static.items()}


def temperatures_record(table: CoefficientTable) -> dict[str, str]:
    """The temperatures for which the coefficients of a table hold, where that is known."""
    return {"temperatures": table.temperatures} if table.temperatures else {}


def whirl_record(table: CoefficientTable) -> dict[str, Any]:
    """Coefficients over frequency and the matrices of journal and pads, where a table has them."""
    record: dict[str, Any] = {}
    over = table.over_frequency
    if over is not None:
        record[_FREQUENCY] = over.frequencies.tolist()
        record |= {
            f"frequency_{_MATRICES[name]}": getattr(over, name).tolist() for name in ("stiffness", "damping")
        }
    if table.systems:
        record["systems"] = [
            {"labels": list(one.labels), **{key: getattr(one, name).tolist() for name, key in _MATRICES.items()}}
            for one in table.systems
        ]
    return record


def over_frequency_from(where: str, record: Mapping[str, Any]) -> OverFrequency | None:
    """The coefficients over frequency that `whirl_record` wrote; None where there are none."""
    if _FREQUENCY not in record:
        return None
    keys = (_FREQUENCY, f"frequency_{_MATRICES['stiffness']}", f"frequency_{_MATRICES['damping']}")
    if missing := [key for key in keys if key not in record]:
        raise InputError("E003", f"{where} lacks {', '.join(missing)}")
    return OverFrequency(*(_numbers(where, key, record[key]) for key in keys))


def systems_from(where: str, record: Mapping[str, Any]) -> tuple[SystemMatrices, ...]:
    """The matrices of journal and pads that `whirl_record` wrote."""
    systems = record.get("systems") or []
    if not isinstance(systems, list):
        raise InputError("E003", f"{where}: systems must be a list")
    read = []
    for one in systems:
        if not isinstance(one, dict) or not {"labels", *_MATRICES.values()} <= set(one):
            raise InputError("E003", f"{where}: every system needs labels, {', '.join(_MATRICES.values())}")
        labels = tuple(str(label) for label in one["labels"])
        read.append(SystemMatrices(labels, *(_numbers(where, key, one[key]) for key in _MATRICES.values())))
    return tuple(read)


def static_from(record: Mapping[str, Any]) -> dict[str, Any]:
    """The static data that `static_record` wrote; other keys are passed over."""
    return {quantity: values for column, values in record.items() if (quantity := static_quantity(column))}


def json_text(tables: CoefficientTable | Iterable[CoefficientTable]) -> str:
    """Write one or more tables as the text of a JSON file."""
    listed = [tables] if isinstance(tables, CoefficientTable) else list(tables)
    records = []
    for table in listed:
        record: dict[str, Any] = {
            "name": table.name,
            "method": table.method,
            **temperatures_record(table),
            "frame": frame_record(table.frame),
            _SPEED: table.speeds.tolist(),
            **warnings_record(table),
            **unsolved_record(table),
        }
        for matrix, key in _MATRICES.items():
            values = getattr(table, matrix)
            if values is not None:
                record[key] = values.tolist()
        record |= whirl_record(table)
        record["static"] = static_record(table)
        records.append(record)
    content = {"babbitt_coefficients": FORMAT, "tables": records}
    return json.dumps(content, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def write_json(tables: CoefficientTable | Iterable[CoefficientTable], path: str | Path) -> None:
    """Write one or more tables to a JSON file.

    Raises
    ------
    InputError
        E007 when the file cannot be written.
    """
    write_text(path, json_text(tables))


def read_json(path: str | Path) -> tuple[CoefficientTable, ...]:
    """Read the tables of a JSON file.

    Raises
    ------
    InputError
        E001 for an unreadable file, E003 for content that is not what `write_json` writes.
    """
    try:
        content = loads_json(read_text(path))
    except ValueError as error:
        raise InputError("E003", f"{path}: not JSON ({error})") from None
    if not isinstance(content, dict) or content.get("babbitt_coefficients") != FORMAT:
        raise InputError(
            "E003", f"{path}: no key babbitt_coefficients with the value {FORMAT}; not a table of Babbitt"
        )
    records = content.get("tables")
    if not isinstance(records, list) or not records:
        raise InputError("E003", f"{path}: no list of tables")
    return tuple(_table(f"{path}: table {place}", record) for place, record in enumerate(records, 1))


def _table(where: str, record: Any) -> CoefficientTable:
    if not isinstance(record, dict):
        raise InputError("E003", f"{where} is not an object")
    needed = ("name", "frame", _SPEED, _MATRICES["stiffness"], _MATRICES["damping"])
    if missing := [key for key in needed if key not in record]:
        raise InputError("E003", f"{where} lacks {', '.join(missing)}")
    static = record.get("static") or {}
    if not isinstance(static, dict):
        raise InputError("E003", f"{where}: static must be an object")
    return CoefficientTable(
        name=str(record["name"]),
        speeds=np.asarray(_numbers(where, _SPEED, record[_SPEED])),
        stiffness=_numbers(where, _MATRICES["stiffness"], record[_MATRICES["stiffness"]]),
        damping=_numbers(where, _MATRICES["damping"], record[_MATRICES["damping"]]),
        mass=_numbers(where, _MATRICES["mass"], record[_MATRICES["mass"]])
        if _MATRICES["mass"] in record
        else None,
        frame=frame_from(where, record["frame"]),
        static=static_from(static),
        method=str(record.get("method", "")),
        temperatures=str(record.get("temperatures", "")),
        over_frequency=over_frequency_from(where, record),
        systems=systems_from(where, record),
        warnings=warnings_from(where, record),
        unsolved_speeds=unsolved_from(where, record),
    )


def _numbers(where: str, key: str, given: Any) -> Any:
    try:
        return np.array(given, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError("E003", f"{where}: {key} is not an array of numbers") from None
