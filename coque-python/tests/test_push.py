"""Forces that a function exerts: the bits of the same load in the scene, their work in the balance, faults that end the run."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import cantilever
from numpy.typing import NDArray

import coque

Rows = NDArray[np.float64]
MARCH = {"explicit": {"transient": {"duration": 1.0, "record_every": 0.1}}}


def marched(**changes: Any) -> coque.Scene:
    return coque.Scene(cantilever(**{"analysis": MARCH, "loads": None, **changes}))


def test_a_force_has_the_bits_of_the_same_load() -> None:
    scene = marched()
    corner = int(np.argmax(scene.points() @ [1.0, 1.0, 0.0]))
    loaded = marched(sets={"corner": {"nearest": [10.0, 1.0, 0.0]}})
    force = np.array([0.0, 0.003, 0.1])
    by_scene = loaded.with_({"loads[+]": {"on": "corner", "force": {"total": force}}}).run()

    def push(time: float, x: Rows, v: Rows) -> Rows:
        forces = np.zeros_like(x)
        forces[corner] = force
        return forces

    for threads in (1, 2):
        result = scene.run(push=push, threads=threads)
        assert np.array_equal(result.curve.rows, by_scene.curve.rows)
    assert "forces that a function of the caller exerts" in result.summary["modelled"]
    assert "loads" not in result.summary["left_out"]


def test_each_call_is_made_on_a_thread_that_python_knows_already() -> None:
    # What Python keeps of a thread goes when it lets go of the thread: a count of one in each call would tell so.
    calls = threading.local()

    def push(time: float, x: Rows, v: Rows) -> Rows:
        calls.count = getattr(calls, "count", 0) + 1
        most.append(calls.count)
        return np.zeros_like(x)

    for threads in (1, 2):
        most: list[int] = []
        marched().run(push=push, threads=threads)
        assert most == list(range(1, len(most) + 1))
        assert len(most) > 100


def test_it_sees_times_places_and_velocities_and_its_work_is_counted() -> None:
    scene = marched()
    rest, times, tips = scene.points(), [], []

    def wind(time: float, x: Rows, v: Rows) -> Rows:
        times.append(time)
        tips.append(float(x[-1, 2]))
        # A drag towards a wind along z.
        return 0.004 * (np.array([0.0, 0.0, 1.0]) - v)

    result = scene.run(push=wind)
    curve = result.curve
    assert times[0] == 0.0 and times[-1] <= 1.0 and np.all(np.diff(times) >= 0.0)
    assert tips[0] == rest[-1, 2] and max(tips) > 0.01
    # All of its work is in the body: the balance misses what a march of so few steps does.
    turned = curve["external"][-1]
    assert turned > 1e-4
    assert abs(curve["kinetic"][-1] + curve["internal"][-1] - turned) < 1e-3 * turned


def test_in_a_quasi_static_run_it_sees_the_level_and_what_it_lifts_comes_to_rest() -> None:
    scene = marched(analysis={"explicit": {"quasi-static": {"levels": 2}}})
    rest = scene.points()
    corner = int(np.argmax(rest @ [1.0, 1.0, 0.0]))
    seen = []

    def push(level: float, x: Rows, v: Rows) -> Rows:
        seen.append(level)
        forces = np.zeros_like(x)
        # A load that a spring takes part of: force and stiffness of one size at the tip.
        forces[corner, 2] = 0.02 * level - 0.04 * (x[corner, 2] - rest[corner, 2])
        return forces

    spring = {"on": "corner", "spring": {"direction": [0.0, 0.0, 1.0], "stiffness": 0.04}}
    result = scene.run(push=push)
    load = {"on": "corner", "force": {"total": [0.0, 0.0, 0.02]}}
    loaded = marched(analysis={"static": {"levels": 2}}, sets={"corner": {"nearest": [10.0, 1.0, 0.0]}}, loads=[load])
    exact = loaded.with_({"supports[+]": spring}).run()
    assert min(seen) == 0.0 and max(seen) == 1.0
    assert result.curve["w_tip"][-2:] == pytest.approx(exact.curve["w_tip"][-2:], rel=1e-3)


def test_solids_are_pushed_too() -> None:
    block: dict[str, Any] = {
        "title": "A bar of bonds",
        "units": {"length": "m", "force": "N", "time": "s"},
        "bodies": {
            "bar": {
                "solid": {
                    "geometry": {"block": {"lengths": [1.0, 0.2], "spacing": 0.05, "thickness": 0.1}},
                    "material": {"elastic": {"young": 1e3, "poisson": 0.3333, "density": 1.0}},
                    "formulation": {"bond-based": {"horizon": 3.015, "plane": "stress"}},
                }
            }
        },
        "analysis": {"explicit": {"transient": {"duration": 0.02, "record_every": 0.005}}},
        "curve": [{"name": "v", "of": "velocity", "on": "all", "direction": [1.0, 0.0, 0.0]}],
    }
    scene = coque.Scene(block)
    nodes = len(scene.points())
    result = scene.run(push=lambda t, x, v: np.full((nodes, 3), [1.0 / nodes, 0.0, 0.0]))
    # A force of one on a mass of 0.02, all as one: v = t F/m, whatever the body does within.
    assert result.curve["v"][-1] == pytest.approx(0.02 / 0.02, rel=0.05)


def test_what_it_raises_ends_the_run_and_keeps_results() -> None:
    def push(time: float, x: Rows, v: Rows) -> Rows:
        if time > 0.55:
            raise ZeroDivisionError("of the push")
        return np.zeros_like(x)

    with pytest.raises(ZeroDivisionError, match="of the push") as caught:
        marched().run(push=push)
    result = caught.value.result  # type: ignore[attr-defined]
    assert result.ended == "interrupted" and 6 <= len(result.curve.rows) <= 7


@pytest.mark.parametrize(
    ("given", "error", "says"),
    [
        (3.0, ValueError, r"an array of \(1,\); it must be one of \(63, 3\)"),
        (np.zeros((2, 3)), ValueError, r"an array of \(2, 3\)"),
        (np.full((63, 3), np.nan), ValueError, "not finite"),
        ("wind", ValueError, "could not convert"),
        (None, (TypeError, ValueError), "an array|NoneType"),
    ],
)
def test_what_are_no_forces_is_refused(given: Any, error: Any, says: str) -> None:
    with pytest.raises(error, match=says):
        marched().run(push=lambda t, x, v: given)


def test_there_is_none_without_time_nor_on_several_bodies(scenes: Path) -> None:
    def push(time: float, x: Rows, v: Rows) -> Rows:
        raise AssertionError("never called")

    with pytest.raises(coque.CoqueError, match="in marches only, in analysis.explicit.transient .* not in a linear analysis"):
        coque.Scene(cantilever()).run(push=push)
    with pytest.raises(coque.CoqueError, match="alone in its scene"):
        coque.Scene(scenes / "dam-break.toml").run(push=push)


def test_such_a_run_keeps_no_checkpoint(tmp_path: Path) -> None:
    scene = marched(output={"checkpoint_every": 1e-3})
    scene.run(push=lambda t, x, v: np.zeros_like(x), progress=lambda news: False, out=tmp_path / "out")
    assert not list((tmp_path / "out").glob("checkpoint*"))
