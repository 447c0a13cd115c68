//! The outer faces of hexahedra and wedges: what of a solid, or of a shell with its thickness, can be seen.

use std::borrow::Cow;
use std::collections::BTreeMap;

use mesh_io::{Array, Sheet};

/// Faces of a hexahedron, seen from outside counter-clockwise; its lower corners come before its upper ones.
const HEXAHEDRON: [&[usize]; 6] =
    [&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[3, 7, 6, 2], &[0, 4, 7, 3], &[1, 2, 6, 5]];
/// Those of a wedge.
const WEDGE: [&[usize]; 5] = [&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]];

/// The faces of a cell of volume, by places in the cell; none of a polygon.
fn sides(cell: &[usize]) -> &'static [&'static [usize]] {
    match cell.len() {
        8 => &HEXAHEDRON,
        6 => &WEDGE,
        _ => &[],
    }
}

/// The sheet with the faces that one cell of volume has alone in place of these cells; each has the numbers of its cell.
pub(super) fn outer(sheet: &Sheet) -> Cow<'_, Sheet> {
    if sheet.cells.iter().all(|cell| sides(cell).is_empty()) {
        return Cow::Borrowed(sheet);
    }
    let face = |cell: &[usize], side: &[usize]| side.iter().map(|&corner| cell[corner]).collect::<Vec<_>>();
    let sorted = |mut face: Vec<usize>| {
        face.sort_unstable();
        face
    };
    let mut used: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
    for cell in &sheet.cells {
        sides(cell).iter().for_each(|side| *used.entry(sorted(face(cell, side))).or_default() += 1);
    }
    // The cells that are drawn, and the cell whose numbers each has.
    let (mut cells, mut from) = (Vec::new(), Vec::new());
    for (number, cell) in sheet.cells.iter().enumerate() {
        if sides(cell).is_empty() {
            cells.push(cell.clone());
        }
        let faces = sides(cell).iter().map(|side| face(cell, side));
        cells.extend(faces.filter(|face| used[&sorted(face.clone())] == 1));
        from.resize(cells.len(), number);
    }
    let of_faces = |array: &Array| {
        let rows = from.iter().flat_map(|&cell| &array.numbers[cell * array.width..][..array.width]);
        Array { numbers: rows.copied().collect(), ..array.clone() }
    };
    let cell_data = sheet.cell_data.iter().map(|(name, array)| (name.clone(), of_faces(array))).collect();
    Cow::Owned(Sheet { cells, cell_data, ..sheet.clone() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_cubes_show_ten_faces() {
        let mut points = Vec::new();
        for z in 0..3 {
            points.extend([[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| [x, y, z].map(f64::from)));
        }
        let cells = vec![(0..8).collect::<Vec<usize>>(), (4..12).collect()];
        let heights = Array { width: 1, numbers: vec![0.5, 1.5], ..Array::default() };
        let cell_data = [("height".to_string(), heights)].into();
        let sheet = Sheet { points, cells, cell_data, ..Sheet::default() };
        let seen = outer(&sheet);
        assert_eq!((seen.cells.len(), seen.cell_data["height"].numbers.len()), (10, 10));
        assert_eq!(seen.cell_data["height"].numbers[..5], [0.5; 5]);
        // Every face is turned outward: its normal points away from the middle.
        for cell in &seen.cells {
            let x: Vec<nalgebra::Vector3<f64>> = cell.iter().map(|&a| sheet.points[a].into()).collect();
            let normal = (x[1] - x[0]).cross(&(x[2] - x[0]));
            assert!(normal.dot(&((x[0] + x[2]) * 0.5 - nalgebra::Vector3::new(0.5, 0.5, 1.0))) > 0.0);
        }
        assert!(matches!(outer(&seen), Cow::Borrowed(_)));
    }

    #[test]
    fn a_wedge_beside_a_triangle_has_five_faces_of_its_colour() {
        let sheet = Sheet {
            points: vec![[0.0; 3]; 9],
            cells: vec![(0..6).collect(), vec![6, 7, 8]],
            cell_data: [("n".into(), Array { width: 1, numbers: vec![3.0, 5.0], ..Array::default() })].into(),
            ..Sheet::default()
        };
        let drawn = outer(&sheet);
        assert_eq!(drawn.cell_data["n"].numbers, [3.0, 3.0, 3.0, 3.0, 3.0, 5.0]);
        // Every edge of a wedge belongs to two of its faces, which run along it in opposite directions.
        let edges = |face: &Vec<usize>| {
            (0..face.len()).map(|i| (face[i], face[(i + 1) % face.len()])).collect::<Vec<_>>()
        };
        let edges: Vec<_> = drawn.cells[..5].iter().flat_map(edges).collect();
        assert_eq!(edges.len(), 18);
        assert!(edges.iter().all(|&(a, b)| edges.iter().filter(|&&edge| edge == (b, a)).count() == 1));
    }
}
