"""Thin shells, solids that break and fluids that load both, all by particles: scenes, runs and results from Python.

    import coque

    result = coque.Scene("scenes/ring.toml").run()
    result.curve["minus_U_tip"]

Every number has the unit of its scene; `docs/python.md` shows the rest.
"""

from ._coque import schema as _schema
from ._errors import CoqueError, CoqueWarning, Diverged, Interrupted, NotSettled, SceneError
from .mesh import Mesh
from .result import Body, Curve, Frame, Result, load
from .scene import Event, Progress, Scene, Steps, Sweep, sweep

__all__ = [
    "Body",
    "CoqueError",
    "CoqueWarning",
    "Curve",
    "Diverged",
    "Event",
    "Frame",
    "Interrupted",
    "Mesh",
    "NotSettled",
    "Progress",
    "Result",
    "Scene",
    "SceneError",
    "Steps",
    "Sweep",
    "load",
    "schema",
    "sweep",
]


def schema() -> str:
    """The JSON schema of scenes."""
    return _schema()
