"""Courses in time, of functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np


def amplitude(of: Callable[[float], Any], start: float, end: float, count: int = 201) -> dict[str, list[list[float]]]:
    """A function of time as the amplitude of a load or a support: `amplitude=coque.amplitude(np.sin, 0.0, 6.0)`.

    It is called here, at `count` equal times, and never while a scene runs: the scene has a table with straight lines between them, off by
    `h² max|f″|/8` at most, h the time between two of them. Before `start` and behind `end` the factor stays.
    """
    if count < 2 or not start < end:
        raise ValueError("an amplitude takes two times at least, the first before the last")
    return {"table": [[float(time), float(of(float(time)))] for time in np.linspace(start, end, count)]}
