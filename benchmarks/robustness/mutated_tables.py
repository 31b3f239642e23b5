"""Tables with random faults that a case names: measured bores, changing loads, displacements, compliances, limits.

Each seed gives a case and the table it names, in CSV, NPZ or TOML, in which cells, headings, lines, numbers of
columns, encodings or bytes are changed, or whose name leads elsewhere. `babbitt check` answers as to any other
file.

    python benchmarks/robustness/mutated_tables.py [NUMBER [FIRST_SEED]]
"""

from __future__ import annotations

import io
import math
import os
import random
import shutil
import sys
import zipfile
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from answers import answer_of, run_seeds

__all__ = ["check_mutated_table", "mutated_table"]

CASE = """\
kind: journal
name: Tables
method: film
diameter: 80 mm
width: 40 mm
clearance: {{kind: relative, mean: 2 permille}}
span: 180 deg
materials: {{bearing: C10, journal: C45}}
lubricant: ISO VG 46
supply: {{temperature: 50 degC, pressure: 0.2 MPa}}
load: 4 kN
speed: 2000 rpm
{reads}
"""

READS = {
    "bore": "bore: {kind: measured, file: NAME}",
    "load": "dynamic_load: {kind: table, file: NAME}",
    "displacement": "displacement: {file: NAME}",
    "compliance": "compliance: [{kind: file, file: NAME}]",
    "limits": "limits: {tables: NAME}",
}
ENDINGS = {"bore": "csv", "load": "csv", "displacement": "csv", "compliance": "csv", "limits": "toml"}
CELLS = (
    "",
    " ",
    "nan",
    "inf",
    "-inf",
    "1e999",
    "1e308",
    "-1e308",
    "1e-320",
    "x",
    "1,5",
    "'1'",
    '"',
    "=1+1",
    "1 mm",
    "٣",
    "\u00a0",
    "0x1p3",
    "1_000",
    "9" * 400,
    "--1",
    "true",
    "None",
    "\u202e1",
    "\x00",
    "\x1b[31m",
)
HEADINGS = (
    "angle,departure",
    "angle [deg]",
    "angle [kg],departure [um]",
    "a [deg],b [um],c [um],d [um]",
    "[deg],[um]",
    "x",
    "angle [deg];departure [um]",
    "angle (rad),departure (m)",
    "angle [deg" + "g" * 5000 + "],b [m]",
    "",
    "a [],b []",
    "a [deg],b [um],c [um/MPa]",
    "a [1/0],b [**]",
    "a [K],b [N],c [N]",
)
NAMES = (
    "missing.csv",
    ".",
    "..",
    "../table.csv",
    "/dev/zero",
    "/etc/passwd",
    "a" * 300 + ".csv",
    '"a\\0b.csv"',
    "pipe.csv",
    "folder.csv",
    "link.csv",
    '"x\\u001b[31m.csv"',
    "''",
    "CON",
    "~/x.csv",
    "case.yaml",
)


def sound_table(kind: str, rng: random.Random) -> bytes:
    """A table as it should be."""
    if kind == "limits":
        return files("babbitt.properties.materials").joinpath("limits.toml").read_bytes()
    number = rng.choice((8, 12))
    angles = [360.0 * place / number for place in range(number)]
    if kind == "bore":
        rows = [f"{angle:g},{3.0 * math.cos(2.0 * math.radians(angle)):.4f}" for angle in angles]
        heading = "angle [deg],departure [um]"
    elif kind == "load":
        rows = [
            f"{angle:g},{math.cos(math.radians(angle)):.3f},{math.sin(math.radians(angle)):.3f}"
            for angle in angles
        ]
        heading = "angle [deg],fx [kN],fy [kN]"
    elif kind == "displacement":
        rows = [f"{angle:g},{z},{rng.random():.3f}" for angle in angles for z in (-20, 0, 20)]
        heading = "angle [deg],z [mm],displacement [um]"
    else:
        rows = [f"{one:g},{other:g},{0.1 if one == other else 0.01}" for one in angles for other in angles]
        heading = "angle [deg],loaded [deg],compliance [um/MPa]"
    return "\n".join([heading, *rows, ""]).encode()


def sound_arrays(rng: random.Random) -> dict[str, Any]:
    """Arrays of a compliance as they should be."""
    number = rng.choice((3, 8, 24))
    return {"angles": np.arange(number) * (math.tau / number), "compliance": 1e-13 * np.eye(number)}


def mutated_table(seed: int, folder: Path) -> Path:
    """Write the case and the table of a seed into a folder; give the path of the case."""
    rng = random.Random(seed)
    kind = rng.choice(tuple(READS))
    arrays = kind == "compliance" and rng.random() < 0.6
    name = "table." + ("npz" if arrays else ENDINGS[kind])
    content = _arrays(rng) if arrays else _text(rng, sound_table(kind, rng))
    if rng.random() < 0.25:
        content = _bytes(rng, content)
    (folder / name).write_bytes(content)
    if rng.random() < 0.15:
        name = rng.choice(NAMES)
        _surroundings(folder)
    case = folder / "case.yaml"
    case.write_text(CASE.format(reads=READS[kind].replace("NAME", name)), encoding="utf-8")
    return case


def check_mutated_table(seed: int, folder: Path) -> str:
    """Check the case of a seed; give what is wrong with the answer, empty where nothing is."""
    inside = folder / "inside"
    shutil.rmtree(inside, ignore_errors=True)
    inside.mkdir()
    return answer_of(mutated_table(seed, inside))


def _surroundings(folder: Path) -> None:
    """What a name may lead to besides a table."""
    os.mkfifo(folder / "pipe.csv")
    (folder / "folder.csv").mkdir()
    (folder / "link.csv").symlink_to("link.csv")


def _text(rng: random.Random, content: bytes) -> bytes:
    """A table of text with up to four changes of its lines and cells."""
    lines = content.decode().split("\n")
    for _ in range(rng.choice((0, 1, 1, 2, 4))):
        place = rng.randrange(len(lines))
        cells = lines[place].split(",")
        match rng.randrange(12):
            case 0:
                cells[rng.randrange(len(cells))] = rng.choice(CELLS)
                lines[place] = ",".join(cells)
            case 1:
                lines[0] = rng.choice(HEADINGS)
            case 2:
                del lines[place]
                lines = lines or [""]
            case 3:
                lines.insert(place, lines[rng.randrange(len(lines))])
            case 4:
                rng.shuffle(lines)
            case 5:
                lines[place] = ",".join(cells[:-1]) if rng.random() < 0.5 else ",".join([*cells, "1"])
            case 6:
                lines = [line.replace(",", rng.choice((";", "\t", " ", ",,"))) for line in lines]
            case 7:
                lines.insert(
                    place, rng.choice(("# remark", '"', "'''", '"""', "[[", "a.b.c = 1", "= 1", "[a", "\ufeff"))
                )
            case 8:
                lines = lines[: rng.randrange(len(lines) + 1)] or [""]
            case 9:
                lines.insert(
                    place, "[" * rng.choice((3, 30, 3000)) if rng.random() < 0.5 else ".".join("a" * 3000) + " = 1"
                )
            case 10:
                lines *= rng.choice((2, 20))
            case _:
                lines = [line.replace("deg", rng.choice(("rad", "kg", "", "K"))) for line in lines]
    return "\n".join(lines).encode("utf-8", "replace")


def _arrays(rng: random.Random) -> bytes:
    """An archive of arrays with one change, or sixteen megabytes of zeros that pack to little."""
    arrays = sound_arrays(rng)
    name, number = rng.choice(tuple(arrays)), arrays["angles"].size
    match rng.randrange(12):
        case 0:
            del arrays[name]
        case 1:
            arrays[name] = arrays[name].astype(rng.choice((complex, "U8", "S8", bool, np.int8, ">f8", np.float16)))
        case 2:
            arrays[name] = arrays[name].reshape(-1)[: rng.randrange(number + 1)]
        case 3:
            flat = arrays[name].reshape(-1)
            flat[rng.randrange(flat.size)] = rng.choice((np.nan, np.inf, -np.inf, 1e300, -1.0, 1e-300))
        case 4:
            arrays[name] = np.array(rng.choice((1.0, "x", None, {"a": 1})), dtype=object)
        case 5:
            arrays[name] = np.zeros(rng.choice(((0,), (0, 0), (1,), (2, 3, 4), ())))
        case 6:
            arrays["angles"] = rng.choice((-1.0, 1e6, 0.0)) * arrays["angles"]
        case 7:
            arrays["angles"] = np.array([1, "a", None], dtype=object)
        case 8:
            arrays[name] = np.zeros(2_000_000)
        case 9:
            arrays |= {"x" * 300: np.zeros(3), "../y": np.zeros(3)}
        case 10:
            return _archive({"angles.npy": b"\x93NUMPY\x01\x00" + bytes(rng.randrange(256) for _ in range(60))})
        case _:
            pass
    target = io.BytesIO()
    np.savez_compressed(target, **arrays)
    return target.getvalue()


def _archive(members: dict[str, bytes]) -> bytes:
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w") as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return target.getvalue()


def _bytes(rng: random.Random, content: bytes) -> bytes:
    at = rng.randrange(len(content) + 1)
    match rng.randrange(6):
        case 0:
            return content[:at]
        case 1:
            return content[:at] + bytes(rng.randrange(256) for _ in range(4)) + content[at:]
        case 2:
            return content.decode("latin-1").encode(rng.choice(("utf-16", "utf-8-sig", "utf-32")))
        case 3:
            return content.replace(b"\n", rng.choice((b"\r\n", b"\r", b"\n\n", b"\x00")))
        case 4:
            return b""
        case _:
            changed = bytearray(content or b"\x00")
            for _ in range(rng.choice((1, 5, 50))):
                changed[rng.randrange(len(changed))] ^= 1 << rng.randrange(8)
            return bytes(changed)


if __name__ == "__main__":
    sys.exit(run_seeds("tables", check_mutated_table, 3000))
