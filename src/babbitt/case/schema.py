"""The JSON Schema of the case language, drawn from the models, for editors and for the documentation."""

from __future__ import annotations

import json
from importlib.resources import files
from typing import Any

from babbitt.case.method_mapping import METHOD

SCHEMA_FILE = "schema.json"


def case_schema() -> dict[str, Any]:
    """Draw the schema from the models.

    Returns
    -------
    dict
        JSON Schema, draft 2020-12. A quantity is a number in SI or text with a unit; ``x-unit`` is its SI unit,
        ``x-kind`` its kind where two share a unit, ``x-allowed`` its range, ``x-example`` how an engineer writes
        one; ``x-methods`` are the methods that read a field, where not all do.
    """
    from pydantic import TypeAdapter
    from pydantic.json_schema import GenerateJsonSchema

    from babbitt.case.kinds import any_case

    drawn = TypeAdapter(any_case()).json_schema()
    define_methods(drawn["$defs"])
    define_blocks(drawn)
    return {
        "$schema": GenerateJsonSchema.schema_dialect,
        "title": "Babbitt case",
        "description": "A bearing, a machine of bearings, the statics of a shaft, or the footstep of a screw.",
        **drawn,
    }


def define_methods(definitions: dict[str, Any]) -> None:
    """Put the mappings of methods among the definitions, once each, as all other parts are."""
    for part in list(definitions.values()):
        ways = part.get("properties", {}).get(METHOD, {}).get("anyOf", [])
        for place, way in enumerate(ways):
            if way.get("type") == "object":
                definitions[way["title"]] = way
                ways[place] = {"$ref": f"#/$defs/{way['title']}"}


def define_blocks(drawn: dict[str, Any]) -> None:
    """Let a study and a title block stand beside a case of any kind."""
    from pydantic import TypeAdapter

    from babbitt.case.loading import DOCUMENT, STUDY
    from babbitt.case.parts.study import StudyBlock
    from babbitt.case.parts.title_block import TitleBlock

    for key, part in ((STUDY, StudyBlock), (DOCUMENT, TitleBlock)):
        block = TypeAdapter(part).json_schema(ref_template="#/$defs/{model}")
        drawn["$defs"] |= block.pop("$defs")
        drawn["$defs"][part.__name__] = block
        for reference in drawn["discriminator"]["mapping"].values():
            case = drawn["$defs"][reference.rpartition("/")[2]]
            case["properties"][key] = {"$ref": f"#/$defs/{part.__name__}"}


def shipped_schema() -> str:
    """Give the text of the schema that comes with the package."""
    return files("babbitt.case").joinpath(SCHEMA_FILE).read_text(encoding="utf-8")


def written_schema() -> str:
    """Draw the schema and write it as the shipped file is written."""
    return json.dumps(case_schema(), indent=1, ensure_ascii=False, sort_keys=True) + "\n"
