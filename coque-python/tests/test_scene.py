"""Scenes: what they may be made of, how they are refused, that nothing broken ends the interpreter."""

from __future__ import annotations

import json
import math
import pickle
import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import cantilever

import coque


def test_file_text_table_and_keywords_are_one_scene(tmp_path: Path) -> None:
    table = coque.Scene(cantilever())
    file = tmp_path / "cantilever.toml"
    file.write_text(table.text, encoding="utf-8")
    scenes = [table, coque.Scene(**cantilever()), coque.Scene(table.text), coque.Scene(file), coque.Scene(str(file))]
    tips = {scene.run().curve["w_tip"][0] for scene in scenes}
    assert len(tips) == 1
    assert {(scene.title, scene.analysis) for scene in scenes} == {("Cantilever", "linear")}


def test_the_tip_is_that_of_the_beam() -> None:
    tip = coque.Scene(cantilever()).run().curve["w_tip"][0]
    # PL³/3EI; twenty cells along the strip and its shear take 5.6e-4 of it.
    assert tip == pytest.approx(0.1 * 1000.0 / (3.0 * 100.0), rel=2e-3)


def test_numbers_and_words_come_through_unchanged() -> None:
    odd = 'a "quoted" \\ word\n\t\x7f☃'
    scene = coque.Scene(cantilever(title=odd, material={"elastic": {"young": 0.1 + 1.2e6, "poisson": np.float64(0), "density": 7.85e-9}}))
    assert scene.title == odd
    assert f"young = {0.1 + 1.2e6!r}" in scene.text and "density = 7.85e-09" in scene.text
    arrays = cantilever(geometry={"plate": {"lengths": np.array([10.0, 1.0]), "particles": (np.int64(21), 3)}}, masses=None)
    assert coque.Scene(arrays).run().curve["w_tip"] == coque.Scene(cantilever()).run().curve["w_tip"]


def test_values_are_replaced_one_after_the_other() -> None:
    scene = coque.Scene(cantilever(), set={"section.homogeneous.thickness": 0.2})
    other = scene.with_({"geometry.plate.particles": [41, 3], "title": "Finer"})
    assert (scene.title, other.title) == ("Cantilever", "Finer")
    assert other.replaced == {"section.homogeneous.thickness": "0.2", "geometry.plate.particles": "[41, 3]", "title": '"Finer"'}
    assert other.run().curve["w_tip"][0] == pytest.approx(coque.Scene(cantilever()).run().curve["w_tip"][0] / 8, rel=2e-3)
    again = pickle.loads(pickle.dumps(other))
    assert again.run().curve["w_tip"] == other.run().curve["w_tip"]


def test_a_check_says_what_is_modelled_and_what_it_costs() -> None:
    found = coque.Scene(cantilever()).check(cost=True)
    assert found["model"]["particles"] == 63 and "contact" in found["model"]["left_out"]
    assert found["cost"]["seconds_a_step"] > 0.0
    assert "cost" not in coque.Scene(cantilever()).check()


def test_a_refusal_names_key_value_bound_repair_and_place() -> None:
    text = coque.Scene(cantilever()).text
    with pytest.raises(coque.SceneError) as caught:
        coque.Scene(text.replace("thickness = 0.1", "thickness = -0.1"))
    error = caught.value
    assert (error.code, error.key, error.value) == ("scene::value", "section.homogeneous.thickness", "-0.1")
    assert (error.bound, error.origin, error.line) == ("positive", "scene", 5)
    assert error.column == text.splitlines()[4].index("0.1") + 1
    assert "must be positive" in str(error) and error.repair in str(error)
    assert "╭─[scene:5:" in error.drawn
    assert isinstance(error, ValueError)
    assert str(pickle.loads(pickle.dumps(error))) == str(error)
    missing = cantilever()
    del missing["units"]
    with pytest.raises(coque.SceneError, match="`units` is missing"):
        coque.Scene(missing)
    with pytest.raises(coque.SceneError, match="unknown key"):
        coque.Scene(cantilever(), set={"section.homogeneous.thicknes": 0.1})
    with pytest.raises(coque.SceneError, match="u7"):
        coque.Scene(cantilever(supports=[{"on": "u7", "clamped": {}}])).run()


def test_what_is_no_scene_is_refused_by_its_kind(tmp_path: Path) -> None:
    with pytest.raises(TypeError, match="one of them"):
        coque.Scene()
    with pytest.raises(TypeError, match="one of them"):
        coque.Scene("ring.toml", title="Ring")
    with pytest.raises(FileNotFoundError):
        coque.Scene(tmp_path / "nothing.toml")
    with pytest.raises(TypeError, match="no set"):
        coque.Scene(cantilever(loads={1, 2}))
    with pytest.raises(TypeError, match="keys of a scene are words"):
        coque.Scene({1: 2})
    circle: dict[str, Any] = {}
    circle["circle"] = circle
    with pytest.raises(ValueError, match="nested too deeply"):
        coque.Scene(circle)
    with pytest.raises(ValueError):
        coque.Scene("title = '\ud800'\n")
    with pytest.raises(coque.SceneError, match="finite"):
        coque.Scene(cantilever(section={"homogeneous": {"thickness": math.nan}}))
    with pytest.raises(ValueError, match="at least 1"):
        coque.Scene(cantilever()).run(threads=0)


def test_broken_scenes_raise_and_nothing_else() -> None:
    """A scene with a value or a key changed at random runs or is refused; whatever else comes out fails here."""
    chance = random.Random(1)
    odd = [-1, 0, 1e300, 5e-324, True, "", "u1", [], {}, [[]], [0.0, 0.0, 0.0], {"x": 1}, 3, 2**70, "\x00"]
    refused = 0
    for _ in range(400):
        scene = json.loads(json.dumps(cantilever()))
        place: Any = scene
        while True:
            keys = list(place) if isinstance(place, dict) else list(range(len(place)))
            key = chance.choice(keys)
            if isinstance(place[key], (dict, list)) and place[key] and chance.random() < 0.7:
                place = place[key]
                continue
            action = chance.randrange(3)
            if action == 0:
                place[key] = chance.choice(odd)
            elif action == 1:
                del place[key]
            elif isinstance(place, dict):
                place[chance.choice(["odd", "", "a.b", "é", key + "x"])] = place.pop(key)
            break
        try:
            coque.Scene(scene).check()
        except (coque.SceneError, ValueError):
            refused += 1
    assert 200 < refused < 400


def test_broken_text_raises_and_nothing_else() -> None:
    chance = random.Random(2)
    text = coque.Scene(cantilever()).text
    for _ in range(400):
        at = chance.randrange(len(text))
        broken = text[:at] + chance.choice(["", "\n", "[", '"', "{", "=", "9e9", "\x00", "é"]) + text[at + chance.randrange(6) :]
        try:
            coque.Scene(broken + "\n").check()
        except coque.SceneError as error:
            assert error.drawn
