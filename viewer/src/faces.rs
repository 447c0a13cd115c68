//! Faces that can be seen: polygons of sheets, outer faces of cells of volume; the border of a sheet.

use std::collections::HashMap;

/// Faces of a hexahedron, seen from outside counter-clockwise; its lower corners come before its upper ones.
const HEXAHEDRON: [[usize; 4]; 6] =
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [3, 7, 6, 2], [0, 4, 7, 3], [1, 2, 6, 5]];
/// Those of a wedge; a triangle says its last corner twice.
const WEDGE: [[usize; 4]; 5] = [[0, 2, 1, 1], [3, 4, 5, 5], [0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]];

/// What of the cells of a body is drawn.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Faces {
    /// Corners round each face; a triangle says its last corner twice.
    pub faces: Vec<[u32; 4]>,
    /// Edges that one face has alone, in the direction of that face.
    pub border: Vec<[u32; 2]>,
}

impl Faces {
    /// Faces of cells as frames have them: polygons of three and four corners, wedges, hexahedra; points and lines have none.
    pub fn of(cells: &[Vec<usize>]) -> Self {
        let mut faces: Vec<[u32; 4]> = Vec::new();
        let mut sides: Vec<[u32; 4]> = Vec::new();
        for cell in cells {
            let at = |face: &[usize; 4]| face.map(|corner| cell[corner] as u32);
            match cell.len() {
                3 => faces.push(at(&[0, 1, 2, 2])),
                4 => faces.push(at(&[0, 1, 2, 3])),
                6 => sides.extend(WEDGE.iter().map(at)),
                8 => sides.extend(HEXAHEDRON.iter().map(at)),
                _ => {}
            }
        }
        let sorted = |face: &[u32; 4]| {
            let mut corners = *face;
            corners.sort_unstable();
            corners
        };
        let mut used: HashMap<[u32; 4], u32> = HashMap::with_capacity(sides.len());
        sides.iter().for_each(|face| *used.entry(sorted(face)).or_default() += 1);
        faces.extend(sides.into_iter().filter(|face| used[&sorted(face)] == 1));
        let border = border(&faces);
        Self { faces, border }
    }
}

/// Edges of a face, each from its first corner to its second.
fn edges(&[a, b, c, d]: &[u32; 4]) -> impl Iterator<Item = [u32; 2]> {
    [[a, b], [b, c], [c, d], [d, a]].into_iter().filter(|[from, to]| from != to)
}

fn border(faces: &[[u32; 4]]) -> Vec<[u32; 2]> {
    let undirected = |[from, to]: [u32; 2]| [from.min(to), from.max(to)];
    let mut used: HashMap<[u32; 2], u32> = HashMap::with_capacity(2 * faces.len());
    faces.iter().flat_map(edges).for_each(|edge| *used.entry(undirected(edge)).or_default() += 1);
    faces.iter().flat_map(edges).filter(|&edge| used[&undirected(edge)] == 1).collect()
}

/// Turns every face whose normal points against the directors at its corners, rows of three numbers.
pub(crate) fn toward(faces: &mut Faces, points: &[[f64; 3]], directors: &[f64]) {
    for face in &mut faces.faces {
        let [a, b, c, d] = face.map(|corner| corner as usize);
        let across = |from: usize, to: usize| [0, 1, 2].map(|k| points[to][k] - points[from][k]);
        let (u, v) = (across(a, c), across(b, d));
        let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let along: f64 =
            [a, b, c, d].iter().map(|i| (0..3).map(|k| normal[k] * directors[3 * i + k]).sum::<f64>()).sum();
        if along < 0.0 {
            let [a, b, c, d] = *face;
            *face = if c == d { [a, c, b, b] } else { [a, d, c, b] };
        }
    }
    faces.border = border(&faces.faces);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_cubes_show_ten_faces_without_a_border() {
        // Side by side along x: 3 by 2 by 2 points.
        let at = |i: usize, j: usize, k: usize| i + 3 * (j + 2 * k);
        let cube = |i: usize| -> Vec<usize> {
            [0, 1]
                .into_iter()
                .flat_map(|k| [at(i, 0, k), at(i + 1, 0, k), at(i + 1, 1, k), at(i, 1, k)])
                .collect()
        };
        let faces = Faces::of(&[cube(0), cube(1)]);
        assert_eq!((faces.faces.len(), faces.border.len()), (10, 0));
        // A wedge has two triangles and three quadrangles.
        let wedge = Faces::of(&[vec![0, 1, 2, 3, 4, 5]]);
        assert_eq!(wedge.faces.iter().filter(|face| face[2] == face[3]).count(), 2);
        assert_eq!((wedge.faces.len(), wedge.border.len()), (5, 0));
    }

    #[test]
    fn a_sheet_has_its_border_and_particles_have_nothing() {
        let faces = Faces::of(&[vec![0, 1, 4, 3], vec![1, 2, 4]]);
        assert_eq!((faces.faces.len(), faces.border.len()), (2, 5));
        assert_eq!(Faces::of(&[vec![0], vec![1], vec![0, 1]]), Faces::default());
    }

    #[test]
    fn faces_look_where_directors_point() {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let mut faces = Faces::of(&[vec![0, 1, 2, 3], vec![0, 1, 2]]);
        toward(&mut faces, &points, &[0.0, 0.0, 1.0].repeat(4));
        assert_eq!(faces.faces, [[0, 1, 2, 3], [0, 1, 2, 2]]);
        toward(&mut faces, &points, &[0.0, 0.0, -1.0].repeat(4));
        assert_eq!(faces.faces, [[0, 3, 2, 1], [0, 2, 1, 1]]);
    }
}
