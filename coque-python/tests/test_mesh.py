"""Meshes in memory: the bits of the same mesh in a file, refused by number."""

from __future__ import annotations

import pickle
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import meshio
import numpy as np
import pytest
from conftest import cantilever

import coque

# Ten by two quadrangles on 10 × 1, the last of them cut into triangles.
NODES = [(x, y) for y in np.linspace(0.0, 1.0, 3) for x in np.linspace(0.0, 10.0, 11)]
QUADS = [[a, a + 1, a + 12, a + 11] for row in range(2) for a in range(11 * row, 11 * row + 10)]
FACES = [*QUADS[:-1], [20, 21, 32], [20, 32, 31]]
SETS = {"root": [0, 11, 22], "end": [10, 21, 32]}


def on_mesh(**mesh: Any) -> dict[str, Any]:
    changes: dict[str, Any] = {
        "geometry": {"mesh": {"file": "strip.msh"}},
        "supports": [{"on": "root", "clamped": {}}],
        "loads": [{"on": "end", "force": {"total": [0.0, 0.0, 0.1]}}],
        "curve": [{"name": "w_tip", "of": "displacement", "on": "end", "direction": [0.0, 0.0, 1.0]}],
    }
    return {**cantilever(**changes), **mesh}


def tip(mesh: Any) -> float:
    scene = coque.Scene(on_mesh(), meshes={"strip.msh": mesh})
    return float(scene.run().curve["w_tip"][0])


def written(folder: Path) -> coque.Scene:
    """The same mesh in a file of Gmsh."""
    nodes = [f"{number} {x} {y} 0" for number, (x, y) in enumerate(NODES, 1)]
    lines = [(1, 1, [a + 1, a + 12]) for a in (0, 11)] + [(1, 2, [a + 1, a + 12]) for a in (10, 21)]
    cells = [*lines, *((len(face) - 1, 3, [node + 1 for node in face]) for face in FACES)]
    elements = [f"{n} {kind} 2 {tag} {tag} {' '.join(map(str, ids))}" for n, (kind, tag, ids) in enumerate(cells, 1)]
    parts = {"MeshFormat": ["2.2 0 8"], "PhysicalNames": ["3", '1 1 "root"', '1 2 "end"', '2 3 "sheet"']}
    parts |= {"Nodes": [str(len(nodes)), *nodes], "Elements": [str(len(elements)), *elements]}
    text = "".join(f"${name}\n" + "".join(f"{line}\n" for line in body) + f"$End{name}\n" for name, body in parts.items())
    (folder / "strip.msh").write_text(text, encoding="utf-8")
    (folder / "strip.toml").write_text(coque.Scene(on_mesh(), meshes={"strip.msh": (NODES, FACES)}).text, encoding="utf-8")
    return coque.Scene(folder / "strip.toml")


def test_arrays_give_the_bits_of_their_file(tmp_path: Path) -> None:
    from_file = float(written(tmp_path).run().curve["w_tip"][0])
    # PL³/3EI; ten cells along the strip, two of them triangles, take a few thousandths.
    assert from_file == pytest.approx(1.0 / 3.0, rel=1e-2)
    assert tip(coque.Mesh(NODES, FACES, SETS)) == from_file


def test_meshes_of_others_are_taken() -> None:
    mesh = coque.Mesh(NODES, QUADS, SETS)
    expected = tip(mesh)
    points = np.column_stack([np.array(NODES), np.zeros(len(NODES))])
    sets = {name: np.array(ids) for name, ids in SETS.items()}
    assert tip(meshio.Mesh(points, [("line", [[0, 1]]), ("quad", QUADS)], point_sets=sets)) == expected
    groups = coque.Mesh.of(meshio.Mesh(points, [("quad", QUADS)], cell_sets={"half": [np.arange(10)]}))
    assert list(groups.face_sets["half"]) == list(range(10))
    flat = np.concatenate([[4, *face] for face in QUADS])
    pyvista = coque.Mesh.of(SimpleNamespace(points=points, faces=flat))
    assert tip(coque.Mesh(pyvista.points, np.array(pyvista.faces), SETS)) == expected
    scene = coque.Scene(on_mesh(), meshes={"strip.msh": mesh}).with_({"title": "Once more"})
    assert float(pickle.loads(pickle.dumps(scene)).run().curve["w_tip"][0]) == expected


def test_what_is_no_mesh_is_refused() -> None:
    with pytest.raises(TypeError, match="no mesh can be made of int"):
        coque.Scene(on_mesh(), meshes={"strip.msh": 3})
    for points, faces, says in [
        ([1.0, 2.0], QUADS, "two or three numbers"),
        (NODES, [[0, 1]], "face 0 has 2 corners"),
        (NODES, np.zeros((3, 5), dtype=int), "three or four"),
        (NODES, [[0, 1, -12, 11]], "whole numbers"),
        (NODES, [[0, 1, 0.5, 11]], "whole numbers"),
        (NODES, [[0, 1, 2**40, 11]], "whole numbers"),
    ]:
        with pytest.raises(ValueError, match=says):
            coque.Mesh(points, faces)
    with pytest.raises(ValueError, match="the set root must"):
        coque.Mesh(NODES, QUADS, {"root": [0.5]})
    for mesh, says in [
        (coque.Mesh(NODES, [[0, 1, 12, 99]]), "face 0 names node 99 where there are 33"),
        (coque.Mesh(NODES, [[0, 0, 12, 11]]), "twice"),
        (coque.Mesh(NODES, []), "no triangles or quadrangles"),
        (coque.Mesh(NODES, QUADS, {"root": [33]}), "the set root names node 33"),
        (coque.Mesh([(np.nan, 0.0), *NODES[1:]], QUADS), "node 0 has no finite place"),
    ]:
        with pytest.raises(coque.SceneError, match=says) as caught:
            tip(mesh)
        assert caught.value.key == "geometry.mesh.file"
