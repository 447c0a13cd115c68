"""The command within the package: the same bytes, words and exit codes as the program."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT


def ran(*words: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(words, cwd=ROOT, capture_output=True, text=True)


def test_it_runs_a_scene_to_the_same_bytes(command: str, tmp_path: Path) -> None:
    for who, words in (("program", [command]), ("module", [sys.executable, "-m", "coque"])):
        done = ran(*words, "run", "scenes/scordelis-lo.toml", "--out", str(tmp_path / who))
        assert done.returncode == 0, done.stderr
    curves = [(tmp_path / who / "curve.csv").read_bytes() for who in ("program", "module")]
    assert curves[0] == curves[1] and len(curves[0]) > 50


@pytest.mark.parametrize("words", [["--version"], ["--help"], ["list"], ["schema"], ["run"], ["run", "no-such.toml"], ["odd"]])
def test_it_says_the_same(command: str, words: list[str]) -> None:
    program, module = ran(command, *words), ran(sys.executable, "-m", "coque", *words)
    assert (module.returncode, module.stdout, module.stderr) == (program.returncode, program.stdout, program.stderr)
    assert program.stdout or program.returncode == 2
