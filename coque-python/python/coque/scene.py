"""Scenes: read, changed, checked, run."""

from __future__ import annotations

import itertools
import json
import sys
import threading
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _coque, _toml
from ._errors import CoqueError, Diverged, Interrupted
from .mesh import Mesh
from .result import Curve, Frame, Result, _warning, load

if TYPE_CHECKING:
    from ._keys import SceneKeys

    if sys.version_info >= (3, 11):
        from typing import Unpack
    else:
        from typing_extensions import Unpack


# As many as the command takes.
_MOST_THREADS = 1024

_Rows = NDArray[np.float64]
Push = Callable[[float, _Rows, _Rows], Any]
"""A function of time, or of the level of a quasi-static run, positions and velocities that gives an array of a force on each particle."""


class Progress(NamedTuple):
    """How a run is going."""

    done: float
    """Part that is done, from 0 to 1; a guess where levels may settle early."""
    time: float
    """Time; zero without time."""
    level: float
    """Load level."""
    steps: int
    """Steps done; without time the points found."""
    kinetic: float
    """Kinetic energy."""
    internal: float
    """Internal energy when it was last evaluated."""


@dataclass(frozen=True)
class _Brought:
    """What a scene calls by name."""

    meshes: dict[str, Mesh]
    arrays: dict[str, NDArray[np.float64]]

    @staticmethod
    def of(meshes: Optional[Mapping[str, Any]], arrays: Optional[Mapping[str, ArrayLike]]) -> _Brought:
        def numbers(name: str, given: ArrayLike) -> NDArray[np.float64]:
            # A copy: a scene never changes.
            array = np.array(given, dtype=np.float64)
            if array.ndim != 1:
                raise ValueError(f"the array {name} has the shape {array.shape}; it must have a number for each particle")
            return array

        found = {name: Mesh.of(mesh) for name, mesh in (meshes or {}).items()}
        return _Brought(found, {name: numbers(name, given) for name, given in (arrays or {}).items()})

    def handed_over(self) -> _coque._Brought:
        return {name: mesh._arrays() for name, mesh in self.meshes.items()}, self.arrays


class Scene:
    """A scene that has passed every check that needs no particles; never changed.

    `Scene("ring.toml")` reads a file, `Scene(text)` a text of more than one line, `Scene(dict)` and `Scene(title=…, units=…)` take Python's
    own values. `set` replaces values: `{"section.homogeneous.thickness": 0.2}`. `meshes` are those that `geometry.mesh.file` calls by their
    names; whatever `Mesh.of` takes. `arrays` are those that `values` calls by name: a number for each particle, in the order of `points()`.

    Raises `SceneError` for the first thing that is wrong, `OSError` for a file that cannot be read.
    """

    def __init__(
        self,
        given: Union[str, PathLike[str], Mapping[str, Any], None] = None,
        /,
        *,
        set: Optional[Mapping[str, Any]] = None,
        meshes: Optional[Mapping[str, Any]] = None,
        arrays: Optional[Mapping[str, ArrayLike]] = None,
        **keys: Unpack[SceneKeys],
    ) -> None:
        if (given is None) == (not keys):
            raise TypeError("a scene is a file, a text, a dictionary or keywords: one of them")
        if given is None or isinstance(given, Mapping):
            text, origin = _toml.text(keys if given is None else given), "scene"
        elif isinstance(given, str) and "\n" in given:
            text, origin = given, "scene"
        else:
            origin = fspath(given)
            text = Path(origin).read_bytes().decode("utf-8")
        replaced = [(path, _toml.value(value)) for path, value in (set or {}).items()]
        self._take(text, origin, replaced, _Brought.of(meshes, arrays))

    def _take(self, text: str, origin: str, replaced: list[tuple[str, str]], brought: _Brought) -> None:
        self._text, self._origin, self._replaced, self._brought = text, origin, replaced, brought
        self._scene = _coque.Scene(text, origin, replaced, brought.handed_over())

    @classmethod
    def _made(cls, text: str, origin: str, replaced: list[tuple[str, str]], brought: _Brought) -> Scene:
        scene = cls.__new__(cls)
        scene._take(text, origin, replaced, brought)
        return scene

    def __reduce__(self) -> Any:
        return Scene._made, (self._text, self._origin, self._replaced, self._brought)

    @property
    def text(self) -> str:
        """Its text, without what `set` and `with_` replaced."""
        return self._text

    @property
    def replaced(self) -> dict[str, str]:
        """What `set` and `with_` replaced, as TOML."""
        return dict(self._replaced)

    @property
    def title(self) -> str:
        """Its title."""
        return self._scene.title

    @property
    def analysis(self) -> str:
        """Its analysis, as scenes call it."""
        return self._scene.analysis

    def __repr__(self) -> str:
        return f"Scene({self.title!r}, {self.analysis})"

    def with_(self, changes: Mapping[str, Any], *, arrays: Optional[Mapping[str, ArrayLike]] = None) -> Scene:
        """Another scene, in which some values are replaced, with further arrays."""
        more = [(path, _toml.value(value)) for path, value in changes.items()]
        further = _Brought.of(None, arrays)
        brought = _Brought(self._brought.meshes, {**self._brought.arrays, **further.arrays})
        return Scene._made(self._text, self._origin, [*self._replaced, *more], brought)

    def points(self) -> NDArray[np.float64]:
        """Builds it: the places of all particles at rest, a row each; several bodies stand one behind the other."""
        return self._scene.points()

    def check(self, *, cost: bool = False, threads: int = 1) -> dict[str, Any]:
        """Builds it: `model` says what is modelled and left out, `warnings` what is doubtful; `cost`, if asked for, times a few steps."""
        _checked(threads)
        found = self._scene.check(cost, threads)
        found["model"] = json.loads(found["model"])
        found["warnings"] = [_warning(said) for said in found["warnings"]]
        return found

    def run(
        self,
        *,
        threads: int = 1,
        progress: Union[bool, Callable[[Progress], Any]] = False,
        fields: Optional[bool] = None,
        out: Union[str, PathLike[str], None] = None,
        push: Optional[Push] = None,
        on_fail: str = "raise",
    ) -> Result:
        """Runs it; results are the same for any number of threads.

        `progress` shows a line on the standard error, or is called with a `Progress` some twenty times a second and ends the run by `False`.
        `fields` keeps frames in memory: `True` each, or every n-th as [output.fields] says, `False` none, nothing as the scene asks. `out` is a
        folder for what `coque run` writes. `push(t, x, v)` is called in every step with the time, all positions and all velocities, those of
        half a step before, and gives an array of a force on each particle; `x` and `v` are good for the call only. In `explicit.quasi-static`
        its `t` is the load level. It is for a shell or a solid alone in a march, and such a run keeps no checkpoint. `on_fail="return"` gives the result of a run that diverged in place of `Diverged`.

        Raises `SceneError`, `Diverged`, `Interrupted` at Ctrl-C, `CoqueError` for a folder that cannot be written; what a callback raises, with
        what was found so far in its `result`.
        """
        if on_fail not in ("raise", "return"):
            raise ValueError(f'on_fail is {on_fail!r}; it must be "raise" or "return"')
        result = self._run(threads, _listener(progress), fields, out, on_fail, push)
        result._warn(stacklevel=2)
        return result

    def _run(
        self,
        threads: int,
        listener: Optional[Callable[[Progress], Any]],
        fields: Optional[bool],
        out: Union[str, PathLike[str], None],
        on_fail: str,
        push: Optional[Push] = None,
    ) -> Result:
        def exert(time: float, positions: _Rows, velocities: _Rows) -> _Rows:
            assert push is not None
            forces = np.ascontiguousarray(push(time, positions, velocities), dtype=np.float64)
            if forces.shape != positions.shape:
                raise ValueError(f"push gave an array of {forces.shape}; it must be one of {positions.shape}, a force on each particle")
            return forces

        _checked(threads)
        folder = None if out is None else Path(out)
        with _heard(listener) as tell:
            found = self._scene.run(threads, tell, fields, folder, None if push is None else exert)
        result = Result._of(found, self._text, folder)
        _raise(found, result)
        _fail(result, on_fail)
        return result

    def forecast(self, accuracy: float, *, within: float = 60.0, threads: int = 1) -> list[dict[str, Any]]:
        """Runs it on ever finer lattices, for so many seconds each method, to tell which lattice, method and analysis have an error of at most
        `accuracy`, a share of the greatest value of each column (0.005 for half a percent): a row per method with `method`, the `runs` that
        tell, and, where it can be told, `lattice`, `spacing` over that of the scene, `particles`, `error`, `seconds`, `bytes` and whether it
        `ran` or is predicted. Ctrl-C ends it behind the lattice that is under way.

        Raises `SceneError`, `CoqueError` where nothing can be told.
        """
        if not 1e-6 <= accuracy <= 0.5 or not 0.1 <= within <= 86_400.0:
            raise ValueError("accuracy must be from 1e-6 to 0.5, within from 0.1 to 86400 seconds")
        _checked(threads)
        return _coque.forecast(self._scene, accuracy, within, threads)

    def steps(self, *, threads: int = 1, records: bool = False) -> Steps:
        """The run, led by whoever loops over it: an event is a step, a record or a level; with `records` each row of the curve."""
        _checked(threads)
        return Steps(self._scene.simulation(threads), records)


def resume(
    folder: Union[str, PathLike[str]],
    *,
    threads: Optional[int] = None,
    progress: Union[bool, Callable[[Progress], Any]] = False,
    meshes: Optional[Mapping[str, Any]] = None,
    arrays: Optional[Mapping[str, ArrayLike]] = None,
    on_fail: str = "raise",
) -> Result:
    """Goes on with the run in a folder from its checkpoint (`output.checkpoint_every`), to the same bits; its frames are those of the folder.

    Threads are as many as before where nothing is said. `meshes` and `arrays` are those that its scene calls by name. Raises as `Scene.run`, and
    `CoqueError` for a folder without a checkpoint.
    """
    listener, folder = _listener(progress), Path(folder)
    _checked(1 if threads is None else threads)
    brought = _Brought.of(meshes, arrays)
    with _heard(listener) as tell:
        found = _coque.resume(folder, brought.handed_over(), threads, tell)
    result = replace(Result._of(found), frames=load(folder).frames, _folder=folder)
    _raise(found, result)
    _fail(result, on_fail)
    result._warn(stacklevel=2)
    return result


def _checked(threads: int) -> None:
    if not 1 <= threads <= _MOST_THREADS:
        raise ValueError(f"threads is {threads}; it must be at least 1 and at most {_MOST_THREADS}")


@contextmanager
def _heard(listener: Optional[Callable[[Progress], Any]]) -> Iterator[Optional[Callable[..., Any]]]:
    """The listener as Rust calls it; its line is taken away behind the run."""

    def tell(*news: Any) -> Any:
        return listener(Progress(*news)) if listener else None

    try:
        yield tell if listener else None
    finally:
        if isinstance(listener, _Line):
            listener.close()


def _raise(found: dict[str, Any], result: Result) -> None:
    """Raises what ended a run from outside, with what was found before."""
    raised: Optional[BaseException] = found["raised"]
    if isinstance(raised, KeyboardInterrupt):
        raise Interrupted(result.message, result) from None
    if raised is not None:
        # Exceptions of other packages may take no attributes.
        with suppress(AttributeError, TypeError):
            raised.result = result  # type: ignore[attr-defined]
        raise raised


def _fail(result: Result, on_fail: str) -> None:
    if result.ended == "refused":
        error = CoqueError(result.message)
        error.result = result
        raise error
    if result.ended == "diverged" and on_fail == "raise":
        raise Diverged(result.message, result)


class _Line:
    """A line on the standard error."""

    def __init__(self) -> None:
        self._width = 0

    def __call__(self, news: Progress) -> None:
        said = f"{100 * news.done:3.0f} %, level {news.level:.4f}, step {news.steps}"
        self._width = max(self._width, len(said))
        print(f"\r{said:<{self._width}}", end="", file=sys.stderr, flush=True)

    def close(self) -> None:
        if self._width:
            print(f"\r{'':<{self._width}}\r", end="", file=sys.stderr, flush=True)


def _listener(progress: Union[bool, Callable[[Progress], Any]]) -> Optional[Callable[[Progress], Any]]:
    if callable(progress):
        return progress
    return _Line() if progress else None


@dataclass(frozen=True)
class Event:
    """What has happened to a run that is led step by step."""

    kind: str
    """`step`, or `record` where the curve has grown."""
    time: float
    """Time; zero without time."""
    level: float
    """Load level."""
    _steps: Steps

    def frame(self, *, stresses: bool = False) -> Frame:
        """The bodies as they are now, with their fields."""
        return self._steps.frame(stresses=stresses)

    @property
    def curve(self) -> Curve:
        """The curve so far."""
        return self._steps.curve


class Steps(Iterator[Event]):
    """A run under way, event by event. A run that is left alone gives the bits of `Scene.run`."""

    def __init__(self, simulation: _coque.Simulation, records: bool) -> None:
        self._simulation, self._records = simulation, records

    def __iter__(self) -> Steps:
        return self

    def __next__(self) -> Event:
        kind, time, level = self._simulation.advance(self._records)
        if kind == "end":
            raise StopIteration
        if kind == "failed":
            result = Result._of(self._simulation.finish())
            _fail(result, "raise")
        return Event(kind, time, level, self)

    def frame(self, *, stresses: bool = False) -> Frame:
        """The bodies as they are now, with their fields."""
        return Frame._of(self._simulation.frame(stresses))

    @property
    def curve(self) -> Curve:
        """The curve so far."""
        return Curve(*self._simulation.curve())

    def finish(self) -> Result:
        """Ends the run where it stands: what it leaves behind."""
        result = Result._of(self._simulation.finish())
        result._warn(stacklevel=2)
        return result


@dataclass(frozen=True)
class Sweep(Sequence[tuple[dict[str, Any], Result]]):
    """Runs of a sweep, in the order of their values: pairs of values and result."""

    runs: list[tuple[dict[str, Any], Result]]

    def __len__(self) -> int:
        return len(self.runs)

    def __getitem__(self, at: Any) -> Any:
        return self.runs[at]

    def to_pandas(self) -> Any:
        """A row per run: its values, how it ended, words of its warnings, the last row of its curve."""
        import pandas

        def row(values: dict[str, Any], result: Result) -> dict[str, Any]:
            last = {name: column[-1] for name, column in result.curve.items() if len(column)}
            words = " ".join(sorted({warning.word for warning in result.warnings}))
            return {**values, "ended": result.ended, "warnings": words, **last}

        return pandas.DataFrame([row(values, result) for values, result in self.runs])


def sweep(scene: Scene, over: Mapping[str, Sequence[Any]], *, workers: int = 1, fields: Optional[bool] = None) -> Sweep:
    """Runs a scene for every combination of values, the last list running fastest; `workers` of them at a time, one thread each.

    A run that diverges does not stop the others: its result says so. A value that is refused raises `SceneError` before anything runs.
    """
    every = [dict(zip(over, values)) for values in itertools.product(*over.values())]
    scenes = [scene.with_(values) for values in every]
    left = threading.Event()

    def goes_on(_: Progress) -> bool:
        return not left.is_set()

    with ThreadPoolExecutor(max_workers=workers) as pool:
        runs = [pool.submit(one._run, 1, goes_on, fields, None, "return") for one in scenes]
        try:
            results = [run.result() for run in runs]
        except BaseException:
            # Runs under way end soon; the interpreter waits for them.
            left.set()
            pool.shutdown(wait=False, cancel_futures=True)
            raise
    said = {(warning.word, str(warning)): warning for result in results for warning in result.warnings}
    for warning in said.values():
        warnings.warn(warning, stacklevel=2)
    return Sweep(list(zip(every, results)))
