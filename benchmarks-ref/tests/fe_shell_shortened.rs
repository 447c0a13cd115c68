//! A plate whose end is moved, through buckling.

use benchmarks_ref::fe_shell::cases::{plate_path, plate_shortened};

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

/// The flat plate buckles by itself: its force leaves the straight line at the critical one, and keeps `1/(1 + 2 (a² + νb²)²/((1 − ν²)
/// (a⁴ + 3b⁴)))` = .7037 of the stiffness, a = 1/300 and b = 1/200.
#[test]
fn the_flat_plate_buckles_by_itself() {
    let solved = plate_path(6, 0.0, 0.006, 0.08).unwrap();
    let points: Vec<(f64, f64)> = solved.column(0).into_iter().zip(solved.column(1)).collect();
    let flat = points[1].1 / points[1].0;
    assert!((flat / FLAT - 1.0).abs() < 1e-4, "measured 3e-5: {flat}");
    let bent: Vec<(f64, f64)> =
        points.iter().filter(|point| point.1 < 0.99 * flat * point.0).copied().collect();
    let [(u, force), .., (v, last)] = bent[..] else { panic!("{points:?}") };
    let kept = (last - force) / (v - u) / flat;
    let at = (force - kept * flat * u) / (1.0 - kept);
    assert!((kept / 0.7037 - 1.0).abs() < 0.025, "measured .008, by 18 × 12 elements and a secant: {kept}");
    assert!((at / CRITICAL - 1.0).abs() < 2.5e-3, "measured 8e-4: {at}");
    assert!(solved.column(2).last().is_some_and(|w| *w > 0.7), "along z");
}
