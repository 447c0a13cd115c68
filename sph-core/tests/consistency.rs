//! Divergence consistency: a constant flux balances its edges after the correction, and rows stay exact.
#![allow(clippy::unwrap_used)] // set-up that fails is a test that fails

mod common;

use common::{curved_clouds, flat_clouds};
use sph_core::*;

/// Largest error of monomials up to each point's order, with G and lengths in units of the spacing.
fn row_error(operator: &SamplingOperator, cloud: &Cloud) -> f64 {
    let spacing = cloud.spacing();
    let mut worst: f64 = 0.0;
    for (p, point) in operator.points.iter().enumerate() {
        let stencil = operator.stencil(p);
        for (i, j) in (0..=3).flat_map(|i| (0..=3 - i).map(move |j| (i, j))) {
            if i + j > i32::from(operator.orders[p]) {
                continue;
            }
            let mut slope = [-f64::from((i, j) == (1, 0)), -f64::from((i, j) == (0, 1))];
            for (k, &b) in stencil.particles.iter().enumerate() {
                let arm = cloud.positions[b as usize] - point.position;
                let (xi, eta) = (arm.dot(&point.frame.t1) / spacing, arm.dot(&point.frame.t2) / spacing);
                slope[0] += stencil.g1[k] * spacing * xi.powi(i) * eta.powi(j);
                slope[1] += stencil.g2[k] * spacing * xi.powi(i) * eta.powi(j);
            }
            worst = worst.max(slope[0].abs()).max(slope[1].abs());
        }
    }
    worst
}

fn report(name: &str, report: &ConsistencyReport) {
    println!(
        "{name}: {} iterations, {:.1e} -> {:.1e}",
        report.iterations, report.residual_before, report.residual_after
    );
}

#[test]
fn kernel_stencils_become_consistent_on_flat_clouds() {
    for (cloud_name, cloud) in flat_clouds() {
        for kernel in kernels() {
            let name = format!("{cloud_name} {}", kernel.name());
            let mut operator = kernel_operator(&cloud, kernel, 1.8).unwrap();
            let done = make_divergence_consistent(&mut operator, &cloud, &[1]).unwrap();
            report(&name, &done);
            assert!(done.residual_after < 1e-8, "{name}: {done:?}");
            assert!(row_error(&operator, &cloud) < 1e-12, "{name}");
        }
    }
}

#[test]
fn nodal_stencils_become_consistent_on_flat_clouds() {
    for (cloud_name, cloud) in flat_clouds() {
        for (order, smoothing) in [(1, 1.2), (2, 1.3), (3, 1.6)] {
            let name = format!("{cloud_name} nodal {order}");
            let mut operator = nodal_operator(&cloud, &CubicSpline, order, smoothing).unwrap();
            let done = make_divergence_consistent(&mut operator, &cloud, &[1]).unwrap();
            report(&name, &done);
            assert!(done.residual_after < 1e-8, "{name}: {done:?}");
        }
    }
}

#[test]
fn lattices_keep_the_nodal_order_where_their_areas_allow_it() {
    let plate = Plate { lengths: [2.0, 1.5] };
    for (weights, order, smoothing) in
        [(EndWeights::Trapezoid, 2, 1.3), (EndWeights::Gregory, 2, 1.3), (EndWeights::Gregory, 3, 1.5)]
    {
        let name = format!("{weights:?} nodal {order}");
        let cloud = lattice(&plate, [13, 11], weights).unwrap();
        let mut operator = nodal_operator(&cloud, &CubicSpline, order, smoothing).unwrap();
        let orders = operator.orders.clone();
        let done = make_divergence_consistent(&mut operator, &cloud, &orders).unwrap();
        report(&name, &done);
        assert!(done.residual_after < 1e-7, "{name}: {done:?}");
        assert!(row_error(&operator, &cloud) < 1e-12, "{name}");
    }
}

#[test]
fn the_consistent_operator_on_the_corners_of_a_cell_is_the_cell_operator() {
    for (name, cloud) in flat_clouds() {
        let exact = cell_operator(&cloud).unwrap();
        let mut operator = exact.clone();
        // Disturb every quadrangle along its one free direction: numbers orthogonal to 1, ξ, η.
        for p in 0..operator.points.len() {
            let entries = operator.entries(p);
            if entries.len() == 4 {
                let arms: Vec<Vec3> = entries
                    .clone()
                    .map(|e| cloud.positions[operator.particles[e] as usize] - operator.points[p].position)
                    .collect();
                let signs = [1.0, -1.0, 1.0, -1.0];
                let sum: Vec3 = arms.iter().zip(signs).map(|(arm, s)| arm * s).sum();
                let frame = operator.points[p].frame;
                for (k, e) in entries.enumerate() {
                    let free = signs[k] - exact.g1[e] * sum.dot(&frame.t1) - exact.g2[e] * sum.dot(&frame.t2);
                    operator.g1[e] += 0.3 * free * libm::sin(p as f64);
                    operator.g2[e] -= 0.2 * free * libm::cos(p as f64);
                }
            }
        }
        let done = make_divergence_consistent(&mut operator, &cloud, &[1]).unwrap();
        report(name, &done);
        assert!(done.residual_before > 1e-3 && done.residual_after < 1e-8, "{name}: {done:?}");
        for (x, y) in operator.g1.iter().chain(&operator.g2).zip(exact.g1.iter().chain(&exact.g2)) {
            assert!((x - y).abs() * cloud.spacing() < 1e-7, "{name}: {x} {y}");
        }
    }
}

#[test]
fn curved_clouds_become_as_consistent_as_their_geometry_allows() {
    // The disordered dome has edges made of its cells, and nothing contradicts. The roof has flat cells inside exact
    // edges: chord and arc of Δφ = 0.19 differ by Δφ²/24 = 0.0015 per spacing, two or three times that at corners.
    // The wave is nearly contradictory; 1e-4 is what was found, a thousandth of the error before. Strip: 7e-7 found.
    let bounds =
        [("roof", 5e-3_f64), ("dome", 1e-9), ("wave", 2e-4), ("strip", 1e-5), ("scattered roof", 1e-2)];
    for ((name, cloud), (same, bound)) in curved_clouds().into_iter().zip(bounds) {
        assert_eq!(name, same);
        let mut operator = kernel_operator(&cloud, &CubicSpline, 1.8).unwrap();
        let done = make_divergence_consistent(&mut operator, &cloud, &[1]).unwrap();
        report(name, &done);
        assert!(done.residual_after < bound.min(done.residual_before), "{name}: {done:?}");
        assert!(row_error(&operator, &cloud) < 1e-12, "{name}");
    }
}

#[test]
fn operators_and_clouds_must_belong_together() {
    let plate = Plate { lengths: [1.0, 1.0] };
    let cloud = lattice(&plate, [5, 5], EndWeights::Trapezoid).unwrap();
    let other = lattice(&plate, [6, 5], EndWeights::Trapezoid).unwrap();
    let mut operator = cell_operator(&cloud).unwrap();
    assert!(matches!(
        make_divergence_consistent(&mut operator, &other, &[1]),
        Err(SpaceError::Length { .. })
    ));
    assert!(matches!(
        make_divergence_consistent(&mut operator, &cloud, &[1, 1]),
        Err(SpaceError::Length { .. })
    ));
}
