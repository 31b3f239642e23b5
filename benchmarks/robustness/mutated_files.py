"""Case files with random faults: what `babbitt check` may answer to them, and a generator of such files.

Each seed gives one file: a template or an example in which keys, values, units, types, structure, nesting or the
encoding of the text are changed. `check` must end with exit status 0 or 2, without traceback, each line of its
answer with the name of the file, and within ten seconds.

    python benchmarks/robustness/mutated_files.py [NUMBER [FIRST_SEED]]
"""

from __future__ import annotations

import copy
import random
import sys
from pathlib import Path
from typing import Any

import yaml
from answers import answer_of, run_seeds

from babbitt.case import kinds, template

__all__ = ["check_mutated_file", "mutated_file"]

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"

SLOW = ("thrust", "thrust_line", "trawler_thrust_line.yaml")
"""Sources whose check finds a film, which takes a second; drawn seldom."""

NUMBERS = (0, -1, 1, 7, 200, 1e-300, 1e300, -1e308, 0.1 + 0.2, 10**400, float("nan"), float("inf"), -float("inf"))
WORDS = (
    "",
    " ",
    "x",
    "nan mm",
    "inf N",
    "1e999 mm",
    "-0 mm",
    "0 mm",
    "5",
    "5 banana",
    "12,5 mm",
    "1 000 mm",
    "1.000 kN",
    "3 m/s",
    "50 degC",
    "-400 degC",
    "1e-30 m",
    "9e99 Pa",
    "H7/e8",
    "ISO VG 46",
    "B83",
    "film",
    "iso7902",
    "full",
    "true",
    "null",
    "~",
    "2026-11-23",
    "12:30",
    "0x10",
    "µm",
    "5 µm",
    "\U0001d7dd mm",
    "\xbd mm",
    "\u202e5 mm",
    "a\u0000b",
    "\ud800",
    "../x",
    "/dev/zero",
    "%s%n",
    "{0}",
    "[bold]x[/bold]",
    "=1+1",
    "\x1b[31m",
    "q" * 200,
    "9" * 70,
    "k" * 3000,
)
UNITS = (
    "mm",
    "m",
    "um",
    "N",
    "kN",
    "rpm",
    "rad/s",
    "degC",
    "K",
    "Pa",
    "MPa",
    "deg",
    "L/min",
    "%",
    "",
    "mPa s",
    "kg",
)


LARGE = 1000
"""Places of a tree that is not made many times larger."""


def sources() -> dict[str, str]:
    """Text of every template and example, by name."""
    made = {kind: template(kind) for kind in kinds()}
    return made | {path.name: path.read_text("utf-8") for path in sorted(EXAMPLES.glob("*.yaml"))}


SOURCES = sources()
QUICK = tuple(name for name in SOURCES if name not in SLOW)


def mutated_file(seed: int) -> bytes:
    """Bytes of the file of a seed."""
    rng = random.Random(seed)
    text = SOURCES[rng.choice(SLOW) if rng.random() < 0.01 else rng.choice(QUICK)]
    if rng.random() < 0.7:
        given = yaml.safe_load(text)
        for _ in range(rng.choice((1, 1, 1, 2, 3, 6))):
            given = _structure(rng, given)
        text = _dumped(given)
    content = text.encode("utf-8", "surrogatepass")
    if rng.random() < 0.4:
        content = _bytes(rng, content)
    return content


def check_mutated_file(seed: int, folder: Path) -> str:
    """Check the file of a seed; give what is wrong with the answer, empty where nothing is."""
    path = folder / "case.yaml"
    path.write_bytes(mutated_file(seed))
    return answer_of(path)


def _dumped(given: Any) -> str:
    try:
        return str(yaml.safe_dump(given, allow_unicode=True, sort_keys=False))
    except (yaml.YAMLError, RecursionError):
        return repr(given)


def _structure(rng: random.Random, given: Any) -> Any:
    """The same tree with one change."""
    made = copy.deepcopy(given)
    places = list(_places(made))
    if not places:
        return rng.choice(WORDS)
    container, key = rng.choice(places)
    value = container[key]
    match rng.randrange(14):
        case 0:
            del container[key]
        case 1:
            container[key] = rng.choice(NUMBERS)
        case 2:
            container[key] = rng.choice(WORDS)
        case 3:
            container[key] = rng.choice(
                (None, True, False, [], {}, [[]], [None], {"kind": None}, {"": 1}, {"a": {}})
            )
        case 4:
            container[key] = _requantified(rng, value)
        case 5:
            container[key] = _nested(rng, value)
        case 6 if isinstance(container, dict):
            container[_misspelt(rng, str(key))] = container.pop(key)
        case 7:
            other, there = rng.choice(places)
            container[key] = copy.deepcopy(other[there]) if there in other or isinstance(other, list) else 1
        case 8:
            foreign = yaml.safe_load(SOURCES[rng.choice(list(SOURCES))])
            if isinstance(container, dict) and isinstance(foreign, dict):
                container |= dict(rng.sample(sorted(foreign.items()), min(2, len(foreign))))
        case 9 if isinstance(container, list) and len(places) < LARGE:
            container *= rng.choice((0, 2, 30, 300))
        case 10 if len(places) < LARGE:
            container[key] = [copy.deepcopy(value) for _ in range(rng.choice((0, 1, 2, 40)))]
        case 11 if isinstance(container, dict):
            container[
                rng.choice(("file", "tables", "kind", "name", "method", "<<", "operating_points", "bore", "-1"))
            ] = rng.choice((*WORDS, *NUMBERS))
        case 12 if isinstance(made, dict):
            made["kind"] = rng.choice((*kinds(), "x", 1))
        case _:
            container[key] = _requantified(rng, value)
    return made


def _places(tree: Any) -> Any:
    if isinstance(tree, dict):
        for key in tree:
            yield tree, key
            yield from _places(tree[key])
    elif isinstance(tree, list):
        for index in range(len(tree)):
            yield tree, index
            yield from _places(tree[index])


def _requantified(rng: random.Random, value: Any) -> Any:
    """Another number or unit where a quantity stands."""
    number, _, unit = str(value).partition(" ")
    try:
        of = float(number)
    except ValueError:
        return rng.choice(WORDS)
    of *= rng.choice((-1.0, 0.0, 1e-6, 1e-3, 0.5, 0.9, 1.1, 2.0, 1e3, 1e6))
    return rng.choice((of, f"{of:g} {rng.choice(UNITS)}", f"{of:g} {unit}", f"{of:g} {unit}", f"{of:.3f} {unit}"))


def _nested(rng: random.Random, value: Any) -> Any:
    for _ in range(rng.choice((1, 2, 10, 30))):
        value = [value] if rng.random() < 0.5 else {rng.choice(("a", "kind", "name")): value}
    return value


def _misspelt(rng: random.Random, key: str) -> str:
    place = rng.randrange(len(key) + 1)
    return rng.choice(
        (key[:place] + key[place + 1 :], key[:place] + "x" + key[place:], key.upper(), key * 60, f" {key}")
    )


def _bytes(rng: random.Random, content: bytes) -> bytes:
    """The same text with one change of its bytes."""
    lines = content.split(b"\n")
    at, place = rng.randrange(len(content) + 1), rng.randrange(len(lines))
    match rng.randrange(12):
        case 0:
            return content[:at]
        case 1:
            return content[:at] + bytes(rng.randrange(256) for _ in range(rng.choice((1, 2, 8)))) + content[at:]
        case 2:
            return b"\n".join([*lines[:place], *lines[place + 1 :]])
        case 3:
            return b"\n".join([*lines[: place + 1], *lines[place:]])
        case 4:
            return content.decode("utf-8", "replace").encode(
                rng.choice(("utf-16", "utf-32", "latin-1", "utf-8-sig", "cp037")), "replace"
            )
        case 5:
            return b"\n".join([*lines[:place], b"\t" + lines[place], *lines[place + 1 :]])
        case 6:
            return b"\n".join(
                [
                    *lines[:place],
                    rng.choice((b"- ", b"  ", b"? ", b"&a ", b"*a ", b"!!x ", b"%")) + lines[place],
                    *lines[place + 1 :],
                ]
            )
        case 7:
            return content.replace(
                b": ", rng.choice((b":", b" = ", b": &a ", b": *a ", b": !t ", b": |\n  ", b": {")), 1
            )
        case 8:
            return content + rng.choice(
                (b"\n---\nkind: journal\n", b"\n...\nx", b"}", b"\x00", b"a: &a [*a]", b"\xff")
            )
        case 9:
            return content + b"z: " + b"[" * rng.choice((5, 30, 3000))
        case 10:
            return content.replace(b"\n", rng.choice((b"\r\n", b"\r", b"\xe2\x80\xa8")))
        case _:
            swapped = bytearray(content)
            if swapped:
                swapped[at % len(swapped)] ^= 1 << rng.randrange(8)
            return bytes(swapped)


if __name__ == "__main__":
    sys.exit(run_seeds("case files", check_mutated_file, 6000))
