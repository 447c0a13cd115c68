//! Places on a face that stand for its corners: means over the face by functions dual to the shape functions of its corners.
//!
//! With shape functions N_k and `ψ_j = D_j Σ_k M⁻¹_jk N_k`, `D_j = ∫N_j`, `M_jk = ∫N_j N_k` over the same places,
//!
//! ```text
//! ∫ψ_j N_k = δ_jk D_j,   so that   ∫ψ_j x = D_j x_j   for   x = Σ N_k x_k
//! ```
//!
//! A field that is x on the face has so the value x_j at a corner, and one with other nodes than the face its mean about it, however fine
//! either is [wohlmuth2000].

use nalgebra::DMatrix;
use sph_core::Vec3;

use crate::foot::shape;

/// Places at most along an edge of a face.
const MOST: usize = 16;

/// Places on a face.
#[derive(Clone, Debug, PartialEq)]
pub struct Dual {
    /// The places \[L\].
    pub places: Vec<Vec3>,
    /// By place what it counts for each corner, `ψ_j` times its part of the area \[L²\].
    pub counts: Vec<Vec<f64>>,
    /// Sums of these by corner, D \[L²\].
    pub areas: Vec<f64>,
}

impl Dual {
    /// Those on a face of three corners or four, two at least over a length along each edge \[L\]; none on a face without an area.
    pub fn on(corners: &[Vec3], length: f64) -> Option<Self> {
        let count = corners.len();
        let edge = (0..count).map(|i| (corners[(i + 1) % count] - corners[i]).norm()).fold(0.0, f64::max);
        let parts = 2 * (libm::ceil(edge / length) as usize).clamp(1, MOST / 2);
        let step = 1.0 / parts as f64;
        let (mut places, mut shapes) = (Vec::new(), Vec::new());
        for (i, j) in (0..parts * parts).map(|number| (number / parts, number % parts)) {
            let [u, v] = [i, j].map(|k| (k as f64 + 0.5) * step);
            // A triangle as a square with two corners on one place.
            let (at, narrowed) = if count == 3 { ([u, v * (1.0 - u)], 1.0 - u) } else { ([u, v], 1.0) };
            let (weights, along) = shape(count, at);
            let sum = |weights: &[f64; 4]| -> Vec3 { corners.iter().zip(weights).map(|(x, w)| x * *w).sum() };
            let area = sum(&along[0]).cross(&sum(&along[1])).norm() * narrowed * step * step;
            places.push(sum(&weights));
            shapes.push((weights, area));
        }
        let products = |i: usize, j: usize| shapes.iter().map(|(n, area)| n[i] * n[j] * area).sum::<f64>();
        let inverse = DMatrix::from_fn(count, count, products).try_inverse()?;
        let areas: Vec<f64> = (0..count).map(|i| shapes.iter().map(|(n, area)| n[i] * area).sum()).collect();
        let dual = |(n, area): &([f64; 4], f64)| -> Vec<f64> {
            (0..count)
                .map(|j| areas[j] * area * (0..count).map(|k| inverse[(j, k)] * n[k]).sum::<f64>())
                .collect()
        };
        let counts: Vec<Vec<f64>> = shapes.iter().map(dual).collect();
        areas.iter().all(|area| *area > 0.0).then_some(Self { places, counts, areas })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A warped quadrilateral, a triangle: the mean of the face by each corner is that corner, of one the area; rounding.
    #[test]
    fn a_face_has_its_corners_for_means() {
        let corners = [[0.0, 0.0, 0.0], [1.1, 0.1, 0.1], [1.3, 0.9, -0.1], [-0.1, 1.0, 0.2]].map(Vec3::from);
        for (count, length) in [(4, 0.3), (4, 9.0), (3, 0.4)] {
            let corners = &corners[..count];
            let dual = Dual::on(corners, length).unwrap();
            for (j, corner) in corners.iter().enumerate() {
                let counts = || dual.counts.iter().map(|own| own[j]);
                let mean: Vec3 =
                    dual.places.iter().zip(counts()).map(|(x, own)| x * own).sum::<Vec3>() / dual.areas[j];
                assert!((mean - corner).norm() < 1e-13, "{count} {j}");
                assert!((counts().sum::<f64>() / dual.areas[j] - 1.0).abs() < 1e-13);
            }
        }
        assert_eq!(Dual::on(&[Vec3::x(), Vec3::x(), Vec3::x()], 1.0), None);
    }
}
