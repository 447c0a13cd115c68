//! Strips and a sphere on smooth flats: a fold between two, a cantilever that comes to lie on one, a strip lifted off one, a hemisphere pressed by one.

use libm::{pow, sqrt};

use crate::catalogue::{Reference, reference};
use crate::error::ReferenceError;

/// P h²/B of a fold between plates: twice the square of `∫ √sin` over a right angle.
const FOLD: f64 = 2.871_080_04;

/// Force P/B of a unit of width \[1/L²\] on a strip folded between plates, the mid-surfaces of whose legs are a distance apart \[L\].
pub fn fold(distance: f64) -> f64 {
    FOLD / (distance * distance)
}

/// Force of a flat on a cantilever of length one under a load q that is spread over it \[B c/L⁴\], whose face is a height c above the flat; in B c/L³
/// of a unit of width.
///
/// From 8 on its end touches, with `3 (q − 8)/8`; from 72 on it lies flat beyond the free span `a = (72/q)^¼` and the flat bears `q a/3`
/// on the line of lift-off and `q (1 − a)` beyond.
pub fn cantilever_on_flat(load: f64) -> f64 {
    if load <= 72.0 {
        return (0.375 * (load - 8.0)).max(0.0);
    }
    let span = pow(72.0 / load, 0.25);
    load * (1.0 - span) + load * span / 3.0
}

/// Length l/l₀ that hangs of a heavy strip whose end is lifted by so much \[q l₀⁴/B\], and the force on the end F/(q l₀).
pub fn lifted(lift: f64) -> [f64; 2] {
    let length = sqrt(sqrt(24.0 * lift));
    [length, 0.5 * length]
}

/// Approach δ/t of a rigid flat to a hemisphere with R/t = 100, and force F R/(E t³), by elements.
///
/// # Errors
/// [`ReferenceError`] if the table is not there.
pub fn hemisphere_on_flat() -> Result<Vec<[f64; 2]>, ReferenceError> {
    let table: Reference = reference("contact_hemisphere_on_flat")?;
    let row = |row: usize| Ok([table.number(row, "delta")?, table.number(row, "F")?]);
    (0..table.rows.len()).map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_forms_are_those_of_the_tables() {
        let near = |found: f64, known: f64, what: &str| {
            assert!((found / known - 1.0).abs() < 1e-7, "{what}: {found} {known}");
        };
        let table = reference("contact_fold_between_plates").unwrap();
        for row in 0..table.rows.len() {
            let [h, force] = ["h", "P/B"].map(|column| table.number(row, column).unwrap());
            near(fold(h), force, "fold");
        }
        let table = reference("contact_strip_lifted").unwrap();
        for row in 0..table.rows.len() {
            let [lift, length, force] = ["delta", "l", "F"].map(|column| table.number(row, column).unwrap());
            near(lifted(lift)[0], length, "length");
            near(lifted(lift)[1], force, "force");
        }
        let table = reference("contact_cantilever_on_flat").unwrap();
        let of = |row, column: &str| table.number(row, column).unwrap();
        for row in 0..table.rows.len() {
            let (load, span) = (of(row, "q"), of(row, "free span"));
            let line = of(row, "force at the tip, or on the line of lift-off");
            let whole = line + load * (1.0 - span);
            assert!((cantilever_on_flat(load) - whole).abs() < 1e-5, "{load}: {whole}");
        }
    }

    /// A small approach is that of a point load, 4/√(3(1 − ν²)) δ/t, and a disc stiffens from there on.
    #[test]
    fn the_hemisphere_begins_as_under_a_point_load_and_stiffens() {
        let rows = hemisphere_on_flat().unwrap();
        let point = 4.0 / sqrt(3.0 * (1.0 - 0.3 * 0.3));
        assert!((rows[0][1] / rows[0][0] / point - 1.0).abs() < 0.12, "{:?}", rows[0]);
        // The first row is that in which contact is least resolved.
        for pair in rows[1..].windows(2) {
            assert!(pair[1][1] / pair[1][0] > pair[0][1] / pair[0][0], "{pair:?}");
        }
    }
}
