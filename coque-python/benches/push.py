"""What a call back to Python costs a step: `PYTHONPATH=target/python/package target/python/bin/python coque-python/benches/push.py`, after
`cargo xtask package`, with nothing else running. Medians of seven rounds; docs/python.md has the table."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

import coque

Push = Callable[[float, NDArray[np.float64], NDArray[np.float64]], NDArray[np.float64]]
ROUNDS = 7
SIZES = [([21, 3], 6.0), ([50, 20], 0.2), ([200, 50], 0.02)]


def scene(particles: list[int], duration: float) -> coque.Scene:
    """A cantilever of so many particles in some thousands of steps."""
    return coque.Scene(
        {
            "title": "Cantilever",
            "units": {"length": "m", "force": "N", "time": "s"},
            "geometry": {"plate": {"lengths": [10.0, 1.0], "particles": particles}},
            "material": {"elastic": {"young": 1.2e6, "poisson": 0.0, "density": 1.0}},
            "section": {"homogeneous": {"thickness": 0.1}},
            "supports": [{"on": "u0", "clamped": {}}],
            "analysis": {"explicit": {"transient": {"duration": duration, "record_every": duration}}},
            "curve": [{"name": "w", "of": "displacement", "on": "u1", "direction": [0.0, 0.0, 1.0]}],
        }
    )


def step(of: coque.Scene, push: Push | None) -> float:
    """Microseconds of a step."""
    begun = time.perf_counter()
    result = of.run(push=push)
    return 1e6 * (time.perf_counter() - begun) / float(result.summary["steps"])


print(f"{'particles':>10}{'step [us]':>12}{'the call':>12}{'with a sine':>12}")
for particles, duration in SIZES:
    count = particles[0] * particles[1]
    nothing = np.zeros((count, 3))
    of = scene(particles, duration)
    kinds: list[Push | None] = [None, lambda t, x, v: nothing, lambda t, x, v: 1e-9 * np.sin(x)]
    rounds = [[step(of, push) for push in kinds] for _ in range(ROUNDS)]
    bare, called, sine = (statistics.median(column) for column in zip(*rounds, strict=True))
    print(f"{count:>10}{bare:>12.1f}{called - bare:>12.1f}{sine - bare:>12.1f}")
