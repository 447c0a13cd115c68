"""Meshes of the module `gmsh`: the bits of its file, with groups as sets. Without the module the test is skipped."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_mesh import on_mesh

import coque

gmsh: Any = pytest.importorskip("gmsh", reason="no module gmsh (pip install gmsh; on Linux with libglu1-mesa)")


@pytest.fixture
def strip() -> Iterator[None]:
    """A strip of 10 × 1 with a node of the geometry that belongs to no face, of triangles and quadrangles."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    model = gmsh.model
    rectangles = [model.occ.addRectangle(5.0 * half, 0.0, 0.0, 5.0, 1.0) for half in (0, 1)]
    model.occ.fragment([(2, rectangles[0])], [(2, rectangles[1])])
    model.occ.addPoint(3.0, 7.0, 0.0)
    model.occ.synchronize()
    ends = {"root": 0.0, "end": 10.0}
    for name, x in ends.items():
        found = model.getEntitiesInBoundingBox(x - 1e-6, -1.0, -1.0, x + 1e-6, 2.0, 1.0, 1)
        model.addPhysicalGroup(1, [tag for _, tag in found], name=name)
    model.addPhysicalGroup(2, [rectangles[0]], name="left")
    model.addPhysicalGroup(2, [rectangles[1]])
    model.mesh.setRecombine(2, rectangles[1])
    gmsh.option.setNumber("Mesh.MeshSizeMax", 0.3)
    model.mesh.generate(2)
    yield
    gmsh.finalize()


def tip(scene: coque.Scene) -> float:
    return float(scene.run().curve["w_tip"][0])


def test_a_model_is_a_mesh_with_its_groups(strip: None, tmp_path: Path) -> None:
    mesh = coque.Mesh.of(gmsh)
    points = np.asarray(mesh.points)
    corners = {len(face) for face in mesh.faces}  # type: ignore[arg-type, union-attr]
    assert corners == {3, 4} and points[:, 1].max() == pytest.approx(1.0)
    assert set(mesh.sets) == {"root", "end"} and "left" in mesh.face_sets and len(mesh.face_sets) == 2
    assert np.allclose(points[np.asarray(mesh.sets["end"]), 0], 10.0)
    assert sum(len(np.asarray(ids)) for ids in mesh.face_sets.values()) == len(mesh.faces)  # type: ignore[arg-type]
    memory = tip(coque.Scene(on_mesh(), meshes={"strip.msh": gmsh}))
    # PL³/3EI; cells of a third of the width take parts of a hundred.
    assert memory == pytest.approx(1.0 / 3.0, rel=3e-2)
    # The file numbers nodes as the model does; the module wrote it.
    gmsh.write(str(tmp_path / "strip.msh"))
    (tmp_path / "strip.toml").write_text(coque.Scene(on_mesh(), meshes={"strip.msh": mesh}).text, encoding="utf-8")
    assert tip(coque.Scene(tmp_path / "strip.toml")) == pytest.approx(memory, rel=1e-9)


def test_faces_of_second_order_are_taken_by_their_corners(strip: None) -> None:
    first = coque.Mesh.of(gmsh)
    gmsh.model.mesh.setOrder(2)
    second = coque.Mesh.of(gmsh)
    assert len(second.faces) == len(first.faces)  # type: ignore[arg-type]
    assert np.allclose(np.sort(np.asarray(second.points), axis=0), np.sort(np.asarray(first.points), axis=0))
