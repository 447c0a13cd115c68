"""Calls of the package with arguments that make no sense: each is refused by an ordinary exception, or does something sensible.

A few hundred by default; `COQUE_FUZZ_CALLS=10000` asks for more, `COQUE_FUZZ_SEED` for others.
"""

from __future__ import annotations

import os
import random
import warnings
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from conftest import cantilever
from test_mesh import FACES, NODES, SETS, on_mesh

import coque

CALLS = int(os.environ.get("COQUE_FUZZ_CALLS", "300"))
SEED = int(os.environ.get("COQUE_FUZZ_SEED", "3"))

# What a call may end by; whatever else comes out, a panic of Rust among it, fails.
ALLOWED = (ValueError, TypeError, OSError, KeyError, IndexError, OverflowError, AttributeError, coque.CoqueError, coque.Diverged)
MARCH = {"explicit": {"transient": {"duration": 0.05, "record_every": 0.01}}}
ODD: list[Any] = [
    None, True, -1, 0, 1, 3, 2**31, 2**70, -0.0, 0.5, 1e300, 5e-324, float("nan"), float("inf"), "", "u1", "\ud800", "a\nb", "\x00", b"\xff",
    [], {}, (), [[]], [1, [2]], {"x": 1}, {1: 2}, object(), print, np.float32(2.0), np.array(3), np.zeros(0), np.zeros((63, 3)),
    np.ones(63), np.ones(63)[::-1], np.ones(63, dtype=complex), np.array(["a", "b"]), np.array([None, 1], dtype=object),
    np.full((63, 3), np.nan), np.zeros((63, 3), dtype=np.float32, order="F"), SimpleNamespace(points=1, cells_dict={}),
    SimpleNamespace(points=[], faces=[9]), (NODES, FACES), (NODES, np.array(FACES[:3])),
]  # fmt: skip


class Fuzz:
    """Scenes, results and random arguments."""

    def __init__(self, folder: Path) -> None:
        self.chance = random.Random(SEED)
        self.folder = folder
        self.march = coque.Scene(cantilever(analysis=MARCH, output={"checkpoint_every": 3600.0, "fields": {}}))
        self.still = coque.Scene(cantilever())
        self.march.run(out=folder / "whole")
        self.march.run(out=folder / "part", progress=lambda news: False)

    def odd(self) -> Any:
        return self.chance.choice(ODD)

    def some(self, *names: str) -> dict[str, Any]:
        """Odd values for some keywords."""
        return {name: self.odd() for name in names if self.chance.random() < 0.25}

    def scene(self) -> Any:
        table = cantilever()
        table[self.chance.choice(list(table))] = self.odd()
        return coque.Scene(table, **self.some("set", "meshes", "arrays")).check()

    def mesh(self) -> Any:
        given = {"points": NODES, "faces": FACES, "sets": SETS, **self.some("points", "faces", "sets", "face_sets")}
        mesh = coque.Mesh(**given)
        return coque.Scene(on_mesh(), meshes={"strip.msh": self.chance.choice([mesh, self.odd()])}).run()

    def arrays(self) -> Any:
        load = {"on": "all", "pressure": {"value": self.chance.choice([1e-3, self.odd()]), "values": self.chance.choice(["p", self.odd()])}}
        return coque.Scene(cantilever(loads=[load]), arrays={"p": self.odd()}).run()

    def run(self) -> Any:
        scene = self.chance.choice([self.march, self.still])
        words = self.some("threads", "progress", "fields", "on_fail")
        forces = self.odd()
        if self.chance.random() < 0.6:
            words["push"] = self.chance.choice([forces, lambda t, x, v: forces, lambda t, x, v: x, lambda *all: x_of(*all)])
        return scene.run(**words)

    def page(self) -> Any:
        result = self.still.run(fields=True)
        body = result.frames[0].body
        for name in ("points", "connectivity", "offsets"):
            if self.chance.random() < 0.3:
                setattr(body, name, self.odd())
        if self.chance.random() < 0.5:
            body.point_data["displacement"] = self.odd()
        return result.view(**self.some("height", "size"))._repr_html_()

    def folder_of(self) -> Path:
        """A folder of a run with a file that is cut or filled with something else."""
        source = self.folder / self.chance.choice(["whole", "part"])
        to = self.folder / "broken"
        for file in source.rglob("*"):
            there = to / file.relative_to(source)
            if file.is_dir():
                there.mkdir(parents=True, exist_ok=True)
            else:
                there.parent.mkdir(parents=True, exist_ok=True)
                there.write_bytes(file.read_bytes())
        victim = self.chance.choice([file for file in sorted(to.rglob("*")) if file.is_file()])
        text = bytearray(victim.read_bytes())
        at = self.chance.randrange(len(text) + 1)
        text[at : at + self.chance.randrange(30)] = bytes(self.chance.choice([b"", b"\x00", b"9", b"<", b'"', b"}", b"\xff\xfe"]))
        victim.write_bytes(bytes(text))
        return to

    def loaded(self) -> Any:
        result = coque.load(self.chance.choice([self.folder_of(), self.odd()]))
        for frame in result.frames:
            frame.body
        return result.view()

    def resumed(self) -> Any:
        return coque.resume(self.chance.choice([self.folder_of(), self.odd()]), **self.some("threads", "progress", "meshes", "arrays"))

    def steps(self) -> Any:
        steps = self.march.steps(**self.some("threads", "records"))
        for event in steps:
            action = self.chance.randrange(6)
            if action == 0:
                event.frame(**self.some("stresses"))
            elif action == 1:
                steps.finish()
                return event.curve
        return steps.finish()

    def small(self) -> Any:
        calls: list[Callable[[], Any]] = [
            lambda: coque.amplitude(self.odd(), self.odd(), self.odd(), self.chance.choice([2, 5, "3", -1, None])),
            lambda: self.still.with_({self.odd(): self.odd()}),
            lambda: coque.sweep(self.still, {"section.homogeneous.thickness": self.odd()}, **self.some("workers")),
            lambda: self.still.forecast(self.odd(), within=0.1),
            lambda: coque.Mesh.of(self.odd()),
            lambda: self.still.run().curve[self.odd()],
            lambda: self.still.run().save_view(self.odd()),
        ]
        return self.chance.choice(calls)()


def x_of(*all: Any) -> Any:
    return all[1].T


@pytest.mark.filterwarnings("ignore")
def test_calls_without_sense_raise_ordinary_exceptions(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    fuzz = Fuzz(tmp_path)
    kinds = [fuzz.scene, fuzz.mesh, fuzz.arrays, fuzz.run, fuzz.page, fuzz.loaded, fuzz.resumed, fuzz.steps, fuzz.small]
    raised: dict[str, int] = {}
    for number in range(CALLS):
        kind = kinds[number % len(kinds)]
        state = fuzz.chance.getstate()
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                kind()
            raised["nothing"] = raised.get("nothing", 0) + 1
        except ALLOWED as error:
            raised[type(error).__name__] = raised.get(type(error).__name__, 0) + 1
        except BaseException as error:
            error.args = (*error.args, f"call {number}, {kind.__name__}, state {hash(state)}")
            raise
    assert raised["nothing"] > CALLS // 30 and sum(raised.values()) == CALLS, raised
    print(raised)
