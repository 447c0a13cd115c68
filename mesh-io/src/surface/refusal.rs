//! What the cloud refuses of a surface, with nodes and faces named as in the file.

use sph_core::{Cell, SpaceError};

use super::raw::counted;
use super::{MeshError, Surface};

impl Surface {
    /// What a cloud refused, with particles and cells named as the file does.
    pub fn refusal(&self, error: &SpaceError) -> MeshError {
        let name = |node: usize| self.name(node as u32);
        let line = |node: usize| {
            let used = |face: &Cell| face.particles().contains(&(node as u32));
            self.faces.iter().position(used).map_or(0, |face| self.origins[face].1)
        };
        let refusal = match *error {
            SpaceError::Coincident { first, second, .. } => MeshError::at(
                line(second),
                format!("{} and {} coincide", name(first), name(second)),
                "merge them: in Gmsh with Coherence Mesh or Mesh.MeshSizeMin, elsewhere by equivalencing nodes",
            ),
            SpaceError::Isolated { particle, .. } => MeshError::whole(
                format!("{} is far from all others", name(particle)),
                "remove it, or bring its neighbours",
            ),
            SpaceError::BadNumber { particle, what, value, bound } => MeshError::at(
                line(particle),
                format!("{}: {what} is {value}; it must be {bound}", name(particle)),
                "correct it in the file",
            ),
            SpaceError::Sliver { cell, particle, degrees, bound } => {
                let (line, face) = self.face_of(cell);
                let what = format!(
                    "{face}: the corner at {} has {degrees:.2}°; at least {bound}° is needed",
                    name(particle)
                );
                MeshError::at(
                    line,
                    what,
                    "move the node, merge it with its neighbour, or mesh the surface anew",
                )
            }
            SpaceError::NormalAgainstCell { particle, cell, degrees } => {
                let (line, face) = self.face_of(cell);
                let what = format!(
                    "{face}: the normal at {} is {degrees:.0}° from that of the face; less than 90° is needed",
                    name(particle)
                );
                let repair = match self.normals {
                    Some(_) => "turn it round, or leave the normals out of the file",
                    None => {
                        "the surface folds there: refine it, or give the parts nodes of their own along the fold"
                    }
                };
                MeshError::at(line, what, repair)
            }
            ref other => {
                let message = other.to_string();
                let (what, repair) = message.rsplit_once("; ").unwrap_or((&message, "mesh the surface anew"));
                MeshError::whole(what, repair)
            }
        };
        refusal.named(&self.file)
    }

    /// Line and words for the face, or the two joined triangles, behind a cell of the cloud.
    fn face_of(&self, cell: usize) -> (usize, String) {
        let (cells, _) = self.cells(&vec![0; self.faces.len()]);
        let Some((cell, _)) = cells.get(cell) else { return (0, format!("cell {cell}")) };
        let inside =
            |one: &Cell, other: &Cell| one.particles().iter().all(|node| other.particles().contains(node));
        // A half of a warped quadrangle lies within its face.
        let within = |face: &Cell| inside(face, cell) || face.count == 4 && inside(cell, face);
        let found: Vec<(u64, usize)> = self
            .faces
            .iter()
            .zip(&self.origins)
            .filter(|(face, _)| within(face))
            .map(|(_, origin)| *origin)
            .collect();
        let line = found.first().map_or(0, |(_, line)| *line);
        match found[..] {
            [(one, _)] => (line, format!("face {one}")),
            [(one, _), (other, _)] => (line, format!("faces {one} and {other}, joined into a quadrangle")),
            _ => (line, format!("{} between the same nodes", counted(found.len(), "face"))),
        }
    }
}
