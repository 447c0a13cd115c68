//! Invariants of every operator on every cloud: exactness, transposes, second moments, rotations.
#![allow(clippy::unwrap_used)] // set-up that fails is a test that fails

mod common;

use approx::assert_abs_diff_eq;
use common::{curved_clouds, flat_clouds, operators};
use nalgebra::Rotation3;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use sph_core::*;

/// Coordinates of `x` in the tangent plane of `point`.
fn plane(point: &SamplingPoint, x: &Vec3) -> (f64, f64) {
    ((x - point.position).dot(&point.frame.t1), (x - point.position).dot(&point.frame.t2))
}

#[test]
fn constants_and_linear_fields_are_exact() {
    for (cloud_name, cloud) in flat_clouds().into_iter().chain(curved_clouds()) {
        for (name, operator) in operators(&cloud) {
            for (p, point) in operator.points.iter().enumerate() {
                let stencil = operator.stencil(p);
                // Sums of 1, ξ, η with φ, G₁, G₂; lengths in units of the spacing.
                let mut sums = [[0.0; 3]; 3];
                for (k, &b) in stencil.particles.iter().enumerate() {
                    let (xi, eta) = plane(point, &cloud.positions[b as usize]);
                    let numbers =
                        [stencil.phi[k], stencil.g1[k] * cloud.spacing(), stencil.g2[k] * cloud.spacing()];
                    for (row, number) in numbers.into_iter().enumerate() {
                        sums[row][0] += number;
                        sums[row][1] += number * xi / cloud.spacing();
                        sums[row][2] += number * eta / cloud.spacing();
                    }
                }
                for (row, column) in (0..3).flat_map(|r| (0..3).map(move |c| (r, c))) {
                    let error = (sums[row][column] - f64::from(row == column)).abs();
                    assert!(
                        error < 1e-12,
                        "{cloud_name}, {name}, point {p}: sum {row}{column} off by {error:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn aligned_frames_keep_gradients_in_space() {
    let axis = Vec3::new(0.3, 1.0, 0.4);
    for (cloud_name, cloud) in flat_clouds().into_iter().chain(curved_clouds()) {
        let fields = [|x: &Vec3| x.x, |x: &Vec3| x.y, |x: &Vec3| x.z]
            .map(|f| cloud.positions.iter().map(f).collect::<Vec<f64>>());
        for (name, operator) in operators(&cloud) {
            let mut aligned = operator.clone();
            aligned.align(&axis).unwrap();
            let in_space = |operator: &SamplingOperator, field: &[f64]| -> Vec<Vec3> {
                let slopes = operator.gradient(field);
                operator
                    .points
                    .iter()
                    .zip(slopes)
                    .map(|(p, g)| p.frame.t1 * g[0] + p.frame.t2 * g[1])
                    .collect()
            };
            for field in &fields {
                for (a, b) in in_space(&operator, field).iter().zip(in_space(&aligned, field)) {
                    // Sums of some tens of numbers of either sign, of size one.
                    assert!((a - b).norm() < 1e-12, "{cloud_name}, {name}: {a} {b}");
                }
            }
            for (before, after) in operator.points.iter().zip(&aligned.points) {
                let Frame { t1, t2, n } = after.frame;
                assert_eq!(
                    (before.position, before.weight, before.frame.n),
                    (after.position, after.weight, n)
                );
                assert!((t1.cross(&t2) - n).norm() < 1e-14 && t1.dot(&n).abs() < 1e-14);
                assert!(t2.dot(&axis).abs() < 1e-14 && t1.dot(&axis) > 0.0, "{cloud_name}, {name}");
            }
        }
    }
}

#[test]
fn aligned_second_moments_are_those_of_the_same_tensor() {
    for (cloud_name, cloud) in flat_clouds().into_iter().chain(curved_clouds()) {
        for (name, operator) in operators(&cloud) {
            let mut aligned = operator.clone();
            aligned.align(&Vec3::new(0.3, 1.0, 0.4)).unwrap();
            let moments = [&operator, &aligned].map(|operator| operator.second_moments(&cloud.positions));
            for (p, (before, after)) in operator.points.iter().zip(&aligned.points).enumerate() {
                let frames = [before.frame, after.frame];
                let turn = |new: usize, old: usize| {
                    let axes = |f: &Frame| [f.t1, f.t2];
                    axes(&frames[1])[new].dot(&axes(&frames[0])[old])
                };
                let tensor = |e: &[f64; 6], [a, b, c]: [usize; 3]| e[3 * a + if b == c { b } else { 2 }];
                for number in 0..8 {
                    let [a, b, c] = [number & 1, number >> 1 & 1, number >> 2];
                    let rotated: f64 = (0..8)
                        .map(|old| [old & 1, old >> 1 & 1, old >> 2])
                        .map(|[i, j, k]| {
                            turn(a, i) * turn(b, j) * turn(c, k) * tensor(&moments[0][p], [i, j, k])
                        })
                        .sum();
                    let error = (rotated - tensor(&moments[1][p], [a, b, c])).abs();
                    assert!(error < 1e-12 * cloud.spacing(), "{cloud_name}, {name}, point {p}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn an_axis_that_stands_on_the_surface_is_refused_with_its_place() {
    let roof = Cylinder { radius: 2.0, angles: [-0.5, 0.5], length: 3.0 };
    let cloud = lattice(&roof, [3, 3], EndWeights::Trapezoid).unwrap();
    // Nodal points lie at the particles: the crown's normal is z.
    let mut operator = nodal_operator(&cloud, &CubicSpline, 1, 1.3).unwrap();
    let crown = Vec3::new(0.0, 0.0, 2.0);
    match operator.align(&Vec3::z()).unwrap_err() {
        SpaceError::AxisNormal { position, projection, bound } => {
            let off = Vec3::from(position) - crown;
            assert!(libm::hypot(off.x, off.z) < 1e-12 && projection < 1e-12 && bound == 1e-6, "{position:?}");
        }
        other => panic!("{other}"),
    }
    for axis in [Vec3::zeros(), Vec3::new(f64::NAN, 0.0, 0.0), Vec3::new(f64::INFINITY, 0.0, 0.0)] {
        assert!(matches!(operator.align(&axis), Err(SpaceError::AxisNormal { .. })));
    }
}

#[test]
fn nodal_gradients_are_exact_up_to_the_order_they_report() {
    for (cloud_name, cloud) in flat_clouds().into_iter().chain(curved_clouds()) {
        for (name, operator) in operators(&cloud) {
            for (p, point) in operator.points.iter().enumerate() {
                for (i, j) in [(2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)] {
                    if i + j > i32::from(operator.orders[p]) {
                        continue;
                    }
                    let stencil = operator.stencil(p);
                    let mut slope = [0.0; 2];
                    for (k, &b) in stencil.particles.iter().enumerate() {
                        let (xi, eta) = plane(point, &cloud.positions[b as usize]);
                        let value = (xi / cloud.spacing()).powi(i) * (eta / cloud.spacing()).powi(j);
                        slope[0] += stencil.g1[k] * value * cloud.spacing();
                        slope[1] += stencil.g2[k] * value * cloud.spacing();
                    }
                    let error = slope[0].abs().max(slope[1].abs());
                    assert!(error < 1e-10, "{cloud_name}, {name}, point {p}: ξ^{i}η^{j} off by {error:e}");
                }
            }
        }
    }
}

#[test]
fn nodal_order_three_is_reached_inside_and_order_two_on_edges() {
    for (cloud_name, cloud) in flat_clouds().into_iter().chain(curved_clouds()) {
        let operator = nodal_operator(&cloud, &CubicSpline, 3, 1.6).unwrap();
        for a in 0..cloud.len() {
            let expected = if cloud.edge_lengths[a] > 0.0 { 2 } else { 3 };
            assert_eq!(operator.orders[a], expected, "{cloud_name}, particle {a}");
            assert_eq!(operator.stencil(a).particles[0], a as u32);
            assert_eq!(operator.stencil(a).phi[0], 1.0);
        }
    }
}

#[test]
fn cells_sum_a_constant_flux_to_the_edge_normals() {
    for (name, cloud) in flat_clouds() {
        let operator = cell_operator(&cloud).unwrap();
        for direction in [Vec3::x(), Vec3::y(), Vec3::z()] {
            let flux: Vec<[f64; 3]> = operator
                .points
                .iter()
                .map(|point| [0.0, point.frame.t1.dot(&direction), point.frame.t2.dot(&direction)])
                .collect();
            for (b, sum) in operator.gather(&flux).into_iter().enumerate() {
                let error = (sum - cloud.edge_normals[b].dot(&direction)).abs() / cloud.spacing();
                assert!(error < 1e-13, "{name}, particle {b}: off by {error:e}");
            }
        }
    }
}

#[test]
fn a_square_lattice_gives_quarters() {
    let spacing = 0.1;
    let cloud = lattice(&Plate { lengths: [1.0, 0.6] }, [11, 7], EndWeights::Trapezoid).unwrap();
    let cell = cell_operator(&cloud).unwrap();
    // A reach of 0.5 grows until it holds the four corners.
    for (kernel, reach) in kernels().into_iter().flat_map(|kernel| [(kernel, 0.5), (kernel, 1.4)]) {
        let wide = kernel_operator(&cloud, kernel, reach).unwrap();
        for p in 0..cell.points.len() {
            let (compact, corrected) = (cell.stencil(p), wide.stencil(p));
            assert_eq!((compact.particles.len(), corrected.particles.len()), (4, 4));
            for (k, b) in compact.particles.iter().enumerate() {
                let same = corrected.particles.iter().position(|c| c == b).unwrap();
                let (xi, eta) = plane(&cell.points[p], &cloud.positions[*b as usize]);
                let half = 0.5 / spacing; // G = ±1/(2Δ)
                assert_abs_diff_eq!(compact.phi[k], 0.25, epsilon = 1e-13);
                assert_abs_diff_eq!(compact.g1[k], half * xi.signum(), epsilon = 1e-12);
                assert_abs_diff_eq!(compact.g2[k], half * eta.signum(), epsilon = 1e-12);
                assert_abs_diff_eq!(corrected.phi[same], compact.phi[k], epsilon = 1e-13);
                assert_abs_diff_eq!(corrected.g1[same], compact.g1[k], epsilon = 1e-12);
                assert_abs_diff_eq!(corrected.g2[same], compact.g2[k], epsilon = 1e-12);
            }
        }
        for operator in [&cell, &wide] {
            for moments in operator.second_moments(&cloud.positions) {
                assert!(moments.iter().all(|e| e.abs() < 1e-13 * spacing), "{}: {moments:?}", kernel.name());
            }
        }
    }
}

#[test]
fn second_moments_are_those_of_quadratic_fields() {
    // On any flat cloud E_α,11 is the gradient of ½ξ² at the point, by definition.
    for (_, cloud) in flat_clouds() {
        let operator = cell_operator(&cloud).unwrap();
        for (p, moments) in operator.second_moments(&cloud.positions).into_iter().enumerate().step_by(7) {
            let at = |f: &dyn Fn(f64, f64) -> f64| -> [f64; 2] {
                let field: Vec<f64> = cloud
                    .positions
                    .iter()
                    .map(|x| plane(&operator.points[p], x))
                    .map(|(xi, eta)| f(xi, eta))
                    .collect();
                operator.gradient(&field)[p]
            };
            let fields: [[f64; 2]; 3] =
                [at(&|xi, _| 0.5 * xi * xi), at(&|_, eta| 0.5 * eta * eta), at(&|xi, eta| 0.5 * xi * eta)];
            for (k, field) in fields.iter().enumerate() {
                assert_abs_diff_eq!(moments[k], field[0], epsilon = 1e-14);
                assert_abs_diff_eq!(moments[3 + k], field[1], epsilon = 1e-14);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 16, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() })]

    /// Σ_p w_p (q·value + n₁·f,₁ + n₂·f,₂) = Σ_b f_b · gathered_b.
    #[test]
    fn gather_is_the_transpose_of_value_and_gradient(seed in any::<u64>()) {
        let cloud = jittered_lattice(&Cylinder { radius: 2.0, angles: [0.0, 1.0], length: 2.0 }, [9, 9], 0.25, seed).unwrap();
        let noise = |k: usize| libm::sin((seed % 1000 + 1) as f64 * (k + 1) as f64);
        for (name, operator) in operators(&cloud) {
            let field: Vec<f64> = (0..cloud.len()).map(noise).collect();
            let resultants: Vec<[f64; 3]> =
                (0..operator.points.len()).map(|p| [noise(3 * p), noise(3 * p + 1), noise(3 * p + 2)]).collect();
            let (values, gradients) = (operator.value(&field), operator.gradient(&field));
            let at_points: f64 = (0..operator.points.len())
                .map(|p| {
                    let [q, n1, n2] = resultants[p];
                    operator.points[p].weight * (q * values[p] + n1 * gradients[p][0] + n2 * gradients[p][1])
                })
                .sum();
            let at_particles: f64 = operator.gather(&resultants).iter().zip(&field).map(|(g, f)| g * f).sum();
            prop_assert!((at_points - at_particles).abs() < 1e-11, "{}: {} {}", name, at_points, at_particles);
        }
    }

    /// A rotated and moved cloud has the same stencils.
    #[test]
    fn rigid_motion_leaves_the_numbers(angles in prop::array::uniform3(-3.0..3.0f64), shift in prop::array::uniform3(-5.0..5.0f64)) {
        let rotation = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        for (cloud_name, cloud) in flat_clouds().into_iter().chain(curved_clouds()) {
            let moved = cloud.transformed(&rotation, &Vec3::from(shift));
            prop_assert_eq!(moved.check(), Ok(()));
            // Compact operators: a wide support on a lattice has neighbours exactly on its rim, which rounding may count.
            let pairs = [
                (cell_operator(&cloud).unwrap(), cell_operator(&moved).unwrap()),
                (kernel_operator(&cloud, &WendlandC2, 1.37).unwrap(), kernel_operator(&moved, &WendlandC2, 1.37).unwrap()),
                (nodal_operator(&cloud, &CubicSpline, 2, 1.31).unwrap(), nodal_operator(&moved, &CubicSpline, 2, 1.31).unwrap()),
            ];
            for (before, after) in pairs {
                prop_assert_eq!(&before.particles, &after.particles, "{}", cloud_name);
                for (x, y) in [(&before.phi, &after.phi), (&before.g1, &after.g1), (&before.g2, &after.g2)] {
                    for (x, y) in x.iter().zip(y) {
                        prop_assert!((x - y).abs() < 1e-9, "{}: {} {}", cloud_name, x, y);
                    }
                }
            }
        }
    }
}

#[test]
fn values_that_make_no_operator_are_refused() {
    let plate = Plate { lengths: [1.0, 1.0] };
    let small = lattice(&plate, [2, 2], EndWeights::Trapezoid).unwrap();
    assert!(matches!(
        nodal_operator(&small, &CubicSpline, 2, 1.3),
        Err(SpaceError::TooFew { found: 4, needed: 6, .. })
    ));
    assert!(matches!(nodal_operator(&small, &CubicSpline, 4, 1.3), Err(SpaceError::OutOfRange { .. })));
    assert!(matches!(nodal_operator(&small, &CubicSpline, 1, 0.0), Err(SpaceError::OutOfRange { .. })));
    assert!(matches!(kernel_operator(&small, &CubicSpline, f64::NAN), Err(SpaceError::OutOfRange { .. })));
    assert!(kernel_operator(&small, &CubicSpline, 1.4).is_ok());
    let corner = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|x| Vec3::new(x[0], x[1], 0.0)).to_vec();
    let triangle = Cloud::from_cells(corner, None, vec![Cell::triangle([0, 1, 2])]).unwrap();
    assert!(cell_operator(&triangle).is_ok());
    assert!(matches!(
        kernel_operator(&triangle, &CubicSpline, 1.4),
        Err(SpaceError::TooFew { found: 3, needed: 4, .. })
    ));
}
