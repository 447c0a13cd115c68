"""Courses in time of functions, and numbers by particle: the bits of the same numbers in the scene, closed forms, refusals."""

from __future__ import annotations

import math
import pickle
from typing import Any

import numpy as np
import pytest
from conftest import cantilever

import coque


def test_an_amplitude_is_a_table_of_its_function() -> None:
    march = {"explicit": {"transient": {"duration": 2.0, "record_every": 0.1}}}

    def tip(amplitude: Any) -> Any:
        load = {"on": "u1", "force": {"total": [0.0, 0.0, 0.1]}, "amplitude": amplitude}
        return coque.Scene(cantilever(analysis=march, loads=[load])).run().curve["w_tip"]

    by_scene = tip({"sine": {"period": 1.5}})
    turn = 2.0 * math.pi / 1.5
    for count in (51, 101):
        by_table = tip(coque.amplitude(lambda t: math.sin(turn * t), 0.0, 2.0, count))
        # Straight lines are off by h² max|f″|/8 of a force, and the beam follows within about as much.
        bound = (turn * 2.0 / (count - 1)) ** 2 / 8.0
        assert np.abs(by_table - by_scene).max() < 2.0 * bound * np.abs(by_scene).max()
    assert coque.amplitude(np.cos, 0.0, 1.0, 2) == {"table": [[0.0, 1.0], [1.0, math.cos(1.0)]]}
    for start, end, count in [(0.0, 1.0, 1), (1.0, 1.0, 5)]:
        with pytest.raises(ValueError, match="two times"):
            coque.amplitude(np.sin, start, end, count)


def pressed(pressure: dict[str, Any], **brought: Any) -> coque.Scene:
    return coque.Scene(cantilever(loads=[{"on": "all", "pressure": pressure}]), **brought)


def test_even_numbers_are_a_pressure_to_the_bit() -> None:
    even = pressed({"value": 1e-3, "follower": True}).run().curve.rows
    ones = np.ones(63)
    assert np.array_equal(pressed({"value": 1e-3, "values": "p", "follower": True}, arrays={"p": ones}).run().curve.rows, even)
    assert np.array_equal(pressed({"values": "p", "follower": True}, arrays={"p": 1e-3 * ones}).run().curve.rows, even)


def test_a_pressure_that_grows_bends_as_the_beam_does() -> None:
    plain = coque.Scene(cantilever())
    along = plain.points()[:, 0]
    scene = plain.with_({"loads[0]": {"on": "all", "pressure": {"values": "p"}}}, arrays={"p": 1e-4 * along})
    # A load q x/L on a cantilever: w = 11 q L⁴/120 EI, q the load at the tip; nodes take 1/400 of it, the shear of cells 6e-4.
    exact = 11.0 * 1e-3 * 1e4 / (120.0 * 100.0)
    assert scene.run().curve["w_tip"][0] == pytest.approx(exact, rel=5e-3)
    assert pickle.loads(pickle.dumps(scene)).run().curve["w_tip"] == scene.run().curve["w_tip"]


def test_a_thickness_by_particle() -> None:
    def tip(section: dict[str, Any], **brought: Any) -> float:
        return float(coque.Scene(cantilever(section={"homogeneous": section}), **brought).run().curve["w_tip"][0])

    taper = {"thickness": 0.1, "taper": {"point": [0.0, 0.0, 0.0], "gradient": [-0.005, 0.0, 0.0]}}
    along = coque.Scene(cantilever()).points()[:, 0]
    thickness = 0.1 - 0.005 * along
    # The mean of the corners is the value at the centre, up to its rounding, which the solution makes 2e-11.
    by_array = tip({"thickness": 1.0, "values": "t"}, arrays={"t": thickness})
    assert by_array == pytest.approx(tip(taper), rel=7e-11)
    with pytest.raises(coque.SceneError, match="positive in every cell"):
        tip({"thickness": 1.0, "values": "t"}, arrays={"t": -thickness})


def test_a_modulus_by_particle() -> None:
    def tip(**brought: Any) -> float:
        elastic = {"young": 1.2e6, "poisson": 0.0, "density": 1.0, **brought.pop("elastic", {})}
        return float(coque.Scene(cantilever(material={"elastic": elastic}), **brought).run().curve["w_tip"][0])

    def by(numbers: Any) -> float:
        return tip(elastic={"young-values": "e"}, arrays={"e": numbers})

    along = coque.Scene(cantilever()).points()[:, 0]
    even = tip()
    # One section in every cell in place of one for all.
    assert by(np.ones(63)) == pytest.approx(even, rel=1e-12)
    assert by(np.full(63, 0.5)) == pytest.approx(2.0 * even, rel=1e-10)
    # E = E₀/(1 + x/L): ∫(L − x)²(1 + x/L) dx is 5/4 of ∫(L − x)² dx.
    assert by(1.0 / (1.0 + along / 10.0)) == pytest.approx(1.25 * even, rel=1e-3)
    with pytest.raises(coque.SceneError, match="positive in every cell") as caught:
        by(-np.ones(63))
    assert caught.value.key == "material.elastic.young-values"
    block = {"block": {"lengths": [1.0, 0.2], "spacing": 0.05, "thickness": 0.1}}
    material = {"elastic": {"young": 1.0, "young-values": "e", "poisson": 0.3333, "density": 1.0}}
    formulation = {"bond-based": {"horizon": 3.015, "plane": "stress"}}
    solid = {"title": "A bar", "units": {"length": "m", "force": "N", "time": "s"}, "analysis": {"linear": {}}}
    with pytest.raises(coque.SceneError, match="one `young` for a solid"):
        coque.Scene({**solid, "bodies": {"bar": {"solid": {"geometry": block, "material": material, "formulation": formulation}}}})


def test_what_is_no_array_of_the_particles_is_refused() -> None:
    for arrays, says in [
        ({}, "no array in memory"),
        ({"p": np.ones(62)}, "an array of 62 numbers"),
        ({"p": np.full(63, np.inf)}, "not finite at particle 0"),
    ]:
        with pytest.raises(coque.SceneError, match=says) as caught:
            pressed({"values": "p"}, arrays=arrays).run()
        assert caught.value.key == "loads[0].pressure.values"
    with pytest.raises(ValueError, match="a number for each particle"):
        pressed({"values": "p"}, arrays={"p": np.ones((63, 3))})
    with pytest.raises(coque.SceneError, match=r"`loads\[0\]\.pressure\.value` is missing"):
        pressed({})


def test_an_array_is_taken_as_it_was() -> None:
    numbers = 1e-3 * np.ones(63)
    scene = pressed({"values": "p"}, arrays={"p": numbers})
    before = scene.run().curve.rows
    numbers[:] = 0.0
    assert np.array_equal(scene.run().curve.rows, before)
