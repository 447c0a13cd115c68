"""A run as a page that a browser shows by itself: shapes that turn, fields, frames, the curve."""

from __future__ import annotations

import html
import json
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

import numpy as np
from numpy.typing import NDArray

from . import _coque

if TYPE_CHECKING:
    from .result import Body, Result

# Greatest size of a page, in bytes a megabyte.
_MEGABYTE = 1_000_000


class View:
    """A page; notebooks show it, with all that it needs in it, so that it stays when the notebook is exported."""

    def __init__(self, page: str, height: int) -> None:
        self.page = page
        """The whole text, HTML."""
        self.height = height
        """Height in a notebook, in pixels."""

    def _repr_html_(self) -> str:
        style = f"width:100%;height:{int(self.height)}px;border:1px solid #ccc"
        return f'<iframe srcdoc="{html.escape(self.page, quote=True)}" style="{style}"></iframe>'

    def save(self, path: Union[str, PathLike[str]]) -> None:
        """Writes the page into a file."""
        Path(path).write_text(self.page, encoding="utf-8")

    def __repr__(self) -> str:
        return f"View({len(self.page) / _MEGABYTE:.1f} MB)"


def page(result: Result, size: float) -> str:
    """The page of a result: of the frames in memory, else of those in its folder."""
    if not size > 0.0:
        raise ValueError(f"size is {size}; it must be positive")
    most = int(size * _MEGABYTE)
    if result._folder is not None and not isinstance(result.frames, list):
        return _coque.page_of(result._folder, most)
    made = _coque.Page()
    for frame in result.frames:
        made.begin(frame.along)
        for name, body in frame.bodies.items():
            made.add(name, _arrays(body))
    for name, sets in result.sets.items():
        for set_name, points in sets.items():
            made.name_set(name, set_name, _flat(points, np.uint32))
    curve = result.curve
    return made.html(result._scene, json.dumps(result.summary), (list(curve.units.items()), curve.rows), most)


def _arrays(body: Body) -> _coque._Shown:
    def fields(of: dict[str, NDArray[Any]]) -> list[_coque._ShownField]:
        return [(name, _unit(body.units[name]), body.components[name], _flat(rows, np.float64)) for name, rows in of.items()]

    corners, offsets = _flat(body.connectivity, np.uint32), _flat(body.offsets, np.uint32)
    return _flat(body.points, np.float64), corners, offsets, fields(body.point_data), fields(body.cell_data)


def _unit(unit: str) -> Any:
    return None if unit == "-" else unit


def _flat(rows: NDArray[Any], kind: Any) -> NDArray[Any]:
    return np.ascontiguousarray(rows, dtype=kind)


def table(result: Result) -> str:
    """What a notebook shows of a result: how it ended, the last row of its curve, its warnings."""

    def row(*cells: str) -> str:
        return "<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in cells) + "</tr>"

    curve = result.curve
    last = [(name, f"{column[-1]:.6g}", curve.units[name]) for name, column in curve.items() if len(column)]
    rows = "".join(row(*cells) for cells in last)
    warned = "".join(f"<li>{html.escape(str(warning))}</li>" for warning in result.warnings)
    title = html.escape(str(result.summary.get("title", "")))
    counts = f"{len(curve.rows)} rows, {len(result.frames)} frames"
    return (
        f"<p><b>{title}</b>: {html.escape(result.message)}; {counts}; the last row:</p><table>{rows}</table>"
        + (f"<p>Warnings:</p><ul>{warned}</ul>" if warned else "")
    )
