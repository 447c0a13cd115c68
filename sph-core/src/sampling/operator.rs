//! Sampling operators: values and gradients at points from particles, and their transposes.

use crate::Vec3;
use crate::error::SpaceError;
use crate::surface::frame::Frame;

/// Projection of a unit vector on the surface below which it has no direction there.
const SHORTEST_PROJECTION: f64 = 1e-6;

/// Where a field and its surface gradient are sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SamplingPoint {
    /// Position `[L]`.
    pub position: Vec3,
    /// Frame in which the gradient has its two components.
    pub frame: Frame,
    /// Area the point stands for `[L²]`.
    pub weight: f64,
}

/// For each sampling point p a stencil of particles b with numbers φ, G₁, G₂ (compressed rows):
/// `f(p) = Σ φ_b f_b`, `f,α(p) = Σ G_αb f_b`.
#[derive(Clone, Debug, PartialEq)]
pub struct SamplingOperator {
    /// Sampling points.
    pub points: Vec<SamplingPoint>,
    /// First entry of each point's stencil, and the end.
    pub offsets: Vec<u32>,
    /// Particle of each entry.
    pub particles: Vec<u32>,
    /// Value numbers φ, dimensionless.
    pub phi: Vec<f64>,
    /// Gradient numbers along `t1` `[1/L]`.
    pub g1: Vec<f64>,
    /// Gradient numbers along `t2` `[1/L]`.
    pub g2: Vec<f64>,
    /// Kernel weight of each entry over the greatest of its stencil, dimensionless: entries change in proportion to it
    /// when the operator is made divergence consistent.
    pub kernel_weights: Vec<f64>,
    /// Polynomial order that each point differentiates exactly.
    pub orders: Vec<u8>,
    /// Number of particles of the cloud.
    pub particle_count: usize,
}

/// The stencil of one sampling point.
#[derive(Clone, Copy, Debug)]
pub struct Stencil<'a> {
    /// Particles.
    pub particles: &'a [u32],
    /// Value numbers φ, dimensionless.
    pub phi: &'a [f64],
    /// Gradient numbers along `t1` `[1/L]`.
    pub g1: &'a [f64],
    /// Gradient numbers along `t2` `[1/L]`.
    pub g2: &'a [f64],
}

impl SamplingOperator {
    /// Operator without points on a cloud of `particle_count` particles.
    pub(crate) fn empty(particle_count: usize) -> SamplingOperator {
        SamplingOperator {
            points: Vec::new(),
            offsets: vec![0],
            particles: Vec::new(),
            phi: Vec::new(),
            g1: Vec::new(),
            g2: Vec::new(),
            kernel_weights: Vec::new(),
            orders: Vec::new(),
            particle_count,
        }
    }

    /// Appends a point; `kernel_weights` of any scale.
    pub(crate) fn push(&mut self, point: SamplingPoint, order: u8, stencil: Stencil, kernel_weights: &[f64]) {
        let greatest = kernel_weights.iter().copied().fold(0.0, f64::max);
        self.points.push(point);
        self.orders.push(order);
        self.particles.extend_from_slice(stencil.particles);
        self.phi.extend_from_slice(stencil.phi);
        self.g1.extend_from_slice(stencil.g1);
        self.g2.extend_from_slice(stencil.g2);
        self.kernel_weights.extend(kernel_weights.iter().map(|w| w / greatest));
        self.offsets.push(self.particles.len() as u32);
    }

    /// Rotates the frame of every point about its normal until `t1` is the projection of `axis` on the surface, and the
    /// gradient numbers with it. Gradients stay the same vectors of space; material axes need a direction that means
    /// something throughout the cloud, which the frames that operators come with do not.
    ///
    /// # Errors
    /// [`SpaceError::AxisNormal`] where the unit vector along `axis` has a projection shorter than 1e-6 (round-off would
    /// decide its direction), or none because `axis` is zero or not finite.
    pub fn align(&mut self, axis: &Vec3) -> Result<(), SpaceError> {
        self.align_at(0..self.points.len(), axis)
    }

    /// The same at some points.
    ///
    /// # Errors
    /// As [`SamplingOperator::align`].
    pub fn align_at(
        &mut self,
        points: impl IntoIterator<Item = usize>,
        axis: &Vec3,
    ) -> Result<(), SpaceError> {
        let axis = axis.normalize();
        for p in points {
            let Frame { t1, t2, n } = self.points[p].frame;
            let [first, second] = [axis.dot(&t1), axis.dot(&t2)];
            let projection = libm::hypot(first, second);
            if projection.is_nan() || projection < SHORTEST_PROJECTION {
                let position = self.points[p].position.into();
                return Err(SpaceError::AxisNormal { position, projection, bound: SHORTEST_PROJECTION });
            }
            let [cos, sin] = [first / projection, second / projection];
            for entry in self.entries(p) {
                let (g1, g2) = (self.g1[entry], self.g2[entry]);
                self.g1[entry] = cos * g1 + sin * g2;
                self.g2[entry] = cos * g2 - sin * g1;
            }
            self.points[p].frame = Frame { t1: t1 * cos + t2 * sin, t2: t2 * cos - t1 * sin, n };
        }
        Ok(())
    }

    /// Entries of point `p` in the flat arrays.
    pub fn entries(&self, p: usize) -> std::ops::Range<usize> {
        self.offsets[p] as usize..self.offsets[p + 1] as usize
    }

    /// Stencil of point `p`.
    pub fn stencil(&self, p: usize) -> Stencil<'_> {
        let entries = self.entries(p);
        Stencil {
            particles: &self.particles[entries.clone()],
            phi: &self.phi[entries.clone()],
            g1: &self.g1[entries.clone()],
            g2: &self.g2[entries],
        }
    }

    /// Values `Σ φ_b f_b` of a nodal field at the points, in the unit of `field`.
    pub fn value(&self, field: &[f64]) -> Vec<f64> {
        (0..self.points.len())
            .map(|p| {
                let stencil = self.stencil(p);
                stencil.particles.iter().zip(stencil.phi).map(|(&b, phi)| phi * field[b as usize]).sum()
            })
            .collect()
    }

    /// Gradients `[Σ G₁_b f_b, Σ G₂_b f_b]` of a nodal field at the points, in the unit of `field` per `[L]`.
    pub fn gradient(&self, field: &[f64]) -> Vec<[f64; 2]> {
        (0..self.points.len())
            .map(|p| {
                let stencil = self.stencil(p);
                let mut gradient = [0.0; 2];
                for (k, &b) in stencil.particles.iter().enumerate() {
                    gradient[0] += stencil.g1[k] * field[b as usize];
                    gradient[1] += stencil.g2[k] * field[b as usize];
                }
                gradient
            })
            .collect()
    }

    /// Transpose of [`value`](Self::value) and [`gradient`](Self::gradient): from `[q, n₁, n₂]` per point the nodal
    /// sums `Σ_p w_p (φ q + G₁ n₁ + G₂ n₂)`.
    pub fn gather(&self, resultants: &[[f64; 3]]) -> Vec<f64> {
        let mut nodal = vec![0.0; self.particle_count];
        for (p, [q, n1, n2]) in resultants.iter().enumerate() {
            let stencil = self.stencil(p);
            let weight = self.points[p].weight;
            for (k, &b) in stencil.particles.iter().enumerate() {
                nodal[b as usize] += weight * (stencil.phi[k] * q + stencil.g1[k] * n1 + stencil.g2[k] * n2);
            }
        }
        nodal
    }

    /// Second moments of the gradient numbers about each point `[L]`, which the shear correction needs:
    /// `E_α,11 = ½ΣG_α ξ²`, `E_α,22 = ½ΣG_α η²`, `E_α,12 = ½ΣG_α ξη`, in the order
    /// E₁,₁₁ E₁,₂₂ E₁,₁₂ E₂,₁₁ E₂,₂₂ E₂,₁₂. They vanish where quadratic fields are differentiated exactly.
    pub fn second_moments(&self, positions: &[Vec3]) -> Vec<[f64; 6]> {
        (0..self.points.len())
            .map(|p| {
                let (point, stencil) = (&self.points[p], self.stencil(p));
                let mut moments = [0.0; 6];
                for (k, &b) in stencil.particles.iter().enumerate() {
                    let arm = positions[b as usize] - point.position;
                    let (xi, eta) = (arm.dot(&point.frame.t1), arm.dot(&point.frame.t2));
                    for (alpha, g) in [stencil.g1[k], stencil.g2[k]].into_iter().enumerate() {
                        moments[3 * alpha] += 0.5 * g * xi * xi;
                        moments[3 * alpha + 1] += 0.5 * g * eta * eta;
                        moments[3 * alpha + 2] += 0.5 * g * xi * eta;
                    }
                }
                moments
            })
            .collect()
    }
}
