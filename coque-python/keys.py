"""Writes python/coque/_keys.py, the keys of scenes for editors and type checkers, from the schema: `python coque-python/keys.py`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
SCHEMA = HERE.parent / "scenes" / "schema.json"
KEYS = HERE / "python" / "coque" / "_keys.py"
HEAD = '''"""Keys of scenes, for editors and type checkers. Made by coque-python/keys.py from scenes/schema.json: change the schema."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any, Literal, Union

    from typing_extensions import NotRequired, TypeAlias, TypedDict

'''
PLAIN = {"string": "str", "number": "float", "integer": "int", "boolean": "bool"}


class Writer:
    """Definitions so far, each after those that it has within."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def type_of(self, schema: Any, name: str) -> str:
        """The type of a schema; a table without a name becomes `name`."""
        if isinstance(schema, bool):
            return "Any"
        if "$ref" in schema:
            return json.dumps(schema["$ref"].rpartition("/")[2])
        if "const" in schema:
            return f"Literal[{schema['const']!r}]"
        if "enum" in schema:
            return f"Literal[{', '.join(map(repr, schema['enum']))}]"
        if "properties" in schema:
            return self.table(schema, name)
        choices = [choice for word in ("oneOf", "anyOf") for choice in schema.get(word, [])]
        if choices:
            return union([self.type_of(choice, f"{name}_{number}") for number, choice in enumerate(choices, 1)])
        kinds = schema.get("type", "object")
        kinds = [kinds] if isinstance(kinds, str) else kinds
        return union([self.plain(schema, kind, name) for kind in kinds if kind != "null"])

    def plain(self, schema: Any, kind: str, name: str) -> str:
        if kind == "array":
            return f"Sequence[{self.type_of(schema.get('items', True), f'{name}_item')}]"
        if kind == "object":
            return f"Mapping[str, {self.type_of(schema.get('additionalProperties', True), f'{name}_value')}]"
        return PLAIN[kind]

    def table(self, schema: Any, name: str) -> str:
        required = schema.get("required", [])
        rows = []
        for key, inner in schema["properties"].items():
            inner_type = self.type_of(inner, f"{name}_{key.replace('-', '_')}")
            rows.append(f'"{key}": {inner_type if key in required else f"NotRequired[{inner_type}]"}')
        self.lines.append(f'{name} = TypedDict("{name}", {{{", ".join(rows)}}})')
        return f'"{name}"'


def union(types: list[str]) -> str:
    known = list(dict.fromkeys(types))
    return known[0] if len(known) == 1 else f"Union[{', '.join(known)}]"


def keys(schema: Any) -> str:
    """The module."""
    writer = Writer()
    for name, definition in schema["$defs"].items():
        found = writer.type_of(definition, name)
        if found != f'"{name}"':
            writer.lines.append(f"{name}: TypeAlias = {found}")
    # Not one of them is required of a call: the scene may come from a file.
    writer.table({"properties": schema["properties"]}, "SceneKeys")
    return HEAD + "".join(f"    {line}\n" for line in writer.lines)


if __name__ == "__main__":
    KEYS.write_text(keys(json.loads(SCHEMA.read_text(encoding="utf-8"))), encoding="utf-8")
