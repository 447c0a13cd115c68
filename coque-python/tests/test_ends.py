"""An interpreter that ends while runs are under way, forks, threads: nothing crashes."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import cantilever

SETUP = f"""
import os, sys, threading, time
import numpy as np
import coque
scene = coque.Scene({cantilever(analysis={"explicit": {"transient": {"duration": 2000.0, "record_every": 1.0}}})!r})
begun = threading.Event()
def push(t, x, v):
    begun.set()
    return np.zeros_like(x)
def work():
    try:
        scene.run(push=push)
    finally:
        print("came back", flush=True)
thread = threading.Thread(target=work, daemon=True)
thread.start()
begun.wait()
"""

ENDS = {
    "end of the script": "",
    "sys.exit": "sys.exit(3)",
    "an error": "raise ZeroDivisionError('of the script')",
    "a step by step loop beside it": "steps = scene.steps(); next(steps)",
    "another daemon that goes on calling": """
def more():
    while True:
        try:
            scene.check()
        except coque.CoqueError:
            return
threading.Thread(target=more, daemon=True).start()
time.sleep(0.05)
""",
    "a fork": """
child = os.fork()
if child == 0:
    print("child", coque.Scene(scene.text, set={'analysis': {'linear': {}}}).run().ended, flush=True)
    sys.exit(0)
assert os.waitpid(child, 0)[1] == 0
""",
}


@pytest.mark.parametrize("end", ENDS.values(), ids=ENDS.keys())
def test_the_end_of_the_interpreter_ends_runs_in_good_order(end: str, tmp_path: Path) -> None:
    if "fork" in end and not hasattr(os, "fork"):
        pytest.skip("no fork on this system")
    words = [sys.executable, "-W", "ignore", "-c", SETUP + end]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, timeout=120)
    expected = 3 if "exit(3)" in end else 1 if "raise Zero" in end else 0
    assert done.returncode == expected, (done.returncode, done.stderr)
    assert "fatal" not in done.stderr.lower() and "panic" not in done.stderr.lower(), done.stderr
    if "fork" in end:
        assert "child done" in done.stdout


def test_a_callback_that_exits_ends_the_run_and_the_script(tmp_path: Path) -> None:
    script = SETUP.split("thread =")[0] + """
try:
    scene.run(push=lambda t, x, v: sys.exit(5) if t > 0.3 else np.zeros_like(x))
except SystemExit as end:
    assert end.result.ended == "interrupted"
    raise
"""
    done = subprocess.run([sys.executable, "-c", script], cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert done.returncode == 5, done.stderr
