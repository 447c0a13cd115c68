//! Third moments of stencils, less what neighbouring stencils have in common.

use nalgebra::Complex;

use crate::Vec3;
use crate::sampling::operator::{SamplingOperator, SamplingPoint};

/// Times the moments are averaged over neighbours before they are taken off. One leaves a ninth of the variance of random
/// moments in the mean, four a thirtieth; a study is kept in docs/uneven-cells.md.
const AVERAGES: usize = 4;

/// `Σ_b g z³`, `Σ g z² z̄`, `Σ g z z̄²`, `Σ g z̄³` with `g = G₁ + iG₂`, `z = ξ + iη` of a stencil \[L²\].
///
/// They turn with the frame by `e^{4iθ}, e^{2iθ}, 1, e^{−2iθ}`.
type Moments = [Complex<f64>; 4];

impl SamplingOperator {
    /// `T^α_γδε = Σ_b G_αb ξ_γ ξ_δ ξ_ε` of every point less the mean of its neighbours, `[111, 112, 122, 222]` for α = 1, 2
    /// \[L²\].
    ///
    /// A gradient exact on linear fields finds `f,α + ½M^α:∇∇f + (1/6)T^α∴∇∇∇f`. Where T is the same in neighbouring cells, as on
    /// lattices, so is the error; what is left here is the part that differs from cell to cell. Neighbours
    /// share a particle; their frames are carried over along the shorter way on the surface, so that a lattice on any
    /// developable surface has none.
    pub fn uneven_third_moments(&self, positions: &[Vec3]) -> Vec<[[f64; 4]; 2]> {
        let own: Vec<Moments> = (0..self.points.len()).map(|p| self.third_moments(p, positions)).collect();
        let (offsets, neighbours) = self.neighbours_by_particles();
        let mut mean = own.clone();
        for _ in 0..AVERAGES {
            let average = |p: usize| {
                let (mut sum, mut weight) = (Moments::default(), 0.0);
                for &(q, turn) in &neighbours[offsets[p]..offsets[p + 1]] {
                    let w = self.points[q as usize].weight;
                    let twice = turn * turn;
                    let rotated = [twice * twice, twice, Complex::new(1.0, 0.0), twice.conj()];
                    for (k, value) in sum.iter_mut().enumerate() {
                        *value += mean[q as usize][k] * rotated[k] * w;
                    }
                    weight += w;
                }
                sum.map(|value| value / weight)
            };
            mean = (0..own.len()).map(average).collect();
        }
        own.iter()
            .zip(&mean)
            .map(|(own, mean)| components(&std::array::from_fn(|k| own[k] - mean[k])))
            .collect()
    }

    fn third_moments(&self, p: usize, positions: &[Vec3]) -> Moments {
        let (point, stencil) = (&self.points[p], self.stencil(p));
        let mut moments = Moments::default();
        for (k, &b) in stencil.particles.iter().enumerate() {
            let arm = positions[b as usize] - point.position;
            let z = Complex::new(arm.dot(&point.frame.t1), arm.dot(&point.frame.t2));
            let g = Complex::new(stencil.g1[k], stencil.g2[k]);
            let c = z.conj();
            for (sum, cube) in moments.iter_mut().zip([z * z * z, z * z * c, z * c * c, c * c * c]) {
                *sum += g * cube;
            }
        }
        moments
    }

    /// Points that share a particle with each point, itself among them, and `e^{iθ}` of their frames in the frame of the point.
    fn neighbours_by_particles(&self) -> (Vec<usize>, Vec<(u32, Complex<f64>)>) {
        let mut at: Vec<Vec<u32>> = vec![Vec::new(); self.particle_count];
        for p in 0..self.points.len() {
            self.stencil(p).particles.iter().for_each(|&b| at[b as usize].push(p as u32));
        }
        let (mut offsets, mut neighbours) = (vec![0], Vec::new());
        let mut near = Vec::new();
        for (p, point) in self.points.iter().enumerate() {
            near.clear();
            near.extend(self.stencil(p).particles.iter().flat_map(|&b| &at[b as usize]));
            near.sort_unstable();
            near.dedup();
            neighbours.extend(near.iter().map(|&q| (q, carried(&self.points[q as usize], point))));
            offsets.push(neighbours.len());
        }
        (offsets, neighbours)
    }
}

/// `e^{iθ}` of the first tangent of `from`, rotated with its normal the shorter way to that of `to`, in the frame of `to`.
fn carried(from: &SamplingPoint, to: &SamplingPoint) -> Complex<f64> {
    let (t, sum) = (from.frame.t1, from.frame.n + to.frame.n);
    let rotated = t - sum * (to.frame.n.dot(&t) / (1.0 + from.frame.n.dot(&to.frame.n)));
    let z = Complex::new(rotated.dot(&to.frame.t1), rotated.dot(&to.frame.t2));
    // Opposite normals have no shorter way; cells that share a particle never stand so.
    if z.norm() > 0.5 { z / z.norm() } else { Complex::new(1.0, 0.0) }
}

/// The real components from the complex ones: `ξ = ½(z + z̄)`, `η = (z − z̄)/2i`.
fn components([a, b, c, d]: &Moments) -> [[f64; 4]; 2] {
    let i = Complex::i();
    let sums = [
        (a + b * 3.0 + c * 3.0 + d) / 8.0,
        (a + b - c - d) / (i * 8.0),
        (b + c - a - d) / 8.0,
        (a - b * 3.0 + c * 3.0 - d) * i / 8.0,
    ];
    [sums.map(|z| z.re), sums.map(|z| z.im)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::cell_stencil::cell_operator;
    use crate::surface::jitter::jittered_lattice;
    use crate::surface::lattice::{EndWeights, lattice};
    use crate::surface::patch::{Cylinder, Plate};

    #[test]
    fn a_developed_lattice_is_even() {
        let patch = Cylinder { radius: 2.0, angles: [0.0, 1.5], length: 3.0 };
        let cloud = lattice(&patch, [9, 11], EndWeights::Trapezoid).unwrap();
        let operator = cell_operator(&cloud).unwrap();
        let uneven = operator.uneven_third_moments(&cloud.positions);
        assert!(uneven.iter().flatten().flatten().all(|t| t.abs() < 1e-14));
    }

    /// Turning the frames of the points turns the moments and changes nothing else.
    #[test]
    fn moments_do_not_depend_on_frames() {
        let patch = Plate { lengths: [1.0, 1.0] };
        let cloud = jittered_lattice(&patch, [6, 5], 0.3, 7).unwrap();
        let operator = cell_operator(&cloud).unwrap();
        let mut rotated = operator.clone();
        rotated.align(&Vec3::new(0.6, 0.8, 0.0)).unwrap();
        let plain = {
            let mut plain = operator.clone();
            plain.align(&Vec3::x()).unwrap();
            plain.uneven_third_moments(&cloud.positions)
        };
        let (c, s) = (0.6, 0.8);
        for (t, u) in rotated.uneven_third_moments(&cloud.positions).iter().zip(&plain) {
            // T'111 from all components of T along (c, s): g' = c G1 + s G2, ξ' = c ξ + s η.
            let cube = |a: usize| {
                c * c * c * u[a][0]
                    + 3.0 * c * c * s * u[a][1]
                    + 3.0 * c * s * s * u[a][2]
                    + s * s * s * u[a][3]
            };
            assert!((t[0][0] - c * cube(0) - s * cube(1)).abs() < 1e-14);
        }
        // By the definition, smoothing apart: moments of jittered cells are of the size of the cell's area.
        let largest = plain.iter().flatten().flatten().fold(0.0_f64, |most, t| most.max(t.abs()));
        assert!((1e-3..1.0).contains(&(largest / operator.points[0].weight)), "{largest}");
    }
}
