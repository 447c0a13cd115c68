//! A plate whose end is moved, through buckling.

use benchmarks_ref::fe_shell::cases::plate_shortened;

/// E t b/((1 − ν²) a) of the plate with its sides held \[kN/mm\].
const FLAT: f64 = 69.0 * 2.0 * 200.0 / ((1.0 - 0.33 * 0.33) * 300.0);
/// Its critical force by the closed form \[kN\].
const CRITICAL: f64 = 6.863;

/// The first secant is that of the flat plate less what a tenth of the thickness bends; beyond the critical force the plate
/// keeps .704 of its stiffness, by one term of the plate's equations.
#[test]
fn the_shortened_plate_keeps_its_share_of_stiffness_beyond_its_critical_force() {
    let solved = plate_shortened(6, 0.2, 0.13, 13).unwrap();
    let (u, force) = (solved.column(0), solved.column(1));
    assert!((force[1] / (FLAT * u[1]) - 1.0).abs() < 0.03, "{}", force[1]);
    let at = |wanted: f64| {
        let row = force.iter().position(|&f| f > wanted).unwrap();
        let part = (wanted - force[row - 1]) / (force[row] - force[row - 1]);
        u[row - 1] + part * (u[row] - u[row - 1])
    };
    let kept = 0.3 * CRITICAL / (at(1.6 * CRITICAL) - at(1.3 * CRITICAL)) / FLAT;
    // One term keeps its share at the critical force; it falls from there on, by .02 to 1.6 times it.
    assert!((kept - 0.70).abs() < 0.03, "{kept}");
}
