"""What a run leaves behind: curve, frames, summary, warnings."""

from __future__ import annotations

import csv
import json
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union, overload

import numpy as np
from numpy.typing import NDArray

from . import _coque, _view
from ._errors import CoqueError, CoqueWarning, NotSettled

if TYPE_CHECKING:
    import pandas
    import pyvista


class Curve(Mapping[str, NDArray[np.float64]]):
    """Columns by name, a row per record: `curve["W_tip"]`."""

    def __init__(self, columns: Sequence[tuple[str, str]], rows: NDArray[np.float64]) -> None:
        self._rows = np.ascontiguousarray(rows, dtype=np.float64).reshape(-1, len(columns))
        self._places = {name: place for place, (name, _) in enumerate(columns)}
        self.units: dict[str, str] = dict(columns)
        """Unit of each column; `-` without one."""

    @property
    def names(self) -> list[str]:
        """Names of the columns, in their order."""
        return list(self._places)

    @property
    def rows(self) -> NDArray[np.float64]:
        """All numbers, a row per record."""
        return self._rows

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        if name not in self._places:
            raise KeyError(f"the curve has no column {name!r}; it has {', '.join(self._places)}")
        return self._rows[:, self._places[name]]

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def __len__(self) -> int:
        return len(self._places)

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> NDArray[Any]:
        return np.array(self._rows, dtype=dtype)

    def label(self, name: str) -> str:
        """A column with its unit, as beside an axis."""
        return f"{name} [{self.units[name]}]"

    def to_pandas(self) -> pandas.DataFrame:
        """A table; units are in `attrs["units"]`."""
        import pandas

        table = pandas.DataFrame(self._rows, columns=self.names)
        table.attrs["units"] = dict(self.units)
        return table

    def __repr__(self) -> str:
        columns = ", ".join(map(self.label, self))
        return f"Curve({len(self._rows)} rows: {columns})"


class Body:
    """The surface of one body in a frame: `body["moment"]` is a field."""

    def __init__(self, drawn: _coque._Body) -> None:
        self.points: NDArray[np.float64] = drawn["points"]
        """Present positions, a row each."""
        self.connectivity: NDArray[np.uint32] = drawn["corners"]
        """Points of all cells, end to end."""
        self.offsets: NDArray[np.uint32] = drawn["offsets"]
        """Where each cell begins among them, and where the last one ends."""
        self.types: NDArray[np.uint8] = drawn["types"]
        """Kinds of the cells, by their numbers in VTK."""
        self.point_data: dict[str, NDArray[Any]] = {}
        """Fields at the points, a row each."""
        self.cell_data: dict[str, NDArray[Any]] = {}
        """Fields at the cells."""
        self.units: dict[str, str] = {}
        """Units of the fields; `-` without one."""
        self.components: dict[str, list[str]] = {}
        """Names of their components; empty for x, y, z and for single numbers."""
        for at, name, unit, components, numbers in drawn["fields"]:
            (self.point_data if at == "points" else self.cell_data)[name] = numbers
            self.units[name] = unit or "-"
            self.components[name] = components

    def __getitem__(self, name: str) -> NDArray[Any]:
        for fields in (self.point_data, self.cell_data):
            if name in fields:
                return fields[name]
        raise KeyError(f"the frame has no field {name!r}; it has {', '.join(self.units)}")

    def to_pyvista(self) -> pyvista.UnstructuredGrid:
        """The same for PyVista."""
        import pyvista

        begins, ends = self.offsets[:-1], self.offsets[1:]
        cells = np.insert(self.connectivity.astype(np.int64), begins, ends - begins)
        grid = pyvista.UnstructuredGrid(cells, self.types, self.points)
        grid.point_data.update(self.point_data)
        grid.cell_data.update(self.cell_data)
        return grid

    def __repr__(self) -> str:
        return f"Body({len(self.points)} points, {len(self.types)} cells: {', '.join(self.units)})"


@dataclass(frozen=True)
class Frame:
    """A state worth showing; `frame.points` and `frame["moment"]` are those of the one body."""

    along: float
    """What a film runs along: time, load level, number of the point of a path or of the mode."""
    level: Optional[float]
    """Load level; frequency of a mode. None of a file of an older version."""
    time: Optional[float]
    """Time; zero where there is none. None of a file of an older version."""
    bodies: dict[str, Body]
    """Its bodies by name."""

    @property
    def body(self) -> Body:
        """The one body."""
        if len(self.bodies) != 1:
            raise CoqueError(f"the frame has several bodies: name one of {', '.join(self.bodies)} in .bodies")
        return next(iter(self.bodies.values()))

    @property
    def points(self) -> NDArray[np.float64]:
        """Present positions of the one body."""
        return self.body.points

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self.body[name]

    @staticmethod
    def _of(shown: _coque._Frame) -> Frame:
        along, level, time, bodies = shown
        return Frame(along, level, time, {name: Body(body) for name, body in bodies.items()})


class _Files(Sequence[Frame]):
    """Frames of a folder, each read when it is asked for."""

    def __init__(self, frames: list[tuple[float, dict[str, Path]]]) -> None:
        self._frames = frames

    def __len__(self) -> int:
        return len(self._frames)

    @overload
    def __getitem__(self, at: int) -> Frame: ...
    @overload
    def __getitem__(self, at: slice) -> _Files: ...
    def __getitem__(self, at: Union[int, slice]) -> Union[Frame, _Files]:
        if isinstance(at, slice):
            return _Files(self._frames[at])
        along, files = self._frames[at]
        read = {name: _coque.read_frame(file) for name, file in files.items()}
        level, time, _ = next(iter(read.values()))
        return Frame(along, level, time, {name: Body(body) for name, (_, _, body) in read.items()})


@dataclass(frozen=True)
class Result:
    """What a run leaves behind."""

    curve: Curve
    """A row per record."""
    summary: dict[str, Any] = field(repr=False)
    """What ran, what was found and what it cost: `summary.json`."""
    ended: str
    """`done`, `interrupted` or `diverged`; of what could not be done, such as frames without room on the disk, `refused`."""
    message: str = field(repr=False)
    """The same in words."""
    warnings: list[CoqueWarning]
    """What may be wrong with its numbers."""
    sets: dict[str, dict[str, NDArray[np.uint32]]] = field(repr=False)
    """Sets by body and name: the numbers of their particles among the points of a frame. Of a folder, those beside its frames."""
    frames: Sequence[Frame] = field(repr=False)
    """States on the way: those of [output.fields], or those that `fields=True` asked for."""
    _scene: str = field(default="", repr=False)
    _folder: Optional[Path] = field(default=None, repr=False)

    @property
    def cases(self) -> dict[str, dict[str, float]]:
        """Of a scene with load cases the numbers of each case and combination by its name: `result.cases["wind"]["w"]`; `summary["envelope"]` has the
        least and the greatest of each column."""
        found = zip(self.summary.get("cases", []), self.curve.rows)
        return {case["name"]: dict(zip(self.curve.names, map(float, row))) for case, row in found}

    @property
    def envelope(self) -> dict[str, Frame]:
        """Of a scene with load cases and `output.fields.envelope` the frames with the `least` and the `greatest` number of each field, the greatest `size`, and
        the number of the case that is `governing`: `result.envelope["greatest"]["moment"]`; empty of others."""
        cases = len(self.summary.get("cases", []))
        behind = [frame for frame in self.frames if cases and frame.along > cases]
        return dict(zip(("least", "greatest", "size", "governing"), behind))

    def view(self, *, height: int = 560, size: float = 30.0) -> _view.View:
        """The run as a page, which a notebook shows: shapes that turn, fields, frames, the curve. `size` bounds it, in megabytes: a page
        that would be larger has fewer frames, then fewer fields, and says so."""
        return _view.View(_view.page(self, size), height)

    def save_view(self, path: Union[str, PathLike[str]], *, size: float = 30.0) -> None:
        """The same page in a file, for a browser."""
        self.view(size=size).save(path)

    def _repr_html_(self) -> str:
        return _view.table(self)

    def plot(self, column: str, against: Optional[str] = None) -> Any:
        """Draws a column of the curve over another, the first where none is named; gives the axes of matplotlib."""
        import matplotlib.pyplot as pyplot

        along = against or self.curve.names[0]
        rows = (self.curve[along], self.curve[column])
        _, axes = pyplot.subplots()
        # Points that touch each other say no more than their line.
        axes.plot(*rows, "o-" if len(rows[0]) <= 60 else "-", markersize=3)
        axes.set(title=self.summary["title"], xlabel=self.curve.label(along), ylabel=self.curve.label(column))
        return axes

    @staticmethod
    def _of(found: dict[str, Any], scene: str = "", folder: Optional[Path] = None) -> Result:
        said = [CoqueWarning(message) for message in found.get("said", [])]
        return Result(
            curve=Curve(*found["curve"]),
            summary=json.loads(found["summary"]),
            ended=found["ended"],
            message=found["message"],
            warnings=[*map(_warning, found["warnings"]), *said],
            sets=found.get("sets", {}),
            frames=[Frame._of(shown) for shown in found.get("frames", [])],
            _scene=scene,
            _folder=folder,
        )

    def _warn(self, stacklevel: int) -> None:
        for warning in self.warnings:
            warnings.warn(warning, stacklevel=stacklevel + 1)


def _warning(said: tuple[str, str]) -> CoqueWarning:
    word, message = said
    return (NotSettled if word == "not-settled" else CoqueWarning)(message, word)


def load(folder: Union[str, Path]) -> Result:
    """What `coque run`, or `run(out=…)`, wrote into a folder. Frames are read when they are asked for."""
    folder = Path(folder)
    try:
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        with (folder / "curve.csv").open(encoding="utf-8", newline="") as file:
            titles, *rows = csv.reader(file)
        columns = [(name, unit.rstrip("]")) for name, _, unit in (title.rpartition(" [") for title in titles)]
        numbers = np.array(rows, dtype=np.float64).reshape(-1, len(columns))
        said = [_warning((one["kind"], one["message"])) for one in summary["warnings"]]
        names = list(summary.get("bodies", {})) or [summary["kind"]]
        ended = str(summary["ended"])
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise CoqueError(f"{folder} holds no results of a run that has ended: {error}") from error
    kind = "done" if ended == "done" else "interrupted" if ended.startswith("interrupted") else "diverged"
    fields = folder / "fields"
    return Result(Curve(columns, numbers), summary, kind, ended, said, _sets(fields), _files(fields, names), _folder=folder)


def _sets(folder: Path) -> dict[str, dict[str, NDArray[np.uint32]]]:
    """Sets beside the frames of a folder; none where there are no frames."""
    path = folder / "sets.json"
    bodies = json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}
    return {body: {name: np.array(own, dtype=np.uint32) for name, own in sets.items()} for body, sets in bodies.items()}


def _files(folder: Path, names: list[str]) -> _Files:
    """Frames of which each body has one; a list that is missing has none."""
    lists = {name: _coque.frames_listed(folder / f"{name}.pvd") for name in names if (folder / f"{name}.pvd").is_file()}
    together = zip(*([(name, along, file) for along, file in frames] for name, frames in lists.items()))
    return _Files([(of_all[0][1], {name: file for name, _, file in of_all}) for of_all in together])
