"""Write the JSON Schema of the case language that ships with the package."""

from pathlib import Path

import babbitt.case.schema as schema

if __name__ == "__main__":
    target = Path(schema.__file__).with_name(schema.SCHEMA_FILE)
    target.write_text(schema.written_schema(), encoding="utf-8")
    print(f"wrote {target}")
