//! How sharp a contact may be on which bonds rub.

use crate::scene::bounded::Rounding;

/// Least rounding of contact on which bonds rub \[–\]: nodes that slide on a sharp law flutter, and lose the force across in which they rub. A block that slides
/// on a slope of 30 degrees is then 7 to 22 % too fast, with .005 by 5·10⁻⁴.
const LEAST_ROUNDING: f64 = 0.005;
/// The same in words.
pub(super) const RUBBED_BONDS: &str =
    "0.005 or more beside friction of a solid of bonds: nodes that slide on a sharper law flutter";

/// Whether bonds would flutter on a rounding.
pub(super) fn too_sharp(rounding: &Rounding) -> bool {
    rounding.get() < LEAST_ROUNDING
}
