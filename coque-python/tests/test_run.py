"""Runs: the same bits as the command, ended from outside, led step by step, kept in a folder."""

from __future__ import annotations

import csv
import os
import signal
import subprocess
import sys
import threading
import time
import warnings
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from conftest import ROOT, cantilever

import coque

# Each kind of body and of analysis once, in a second or less.
QUICK: list[tuple[str, dict[str, Any]]] = [
    ("ring", {"analysis.static.levels": 4}),
    ("ring", {"analysis": {"explicit": {"transient": {"duration": 2.0, "record_every": 0.5}}}}),
    ("plate", {"analysis.modal.modes": 4}),
    ("scordelis-lo", {}),
    ("dam-break", {"analysis.explicit.transient.duration": 0.05}),
]


def by_command(command: str, scene: Path, changes: dict[str, Any], out: Path) -> None:
    sets = [word for path, value in coque.Scene(scene, set=changes).replaced.items() for word in ("--set", f"{path}={value}")]
    subprocess.run([command, "run", str(scene), "--out", str(out), *sets], cwd=ROOT, check=True, capture_output=True)


@pytest.mark.filterwarnings("ignore::coque.CoqueWarning")
@pytest.mark.parametrize(("name", "changes"), QUICK)
def test_the_command_and_the_package_give_the_same_bits(
    name: str, changes: dict[str, Any], scenes: Path, command: str, tmp_path: Path
) -> None:
    scene = scenes / f"{name}.toml"
    by_command(command, scene, changes, tmp_path / "command")
    result = coque.Scene(scene, set=changes).run(threads=2, out=tmp_path / "package")
    assert result.ended == "done"
    curves = [(tmp_path / who / "curve.csv").read_bytes() for who in ("command", "package")]
    assert curves[0] == curves[1]
    loaded = coque.load(tmp_path / "command")
    assert np.array_equal(loaded.curve.rows, result.curve.rows, equal_nan=True)
    assert loaded.curve.units == result.curve.units
    assert [str(warning) for warning in loaded.warnings] == [str(warning) for warning in result.warnings]


def test_a_curve_is_columns_with_units() -> None:
    curve = coque.Scene(cantilever(analysis={"static": {"levels": 3}})).run().curve
    assert list(curve)[-1] == "w_tip" and curve.units["w_tip"] == "m"
    assert curve["w_tip"].shape == (4,) and np.asarray(curve).shape == (4, len(curve))
    table = curve.to_pandas()
    assert list(table["w_tip"]) == list(curve["w_tip"]) and table.attrs["units"]["w_tip"] == "m"
    with pytest.raises(KeyError, match="it has level"):
        curve["w"]


def test_errors_that_a_scene_asks_for_are_found_with_and_without_a_folder(tmp_path: Path) -> None:
    scene = coque.Scene(ROOT / "scenes/scordelis-lo.toml", set={"error": {}})
    alone, kept = scene.run(), scene.run(out=tmp_path / "kept")
    bars = [result.summary["errors"]["w_edge"]["bar"] for result in (alone, kept)]
    assert bars[0] == bars[1] > 0.0


def test_frames_hold_points_and_fields_with_units(tmp_path: Path) -> None:
    changes = {"output.fields": {"stresses": True}}
    scene = coque.Scene(cantilever(analysis={"static": {"levels": 3}}), set=changes)
    result = scene.run(out=tmp_path / "out")
    assert [frame.level for frame in result.frames] == pytest.approx([0.0, 1 / 3, 2 / 3, 1.0])
    frame = result.frames[-1]
    assert frame.points.shape == (63, 3) and frame.body.units["displacement"] == "m"
    last = frame["displacement"][frame.points[:, 0] > 9.9]
    # Fields are in single precision.
    assert last[:, 2].mean() == pytest.approx(result.curve["w_tip"][-1], rel=1e-6)
    assert set(frame.body.types) == {9} and len(frame.body.connectivity) == 4 * 40
    moment = frame["moment"]
    assert frame.body.components["moment"] == ["11", "22", "12"] and moment.shape[1] == 3
    read = coque.load(tmp_path / "out").frames
    assert len(read) == 4 and read[1:3][0].along == result.frames[1].along
    assert np.array_equal(read[-1].points, frame.points)
    for name in frame.body.units:
        assert np.array_equal(read[-1][name], frame[name]), name
    assert np.array_equal(read[-1].body.offsets, frame.body.offsets)
    assert scene.run(fields=False).frames == [] and coque.Scene(cantilever()).run().frames == []


def test_load_cases_have_names(scenes: Path, tmp_path: Path) -> None:
    scene = coque.Scene(scenes / "two-span-cases.toml", set={"geometry.plate.particles": [21, 3]})
    result = scene.run(out=tmp_path / "out")
    names = ["weight", "people-left", "people-right", "sun", "settled"]
    names += ["all-spans", "left-span", "right-span", "settled-in-the-sun"]
    assert list(result.cases) == names and [case["name"] for case in result.summary["cases"]] == names
    for number, name in enumerate(names, 1):
        row = result.cases[name]
        assert row["case"] == number and row["R_middle"] == result.curve["R_middle"][number - 1]
        assert (tmp_path / f"out/fields/shell-{number - 1:04}-{name}.vtu").exists()
    assert [frame.along for frame in result.frames] == [*range(1, len(names) + 1)]
    loaded = coque.load(tmp_path / "out")
    assert loaded.cases == result.cases and loaded.summary["envelope"] == result.summary["envelope"]
    assert coque.Scene(cantilever()).run().cases == {}
    assert result.envelope == {}
    changes = {"geometry.plate.particles": [21, 3], "output.fields.envelope": True}
    result = coque.Scene(scenes / "two-span-cases.toml", set=changes).run()
    assert list(result.envelope) == ["least", "greatest", "size", "governing"] and len(result.frames) == 9 + 4
    combined = np.array([frame["moment"] for frame in result.frames[5:9]])
    assert np.array_equal(result.envelope["greatest"]["moment"], combined.max(axis=0))
    assert set(np.unique(result.envelope["governing"]["moment"])) <= {6.0, 7.0, 8.0, 9.0}


@pytest.mark.filterwarnings("ignore::coque.CoqueWarning")
def test_several_bodies_are_named(scenes: Path) -> None:
    changes = {"analysis.explicit.transient.duration": 0.01}
    frame = coque.Scene(scenes / "dam-break.toml", set=changes).run(fields=True).frames[-1]
    assert len(frame.bodies) == 2
    with pytest.raises(coque.CoqueError, match="several bodies"):
        frame.points
    assert any("pressure" in body.units for body in frame.bodies.values())


def test_each_warning_is_given_once_with_its_word() -> None:
    # Ten times the load: the answer is no longer small.
    scene = coque.Scene(cantilever(), set={"loads[0].force.total": [0, 0, 1.0]})
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = scene.run()
    said = [warning.message for warning in caught]
    assert [warning.word for warning in result.warnings] == ["large-linear"]
    assert said == result.warnings and caught[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error", coque.CoqueWarning)
        with pytest.raises(coque.CoqueWarning, match="no longer small"):
            scene.run()


def test_a_run_that_diverges_keeps_what_it_found() -> None:
    far = {"analysis": {"static": {"levels": [0.1, 1e6], "iterations": 3}}}
    scene = coque.Scene(cantilever(**far), set={"loads[0].force.total": [-1e4, 0, 1e4]})
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", coque.CoqueWarning)
        with pytest.raises(coque.Diverged, match="no balance") as caught:
            scene.run()
        result = scene.run(on_fail="return")
    assert caught.value.result.ended == result.ended == "diverged"
    assert len(result.curve.rows) >= 1 and result.message == str(caught.value)


@pytest.mark.parametrize("threads", [1, 2])
def test_ctrl_c_raises_with_what_was_found(let_go: coque.Scene, threads: int) -> None:
    # A shell in the background hands its programs down a signal that is ignored.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(coque.Interrupted) as caught:
        let_go.run(threads=threads)
    assert caught.value.result.ended == "interrupted"
    assert isinstance(caught.value, KeyboardInterrupt) and len(caught.value.result.curve.rows) >= 1


def test_a_callback_hears_of_the_run_and_ends_it(let_go: coque.Scene) -> None:
    news: list[coque.Progress] = []

    def tell(progress: coque.Progress) -> bool:
        news.append(progress)
        return len(news) < 3

    result = let_go.run(progress=tell)
    assert result.ended == "interrupted" and len(news) == 3
    assert 0.0 < news[0].time < news[-1].time and news[-1].steps > 0

    def fail(_: coque.Progress) -> None:
        raise ZeroDivisionError("of the callback")

    with pytest.raises(ZeroDivisionError, match="of the callback"):
        let_go.run(progress=fail)


def test_other_threads_go_on_while_a_run_does(let_go: coque.Scene) -> None:
    counted = 0
    stop = threading.Event()

    def count() -> None:
        nonlocal counted
        while not stop.is_set():
            counted += 1
            time.sleep(0)

    other = threading.Thread(target=count)
    other.start()
    before = counted
    let_go.run(progress=lambda news: news.steps < 100)
    stop.set()
    other.join()
    assert counted > before + 100


def test_steps_give_the_bits_of_a_run() -> None:
    march = {"explicit": {"transient": {"duration": 0.5, "record_every": 0.1}}}
    scene = coque.Scene(cantilever(analysis=march))
    whole = scene.run().curve
    steps = scene.steps(threads=2)
    kinds = [event.kind for event in steps]
    assert set(kinds) == {"step", "record"} and kinds.count("record") == len(whole.rows)
    assert np.array_equal(steps.finish().curve.rows, whole.rows)
    records = [(event.time, event.frame()["displacement"][-1, 2], event.curve["w_tip"][-1]) for event in scene.steps(records=True)]
    assert [time for time, _, _ in records] == list(whole["time"])
    assert np.allclose([field for _, field, _ in records], [tip for _, _, tip in records], rtol=0.1, atol=1e-6)


def test_a_loop_that_is_left_ends_the_run() -> None:
    march = {"explicit": {"transient": {"duration": 2000.0, "record_every": 1.0}}}
    steps = coque.Scene(cantilever(analysis=march)).steps(records=True)
    for event in steps:
        if event.time > 2.5:
            break
    result = steps.finish()
    assert result.ended == "interrupted" and result.curve["time"][-1] == pytest.approx(3.0, abs=0.1)
    with pytest.raises(coque.CoqueError, match="the run is over"):
        steps.frame()


def test_a_column_is_plotted_with_its_unit(monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: dict[str, Any] = {}

    def plot(x: Any, y: Any, form: str, **_: Any) -> None:
        drawn.update(x=x, y=y, form=form)

    axes = SimpleNamespace(plot=plot, set=drawn.update)
    pyplot = SimpleNamespace(subplots=lambda: (None, axes))
    monkeypatch.setitem(sys.modules, "matplotlib", SimpleNamespace(pyplot=pyplot))
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", pyplot)
    result = coque.Scene(cantilever(analysis={"static": {"levels": 3}})).run()
    assert result.plot("w_tip") is axes
    assert drawn["xlabel"] == "level [-]" and drawn["ylabel"] == "w_tip [m]" and drawn["form"] == "o-"
    assert drawn["title"] == result.summary["title"] and list(drawn["y"]) == list(result.curve["w_tip"])
    result.plot("level", against="w_tip")
    assert list(drawn["x"]) == list(result.curve["w_tip"]) and drawn["ylabel"] == "level [-]"
    with pytest.raises(KeyError, match="it has level"):
        result.plot("w_tpi")


def test_a_sweep_is_runs_in_order() -> None:
    values: dict[str, list[Any]] = {"section.homogeneous.thickness": [0.1, 0.2], "geometry.plate.particles": [[11, 3], [21, 3]]}
    found = coque.sweep(coque.Scene(cantilever()), values, workers=2)
    assert [run["section.homogeneous.thickness"] for run, _ in found] == [0.1, 0.1, 0.2, 0.2]
    tips = [result.curve["w_tip"][0] for _, result in found]
    assert tips[0] / tips[2] == pytest.approx(8.0, rel=5e-3)
    assert list(found.to_pandas()["w_tip"]) == tips
    with pytest.raises(coque.SceneError):
        coque.sweep(coque.Scene(cantilever()), {"section.homogeneous.thickness": [0.1, -0.1]})


def test_ctrl_c_ends_the_runs_of_a_sweep(let_go: coque.Scene) -> None:
    signal.signal(signal.SIGINT, signal.default_int_handler)
    before = threading.active_count()
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        coque.sweep(let_go, {"section.homogeneous.thickness": [0.1, 0.2, 0.3]}, workers=2)
    # Left alone, the runs take minutes.
    for _ in range(200):
        if threading.active_count() <= before:
            break
        time.sleep(0.05)
    assert threading.active_count() <= before


def test_a_folder_without_results_is_refused(tmp_path: Path) -> None:
    with pytest.raises(coque.CoqueError, match="no results"):
        coque.load(tmp_path)
    (tmp_path / "summary.json").write_text("[]", encoding="utf-8")
    (tmp_path / "curve.csv").write_text("", encoding="utf-8")
    with pytest.raises(coque.CoqueError, match="no results"):
        coque.load(tmp_path)
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(coque.CoqueError, match="cannot create"):
        coque.Scene(cantilever()).run(out=tmp_path / "file")


def test_nothing_is_printed_and_nothing_imported_unasked() -> None:
    code = "import sys, coque; assert not {'pandas', 'pyvista', 'matplotlib'} & set(sys.modules)"
    said = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert said.stdout == said.stderr == ""
