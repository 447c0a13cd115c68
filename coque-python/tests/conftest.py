"""What the tests share: places, and a scene that takes milliseconds."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

import coque

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def scenes() -> Path:
    """The scenes of the repository."""
    return ROOT / "scenes"


@pytest.fixture
def command() -> str:
    """The command `coque`, as `cargo xtask package` built it."""
    return os.environ["COQUE"]


def cantilever(**changes: Any) -> dict[str, Any]:
    """A strip that is clamped at one end and lifted at the other, little enough for a linear answer."""
    scene: dict[str, Any] = {
        "title": "Cantilever",
        "units": {"length": "m", "force": "N", "time": "s"},
        "geometry": {"plate": {"lengths": [10.0, 1.0], "particles": [21, 3]}},
        "material": {"elastic": {"young": 1.2e6, "poisson": 0.0, "density": 1.0}},
        "section": {"homogeneous": {"thickness": 0.1}},
        "supports": [{"on": "u0", "clamped": {}}],
        "loads": [{"on": "u1", "force": {"total": [0.0, 0.0, 0.1]}}],
        "analysis": {"linear": {}},
        "curve": [{"name": "w_tip", "of": "displacement", "on": "u1", "direction": [0.0, 0.0, 1.0]}],
    }
    return {**scene, **changes}


@pytest.fixture
def let_go() -> coque.Scene:
    """The same let go in time, for as long as nobody waits."""
    return coque.Scene(cantilever(analysis={"explicit": {"transient": {"duration": 2000.0, "record_every": 1.0}}}))
