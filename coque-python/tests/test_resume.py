"""Runs that go on from their folder, frames read back, and forecasts."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import cantilever
from test_mesh import FACES, NODES, SETS, on_mesh

import coque

# Long enough that a function of the progress is heard before the end.
MARCH = {"explicit": {"transient": {"duration": 80.0, "record_every": 5.0}}}
KEPT: dict[str, Any] = {"output": {"checkpoint_every": 3600.0, "fields": {}}}


def stopped(scene: coque.Scene, out: Path) -> None:
    result = scene.run(out=out, progress=lambda news: news.time < 20.0)
    assert result.ended == "interrupted" and 0 < len(result.curve.rows) < 17


def test_a_run_goes_on_to_the_same_bits(tmp_path: Path) -> None:
    scene = coque.Scene(cantilever(analysis=MARCH, **KEPT))
    whole = scene.run(out=tmp_path / "whole")
    stopped(scene, tmp_path / "parts")
    heard: list[float] = []
    result = coque.resume(tmp_path / "parts", threads=2, progress=lambda news: heard.append(news.time))
    assert result.ended == "done" and np.array_equal(result.curve.rows, whole.curve.rows)
    assert not heard or heard[0] >= 20.0
    assert [frame.time for frame in result.frames] == [frame.time for frame in whole.frames]
    assert np.array_equal(result.frames[-1].points, whole.frames[-1].points)
    with pytest.raises(coque.CoqueError, match="no checkpoint"):
        coque.resume(tmp_path / "parts")
    with pytest.raises(coque.CoqueError, match="no checkpoint"):
        coque.resume(tmp_path / "nothing")
    assert not (tmp_path / "nothing").exists()


def test_a_mesh_in_memory_is_brought_once_more(tmp_path: Path) -> None:
    mesh = coque.Mesh(NODES, FACES, SETS)
    scene = coque.Scene(on_mesh(analysis=MARCH, **KEPT), meshes={"strip.msh": mesh})
    stopped(scene, tmp_path / "out")
    with pytest.raises(coque.SceneError, match=r"strip\.msh"):
        coque.resume(tmp_path / "out")
    assert coque.resume(tmp_path / "out", meshes={"strip.msh": mesh}).ended == "done"


@pytest.mark.filterwarnings("ignore::coque.CoqueWarning")
@pytest.mark.parametrize(
    "analysis",
    [
        MARCH,
        {"static": {"levels": 3}},
        {"explicit": {"quasi-static": {"levels": [0.5, 1.0], "ramp": 2.0}}},
        {"modal": {"modes": 3}},
    ],
)
def test_frames_of_a_folder_stand_where_those_of_the_run_did(analysis: dict[str, Any], tmp_path: Path) -> None:
    loads = None if "modal" in analysis else cantilever()["loads"]
    scene = coque.Scene(cantilever(analysis=analysis, loads=loads, curve=None if "modal" in analysis else cantilever()["curve"]))
    result = scene.with_({"output.fields": {}}).run(out=tmp_path / "out")
    loaded = coque.load(tmp_path / "out")
    stands = [(frame.along, frame.level, frame.time) for frame in result.frames]
    assert stands == [(frame.along, frame.level, frame.time) for frame in loaded.frames] and len(stands) > 1


def test_a_forecast_says_which_lattice_it_takes() -> None:
    rows = coque.Scene(cantilever()).forecast(0.01, within=20.0)
    first = rows[0]
    assert first["error"] <= 0.01 and first["particles"] > 0 and len(first["runs"]) >= 3
    assert [run["particles"] for run in first["runs"]] == sorted(run["particles"] for run in first["runs"])
    with pytest.raises(ValueError, match="accuracy must be"):
        coque.Scene(cantilever()).forecast(0.0)
    with pytest.raises(coque.CoqueError, match="no accuracy can be estimated"):
        coque.Scene(cantilever(curve=None)).forecast(0.01)
