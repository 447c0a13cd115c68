"""Surfaces that are in memory, for scenes that call them by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from . import _coque


@dataclass(frozen=True, eq=False)
class Mesh:
    """Points and faces, counted from zero; what is no sound surface is refused when a scene is built with it."""

    points: ArrayLike
    """A row x, y, z each, or x, y in the plane."""
    faces: Union[ArrayLike, Sequence[Sequence[int]]]
    """Three or four points each, in order round it; rows of both lengths may be mixed in a list."""
    sets: Mapping[str, ArrayLike] = field(default_factory=dict)
    """Points of sets, by name."""
    face_sets: Mapping[str, ArrayLike] = field(default_factory=dict)
    """Faces of sets, by name; their points are a set as well."""

    def __post_init__(self) -> None:
        self._arrays()

    def _arrays(self) -> _coque._Mesh:
        points = np.asarray(self.points, dtype=np.float64)
        if points.ndim != 2 or points.shape[1] not in (2, 3):
            raise ValueError(f"points are an array of {points.shape}; they must have a row of two or three numbers each")
        whole = np.zeros((len(points), 3))
        whole[:, : points.shape[1]] = points
        sets, face_sets = ({name: _numbers(ids, f"the set {name}") for name, ids in of.items()} for of in (self.sets, self.face_sets))
        return whole, _faces(self.faces), sets, face_sets

    @staticmethod
    def of(given: Any) -> Mesh:
        """A mesh of a `Mesh`, a pair of points and faces, a `meshio.Mesh`, a `pyvista.PolyData` or the module `gmsh`."""
        if isinstance(given, Mesh):
            return given
        if hasattr(given, "model") and hasattr(given.model, "mesh"):
            return Mesh.from_gmsh(given)
        if hasattr(given, "points") and hasattr(given, "cells_dict"):
            return Mesh.from_meshio(given)
        if hasattr(given, "points") and hasattr(given, "faces"):
            return Mesh.from_pyvista(given)
        if isinstance(given, tuple) and len(given) == 2:
            return Mesh(*given)
        raise TypeError(f"no mesh can be made of {type(given).__name__}; give points and faces")

    @staticmethod
    def from_meshio(mesh: Any) -> Mesh:
        """Triangles and quadrangles of a `meshio.Mesh`, with its sets and the groups of Gmsh; other cells are left aside."""
        faces: list[Sequence[int]] = []
        face_sets: dict[str, list[int]] = {}
        groups = {(int(tag), int(dimension)): name for name, (tag, dimension) in mesh.field_data.items()}
        for number, block in enumerate(mesh.cells):
            if block.type not in ("triangle", "quad"):
                continue
            first = len(faces)
            faces.extend(block.data.tolist())
            for name, cells in mesh.cell_sets.items():
                if not name.startswith("gmsh:") and cells[number] is not None:
                    face_sets.setdefault(name, []).extend(first + int(cell) for cell in cells[number])
            if "gmsh:physical" in mesh.cell_data and groups:
                for face, tag in enumerate(mesh.cell_data["gmsh:physical"][number], first):
                    if (int(tag), 2) in groups:
                        face_sets.setdefault(groups[int(tag), 2], []).append(face)
        once = {name: sorted(set(ids)) for name, ids in face_sets.items() if ids}
        return Mesh(mesh.points, faces, dict(mesh.point_sets), once)

    @staticmethod
    def from_pyvista(mesh: Any) -> Mesh:
        """The faces of a `pyvista.PolyData`."""
        flat = np.asarray(mesh.faces)
        faces: list[list[int]] = []
        at = 0
        while at < len(flat):
            faces.append(flat[at + 1 : at + 1 + flat[at]].tolist())
            at += 1 + int(flat[at])
        return Mesh(mesh.points, faces)

    @staticmethod
    def from_gmsh(gmsh: Any) -> Mesh:
        """Triangles and quadrangles of the present model of the module `gmsh`, by their corners; physical groups of surfaces become sets of
        faces, those of curves and points sets of points, by their names, else `physical-TAG`. Nodes without a face are left aside."""
        tags, coordinates, _ = gmsh.model.mesh.getNodes()
        known = {int(tag): row for tag, row in zip(tags, np.reshape(coordinates, (-1, 3)))}
        faces: list[list[int]] = []
        numbers: dict[int, int] = {}
        for kind, elements, nodes in zip(*gmsh.model.mesh.getElements(2)):
            _, _, _, count, _, corners = gmsh.model.mesh.getElementProperties(kind)
            if corners not in (3, 4):
                continue
            for element, row in zip(elements, np.reshape(nodes, (-1, count))):
                numbers[int(element)] = len(faces)
                faces.append([int(node) for node in row[:corners]])
        used = {tag: number for number, tag in enumerate(sorted({node for face in faces for node in face}))}
        sets: dict[str, list[int]] = {}
        face_sets: dict[str, list[int]] = {}
        for dimension, tag in gmsh.model.getPhysicalGroups():
            name = gmsh.model.getPhysicalName(dimension, tag) or f"physical-{tag}"
            if dimension < 2:
                nodes, _ = gmsh.model.mesh.getNodesForPhysicalGroup(dimension, tag)
                sets[name] = sorted(used[int(node)] for node in nodes if int(node) in used)
            elif dimension == 2:
                of_group: set[int] = set()
                for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, tag):
                    for elements in gmsh.model.mesh.getElements(2, entity)[1]:
                        of_group.update(numbers[int(element)] for element in elements if int(element) in numbers)
                face_sets[name] = sorted(of_group)
        points = np.array([known[tag] for tag in used]).reshape(-1, 3)
        return Mesh(points, [[used[node] for node in face] for face in faces], sets, face_sets)


def _faces(given: Any) -> NDArray[np.uint32]:
    """Rows of four; of a triangle the last corner stands twice."""
    if isinstance(given, np.ndarray):
        rows = given
        if rows.ndim != 2 or rows.shape[1] not in (3, 4):
            raise ValueError(f"faces are an array of {rows.shape}; they must have a row of three or four points each")
        if rows.shape[1] == 3:
            rows = np.column_stack([rows, rows[:, 2]])
    else:
        lists = [list(face) for face in given]
        odd = next((number for number, face in enumerate(lists) if len(face) not in (3, 4)), None)
        if odd is not None:
            raise ValueError(f"face {odd} has {len(lists[odd])} corners; it must have 3 or 4")
        rows = np.array([face if len(face) == 4 else [*face, face[2]] for face in lists]).reshape(-1, 4)
    return _numbers(rows.reshape(-1), "faces").reshape(-1, 4)


def _numbers(given: ArrayLike, who: str) -> NDArray[np.uint32]:
    """Whole numbers from zero."""
    numbers = np.asarray(given)
    if numbers.size == 0:
        return np.zeros(0, dtype=np.uint32)
    whole = np.issubdtype(numbers.dtype, np.integer)
    if numbers.ndim != 1 or not whole or int(numbers.min()) < 0 or int(numbers.max()) >= 2**32:
        raise ValueError(f"{who} must be whole numbers, counted from zero")
    return np.ascontiguousarray(numbers, dtype=np.uint32)
