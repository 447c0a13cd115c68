//! Homogeneous strains on lattices: moduli of families, corrected energies at every node, stress, turned bodies.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod lattices;

use lattices::{ALL, displace, formulation, lattice, parts, plane, poisson};
use nalgebra::{Matrix3, Rotation3};
use peridynamics::{Correction, Elastic, Formulation, Influence, Law, Solid, Space, Volumes};
use sph_core::Vec3;

/// Strains small enough that squares of them do not show in five digits.
const SMALL: f64 = 1e-7;

fn strained(body: &mut Solid, strain: &Matrix3<f64>) {
    displace(body, |x| strain * x);
    body.evaluate_internal(true);
}

/// A strain of ones at these places, times the small one.
fn unit(places: &[(usize, usize)]) -> Matrix3<f64> {
    let mut strain = Matrix3::zeros();
    for &(a, b) in places {
        strain[(a, b)] += 0.5 * SMALL;
        strain[(b, a)] += 0.5 * SMALL;
    }
    strain
}

/// E/E₀, ν and G/G₀ of families without correction on infinite lattices. The figures are those of an independent program
/// that sums the energy of one family; printed to four places.
#[test]
fn uncorrected_lattices_have_these_moduli() {
    use Influence::{Constant, Inverse, Linear};
    let (solid, lps) = (Space::Solid, Law::StateBased);
    let (flat, pmb) = (Space::PlaneStress, Law::BondBased);
    for (space, law, influence, horizon, volumes, wanted) in [
        (solid, lps, Constant, 2.015, Volumes::Whole, [1.1341, 0.3072, 0.8974]),
        (solid, lps, Constant, 2.015, Volumes::Partial, [1.0529, 0.3210, 0.9599]),
        (solid, lps, Constant, 3.015, Volumes::Whole, [0.8507, 0.3554, 1.1102]),
        (solid, lps, Constant, 3.015, Volumes::Partial, [1.0160, 0.3273, 0.9879]),
        (solid, lps, Inverse, 3.015, Volumes::Whole, [0.8836, 0.3498, 1.0862]),
        (solid, lps, Inverse, 3.015, Volumes::Partial, [1.0160, 0.3273, 0.9879]),
        (solid, lps, Linear, 3.015, Volumes::Partial, [0.9925, 0.3313, 1.0056]),
        (flat, pmb, Inverse, 3.015, Volumes::Whole, [1.0486, 0.3182, 0.9902]),
        (flat, pmb, Inverse, 3.015, Volumes::Partial, [1.0434, 0.3165, 0.9786]),
        (flat, pmb, Inverse, 4.015, Volumes::Whole, [0.9749, 0.3170, 0.9163]),
        (flat, pmb, Inverse, 4.015, Volumes::Partial, [1.0209, 0.3300, 1.0084]),
        (flat, pmb, Inverse, 6.015, Volumes::Partial, [1.0101, 0.3308, 1.0007]),
    ] {
        let correction = Correction::None;
        let material =
            Elastic { young: 1.0, poisson: if law == lps { 0.33 } else { 1.0 / 3.0 }, density: 1.0 };
        let shape = Formulation { space, law, horizon, volumes, influence, correction };
        // Bonds of a node are those of both ends: the families of its family must be whole too.
        let n = 4 * (horizon + 0.5) as usize + 3;
        let block = if space == solid { lattice(3, [n; 3], [1.0; 3]) } else { plane([n; 2], 1.0) };
        let middle = block.len() / 2;
        let mut body = Solid::new(parts(block, material, shape)).unwrap();
        let mut density = |places: &[(usize, usize)]| {
            strained(&mut body, &unit(places));
            2.0 * body.strain_energy(middle) / (SMALL * SMALL)
        };
        let (one, both, shear) = (density(&[(0, 0)]), density(&[(0, 0), (1, 1)]), density(&[(0, 1)]));
        // W = ½ C₁₁ ε², (C₁₁ + C₁₂) ε², ½ G γ² with γ of one.
        let (c11, c12, g) = (one, 0.5 * both - one, shear);
        let (young, nu) = if space == solid {
            ((c11 - c12) * (c11 + 2.0 * c12) / (c11 + c12), c12 / (c11 + c12))
        } else {
            (c11 - c12 * c12 / c11, c12 / c11)
        };
        let g0 = material.moduli(space).unwrap().mu;
        for (found, wanted) in [young, nu, g / g0].into_iter().zip(wanted) {
            // Half of the last place printed, and as much for the strain.
            assert!((found - wanted).abs() < 1e-4, "{shape:?}: {found:.5}, {wanted}");
        }
    }
}

/// The corrected energy of a block is that of the solid for the unit strains, its faces, edges and corners included, and the stress in its inside is `λ tr ε + 2μ ε`.
#[test]
fn corrected_energies_are_exact_at_every_node() {
    for (space, law) in ALL {
        let d = space.dimensions();
        let material = Elastic { young: 3.0, poisson: poisson(space, law), density: 1.0 };
        let moduli = material.moduli(space).unwrap();
        let n = 17;
        let block = if d == 3 { lattice(3, [n, n, n], [1.0; 3]) } else { plane([n, n], 1.0) };
        let (count, middle) = (block.len(), block.len() / 2);
        let mut body = Solid::new(parts(block, material, formulation(space, law))).unwrap();
        for a in 0..d {
            for b in a..d {
                let strain = unit(&[(a, b)]);
                strained(&mut body, &strain);
                let trace = strain.trace();
                let wanted = 0.5 * moduli.lambda * trace * trace + moduli.mu * strain.norm_squared();
                let whole: f64 = (0..count).map(|node| body.strain_energy(node)).sum();
                // Of the whole body, since half of a bond is the other end's.
                let error = whole / (count as f64 * wanted) - 1.0;
                // The square of the strain.
                assert!(error.abs() < 1e-7, "{space:?} {law:?} {a}{b}: {error}");
                let mut stress = strain * (2.0 * moduli.mu);
                let held = if space == Space::PlaneStress { d } else { 3 };
                (0..held).for_each(|k| stress[(k, k)] += moduli.lambda * trace);
                let error = (body.stress(middle) - stress).norm() / stress.norm();
                assert!(error < 1e-6, "{space:?} {law:?} {a}{b}: {error}");
                assert!((body.strain_energy(middle) / wanted - 1.0).abs() < 1e-6);
            }
        }
    }
}

/// Two nodes alone: `f = 2(d²λ + 2dμ) e/(r² V)`, which is `18 k e/r²` in space. Pairs far from each other make a body.
#[test]
fn two_nodes_pull_by_the_bulk_modulus() {
    let mut block = lattice(3, [2, 1, 1], [1.0; 3]);
    for shift in [Vec3::new(40.0, 0.0, 0.0), Vec3::new(0.0, 40.0, 0.0), Vec3::new(0.0, 0.0, 40.0)] {
        for node in 0..2 {
            block.positions.push(block.positions[node] + shift);
            block.volumes.push(1.0);
        }
    }
    let material = Elastic { young: 2.0, poisson: 0.2, density: 1.0 };
    let shape = Formulation { correction: Correction::None, ..formulation(Space::Solid, Law::StateBased) };
    let mut body = Solid::new(parts(block, material, shape)).unwrap();
    let e = 1e-3;
    body.put(1, body.position(1) + Vec3::x() * e);
    body.evaluate_internal(false);
    let bulk = material.young / (3.0 * (1.0 - 2.0 * material.poisson));
    // The extension is the difference of numbers of order one: 1e-16 of 1e-3.
    assert!((-body.internal_force(0).x / (18.0 * bulk * e) - 1.0).abs() < 1e-12);
}

/// Turned bodies bear nothing.
#[test]
fn rigid_rotations_give_no_force() {
    for (space, law) in ALL {
        let material = Elastic { young: 3.0, poisson: poisson(space, law), density: 1.0 };
        let block = if space == Space::Solid { lattice(3, [7, 6, 5], [1.0; 3]) } else { plane([9, 8], 1.0) };
        let mut body = Solid::new(parts(block, material, formulation(space, law))).unwrap();
        strained(&mut body, &(Matrix3::from_diagonal(&Vec3::new(1e5 * SMALL, 0.0, 0.0))));
        let most =
            |body: &Solid| (0..body.len()).map(|node| body.internal_force(node).norm()).fold(0.0, f64::max);
        let force = most(&body);
        for degrees in [90.0_f64, 33.0] {
            let axis = if space == Space::Solid { Vec3::new(1.0, 2.0, -0.5) } else { Vec3::z() };
            let turn = Rotation3::from_scaled_axis(axis.normalize() * degrees.to_radians());
            displace(&mut body, |x| turn * x - x);
            body.evaluate_internal(false);
            // Rounding of places of order ten over extensions of 1e-2: 1e-13.
            assert!(most(&body) < 1e-12 * force, "{space:?} {law:?}: {:e} of {force}", most(&body));
        }
    }
}
