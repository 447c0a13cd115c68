//! Rows and columns of particles on a parametric patch, edges included.

use crate::error::SpaceError;
use crate::surface::cloud::{Cloud, check_area};
use crate::surface::frame::Frame;
use crate::surface::numbering::Lattice;
use crate::surface::patch::Patch;

/// How a row of particles is weighted when it stands for a length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndWeights {
    /// ½, 1, 1, …: exact for linear functions.
    Trapezoid,
    /// ⅜, 7/6, 23/24, 1, … \[davis1984\]: exact for cubic functions; at least three particles in a row.
    Gregory,
}

impl EndWeights {
    /// Weights of a row of `n` particles at unit spacing; their sum is `n − 1`.
    ///
    /// Gregory's rule adds −⅝, +⅙, −1/24 to the first three particles from either end, so that three particles give
    /// Simpson's rule and four the ⅜ rule.
    pub fn weights(&self, n: usize) -> Result<Vec<f64>, SpaceError> {
        let corrections: &[f64] = match self {
            EndWeights::Trapezoid => &[-1.0 / 2.0],
            EndWeights::Gregory => &[-5.0 / 8.0, 1.0 / 6.0, -1.0 / 24.0],
        };
        let needed = corrections.len().max(2);
        if n < needed {
            return Err(SpaceError::TooFew {
                what: "particles in a row for these end weights",
                found: n,
                needed,
            });
        }
        let mut weights = vec![1.0; n];
        for (k, correction) in corrections.iter().enumerate() {
            weights[k] += correction;
            weights[n - 1 - k] += correction;
        }
        Ok(weights)
    }
}

/// Lattice of `counts` particles on `patch`, evenly spaced in the parameters, with particles **on** the edges.
///
/// Areas are the product of the end weights × the surface Jacobian `|∂X/∂u × ∂X/∂v|`; edge normals and lengths
/// likewise. Frames have `t1` along u. Particles lie on the edges because layouts at cell centres, with the clamp
/// half a spacing away, cost 17–26 % on the rolled ring.
pub fn lattice(patch: &dyn Patch, counts: [usize; 2], weights: EndWeights) -> Result<Cloud, SpaceError> {
    let lattice = Lattice { counts };
    lattice.check()?;
    let [range_u, range_v] = patch.range();
    let (du, dv) = (step(range_u, counts[0]), step(range_v, counts[1]));
    let (weights_u, weights_v) = (weights.weights(counts[0])?, weights.weights(counts[1])?);
    let mut cloud = Cloud {
        positions: Vec::new(),
        frames: Vec::new(),
        areas: Vec::new(),
        edge_normals: Vec::new(),
        edge_lengths: Vec::new(),
        cells: lattice.cells(),
        joined: Vec::new(),
        sides: Some(lattice.sides()),
        lattice: Some(lattice),
    };
    for (i, weight_u) in weights_u.iter().enumerate() {
        for (j, weight_v) in weights_v.iter().enumerate() {
            let (u, v) = (parameter(range_u, counts[0], i), parameter(range_v, counts[1], j));
            let (along_u, along_v) = patch.tangents(u, v);
            let n = patch.normal(u, v);
            let t1 = (along_u - n * n.dot(&along_u)).normalize();
            // Outward conormals: ∂X/∂v × n on the edges of constant u, n × ∂X/∂u on those of constant v.
            let (sign_u, sign_v) = (outward(i, counts[0]), outward(j, counts[1]));
            let normal =
                sign_u * weight_v * dv * along_v.cross(&n) + sign_v * weight_u * du * n.cross(&along_u);
            let length =
                sign_u.abs() * weight_v * dv * along_v.norm() + sign_v.abs() * weight_u * du * along_u.norm();
            cloud.positions.push(patch.position(u, v));
            cloud.frames.push(Frame { t1, t2: n.cross(&t1), n });
            cloud.areas.push(weight_u * du * weight_v * dv * along_u.cross(&along_v).norm());
            cloud.edge_normals.push(normal);
            cloud.edge_lengths.push(length);
        }
    }
    check_lattice_cells(&cloud)?;
    cloud.check()?;
    Ok(cloud)
}

/// Refuses lattice cells that have no area: poles, folded parameters.
pub(crate) fn check_lattice_cells(cloud: &Cloud) -> Result<(), SpaceError> {
    for (c, cell) in cloud.cells.iter().enumerate() {
        check_area(c, cell, &cloud.positions, cell.geometry(&cloud.positions).area)?;
    }
    Ok(())
}

/// Parameter of the `i`-th of `n` particles; both ends exact.
pub(crate) fn parameter(range: [f64; 2], n: usize, i: usize) -> f64 {
    let t = i as f64 / (n - 1) as f64;
    (1.0 - t) * range[0] + t * range[1]
}

/// Parameter step between `n` particles.
pub(crate) fn step(range: [f64; 2], n: usize) -> f64 {
    (range[1] - range[0]) / (n - 1) as f64
}

/// −1 on the first, +1 on the last of `n` particles, 0 between.
fn outward(i: usize, n: usize) -> f64 {
    if i == 0 {
        -1.0
    } else if i == n - 1 {
        1.0
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Vec3;
    use crate::surface::patch::{Cylinder, Plate, Sphere};
    use crate::surface::sides::Side;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use std::f64::consts::PI;

    #[test]
    fn end_weights_integrate_polynomials_of_their_degree() {
        for (weights, degree, shortest) in [(EndWeights::Trapezoid, 1, 2), (EndWeights::Gregory, 3, 3)] {
            for n in shortest..12 {
                let length = (n - 1) as f64;
                let row = weights.weights(n).unwrap();
                for power in 0..=degree {
                    let sum: f64 = row.iter().enumerate().map(|(i, w)| w * (i as f64).powi(power)).sum();
                    let exact = length.powi(power + 1) / f64::from(power + 1);
                    assert_relative_eq!(sum, exact, max_relative = 1e-13);
                }
            }
            assert!(weights.weights(shortest - 1).is_err());
        }
    }

    #[test]
    fn areas_and_edges_add_up_to_those_of_the_patch() {
        // patch, exact area, exact boundary length
        let cases: [(&dyn Patch, f64, f64); 3] = [
            (&Plate { lengths: [2.0, 3.0] }, 6.0, 10.0),
            (&Cylinder { radius: 2.0, angles: [0.0, 1.5], length: 4.0 }, 12.0, 14.0),
            (
                &Sphere { radius: 1.0, polar: [PI / 3.0, PI / 2.0], azimuth: [0.0, 1.0] },
                0.5,
                2.0 * PI / 6.0 + libm::sin(PI / 3.0) + 1.0,
            ),
        ];
        for (patch, area, length) in cases {
            for (weights, order) in [(EndWeights::Trapezoid, 2), (EndWeights::Gregory, 4)] {
                let error = |n: usize| {
                    let cloud = lattice(patch, [n, n + 2], weights).unwrap();
                    assert_relative_eq!(cloud.edge_lengths.iter().sum::<f64>(), length, max_relative = 1e-13);
                    (cloud.areas.iter().sum::<f64>() / area - 1.0).abs()
                };
                let (coarse, fine) = (error(9), error(17));
                assert!(fine < 1e-13 || fine < 1.5 * coarse / f64::from(1 << order), "{coarse} {fine}");
            }
        }
    }

    #[test]
    fn edge_normals_of_a_plate_sum_to_zero_and_point_outward() {
        for weights in [EndWeights::Trapezoid, EndWeights::Gregory] {
            let cloud = lattice(&Plate { lengths: [2.0, 3.0] }, [5, 7], weights).unwrap();
            assert_abs_diff_eq!(cloud.edge_normals.iter().sum::<Vec3>(), Vec3::zeros(), epsilon = 1e-14);
            // Gauss: Σ r·x = 2 × area.
            let flux: f64 = cloud.edge_normals.iter().zip(&cloud.positions).map(|(r, x)| r.dot(x)).sum();
            assert_relative_eq!(flux, 12.0, epsilon = 1e-13);
        }
    }

    #[test]
    fn rows_columns_edges_and_corners_follow_the_numbering() {
        let lattice = Lattice { counts: [3, 5] };
        assert_eq!(lattice.index(1, 2), 7);
        let sides = lattice.sides();
        assert_eq!(sides.edge(Side::U0), [0, 1, 2, 3, 4]);
        assert_eq!(sides.edge(Side::U1), [10, 11, 12, 13, 14]);
        assert_eq!(sides.edge(Side::V0), [0, 5, 10]);
        assert_eq!(sides.edge(Side::V1), [4, 9, 14]);
        assert_eq!(sides.corner(Side::U1, Side::V0), Some(10));
        assert_eq!(sides.corner(Side::V1, Side::U0), Some(4));
        assert_eq!(sides.corner(Side::U0, Side::U1), None);
        assert_eq!(sides.corner(Side::U0, Side::U0), None);
        assert_eq!(lattice.centre(), Some(7));
        assert_eq!(Lattice { counts: [3, 4] }.centre(), None);
    }

    #[test]
    fn poles_and_short_rows_are_refused() {
        let dome = Sphere { radius: 1.0, polar: [0.0, 1.0], azimuth: [0.0, 1.0] };
        assert!(lattice(&dome, [5, 5], EndWeights::Trapezoid).is_err());
        let plate = Plate { lengths: [1.0, 1.0] };
        let short = lattice(&plate, [1, 5], EndWeights::Trapezoid);
        assert!(matches!(short, Err(SpaceError::TooFew { found: 1, needed: 2, .. })));
        let short = lattice(&plate, [2, 5], EndWeights::Gregory);
        assert!(matches!(short, Err(SpaceError::TooFew { found: 2, needed: 3, .. })));
    }
}
