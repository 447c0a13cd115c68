# What Rust hands over; the classes of the package make it pleasant.

from collections.abc import Callable
from pathlib import Path
from typing import Any, Optional, TypedDict, Union, final

import numpy as np
from numpy.typing import NDArray

__all__ = ["Scene", "Simulation", "frames_listed", "read_frame", "schema"]

_Curve = tuple[list[tuple[str, str]], NDArray[np.float64]]
_Mesh = tuple[NDArray[np.float64], NDArray[np.uint32], dict[str, NDArray[np.uint32]], dict[str, NDArray[np.uint32]]]
_Field = tuple[str, str, Optional[str], list[str], NDArray[Any]]

class _Body(TypedDict):
    points: NDArray[np.float64]
    corners: NDArray[np.uint32]
    offsets: NDArray[np.uint32]
    types: NDArray[np.uint8]
    fields: list[_Field]

_Frame = tuple[float, float, float, dict[str, _Body]]

@final
class Scene:
    def __new__(
        cls, text: str, origin: str, replaced: list[tuple[str, str]], meshes: dict[str, _Mesh]
    ) -> Scene: ...
    @property
    def title(self) -> str: ...
    @property
    def analysis(self) -> str: ...
    def check(self, cost: bool, threads: int) -> dict[str, Any]: ...
    def run(
        self,
        threads: int,
        listener: Optional[Callable[[float, float, float, int, float, float], Any]],
        fields: Optional[bool],
        out: Optional[Union[str, Path]],
    ) -> dict[str, Any]: ...
    def simulation(self, threads: int) -> Simulation: ...

@final
class Simulation:
    def advance(self, records: bool) -> tuple[str, float, float]: ...
    def frame(self, stresses: bool) -> _Frame: ...
    def curve(self) -> _Curve: ...
    def finish(self) -> dict[str, Any]: ...

def read_frame(path: Union[str, Path]) -> _Body: ...
def frames_listed(path: Union[str, Path]) -> list[tuple[float, Path]]: ...
def schema() -> str: ...
