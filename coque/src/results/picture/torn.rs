//! Cells across an open crack: bonds hold them no longer, and what a picture would show there is no material.

use mesh_io::Sheet;

/// Mean damage of its corners beyond which a cell may be torn: a node beside a crack through its family has lost two
/// bonds in five.
const BROKEN: f64 = 0.2;
/// A torn cell has an edge that is drawn so many times as long as it was.
const OPEN: f64 = 1.5;

/// Whether a crack runs through a cell and stands open: from the corners at rest and as they are drawn.
pub(super) fn torn(sheet: &Sheet, cell: &[usize], rest: &[[f64; 3]], drawn: &[[f64; 3]]) -> bool {
    let Some(damage) = sheet.point_data.get("damage").filter(|damage| damage.width == 1) else {
        return false;
    };
    let mean = cell.iter().map(|&a| damage.numbers[a]).sum::<f64>() / cell.len() as f64;
    // Of another body beside one that breaks the damage is no number.
    if cell.len() < 3 || mean.is_nan() || mean <= BROKEN {
        return false;
    }
    let square = |x: &[f64; 3], y: &[f64; 3]| x.iter().zip(y).map(|(x, y)| (x - y).powi(2)).sum::<f64>();
    (0..cell.len()).any(|i| {
        let (a, b) = (cell[i], cell[(i + 1) % cell.len()]);
        square(&drawn[a], &drawn[b]) > OPEN * OPEN * square(&rest[a], &rest[b])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use mesh_io::Array;

    #[test]
    fn only_what_is_broken_and_open_is_torn() {
        let rest = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let mut open = rest;
        open[1][0] = 1.6;
        open[2][0] = 1.6;
        let sheet = |damage: f64| Sheet {
            point_data: [("damage".into(), Array { width: 1, numbers: vec![damage; 4], ..Array::default() })]
                .into(),
            ..Sheet::default()
        };
        let cell = [0, 1, 2, 3];
        assert!(torn(&sheet(0.4), &cell, &rest, &open));
        assert!(!torn(&sheet(0.4), &cell, &rest, &rest) && !torn(&sheet(0.1), &cell, &rest, &open));
        assert!(
            !torn(&sheet(f64::NAN), &cell, &rest, &open) && !torn(&Sheet::default(), &cell, &rest, &open)
        );
    }
}
