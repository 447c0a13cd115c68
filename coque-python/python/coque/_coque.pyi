# What Rust hands over; the classes of the package make it pleasant.

from collections.abc import Callable
from pathlib import Path
from typing import Any, Optional, TypedDict, Union, final

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Page",
    "Scene",
    "Simulation",
    "command_line",
    "forecast",
    "frames_listed",
    "leave",
    "page_of",
    "read_frame",
    "resume",
    "schema",
]

_Curve = tuple[list[tuple[str, str]], NDArray[np.float64]]
_Mesh = tuple[NDArray[np.float64], NDArray[np.uint32], dict[str, NDArray[np.uint32]], dict[str, NDArray[np.uint32]]]
_Brought = tuple[dict[str, _Mesh], dict[str, NDArray[np.float64]]]
_Field = tuple[str, str, Optional[str], list[str], NDArray[Any]]

class _Body(TypedDict):
    points: NDArray[np.float64]
    corners: NDArray[np.uint32]
    offsets: NDArray[np.uint32]
    types: NDArray[np.uint8]
    fields: list[_Field]

_ShownField = tuple[str, Optional[str], list[str], NDArray[np.float64]]
_Shown = tuple[
    NDArray[np.float64], NDArray[np.uint32], NDArray[np.uint32], list[_ShownField], list[_ShownField]
]

_Listener = Callable[[float, float, float, int, float, float], Any]
_Push = Callable[[float, NDArray[np.float64], NDArray[np.float64]], NDArray[np.float64]]

_Frame = tuple[float, float, float, dict[str, _Body]]

@final
class Scene:
    def __new__(
        cls, text: str, origin: str, replaced: list[tuple[str, str]], brought: _Brought
    ) -> Scene: ...
    @property
    def title(self) -> str: ...
    @property
    def analysis(self) -> str: ...
    def check(self, cost: bool, threads: int) -> dict[str, Any]: ...
    def run(
        self,
        threads: int,
        listener: Optional[_Listener],
        fields: Optional[bool],
        out: Optional[Union[str, Path]],
        push: Optional[_Push],
    ) -> dict[str, Any]: ...
    def points(self) -> NDArray[np.float64]: ...
    def simulation(self, threads: int) -> Simulation: ...

@final
class Simulation:
    def advance(self, records: bool) -> tuple[str, float, float]: ...
    def frame(self, stresses: bool) -> _Frame: ...
    def curve(self) -> _Curve: ...
    def finish(self) -> dict[str, Any]: ...

@final
class Page:
    def __new__(cls) -> Page: ...
    def begin(self, along: float) -> None: ...
    def add(self, name: str, body: _Shown) -> None: ...
    def name_set(self, body: str, name: str, points: NDArray[np.uint32]) -> None: ...
    def html(self, scene: str, summary: str, curve: _Curve, most: int) -> str: ...

def command_line(arguments: list[str]) -> int: ...
def forecast(scene: Scene, accuracy: float, within: float, threads: int) -> list[dict[str, Any]]: ...
def leave() -> None: ...
def page_of(folder: Union[str, Path], most: int) -> str: ...
def resume(
    folder: Union[str, Path],
    brought: _Brought,
    threads: Optional[int],
    listener: Optional[_Listener],
) -> dict[str, Any]: ...
def read_frame(path: Union[str, Path]) -> tuple[Optional[float], Optional[float], _Body]: ...
def frames_listed(path: Union[str, Path]) -> list[tuple[float, Path]]: ...
def schema() -> str: ...
