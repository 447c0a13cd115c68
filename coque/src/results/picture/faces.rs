//! The outer faces of hexahedra: what of a solid can be seen.

use std::borrow::Cow;
use std::collections::BTreeMap;

use mesh_io::{Array, Sheet};

/// Corners of a hexahedron.
const HEXAHEDRON: usize = 8;
/// Its faces, seen from outside counter-clockwise.
const SIDES: [[usize; 4]; 6] =
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [3, 7, 6, 2], [0, 4, 7, 3], [1, 2, 6, 5]];

/// The sheet with the faces that one hexahedron has alone in place of the hexahedra.
pub(super) fn outer(sheet: &Sheet) -> Cow<'_, Sheet> {
    if sheet.cells.iter().all(|cell| cell.len() != HEXAHEDRON) {
        return Cow::Borrowed(sheet);
    }
    let faces = |cell: &[usize]| SIDES.map(|side| side.map(|corner| cell[corner]));
    let sorted = |mut face: [usize; 4]| {
        face.sort_unstable();
        face
    };
    let mut used: BTreeMap<[usize; 4], usize> = BTreeMap::new();
    for cell in sheet.cells.iter().filter(|cell| cell.len() == HEXAHEDRON) {
        faces(cell).into_iter().for_each(|face| *used.entry(sorted(face)).or_default() += 1);
    }
    // The cells that are drawn, and the cell whose numbers each has.
    let (mut cells, mut from) = (Vec::new(), Vec::new());
    for (number, cell) in sheet.cells.iter().enumerate() {
        let drawn: Vec<Vec<usize>> = match cell.len() {
            HEXAHEDRON => {
                let seen = faces(cell).into_iter().filter(|face| used[&sorted(*face)] == 1);
                seen.map(Vec::from).collect()
            }
            _ => vec![cell.clone()],
        };
        from.extend(drawn.iter().map(|_| number));
        cells.extend(drawn);
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
}
