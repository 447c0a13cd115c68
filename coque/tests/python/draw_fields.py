"""Opens the list of frames of a run with pyvista, as ParaView would, and draws the last one.

python draw_fields.py DIR PICTURE: DIR is the folder of a run with stresses and the extruded shell.
Ends with an assertion if the picture is blank or a body is turned inside out.
"""

import sys
from pathlib import Path

import numpy as np
import pyvista


def last(path):
    reader = pyvista.get_reader(path)
    reader.set_active_time_value(reader.time_values[-1])
    return reader.read()[0]


def main(folder, picture):
    sheet = last(folder / "fields" / "shell.pvd")
    solid = last(folder / "fields" / "solid.pvd")
    volumes = solid.compute_cell_sizes(length=False, area=False)["Volume"]
    assert (volumes > 0).all(), "a cell of the body is turned inside out"
    plotter = pyvista.Plotter(off_screen=True, window_size=(800, 600))
    plotter.add_mesh(solid, scalars="von_mises_top", show_edges=True, cmap="viridis")
    plotter.add_mesh(sheet.extract_feature_edges(manifold_edges=False), color="black", line_width=3)
    image = plotter.screenshot(str(picture), return_img=True)
    share = np.mean(np.any(image != image[0, 0], axis=2))
    # The body fills a fair part of the window; a blank picture or a flat colour does not.
    assert share > 0.05, f"only {share:.1%} of the picture is drawn"
    assert len(np.unique(image.reshape(-1, image.shape[2]), axis=0)) > 100, "one colour for all stresses"
    print(f"{picture}: {share:.0%} drawn")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
