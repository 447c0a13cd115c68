"""The keys for editors are those of the schema, and type checkers see a mistake in one."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

from conftest import ROOT

import coque


def test_keys_are_those_of_the_schema() -> None:
    sys.path.insert(0, str(ROOT / "coque-python"))
    import keys

    assert keys.KEYS.read_text(encoding="utf-8") == keys.keys(json.loads(coque.schema()))


def test_a_type_checker_sees_a_wrong_key(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        'import coque\n'
        'coque.Scene("ring.toml", set={"title": "Ring"})\n'
        'coque.Scene(title="Ring", analysis={"static": {"levels": 4}})\n'
        'coque.Scene(title="Ring", analysys={})\n'
        'coque.Scene(geometry={"plate": {"length": [10.0, 1.0]}})\n',
        encoding="utf-8",
    )
    words = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(ROOT / "target" / "mypy"), str(script)]
    said = subprocess.run(words, capture_output=True, text=True).stdout
    lines = {int(line.split(": error")[0].rpartition(":")[2]) for line in said.splitlines() if ": error:" in line}
    assert lines == {4, 5}, said
