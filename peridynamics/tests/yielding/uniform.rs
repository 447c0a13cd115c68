//! Uniform strains: a node inside yields as an elastic–plastic solid does, in all directions.

use nalgebra::Matrix3;
use peridynamics::{Correction, Influence, Plastic};
use sph_core::Vec3;

use crate::blocks::{
    DX, SHEAR, YOUNG, bonds, middle, mises, on_edges, perfect, shear, strain, usual, yielding,
};
use crate::lattices::lattice;

/// So little that squares of strains count for nothing.
const YIELD: f64 = 1e-7 * YOUNG;

/// Pure shears along and across the axes, then extensions that keep the volume; each of von Mises' strain one, that of an elastic
/// solid at `σ = 3μ`.
fn directions() -> Vec<Matrix3<f64>> {
    let sheared = |n: [f64; 3], m: [f64; 3]| shear(n.into(), m.into()) * 3.0_f64.sqrt();
    let drawn = |n: Vec3| {
        let n = n.normalize();
        n * n.transpose() * 1.5 - Matrix3::identity() * 0.5
    };
    vec![
        sheared([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        sheared([1.0, 1.0, 0.0], [1.0, -1.0, 0.0]),
        sheared([1.0, 1.0, 1.0], [1.0, 1.0, -2.0]),
        sheared([1.0, 2.0, 3.0], [3.0, 0.0, -1.0]),
        drawn(Vec3::x()),
        drawn(Vec3::new(1.0, 1.0, 0.0)),
        drawn(Vec3::new(1.0, 1.0, 1.0)),
    ]
}

/// Up beyond the yield stress, part of the way back, and through zero: stress, plastic strain and work are those of von Mises' law.
#[test]
fn a_node_inside_yields_at_von_mises_stress_in_all_directions() {
    let unit = YIELD / (3.0 * SHEAR);
    for (influence, horizon, count) in [(Influence::Inverse, 2.015, 13), (Influence::Linear, 1.5, 9)] {
        for hardening in [0.0, 0.3 * SHEAR] {
            let plastic = Plastic { yield_stress: YIELD, hardening };
            for direction in directions() {
                let block = lattice(3, [count; 3], [DX; 3]);
                let mut body = yielding(block, bonds(Correction::Even, influence, horizon), plastic);
                let node = middle(&body);
                let (mut offset, mut equivalent) = (0.0, 0.0);
                for way in [0.5, 0.9, 1.5, 3.0, 2.4, 0.0, -0.5] {
                    strain(&mut body, &(direction * (way * unit)));
                    // The law in one dimension, over the yield stress and its strain.
                    let tried: f64 = way - offset;
                    let h = hardening / (3.0 * SHEAR);
                    let more = ((tried.abs() - 1.0 - h * equivalent) / (1.0 + h)).max(0.0);
                    offset += more * tried.signum();
                    equivalent += more;
                    let stress = body.stress(node);
                    let along = stress.dot(&direction) / direction.norm_squared() * 1.5 / YIELD;
                    let found = [along, mises(&stress) / YIELD, body.plastic_strain(node).unwrap() / unit];
                    let wanted = [way - offset, (way - offset).abs(), equivalent];
                    for (found, wanted) in found.into_iter().zip(wanted) {
                        // Of squares of strains of 3e-7.
                        assert!(
                            (found - wanted).abs() < 1e-6,
                            "{influence:?} {direction} {way}: {found} {wanted}"
                        );
                    }
                    let work = equivalent * (1.0 + 0.5 * h * equivalent) * YIELD * unit;
                    assert!((body.plastic_work(node).unwrap() - work).abs() < 1e-6 * YIELD * unit);
                }
            }
        }
    }
}

/// Pressure a hundred times the yield stress, and one that comes on top of a shear, does no yielding inside.
#[test]
fn pressure_does_no_yielding_inside() {
    let unit = YIELD / (3.0 * SHEAR);
    let block = lattice(3, [13; 3], [DX; 3]);
    let mut body = yielding(block, usual(), perfect(YIELD));
    let node = middle(&body);
    let sheared = directions()[0] * (0.9 * unit);
    strain(&mut body, &(sheared - Matrix3::identity() * (100.0 * unit)));
    assert_eq!(body.plastic_strain(node), Some(0.0));
    strain(&mut body, &(sheared * 2.0 - Matrix3::identity() * (100.0 * unit)));
    // Squares of the strain of the pressure: 1e-4 of it in each bond.
    assert!((body.plastic_strain(node).unwrap() / unit - 0.8).abs() < 1e-3);
}

/// Bars in a uniform flow: the mean stress of all nodes, however far it goes, and the work are near those of von Mises' law, though
/// families at faces are cut.
#[test]
fn faces_yield_at_von_mises_stress_in_the_mean() {
    let unit = YIELD / (3.0 * SHEAR);
    for (correction, across) in
        [(Correction::Even, 4), (Correction::Even, 8), (Correction::Balanced, 5), (Correction::Balanced, 9)]
    {
        let balanced = correction == Correction::Balanced;
        let counts = [10, across, across];
        let block = if balanced { on_edges(counts) } else { lattice(3, counts, [DX; 3]) };
        let volume: f64 = block.volumes.iter().sum();
        for (name, direction) in [("sheared", directions()[0]), ("drawn", directions()[4])] {
            let mut body =
                yielding(block.clone(), bonds(correction, Influence::Inverse, 2.015), perfect(YIELD));
            let mut mean = |way: f64| {
                let work = strain(&mut body, &(direction * (way * unit)));
                let of = |node: usize| body.stress(node) * body.block().volumes[node];
                let sum: Matrix3<f64> = (0..body.len()).map(of).sum();
                [mises(&(sum / volume)) / YIELD, work / (volume * YIELD * unit)]
            };
            let [_, _] = mean(2.0);
            let ([near, _], [far, _], [_, work]) = (mean(4.0), mean(100.0), mean(101.0));
            println!("{correction:?} {across} {name}: stress {near:.4}, {far:.4}, work {work:.4}");
            // Measured 0.994 to 1.008, a part of the nodes at faces and edges that falls with the width.
            assert!((near - 1.0).abs() < 0.025 && (work - 1.0).abs() < 0.025, "{near} {work}");
            // It does not grow with the flow: families see no dilatation in what keeps the volume.
            assert!((far - near).abs() < 1e-3, "{near} {far}");
        }
    }
}
