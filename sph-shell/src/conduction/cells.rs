//! What a cell conducts.
//!
//! With the stencil G_αb of a cell of area w and its conductance K, the heat that leaves its particles is `Q = (w K_αβ G_α G_βᵀ + s γ γᵀ) T`,
//! γ the pattern `¼ h`, h = (1, −1, 1, −1), less what of it is linear in space \[flanagan1981\]. Bilinear in a parallelogram it has the mean square gradient
//!
//! ```text
//! mean of ∇(ξη)·K ∇(ξη) = ⅓ K_αβ (J⁻ᵀJ⁻¹)_αβ = (4/3) K_αβ Σ_b G_αb G_βb        s = (4/3) w K_αβ Σ_b G_αb G_βb
//! ```
//!
//! since there `G_b = J⁻ᵀ (±¼, ±¼)`: cells that are parallelograms conduct as fully integrated elements do, all others are exact for linear temperatures.

use sph_core::{SamplingOperator, Vec3};

use super::{Conductor, ConductorError};

/// Projection of an axis on the surface below which it has no direction there.
const SHORTEST: f64 = 1e-6;
const PATTERN: [f64; 4] = [1.0, -1.0, 1.0, -1.0];

/// The heat that leaves the nodes of a cell, by their temperatures \[F L/(T Θ)\].
#[derive(Clone, Copy, Debug)]
pub(super) struct CellMatrix {
    pub nodes: [u32; 4],
    /// Three or four.
    pub count: usize,
    pub entries: [[f64; 4]; 4],
}

impl CellMatrix {
    /// That of a cell with a conductance in the frame of its point.
    pub fn new(
        operator: &SamplingOperator,
        cell: usize,
        tensor: &[f64; 3],
        positions: &[Vec3],
        node: &[u32],
    ) -> Self {
        let (stencil, point) = (operator.stencil(cell), &operator.points[cell]);
        let count = stencil.particles.len().min(4);
        let [k11, k22, k12] = *tensor;
        let product = |a: usize, b: usize| {
            k11 * stencil.g1[a] * stencil.g1[b]
                + k22 * stencil.g2[a] * stencil.g2[b]
                + k12 * (stencil.g1[a] * stencil.g2[b] + stencil.g2[a] * stencil.g1[b])
        };
        let (mut gamma, mut stiffness) = ([0.0; 4], 0.0);
        if count == 4 {
            let along = |axis: &Vec3| -> f64 {
                let place = |b: usize| (positions[stencil.particles[b] as usize] - point.position).dot(axis);
                (0..4).map(|b| 0.25 * PATTERN[b] * place(b)).sum()
            };
            let lever = [along(&point.frame.t1), along(&point.frame.t2)];
            gamma = std::array::from_fn(|b| {
                0.25 * PATTERN[b] - stencil.g1[b] * lever[0] - stencil.g2[b] * lever[1]
            });
            stiffness = 4.0 / 3.0 * (0..4).map(|b| product(b, b)).sum::<f64>();
        }
        let (mut nodes, mut entries) = ([0; 4], [[0.0; 4]; 4]);
        for a in 0..count {
            nodes[a] = node[stencil.particles[a] as usize];
            for b in 0..count {
                entries[a][b] = point.weight * (product(a, b) + stiffness * gamma[a] * gamma[b]);
            }
        }
        Self { nodes, count, entries }
    }
}

/// A symmetric tensor in axes of which the first has these components, cosine and sine, in its own.
pub(super) fn turned([along, across, between]: [f64; 3], [cos, sin]: [f64; 2]) -> [f64; 3] {
    let (c2, s2, cs) = (cos * cos, sin * sin, cos * sin);
    [
        c2 * along + s2 * across + 2.0 * cs * between,
        s2 * along + c2 * across - 2.0 * cs * between,
        cs * (across - along) + (c2 - s2) * between,
    ]
}

/// The conductances of cells in the frames of their points.
///
/// # Errors
/// [`ConductorError`] for conductors that are not positive definite, and for axes that stand on the surface.
pub(super) fn in_frames(
    operator: &SamplingOperator,
    conductors: &[Conductor],
) -> Result<Vec<[f64; 3]>, ConductorError> {
    let mut all = Vec::with_capacity(conductors.len());
    for (cell, Conductor { tensor, axis }) in conductors.iter().enumerate() {
        let [k11, k22, k12] = *tensor;
        if !(k11 > 0.0 && k11.is_finite() && k22.is_finite() && k11 * k22 > k12 * k12) {
            return Err(ConductorError::Conductor { cell, tensor: *tensor });
        }
        let point = &operator.points[cell];
        let Some(axis) = axis else {
            all.push(*tensor);
            continue;
        };
        let [first, second] = [axis.dot(&point.frame.t1), axis.dot(&point.frame.t2)];
        let projection = libm::hypot(first, second);
        if projection.is_nan() || projection < SHORTEST * axis.norm() {
            let position = point.position.into();
            return Err(sph_core::SpaceError::AxisNormal { position, projection, bound: SHORTEST }.into());
        }
        // t1 has the cosine of its angle to the axis along it, and less the sine across it.
        all.push(turned(*tensor, [first / projection, -second / projection]));
    }
    Ok(all)
}
