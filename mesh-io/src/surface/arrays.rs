//! Surfaces from arrays in memory: the same checks as those of files.

mod written;

use std::collections::BTreeMap;

use super::raw::Raw;
use super::{MeshError, Surface};

/// A surface as whoever meshed it has it in memory; nodes and faces are counted from zero.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arrays {
    /// Positions of the nodes `[L]`.
    pub points: Vec<[f64; 3]>,
    /// Corners of the faces, in order round each; of a triangle the last one stands twice.
    pub faces: Vec<[u32; 4]>,
    /// Nodes of sets, by name.
    pub sets: BTreeMap<String, Vec<u32>>,
    /// Faces of sets, by name; their nodes are a set as well.
    pub face_sets: BTreeMap<String, Vec<u32>>,
}

impl Arrays {
    /// The surface; `name` is for messages. Where it `may_hang`, nodes may stand on edges that they do not belong to.
    ///
    /// # Errors
    /// [`MeshError`] for numbers that are no nodes or faces, places that are not finite, and what is no sound surface.
    pub fn surface(&self, name: &str, may_hang: bool) -> Result<Surface, MeshError> {
        let surface = self.raw().and_then(|raw| Surface::new(raw, None, may_hang));
        let surface = surface.map_err(|error| error.named(name))?;
        Ok(Surface { file: name.into(), checksum: self.checksum(), ..surface })
    }

    fn raw(&self) -> Result<Raw, MeshError> {
        let mut raw = Raw::default();
        for (node, &point) in self.points.iter().enumerate() {
            if !point.iter().all(|x| x.is_finite()) {
                return Err(MeshError::whole(
                    format!("node {node} has no finite place"),
                    "give three numbers",
                ));
            }
            raw.push(0, point)?;
        }
        for (face, corners) in (0..).zip(&self.faces) {
            within(corners, self.points.len(), &format!("face {face}"), "node")?;
            let count = if corners[3] == corners[2] { 3 } else { 4 };
            raw.face(0, face, &corners[..count])?;
        }
        for (name, nodes) in &self.sets {
            within(nodes, self.points.len(), &format!("the set {name}"), "node")?;
            raw.make_room(0, nodes.len())?;
            raw.add_to_set(name, nodes);
        }
        for (name, faces) in &self.face_sets {
            within(faces, self.faces.len(), &format!("the set {name}"), "face")?;
            raw.make_room(0, faces.len())?;
            raw.add_faces_to_set(name, faces);
        }
        Ok(raw)
    }

    /// Of all places and corners.
    fn checksum(&self) -> u32 {
        let mut sum = crc32fast::Hasher::new();
        self.points.as_flattened().iter().for_each(|x| sum.update(&x.to_le_bytes()));
        self.faces.as_flattened().iter().for_each(|corner| sum.update(&corner.to_le_bytes()));
        sum.finalize()
    }
}

/// Refuses numbers beyond those that are there.
fn within(numbers: &[u32], count: usize, user: &str, what: &str) -> Result<(), MeshError> {
    match numbers.iter().find(|number| **number as usize >= count) {
        None => Ok(()),
        Some(number) => {
            let found = format!("{user} names {what} {number} where there are {count}");
            Err(MeshError::whole(found, "count from zero"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{Format, parse};

    /// Two quadrangles and a triangle.
    fn strip() -> Arrays {
        let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 1.0], [1.0, 1.0], [2.0, 1.0], [2.5, 0.5]];
        Arrays {
            points: points.map(|[x, y]| [x, y, 0.0]).into(),
            faces: vec![[0, 1, 4, 3], [1, 2, 5, 4], [2, 6, 5, 5]],
            sets: BTreeMap::from([("left".into(), vec![0, 3])]),
            face_sets: BTreeMap::from([("tip".into(), vec![2])]),
        }
    }

    #[test]
    fn arrays_are_the_surface_of_their_file() {
        let file = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 2.5 0.5 0\nf 1 2 5 4\nf 2 3 6 5\nf 3 7 6\n";
        let (read, made) =
            (parse("a.obj", Format::Obj, file.as_bytes()).unwrap(), strip().surface("a", false).unwrap());
        assert_eq!((&read.positions, &read.faces, &read.loops), (&made.positions, &made.faces, &made.loops));
        assert_eq!(made.set("left").unwrap().len(), 2);
        assert_eq!(made.set("tip").unwrap().len(), 3);
        assert_eq!(made.face_sets["tip"].len(), 1);
        let moved = Arrays { points: vec![[0.0, 0.0, 0.1]; 7], ..strip() };
        assert_ne!(made.checksum, moved.checksum());
    }

    #[test]
    fn what_is_no_surface_is_refused_by_its_number() {
        let refused = |arrays: Arrays| arrays.surface("panel", false).unwrap_err().to_string();
        let broken =
            |face: [u32; 4]| refused(Arrays { faces: vec![face], face_sets: BTreeMap::new(), ..strip() });
        assert!(broken([0, 1, 7, 3]).contains("face 0 names node 7 where there are 7"));
        assert!(broken([0, 1, 1, 3]).contains("face 0 has the node at"));
        assert!(broken([0, 1, 2, 2]).contains("no area"));
        let mut nowhere = strip();
        nowhere.points[2][1] = f64::NAN;
        assert!(refused(nowhere).starts_with("panel: node 2 has no finite place"));
        let sets = BTreeMap::from([("far".into(), vec![9])]);
        assert!(refused(Arrays { sets: sets.clone(), ..strip() }).contains("the set far names node 9"));
        assert!(refused(Arrays { face_sets: sets, ..strip() }).contains("the set far names face 9"));
        assert!(refused(Arrays::default()).contains("no triangles or quadrangles"));
    }
}
