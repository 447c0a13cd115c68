"""Reads the fields of a run of scenes/panel.toml with meshio and holds them against its curve and the plane-stress law.

python check_fields.py DIR: DIR is the folder of the run, without time, with stresses and the extruded shell.
Ends with an assertion that names what differs.
"""

import csv
import sys
from pathlib import Path
from xml.etree import ElementTree

import meshio
import numpy as np

# As in scenes/panel.toml.
YOUNG, POISSON, THICKNESS = 3102.75, 0.3, 12.7
ROUND_OFF = 1e-9
# Fields at the sampling points are written in single precision; sums of a few of them.
SINGLE = 2e-6


def close(found, expected, what, bound=ROUND_OFF):
    """Largest difference over the largest value."""
    found, expected = np.asarray(found), np.asarray(expected)
    assert found.shape == expected.shape, f"{what}: {found.shape} against {expected.shape}"
    scale = max(np.abs(expected).max(), 1e-12)
    error = np.abs(found - expected).max() / scale
    assert error < bound, f"{what}: {error:.1e} of {scale:.3e}"


def curve(folder):
    with open(folder / "curve.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))
    names = [title.split(" ")[0] for title in rows[0]]
    return dict(zip(names, np.array(rows[1:], dtype=float).T))


def listed(path):
    sets = ElementTree.parse(path).getroot().findall("./Collection/DataSet")
    return [(float(one.get("timestep")), path.parent / one.get("file")) for one in sets]


def plane_stress(strain, stiffness):
    e11, e22, e12 = strain.T
    shear = 0.5 * (1 - POISSON) * e12
    return stiffness * np.column_stack([e11 + POISSON * e22, e22 + POISSON * e11, shear])


def von_mises(stress):
    s11, s22, s12 = stress.T
    return np.sqrt(s11**2 + s22**2 - s11 * s22 + 3 * s12**2)


def areas(points, quads):
    a, b, c, d = (points[quads[:, i]] for i in range(4))
    return 0.5 * np.linalg.norm(np.cross(c - a, d - b), axis=1)


def check_sheet(mesh, row):
    point, cell = mesh.point_data, {name: data[0].astype(float) for name, data in mesh.cell_data.items()}
    assert [block.type for block in mesh.cells] == ["quad"]
    assert set(point) == {"displacement", "director", "reaction", "thickness"}, sorted(point)
    close(mesh.field_data["TimeValue"], [row["level"]], "TimeValue")
    start = mesh.points - point["displacement"]
    crown = 0
    edge = int(np.argmin(start[:, 0] + (start[:, 1] - 254.0) ** 2))
    close(-point["displacement"][crown, 2], row["w_crown"], "w_crown")
    close(-point["displacement"][edge, 2], row["w_edge"], "w_edge")
    # The crown bears a quarter of the load; at the start there is none.
    assert abs(-4 * point["reaction"][crown, 2] - row["P"]) < ROUND_OFF * max(abs(row["P"]), 1.0), "P"
    close(np.linalg.norm(point["director"], axis=1), np.ones(len(start)), "directors")
    close(point["thickness"], np.full((len(start),), THICKNESS), "thickness")
    t = THICKNESS
    membrane = YOUNG * t / (1 - POISSON**2)
    shear = 5 / 6 * YOUNG / (2 * (1 + POISSON)) * t
    close(cell["membrane_force"], plane_stress(cell["membrane_strain"], membrane), "membrane_force", SINGLE)
    close(cell["moment"], plane_stress(cell["curvature"], membrane * t * t / 12), "moment", SINGLE)
    close(cell["shear_force"], shear * cell["shear_strain"], "shear_force", SINGLE)
    for side, name in [(1, "top"), (-1, "bottom")]:
        stress = cell["membrane_force"] / t + side * 6 / t**2 * cell["moment"]
        close(cell[f"stress_{name}"], stress, f"stress_{name}", SINGLE)
        close(cell[f"von_mises_{name}"], von_mises(stress), f"von_mises_{name}", SINGLE)
    close(np.linalg.norm(cell["t1"], axis=1), np.ones(len(cell["t1"])), "t1", SINGLE)
    # The work of the resultants is the internal energy less that of the zero-energy control.
    work = sum(
        np.sum(cell[force] * cell[strain], axis=1)
        for force, strain in [
            ("membrane_force", "membrane_strain"),
            ("moment", "curvature"),
            ("shear_force", "shear_strain"),
        ]
    )
    energy = 0.5 * np.sum(work * areas(start, mesh.cells[0].data))
    internal = row["internal"]
    assert energy <= internal * (1 + SINGLE), f"{energy} of {internal}"
    assert internal - energy <= 0.01 * internal, f"the control holds {1 - energy / internal:.1e}"


def check_solid(mesh, sheet):
    assert [block.type for block in mesh.cells] == ["hexahedron"]
    count = len(sheet.points)
    low, high = mesh.points[:count], mesh.points[count:]
    close(0.5 * (low + high), sheet.points, "middle of the faces")
    close(high - low, THICKNESS * sheet.point_data["director"], "thickness of the body")
    quads = sheet.cells[0].data
    assert (mesh.cells[0].data == np.hstack([quads, quads + count])).all(), "corners of the hexahedra"
    for name in ["von_mises_top", "von_mises_bottom"]:
        close(mesh.cell_data[name][0], sheet.cell_data[name][0], name)


def main(folder):
    columns = curve(folder)
    sheets, solids = (listed(folder / "fields" / name) for name in ["shell.pvd", "solid.pvd"])
    close([along for along, _ in sheets], columns["level"], "levels")
    assert [along for along, _ in sheets] == [along for along, _ in solids]
    for i, ((_, sheet_path), (_, solid_path)) in enumerate(zip(sheets, solids)):
        row = {name: values[i] for name, values in columns.items()}
        sheet = meshio.read(sheet_path)
        check_sheet(sheet, row)
        check_solid(meshio.read(solid_path), sheet)
    print(f"{len(sheets)} frames agree with the curve")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
