//! Frames of several bodies as one, to be drawn together.

use mesh_io::{Array, Sheet};

/// Side of the square that stands for a particle \[L\], by point.
pub(super) const SIDE: &str = "side of particles";

/// One frame of the frames of several bodies: fields that a body does not have are no number on it.
pub fn together(sheets: Vec<Sheet>) -> Sheet {
    let mut all = Sheet::default();
    for mut sheet in sheets {
        if let Some(side) = side(&sheet) {
            let numbers = vec![side; sheet.points.len()];
            sheet.point_data.insert(SIDE.into(), Array { width: 1, numbers, ..Array::default() });
        }
        let (points, cells) = (all.points.len(), all.cells.len());
        join(&mut all.point_data, sheet.point_data, [points, sheet.points.len()]);
        join(&mut all.cell_data, sheet.cell_data, [cells, sheet.cells.len()]);
        all.points.extend(sheet.points);
        all.cells.extend(sheet.cells.into_iter().map(|cell| cell.into_iter().map(|a| a + points).collect()));
    }
    all
}

/// Side of the square or cube that the largest particle fills: those on a face have but a part of theirs.
pub(super) fn side(sheet: &Sheet) -> Option<f64> {
    let largest = |name: &str| {
        let sizes = sheet.point_data.get(name).filter(|sizes| sizes.width == 1)?;
        sizes.numbers.iter().copied().filter(|size| size.is_finite()).reduce(f64::max)
    };
    largest("area").map(f64::sqrt).or_else(|| largest("volume").map(libm::cbrt))
}

type Fields = std::collections::BTreeMap<String, Array>;

/// Puts fields of so many rows behind those of so many others.
fn join(all: &mut Fields, own: Fields, [before, rows]: [usize; 2]) {
    let lacks = |name: &String, array: &Array| own.get(name).is_none_or(|own| own.width != array.width);
    for (_, array) in all.iter_mut().filter(|(name, array)| lacks(name, array)) {
        array.numbers.extend(std::iter::repeat_n(f64::NAN, rows * array.width));
    }
    for (name, array) in own {
        let width = array.width;
        let known = all.entry(name).or_insert_with(|| Array {
            numbers: vec![f64::NAN; before * width],
            components: array.components.clone(),
            unit: array.unit.clone(),
            width,
        });
        if known.width == width && known.numbers.len() == before * width {
            known.numbers.extend(array.numbers);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_body_does_not_have_is_no_number() {
        let array = |numbers: &[f64]| Array { width: 1, numbers: numbers.into(), ..Array::default() };
        let water = Sheet {
            points: vec![[0.0; 3], [1.0, 0.0, 0.0]],
            cells: vec![vec![0], vec![1]],
            point_data: [("pressure".into(), array(&[1.0, 2.0])), ("area".into(), array(&[0.25, 0.25]))]
                .into(),
            ..Sheet::default()
        };
        let gate = Sheet {
            points: vec![[2.0, 0.0, 0.0]; 3],
            cells: vec![vec![0, 1, 2]],
            point_data: [("damage".into(), array(&[0.0, 0.5, 1.0]))].into(),
            ..Sheet::default()
        };
        let both = together(vec![water, gate]);
        assert_eq!(both.cells, [vec![0], vec![1], vec![2, 3, 4]]);
        let numbers = |name: &str| both.point_data[name].numbers.clone();
        assert_eq!(numbers("pressure")[..2], [1.0, 2.0]);
        assert!(
            numbers("pressure")[2..].iter().all(|x| x.is_nan())
                && numbers("damage")[..2].iter().all(|x| x.is_nan())
        );
        assert_eq!(numbers("damage")[2..], [0.0, 0.5, 1.0]);
        assert_eq!(numbers(SIDE)[..2], [0.5, 0.5]);
    }
}
