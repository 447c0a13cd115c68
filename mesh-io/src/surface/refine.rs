//! The same surface with faces cut into four, all of them or some: what tells how far an answer depends on their size.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use sph_core::{Cell, Vec3};

use super::curved::{bulges, edges};
use super::{Arrays, Surface};

/// A surface that was refined.
#[derive(Clone, Debug, PartialEq)]
pub struct Finer {
    /// The surface.
    pub arrays: Arrays,
    /// Of each node that it has more, the nodes in whose middle it is.
    pub parents: Vec<Vec<u32>>,
}

impl Surface {
    /// The surface with a node in the middle of each edge and of each quadrangle, which lies on the surface through the nodes beside it, not on the
    /// chord (curved.rs). Nodes of a junction are one again; groups of faces keep their
    /// faces, and groups of nodes take in the middle of an edge both ends of which are theirs, if it lies on the boundary or one of the ends
    /// does not. Normals, sections and materials of the file are not kept.
    pub fn refined(&self) -> Arrays {
        self.refined_at(&vec![true; self.faces.len()]).arrays
    }

    /// The same of the faces that are marked. A face beside them is divided so that all fit: with one edge divided a quadrangle into two and a
    /// triangle about its middle, a triangle into two; with two edges into two or three quadrangles, a triangle into one and a triangle;
    /// with more it is refined as well.
    pub fn refined_at(&self, marked: &[bool]) -> Finer {
        let first = self.first_of_junctions();
        let rings = self.rings(&first);
        let divided = divided(&rings, marked);
        let mut points: Vec<[f64; 3]> = self.positions.iter().map(|&x| x.into()).collect();
        let mut new = Middles { first: points.len(), parents: Vec::new(), bulges: bulges(self, &first) };
        let (mut faces, mut middles) = (Vec::new(), BTreeMap::new());
        let mut uses: BTreeMap<[u32; 2], usize> = BTreeMap::new();
        // The place of a face's own node, with its corners.
        let mut centres = Vec::new();
        let mut parts = Vec::with_capacity(rings.len());
        for ring in &rings {
            let mut middle = Vec::with_capacity(ring.len());
            for edge in edges(ring) {
                *uses.entry(edge).or_default() += 1;
                middle.push(
                    divided
                        .contains(&edge)
                        .then(|| *middles.entry(edge).or_insert_with(|| new.middle(&mut points, &edge))),
                );
            }
            let begin = faces.len() as u32;
            divide(ring, &middle, &mut faces, &mut || {
                let node = new.middle(&mut points, ring);
                centres.push((node, ring.clone()));
                node
            });
            parts.push(begin..faces.len() as u32);
        }
        let boundary: BTreeSet<u32> =
            uses.iter().filter(|(_, count)| **count == 1).flat_map(|(edge, _)| *edge).collect();
        let face_sets: BTreeMap<String, Vec<u32>> = self
            .face_sets
            .iter()
            .map(|(name, own)| {
                (name.clone(), own.iter().flat_map(|&face| parts[face as usize].clone()).collect())
            })
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
        Finer { arrays: Arrays { sets: sets.collect(), points, faces, face_sets }, parents: new.parents }
    }

    /// Of each node the first of its junction.
    fn first_of_junctions(&self) -> Vec<u32> {
        let mut first: Vec<u32> = (0..self.positions.len() as u32).collect();
        for group in &self.joined {
            group.iter().for_each(|&node| first[node as usize] = group[0]);
        }
        first
    }

    /// Corners of the faces, nodes of a junction one again.
    fn rings(&self, first: &[u32]) -> Vec<Vec<u32>> {
        let ring = |cell: &Cell| {
            cell.corners[..usize::from(cell.count)].iter().map(|&node| first[node as usize]).collect()
        };
        self.faces.iter().map(ring).collect()
    }
}

/// Edges that get a node: those of the faces that are marked, and of those beside them that have too many such edges to be divided otherwise.
fn divided(rings: &[Vec<u32>], marked: &[bool]) -> BTreeSet<[u32; 2]> {
    let of_marked = rings.iter().zip(marked).filter(|(_, marked)| **marked);
    let mut divided: BTreeSet<[u32; 2]> = of_marked.flat_map(|(ring, _)| edges(ring)).collect();
    loop {
        let before = divided.len();
        for ring in rings {
            let count = edges(ring).filter(|edge| divided.contains(edge)).count();
            if count > 2 {
                divided.extend(edges(ring));
            }
        }
        if divided.len() == before {
            return divided;
        }
    }
}

/// The parts of a face, of whose edges some have a node in the middle; `centre` makes its own.
fn divide(ring: &[u32], middle: &[Option<u32>], faces: &mut Vec<[u32; 4]>, centre: &mut dyn FnMut() -> u32) {
    let count = ring.len();
    // From the first divided edge behind one that is not.
    let turned = |from: usize| -> (Vec<u32>, Vec<Option<u32>>) {
        let at = |k: usize| (from + k) % count;
        ((0..count).map(|k| ring[at(k)]).collect(), (0..count).map(|k| middle[at(k)]).collect())
    };
    let begin = (0..count).find(|&k| middle[k].is_some() && middle[(k + count - 1) % count].is_none());
    let (ring, middle) = turned(begin.unwrap_or(0));
    match (&ring[..], &middle[..]) {
        (&[a, b, c], &[Some(ab), Some(bc), Some(ca)]) => {
            faces.extend([[a, ab, ca, ca], [ab, b, bc, bc], [ca, bc, c, c], [ab, bc, ca, ca]]);
        }
        (&[a, b, c], &[Some(ab), Some(bc), None]) => faces.extend([[ab, b, bc, bc], [a, ab, bc, c]]),
        (&[a, b, c], &[Some(ab), None, None]) => faces.extend([[a, ab, c, c], [ab, b, c, c]]),
        (&[a, b, c, d], &[Some(ab), Some(bc), Some(cd), Some(da)]) => {
            let m = centre();
            faces.extend([[a, ab, m, da], [ab, b, bc, m], [m, bc, c, cd], [da, m, cd, d]]);
        }
        (&[a, b, c, d], &[Some(ab), None, Some(cd), None]) => {
            faces.extend([[a, ab, cd, d], [ab, b, c, cd]]);
        }
        (&[a, b, c, d], &[Some(ab), Some(bc), None, None]) => {
            let m = centre();
            faces.extend([[a, ab, m, d], [ab, b, bc, m], [m, bc, c, d]]);
        }
        (&[a, b, c, d], &[Some(ab), None, None, None]) => {
            let m = centre();
            faces.extend([[a, ab, m, d], [ab, b, c, m], [m, c, d, d]]);
        }
        (&[a, b, c], _) => faces.push([a, b, c, c]),
        (&[a, b, c, d], _) => faces.push([a, b, c, d]),
        _ => {}
    }
}

/// Nodes in the middle of others.
struct Middles {
    first: usize,
    parents: Vec<Vec<u32>>,
    /// How far edges lie off their chords in the middle \[L\].
    bulges: HashMap<[u32; 2], Vec3>,
}

impl Middles {
    /// Adds the middle of an edge or a face; its number. That of a face is where the surface through its edges is \[coons1967\]: the mean of its corners
    /// and half of what its four edges bulge.
    fn middle(&mut self, points: &mut Vec<[f64; 3]>, nodes: &[u32]) -> u32 {
        let sum: Vec3 = nodes.iter().map(|&node| Vec3::from(points[node as usize])).sum();
        let bulge = match nodes {
            &[a, b] => self.bulges.get(&[a, b]).copied(),
            _ => edges(nodes)
                .filter_map(|edge| self.bulges.get(&edge))
                .copied()
                .reduce(|a, b| a + b)
                .map(|sum| 0.5 * sum),
        };
        let mean = sum / nodes.len() as f64;
        points.push(bulge.map_or(mean, |bulge| mean + bulge).into());
        self.parents.push(nodes.to_vec());
        (self.first + self.parents.len() - 1) as u32
    }
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

    /// A square of 4×4 quadrangles.
    fn square() -> Arrays {
        let n = 4;
        let at = |i: u32, j: u32| i * (n + 1) + j;
        Arrays {
            points: (0..=n).flat_map(|i| (0..=n).map(move |j| [f64::from(i), f64::from(j), 0.0])).collect(),
            faces: (0..n)
                .flat_map(|i| (0..n).map(move |j| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]))
                .collect(),
            sets: BTreeMap::from([("left".into(), (0..=n).collect())]),
            face_sets: BTreeMap::from([("corner".into(), vec![0])]),
        }
    }

    #[test]
    fn faces_beside_the_marked_ones_are_divided_to_fit() {
        // Two in the same row leave the one between them two divided edges; one at a corner leaves its neighbours one each.
        for marked in
            [vec![0], vec![5], vec![5, 6], vec![5, 7], vec![5, 10], vec![0, 5, 15], vec![4, 1, 6, 9]]
        {
            let surface = square().surface("square", false).unwrap();
            let mut at = vec![false; 16];
            marked.iter().for_each(|&face: &usize| at[face] = true);
            let finer = surface.refined_at(&at);
            assert_eq!(finer.parents.len(), finer.arrays.points.len() - 25);
            let found = finer.arrays.surface("finer", false).unwrap();
            // No edge hangs: one piece with one boundary, whose faces have the area of the square.
            assert_eq!((found.pieces, found.loops.len()), (1, 1), "{marked:?}");
            let area: f64 = finer
                .arrays
                .faces
                .iter()
                .map(|face| {
                    let [a, b, c, d] = face.map(|node| Vec3::from(finer.arrays.points[node as usize]));
                    0.5 * (c - a).cross(&(d - b)).z
                })
                .sum();
            assert!((area - 16.0).abs() < 1e-12, "{marked:?}: {area}");
            assert!(finer.arrays.faces.len() >= 16 + 3 * marked.len());
        }
    }

    #[test]
    fn sets_take_part_where_their_edges_are_divided() {
        let surface = square().surface("square", false).unwrap();
        let mut at = vec![false; 16];
        at[0] = true;
        let finer = surface.refined_at(&at).arrays;
        assert_eq!((finer.sets["left"].len(), finer.face_sets["corner"].len()), (6, 4));
    }
}
