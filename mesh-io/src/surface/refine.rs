//! The same surface with each face cut into four, flat: what tells how far an answer depends on the size of its faces.

use std::collections::{BTreeMap, BTreeSet};

use sph_core::{Cell, Vec3};

use super::{Arrays, Surface};

impl Surface {
    /// The surface with a node in the middle of each edge and of each quadrangle. Nodes of a junction are one again; groups of faces keep their
    /// faces, and groups of nodes take in the middle of an edge both ends of which are theirs, if it lies on the boundary or one of the ends
    /// does not. Normals, sections and materials of the file are not kept.
    pub fn refined(&self) -> Arrays {
        let mut first: Vec<u32> = (0..self.positions.len() as u32).collect();
        for group in &self.joined {
            group.iter().for_each(|&node| first[node as usize] = group[0]);
        }
        let corners = |cell: &Cell| -> Vec<u32> {
            cell.corners[..usize::from(cell.count)].iter().map(|&node| first[node as usize]).collect()
        };
        let mut points: Vec<[f64; 3]> = self.positions.iter().map(|&x| x.into()).collect();
        let (mut faces, mut middles) = (Vec::new(), BTreeMap::new());
        let mut uses: BTreeMap<[u32; 2], usize> = BTreeMap::new();
        // The place of a quadrangle's own node, with its corners.
        let mut centres = Vec::new();
        for cell in &self.faces {
            let ring = corners(cell);
            let count = ring.len();
            let mut middle = Vec::with_capacity(count);
            for k in 0..count {
                let (a, b) = (ring[k], ring[(k + 1) % count]);
                let edge = [a.min(b), a.max(b)];
                *uses.entry(edge).or_default() += 1;
                middle.push(*middles.entry(edge).or_insert_with(|| mean(&mut points, &[a, b])));
            }
            match (&ring[..], &middle[..]) {
                (&[a, b, c], &[ab, bc, ca]) => {
                    faces.extend([[a, ab, ca, ca], [ab, b, bc, bc], [ca, bc, c, c], [ab, bc, ca, ca]]);
                }
                (&[a, b, c, d], &[ab, bc, cd, da]) => {
                    let m = mean(&mut points, &[a, b, c, d]);
                    centres.push((m, ring.clone()));
                    faces.extend([[a, ab, m, da], [ab, b, bc, m], [m, bc, c, cd], [da, m, cd, d]]);
                }
                _ => {}
            }
        }
        let boundary: BTreeSet<u32> =
            uses.iter().filter(|(_, count)| **count == 1).flat_map(|(edge, _)| *edge).collect();
        let face_sets: BTreeMap<String, Vec<u32>> = self
            .face_sets
            .iter()
            .map(|(name, own)| (name.clone(), own.iter().flat_map(|face| 4 * face..4 * face + 4).collect()))
            .collect();
        let of_nodes = self.sets.iter().filter(|(name, _)| !face_sets.contains_key(*name));
        let sets = of_nodes.map(|(name, own)| {
            let members: BTreeSet<u32> = own.iter().map(|&node| first[node as usize]).collect();
            let holds = |node: &u32| members.contains(node);
            let inner = |nodes: &[u32]| nodes.iter().any(|node| !boundary.contains(node));
            let along = middles.iter().filter(|(edge, _)| {
                edge.iter().all(holds) && (uses.get(*edge) == Some(&1) || inner(&edge[..]))
            });
            let within = centres.iter().filter(|(_, ring)| ring.iter().all(holds) && inner(ring));
            let mut all: Vec<u32> = members.iter().copied().collect();
            all.extend(along.map(|(_, &node)| node).chain(within.map(|&(node, _)| node)));
            (name.clone(), all)
        });
        Arrays { sets: sets.collect(), points, faces, face_sets }
    }
}

/// Adds the mean of some nodes; its number.
fn mean(points: &mut Vec<[f64; 3]>, nodes: &[u32]) -> u32 {
    let sum: Vec3 = nodes.iter().map(|&node| Vec3::from(points[node as usize])).sum();
    points.push((sum / nodes.len() as f64).into());
    points.len() as u32 - 1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two quadrangles and a triangle, with sets of an edge and of a face.
    fn strip() -> Arrays {
        let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 1.0], [1.0, 1.0], [2.0, 1.0], [2.5, 0.5]];
        Arrays {
            points: points.map(|[x, y]| [x, y, 0.0]).into(),
            faces: vec![[0, 1, 4, 3], [1, 2, 5, 4], [2, 6, 5, 5]],
            sets: BTreeMap::from([("left".into(), vec![0, 3]), ("ends".into(), vec![0, 3, 1, 4])]),
            face_sets: BTreeMap::from([("tip".into(), vec![2])]),
        }
    }

    #[test]
    fn each_face_becomes_four_on_the_same_surface() {
        let finer = strip().surface("strip", false).unwrap().refined();
        assert_eq!(finer.faces.len(), 12);
        // Seven nodes, nine edges, two quadrangles.
        assert_eq!(finer.points.len(), 7 + 9 + 2);
        let surface = finer.surface("strip", false).unwrap();
        assert_eq!((surface.pieces, surface.loops.len()), (1, 1));
        assert_eq!(surface.set("left").unwrap().len(), 3);
        assert_eq!(surface.face_sets["tip"].len(), 4);
        assert_eq!(surface.set("tip").unwrap().len(), 6);
        // All lie on the boundary: the three edges of the boundary count, the edge between the two quadrangles does not.
        assert_eq!(surface.set("ends").unwrap().len(), 4 + 3);
    }

    #[test]
    fn twice_refined_it_is_sixteen_times_as_many() {
        let once = strip().surface("strip", false).unwrap().refined();
        let twice = once.surface("strip", false).unwrap().refined();
        assert_eq!(twice.faces.len(), 16 * 3);
        assert_eq!(twice.surface("strip", false).unwrap().set("left").unwrap().len(), 5);
    }
}
