//! `coque mesh`: reads a surface and prints what was found.

use std::path::PathBuf;

use clap::Args;

use super::stderr::{Refused, print};

#[derive(Args)]
pub struct Mesh {
    /// The file: .msh (Gmsh 2.2, 4.1 ASCII), .inp (Abaqus), .stl, .obj, .ply, .vtu, or .csv (points).
    file: PathBuf,
    /// The surface of a body: of tetrahedra what bounds them; refused unless it is closed and looks outwards.
    #[arg(long)]
    body: bool,
}

pub const HELP: &str = "\
Examples:
  coque mesh panel.msh
  coque mesh hull.inp
  coque mesh --body part.msh    # for geometry.filled of a solid, and for what floats

In a scene, beside it:
  [geometry.mesh]
  file = \"panel.msh\"     # relative to the scene
  scale = 0.001           # lengths of the file times this; 1 without
  flip = true             # normals to the other side; false without

Sets for supports, loads and curves: `all`, the groups of the file by their names, the boundary loops
`boundary0`, `boundary1`, ... (the longest first), and what the scene declares:
  [sets]
  crown = { nearest = [0.0, 0.0, 2540.0] }
  end = { plane = { point = [254.0, 0.0, 0.0], normal = [1.0, 0.0, 0.0] } }
  foot = { box = { min = [0.0, 0.0, 0.0], max = [1.0, 9.0, 0.1] } }
A force on a set along the boundary is shared by length, a couple wants one such line.

Where sets and normals come from:
  .msh  physical groups; a view of three components called normals
  .inp  *Nset, *Elset and *Surface; direction cosines after the coordinates of a *Node;
        *Shell Section and *Material for section.file = {} and material.file = {}
  .stl  solids, if there are several; vertices that coincide are merged
  .obj  groups and objects; vn
  .ply  none; nx, ny, nz
  .vtu  point data of whole numbers 0 and 1; point data Normals
  .csv  points with columns x,y,z,nx,ny,nz,area[,thickness], for formulation.nodal alone
Other formats: `meshio convert FILE surface.vtu --ascii`.

Exit codes: 0 sound, 2 refused.";

/// Reads, checks, prints; the error is ready to print.
pub fn carry_out(mesh: &Mesh) -> Result<(), Refused> {
    let text = match mesh.body {
        true => crate::mesh::read_body(&mesh.file).and_then(|surface| crate::mesh::report_body(&surface)),
        false => crate::mesh::read(&mesh.file).and_then(|surface| crate::mesh::report(&surface)),
    };
    print(&text.map_err(|error| format!("{error}\n"))?)
}
