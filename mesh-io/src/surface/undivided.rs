//! One node for all sheets that meet at a place: folds with one normal, for stencils that reach across.

use std::collections::HashMap;

use super::boundary::{boundary_edges, loops};
use super::{Junctions, MeshError, Surface};

impl Surface {
    /// The same with one node at a place where sheets meet, whose normal is the mean over all of them.
    ///
    /// # Errors
    /// [`MeshError`] where more than two faces would then share an edge.
    pub fn undivided(mut self) -> Result<Self, MeshError> {
        if self.joined.is_empty() {
            return Ok(self);
        }
        let mut stays = vec![true; self.positions.len()];
        let mut place: Vec<u32> = (0..self.positions.len() as u32).collect();
        for group in &self.joined {
            for &node in &group[1..] {
                (stays[node as usize], place[node as usize]) = (false, group[0]);
            }
        }
        let mut number = vec![0; stays.len()];
        let mut count = 0;
        for (number, stays) in number.iter_mut().zip(&stays) {
            *number = count;
            count += u32::from(*stays);
        }
        let new = |node: u32| number[place[node as usize] as usize];
        for face in &mut self.faces {
            face.corners = face.corners.map(new);
        }
        keep(&mut self.positions, &stays);
        keep(&mut self.labels, &stays);
        if let Some(normals) = &mut self.normals {
            keep(normals, &stays);
        }
        for nodes in self.sets.values_mut() {
            *nodes = nodes.iter().map(|&node| new(node)).collect();
            nodes.sort_unstable();
            nodes.dedup();
        }
        self.refuse_branches()?;
        self.loops = loops(&self.positions, &boundary_edges(&self.faces), &[]);
        (self.joined, self.junctions) = (Vec::new(), Junctions::default());
        Ok(self)
    }

    fn refuse_branches(&self) -> Result<(), MeshError> {
        let mut at: HashMap<(u32, u32), usize> = HashMap::new();
        for (face, (a, b)) in
            self.faces.iter().enumerate().flat_map(|(i, f)| f.edges().map(move |edge| (i, edge)))
        {
            let count = at.entry((a.min(b), a.max(b))).or_insert(0);
            *count += 1;
            if *count > 2 {
                let what = format!(
                    "the edge between {} and {} belongs to 3 faces or more, and the formulation reaches across edges",
                    self.name(a),
                    self.name(b)
                );
                let repair =
                    "use formulation.stress-point with the support \"cell\", which keeps sheets apart";
                return Err(MeshError::at(self.origins[face].1, what, repair).named(&self.file));
            }
        }
        Ok(())
    }
}

/// Leaves out the entries of nodes that do not stay.
fn keep<T>(list: &mut Vec<T>, stays: &[bool]) {
    let mut stays = stays.iter();
    list.retain(|_| stays.next().copied().unwrap_or_default());
}
