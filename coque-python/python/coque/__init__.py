"""Thin shells, solids that break and fluids that load both, all by particles: scenes, runs and results from Python.

    import coque

    result = coque.Scene("scenes/ring.toml").run()
    result.curve["minus_U_tip"]

Every number has the unit of its scene; `docs/python.md` shows the rest.
"""

import atexit as _atexit

from ._coque import leave as _leave
from ._coque import schema as _schema
from ._errors import CoqueError, CoqueWarning, Diverged, Interrupted, NotSettled, SceneError
from ._amplitude import amplitude
from .mesh import Mesh
from .result import Body, Curve, Frame, Result, load
from .scene import Event, Progress, Scene, Steps, Sweep, resume, sweep
from ._view import View

# Runs of other threads end before the interpreter does.
_atexit.register(_leave)

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
    "View",
    "amplitude",
    "load",
    "resume",
    "schema",
    "sweep",
]


def schema() -> str:
    """The JSON schema of scenes."""
    return _schema()
