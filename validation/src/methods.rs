//! The methods that the same case is run with, from the compact cell to the published strong form, and their looks in charts.

use crate::figures::{BLACK, BLUE, Colour, GREEN, Mark, ORANGE, PURPLE, SKY, VERMILION};

/// The default formulation.
pub const CELL: &str = "stress-point cell";
/// Stress points with a kernel that reaches the four particles of a cell.
pub const WIDE_14: &str = "stress-point 1.4";
/// Stress points with a kernel that reaches twelve particles, the outer eight with little weight.
pub const WIDE_25: &str = "stress-point 2.5";
/// Stress points with the widest kernel that scenes allow.
pub const WIDE_30: &str = "stress-point 3";
/// Sampling at the particles, gradients exact on linear fields.
pub const NODAL_1: &str = "nodal 1";
/// Sampling at the particles, gradients exact on quadratic fields, divergence consistent.
pub const NODAL_2: &str = "nodal 2";
/// Sampling at the particles, gradients exact on cubic fields, divergence consistent, Gregory end weights.
pub const NODAL_3: &str = "nodal 3";
/// The published equations with the published smoothing length.
pub const STRONG_12: &str = "strong-form 1.2";
/// The published equations with a narrower kernel.
pub const STRONG_085: &str = "strong-form 0.85";
/// The published equations with the divergence in difference form and edges prescribed, kernel as narrow.
pub const STRONG_DIFFERENCE: &str = "strong-form, difference";

/// The default formulation without time: the same discrete energy, solved by Newton's method.
pub const STATIC: &str = "stress-point cell, static";

/// The default formulation relaxed: the same energy, by a fictitious motion without a factor of the tangent.
pub const RELAXED: &str = "stress-point cell, relaxed";

/// The independent finite-element shell.
pub const ELEMENTS: &str = "fe shell";

/// Bonds that feel their own extension alone.
pub const PAIRWISE: &str = "bond-based";
/// Bonds that feel the dilatation at both ends.
pub const STATE: &str = "state-based";
/// A rigid body.
pub const RIGID: &str = "rigid body";
/// A thin plate of two peridynamic sheets on directors.
pub const SHEETS: &str = "two sheets";

/// A method.
pub struct Setting {
    /// Name in table and report.
    pub method: &'static str,
    /// Path and value in the scene; none for the default.
    pub set: Option<(&'static str, &'static str)>,
    /// Colour in charts.
    pub colour: Colour,
    /// Mark in charts.
    pub mark: Mark,
}

/// All of shells, finite elements beside. Reach 2 is left out: on these lattices it holds the same four particles as 1.4.
#[rustfmt::skip]
pub const METHODS: [Setting; 13] = [
    Setting { method: CELL, set: None, colour: BLUE, mark: Mark::Disc },
    Setting { method: STATIC, set: None, colour: BLUE, mark: Mark::Square },
    Setting { method: RELAXED, set: None, colour: BLUE, mark: Mark::Triangle },
    Setting { method: ELEMENTS, set: None, colour: BLACK, mark: Mark::Diamond },
    Setting { method: WIDE_14, set: Some(("stress-point.support", "1.4")), colour: SKY, mark: Mark::Circle },
    Setting { method: WIDE_25, set: Some(("stress-point.support", "2.5")), colour: SKY, mark: Mark::Square },
    Setting { method: WIDE_30, set: Some(("stress-point.support", "3.0")), colour: SKY, mark: Mark::Triangle },
    Setting { method: NODAL_1, set: Some(("nodal.order", "1")), colour: ORANGE, mark: Mark::Circle },
    Setting { method: NODAL_2, set: Some(("nodal.order", "2")), colour: PURPLE, mark: Mark::Square },
    Setting { method: NODAL_3, set: Some(("nodal.order", "3")), colour: GREEN, mark: Mark::Triangle },
    Setting { method: STRONG_12, set: Some(("strong-form.smoothing", "1.2")), colour: VERMILION, mark: Mark::Cross },
    Setting { method: STRONG_085, set: Some(("strong-form.smoothing", "0.85")), colour: BLACK, mark: Mark::Cross },
    Setting { method: STRONG_DIFFERENCE, set: Some(("strong-form.divergence", "\"difference\"")), colour: VERMILION, mark: Mark::Square },
];

/// Those of peridynamic bodies.
#[rustfmt::skip]
pub const OF_BONDS: [Setting; 3] = [
    Setting { method: PAIRWISE, set: None, colour: SKY, mark: Mark::Disc },
    Setting { method: STATE, set: None, colour: VERMILION, mark: Mark::Disc },
    Setting { method: SHEETS, set: None, colour: VERMILION, mark: Mark::Square },
];

/// The settings of a method.
pub fn setting(method: &str) -> Option<&'static Setting> {
    METHODS.iter().chain(&OF_BONDS).find(|setting| setting.method == method)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_are_listed_once() {
        for method in [
            CELL,
            STATIC,
            RELAXED,
            ELEMENTS,
            WIDE_14,
            WIDE_25,
            WIDE_30,
            NODAL_1,
            NODAL_2,
            NODAL_3,
            STRONG_12,
            STRONG_085,
            STRONG_DIFFERENCE,
            PAIRWISE,
            STATE,
            SHEETS,
        ] {
            assert_eq!(
                METHODS.iter().chain(&OF_BONDS).filter(|setting| setting.method == method).count(),
                1,
                "{method}"
            );
        }
    }
}
