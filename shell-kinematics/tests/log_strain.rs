//! The logarithmic measure against eigenvectors, differences, and bodies of which strain and curvature are known.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use std::sync::atomic::{AtomicU64, Ordering};

use nalgebra::{Matrix2, SymmetricEigen};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use shell_kinematics::{
    Logarithmic, Matrix8, MeasureForces, Measures, Pack, Resultants, StrainMeasure, Strains, StretchCorrected,
};

fn measures(m: [f64; 8]) -> Measures {
    let [a, b, c, d, e, f, g, h] = m.map(Pack::splat);
    Measures { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] }
}

fn of_strains(s: &Strains) -> [f64; 8] {
    let ([a, b, c], [d, e, f], [g, h]) = (s.membrane, s.curvature, s.shear);
    [a, b, c, d, e, f, g, h].map(|pack| pack.lanes()[0])
}

fn of_forces(s: &MeasureForces) -> [f64; 8] {
    let ([a, b, c], [d, e, f], [g, h]) = (s.membrane, s.curvature, s.shear);
    [a, b, c, d, e, f, g, h].map(|pack| pack.lanes()[0])
}

fn resultants(n: [f64; 8]) -> Resultants {
    let [a, b, c, d, e, f, g, h] = n.map(Pack::splat);
    Resultants { membrane: [a, b, c], moment: [d, e, f], shear: [g, h] }
}

/// Of a flat surface at rest, stretched by λ₁, λ₂ along axes turned by an angle, with curvatures and shears.
fn stretched([first, second]: [f64; 2], angle: f64, rest: [f64; 5]) -> [f64; 8] {
    let (s, c) = (libm::sin(angle), libm::cos(angle));
    let (a, b) = (first * first, second * second);
    let [c11, c22, c12] = [a * c * c + b * s * s, a * s * s + b * c * c, (a - b) * s * c];
    let [k1, k2, k12, g1, g2] = rest;
    [0.5 * c11, 0.5 * c22, c12, k1, k2, k12, g1, g2]
}

const REST: [f64; 8] = [0.5, 0.5, 0.0, 0.3, -0.2, 0.1, 0.02, -0.01];

fn states() -> impl Strategy<Value = [f64; 8]> {
    (prop::array::uniform2(0.4..2.5_f64), -3.2..3.2_f64, prop::array::uniform5(-1.0..1.0_f64))
        .prop_map(|(stretches, angle, rest)| stretched(stretches, angle, rest))
}

/// Greatest differences so far, as bits: of strains, of forces, of gradients, of second gradients.
static WORST: [AtomicU64; 5] = [const { AtomicU64::new(0) }; 5];

/// Prints a difference that is greater than all before.
fn seen(what: usize, difference: f64) -> f64 {
    // Bits of numbers that are not negative are ordered as they are.
    if WORST[what].fetch_max(difference.to_bits(), Ordering::Relaxed) < difference.to_bits() {
        let name = ["strains", "forces", "gradient", "second gradient", "its symmetry"][what];
        println!("{name} {difference:.1e}");
    }
    difference
}

proptest! {
    // The same cases on every run.
    #![proptest_config(ProptestConfig {
        cases: 512,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(19280101),
        ..ProptestConfig::default()
    })]

    /// `h = ½ ln C` and `U⁻¹ = C^{-1/2}` by eigenvectors: strains, curvatures and shears of stretches from .4 to 2.5.
    #[test]
    fn strains_are_those_of_the_eigenvectors(now in states()) {
        let found = of_strains(&Logarithmic.strains(&measures(now), &measures(REST)));
        let c = Matrix2::new(2.0 * now[0], now[2], now[2], 2.0 * now[1]);
        let SymmetricEigen { eigenvalues, eigenvectors } = SymmetricEigen::new(c);
        let of = |f: fn(f64) -> f64| {
            eigenvectors * Matrix2::from_diagonal(&eigenvalues.map(f)) * eigenvectors.transpose()
        };
        let (h, inverse) = (of(|value| 0.5 * libm::log(value)), of(|value| 1.0 / libm::sqrt(value)));
        let tensor = |at: &[f64; 8]| Matrix2::new(at[3], 0.5 * at[5], 0.5 * at[5], at[4]);
        let bent = inverse * tensor(&now);
        let k = (bent + bent.transpose()) * 0.5 - tensor(&REST);
        let gamma = inverse * nalgebra::Vector2::new(now[6] - REST[6], now[7] - REST[7]);
        let expected = [h.m11, h.m22, 2.0 * h.m12, k.m11, k.m22, 2.0 * k.m12, gamma.x, gamma.y];
        for (found, expected) in found.into_iter().zip(expected) {
            // 1.8e-15: rounding of strains to .9 and curvatures to 2.5.
            prop_assert!(seen(0, (found - expected).abs()) < 5.4e-15, "{found} {expected}");
        }
    }

    /// Forces on the measures, gradient and second gradient against differences of the eighth order.
    #[test]
    fn transpose_and_gradients_are_derivatives(now in states(), stress in prop::array::uniform8(-1.0..1.0_f64)) {
        let rest = measures(REST);
        let with = resultants(stress);
        let at = measures(now);
        let forces = of_forces(&Logarithmic.transpose(&at, &rest, &with));
        let gradient: Matrix8 = Logarithmic.gradient(&at, &rest);
        let second: Matrix8 = Logarithmic.second_gradient(&at, &rest, &with);
        // Least principal C is .16: its change in four steps is a twentieth of it.
        let h = 1e-3;
        let slopes = |of: &dyn Fn(&Measures) -> [f64; 8], j: usize| -> [f64; 8] {
            let by = |steps: f64| {
                let mut moved = now;
                moved[j] += steps * h;
                of(&measures(moved))
            };
            let rows = [1.0, 2.0, 3.0, 4.0].map(|steps| (by(steps), by(-steps)));
            let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
            std::array::from_fn(|i| {
                rows.iter().zip(weights).map(|((a, b), w)| w * (a[i] - b[i])).sum::<f64>() / h
            })
        };
        for j in 0..8 {
            let of_strain = slopes(&|m| of_strains(&Logarithmic.strains(m, &rest)), j);
            let of_force = slopes(&|m| of_forces(&Logarithmic.transpose(m, &rest, &with)), j);
            let power: f64 = (0..8).map(|i| stress[i] * of_strain[i]).sum();
            let size = 1.0 + forces[j].abs();
            // 6.5e-13, of the gradient 5.5e-13, of the second 3.3e-12: rounding over the step.
            prop_assert!(seen(1, (power - forces[j]).abs() / size) < 2e-12, "{j}: {power} {}", forces[j]);
            for i in 0..8 {
                let (exact, twice) = (gradient[i][j].lanes()[0], second[i][j].lanes()[0]);
                let off = (of_strain[i] - exact).abs() / (1.0 + exact.abs());
                prop_assert!(seen(2, off) < 2e-12, "{i} {j}: {off:.1e}");
                let size = 1.0 + twice.abs();
                let off = (of_force[i] - twice).abs() / size;
                prop_assert!(seen(3, off) < 1e-11, "{i} {j}: {off:.1e}");
                let off = (twice - second[j][i].lanes()[0]).abs() / size;
                // A second derivative is symmetric: 2.5e-14.
                prop_assert!(seen(4, off) < 8e-14, "{i} {j}: {off:.1e}");
            }
        }
    }
}

/// The transpose is that of the gradient to rounding: no differences.
#[test]
fn the_transpose_is_that_of_the_gradient() {
    let mut worst = 0.0_f64;
    for i in 0..200 {
        let number = |k: usize| libm::sin(1.3 * i as f64 + 2.1 * k as f64);
        let now = stretched(
            [1.4 + number(0), 1.5 + number(1)],
            3.0 * number(2),
            std::array::from_fn(|k| number(3 + k)),
        );
        let stress: [f64; 8] = std::array::from_fn(|k| number(8 + k));
        let (at, rest) = (measures(now), measures(REST));
        let forces = of_forces(&Logarithmic.transpose(&at, &rest, &resultants(stress)));
        let gradient = Logarithmic.gradient(&at, &rest);
        for j in 0..8 {
            let sum: f64 = (0..8).map(|k| stress[k] * gradient[k][j].lanes()[0]).sum();
            worst = worst.max((sum - forces[j]).abs() / (1.0 + forces[j].abs()));
        }
    }
    println!("{worst:.1e}");
    // 1.2e-15: rounding.
    assert!(worst < 4e-15, "{worst:.1e}");
}

/// A strip of any stretch λ rolled to a circle: the logarithm of λ, and the angle that a unit of its length at rest turns.
#[test]
fn a_stretched_circle_has_the_curvature_of_its_turning() {
    let flat = measures([0.5, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    for stretch in [0.5, 0.9, 1.0, 1.1, 1.3, 1.8, 3.0] {
        let turn = 0.4;
        // x,₁ = λ t and d,₁ = turn t per length at rest.
        let circle = measures([0.5 * stretch * stretch, 0.5, 0.0, stretch * turn, 0.0, 0.0, 0.0, 0.0]);
        let found = of_strains(&Logarithmic.strains(&circle, &flat));
        assert!((found[0] - libm::log(stretch)).abs() < 4e-16 && found[1].abs() < 4e-16);
        assert!((found[3] - turn).abs() < 1e-15, "{stretch}: {}", found[3]);
    }
}

/// Two stretches one after the other along one axis add; so do those that follow each other in a turned frame of the same axes.
#[test]
fn strains_along_one_axis_add() {
    let rest = measures([0.5, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let strain = |stretches: [f64; 2], angle: f64| {
        of_strains(&Logarithmic.strains(&measures(stretched(stretches, angle, [0.0; 5])), &rest))
    };
    for angle in [0.0, 0.3, 1.2] {
        let (one, two) = (strain([1.3, 0.8], angle), strain([1.2, 1.1], angle));
        let both = strain([1.3 * 1.2, 0.8 * 1.1], angle);
        for i in 0..3 {
            assert!((one[i] + two[i] - both[i]).abs() < 1e-15);
        }
    }
}

/// Small strains are those of the stretch-corrected measure, to the square of their size.
#[test]
fn small_strains_are_those_of_the_corrected_measure() {
    let rest = measures(REST);
    let apart = |size: f64| {
        let change = [0.4, -0.3, 0.5, 0.6, -0.2, 0.3, 0.1, -0.2];
        let now = measures(std::array::from_fn(|i| REST[i] + size * change[i]));
        let (log, corrected) = (Logarithmic.strains(&now, &rest), StretchCorrected.strains(&now, &rest));
        let pairs = of_strains(&log).into_iter().zip(of_strains(&corrected));
        pairs.fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()))
    };
    let (large, small) = (apart(1e-2), apart(1e-3));
    println!("{large:.1e} {small:.1e}");
    assert!((large / small - 100.0).abs() < 5.0, "{large:.1e} {small:.1e}");
}
