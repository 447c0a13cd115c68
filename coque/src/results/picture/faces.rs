//! Bodies of volume as their faces: pictures draw polygons.

use mesh_io::{Array, Sheet};

/// Faces of a hexahedron, its lower corners before its upper ones.
const HEXAHEDRON: [&[usize]; 6] =
    [&[0, 1, 2, 3], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]];
/// Faces of a wedge.
const WEDGE: [&[usize]; 5] = [&[0, 1, 2], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]];

/// A sheet with hexahedra and wedges, of which a shell with its thickness is made, as their faces; each has the numbers of
/// its cell.
pub fn faces(mut sheet: Sheet) -> Sheet {
    let of = |cell: &Vec<usize>| -> &[&[usize]] {
        match cell.len() {
            8 => &HEXAHEDRON,
            6 => &WEDGE,
            _ => &[],
        }
    };
    if sheet.cells.iter().all(|cell| of(cell).is_empty()) {
        return sheet;
    }
    let (mut cells, mut from) = (Vec::new(), Vec::new());
    for (number, cell) in sheet.cells.iter().enumerate() {
        if of(cell).is_empty() {
            cells.push(cell.clone());
        }
        cells.extend(of(cell).iter().map(|face| face.iter().map(|&corner| cell[corner]).collect()));
        from.resize(cells.len(), number);
    }
    for Array { numbers, width, .. } in sheet.cell_data.values_mut() {
        let row = |&cell: &usize| numbers[cell * *width..(cell + 1) * *width].to_vec();
        *numbers = from.iter().flat_map(row).collect();
    }
    sheet.cells = cells;
    sheet
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_brick_beside_a_triangle_has_six_faces_of_its_colour() {
        let sheet = Sheet {
            points: vec![[0.0; 3]; 11],
            cells: vec![(0..8).collect(), vec![8, 9, 10]],
            cell_data: [("n".into(), Array { width: 1, numbers: vec![3.0, 5.0], ..Array::default() })].into(),
            ..Sheet::default()
        };
        let drawn = faces(sheet);
        assert_eq!(drawn.cells.len(), 7);
        assert_eq!(drawn.cell_data["n"].numbers, [3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 5.0]);
        // Every edge of a brick belongs to two of its faces.
        let mut edges: Vec<[usize; 2]> = drawn.cells[..6]
            .iter()
            .flat_map(|face| (0..4).map(move |i| [face[i], face[(i + 1) % 4]]))
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        assert!(edges.chunks(2).all(|pair| pair[0] == pair[1]) && edges.len() == 24);
    }
}
