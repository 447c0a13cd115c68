//! Zero-energy control of wide stencils and nodal sampling: the residual of particle pairs.
//!
//! With nodal gradients that are exact for quadratic fields, the residual of a pair (a, b), `d = X_b − X_a`,
//!
//! ```text
//! e = x_b − x_a − ½Σ_i[(d·T1_i) x,1(i) + (d·T2_i) x,2(i) + (d·D_i) d_i] − (c1 x̄,1 + c2 x̄,2 + c3 d̄)
//! g = d_b − d_a − ½Σ_i[(d·T1_i) d,1(i) + (d·T2_i) d,2(i)]               − (c1' x̄,1 + c2' x̄,2 + c3' d̄)
//! ```
//!
//! vanishes on quadratic fields; the constants c make it vanish in the reference. Residuals are *linear* in
//! (x, d), so `U_h = Σ ½ (ω/|d|²)(β k_s |e|² + β D_b |g|²)` (after \[ganzenmuller2015\]) is a constant quadratic
//! form, indifferent to rotation. Its matrix, four numbers a pair of particles, is assembled once.

use nalgebra::Matrix3;
use rayon::prelude::*;
use shell_kinematics::SectionScales;
use sph_core::{CubicSpline, Kernel, SamplingOperator, Vec3};

use crate::error::ShellError;
use crate::packs::{PARTICLE_CHUNK, Row};
use crate::reference::{Reference, mean_cell_areas, pair_gradients};

/// One row block: which particle, and `∂f_x/∂x, ∂f_x/∂d, ∂f_d/∂x, ∂f_d/∂d` (each times the unit matrix).
#[derive(Clone, Copy, Debug)]
struct Block {
    particle: u32,
    numbers: [f64; 4],
}

/// The assembled control.
#[derive(Clone, Debug)]
pub(crate) struct PairControl {
    offsets: Vec<u32>,
    blocks: Vec<Block>,
}

/// How x and d of one particle enter e and g of a pair: `[e from x, e from d, g from x, g from d]`.
type Share = (u32, [f64; 4]);

impl PairControl {
    pub fn new(reference: &Reference, section: &SectionScales) -> Result<Self, ShellError> {
        let gradients = pair_gradients(&reference.cloud)?;
        let pairs = weighted_pairs(reference, &gradients);
        let residuals: Vec<Residual> =
            pairs.iter().map(|pair| Residual::new(reference, &gradients, pair, section)).collect();
        Ok(Self::assemble(reference.cloud.len(), &residuals))
    }

    fn assemble(count: usize, residuals: &[Residual]) -> Self {
        let mut of_particle: Vec<Vec<(u32, u32)>> = vec![Vec::new(); count];
        for (r, residual) in residuals.iter().enumerate() {
            for (s, share) in residual.shares.iter().enumerate() {
                of_particle[share.0 as usize].push((r as u32, s as u32));
            }
        }
        let mut offsets = vec![0];
        let mut blocks = Vec::new();
        let mut row = vec![[0.0; 4]; count];
        let mut seen = vec![false; count];
        let mut touched: Vec<u32> = Vec::new();
        for list in &of_particle {
            for &(r, s) in list {
                let residual = &residuals[r as usize];
                let [ex, ed, gx, gd] = residual.shares[s as usize].1;
                let [ke, kg] = residual.stiffness;
                for &(b, [fx, fd, hx, hd]) in &residual.shares {
                    if !std::mem::replace(&mut seen[b as usize], true) {
                        touched.push(b);
                    }
                    let entry = &mut row[b as usize];
                    entry[0] += ke * ex * fx + kg * gx * hx;
                    entry[1] += ke * ex * fd + kg * gx * hd;
                    entry[2] += ke * ed * fx + kg * gd * hx;
                    entry[3] += ke * ed * fd + kg * gd * hd;
                }
            }
            touched.sort_unstable();
            for b in touched.drain(..) {
                seen[b as usize] = false;
                blocks.push(Block { particle: b, numbers: std::mem::take(&mut row[b as usize]) });
            }
            offsets.push(blocks.len() as u32);
        }
        Self { offsets, blocks }
    }

    /// Forces `K (x, d)` into `forces`; returns the energy `½ (x, d)·K (x, d)` \[F L\].
    pub fn evaluate(&self, state: &[Row], forces: &mut [Row], parallel: bool) -> f64 {
        let chunk = |(number, rows): (usize, &mut [Row])| {
            for (i, force) in rows.iter_mut().enumerate() {
                *force = self.row(number * PARTICLE_CHUNK + i, state);
            }
        };
        if parallel {
            forces.par_chunks_mut(PARTICLE_CHUNK).enumerate().for_each(chunk);
        } else {
            forces.chunks_mut(PARTICLE_CHUNK).enumerate().for_each(chunk);
        }
        // Positions count from the first particle: far from the origin the products would lose their digits.
        let origin = state[0];
        let work = |(row, force): (&Row, &Row)| -> f64 {
            (0..3).map(|k| (row[k] - origin[k]) * force[k] + row[3 + k] * force[3 + k]).sum()
        };
        0.5 * state.iter().zip(forces.iter()).map(work).sum::<f64>()
    }

    #[inline(always)]
    fn row(&self, a: usize, state: &[Row]) -> Row {
        let own = &state[a];
        let mut force = [0.0; 6];
        for block in &self.blocks[self.offsets[a] as usize..self.offsets[a + 1] as usize] {
            let other = &state[block.particle as usize];
            let [xx, xd, dx, dd] = block.numbers;
            for k in 0..3 {
                // Rows add up to zero over positions: differences keep translation exact.
                let u = other[k] - own[k];
                let d = other[3 + k];
                force[k] += xx * u + xd * d;
                force[3 + k] += dx * u + dd * d;
            }
        }
        force
    }

    /// The blocks of particle `a`: other particle, and `∂f_x/∂x, ∂f_x/∂d, ∂f_d/∂x, ∂f_d/∂d`.
    pub fn blocks_of(&self, a: usize) -> impl Iterator<Item = (u32, [f64; 4])> + '_ {
        self.blocks[self.offsets[a] as usize..self.offsets[a + 1] as usize]
            .iter()
            .map(|block| (block.particle, block.numbers))
    }

    /// Bytes of the assembled matrix.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.blocks[..]) + size_of_val(&self.offsets[..])
    }
}

/// A pair of particles with its weight ω.
struct Pair {
    ends: [u32; 2],
    weight: f64,
}

/// All unordered pairs of the gradients' stencils, `ω_ab = W_ab (A_a/Σ_a + A_b/Σ_b)`, `Σ_a` the sum of W at a.
fn weighted_pairs(reference: &Reference, gradients: &SamplingOperator) -> Vec<Pair> {
    let cloud = &reference.cloud;
    let spacing: Vec<f64> = mean_cell_areas(cloud).into_iter().map(f64::sqrt).collect();
    let mut ends: Vec<[u32; 2]> = Vec::new();
    for a in 0..cloud.len() {
        for &b in gradients.stencil(a).particles {
            if b as usize != a {
                ends.push([(a as u32).min(b), (a as u32).max(b)]);
            }
        }
    }
    ends.sort_unstable();
    ends.dedup();
    let kernel = |&[a, b]: &[u32; 2]| -> f64 {
        let (a, b) = (a as usize, b as usize);
        let h = 0.65 * (spacing[a] + spacing[b]);
        let r = (cloud.positions[b] - cloud.positions[a]).norm();
        // A stencil that was enlarged reaches beyond the kernel; its far pairs keep a hundredth of the weight.
        CubicSpline.value(r / h).max(0.01 * CubicSpline.value(0.0)) / (h * h)
    };
    let mut sums = vec![0.0; cloud.len()];
    for pair in &ends {
        for &end in pair {
            sums[end as usize] += kernel(pair);
        }
    }
    ends.into_iter()
        .map(|pair| {
            let share = |end: u32| cloud.areas[end as usize] / sums[end as usize];
            Pair { ends: pair, weight: kernel(&pair) * (share(pair[0]) + share(pair[1])) }
        })
        .collect()
}

/// The two residuals of a pair as linear functions of (x, d), and their stiffnesses.
struct Residual {
    shares: Vec<Share>,
    stiffness: [f64; 2],
}

impl Residual {
    fn new(
        reference: &Reference,
        gradients: &SamplingOperator,
        pair: &Pair,
        section: &SectionScales,
    ) -> Self {
        let cloud = &reference.cloud;
        let [a, b] = pair.ends.map(|end| end as usize);
        let d = cloud.positions[b] - cloud.positions[a];
        // Shares before the constants: position and director residual of the raw fields.
        let mut shares: Vec<Share> = Vec::new();
        let mut add = |particle: u32, numbers: [f64; 4]| match shares.iter_mut().find(|s| s.0 == particle) {
            Some(share) => (0..4).for_each(|i| share.1[i] += numbers[i]),
            None => shares.push((particle, numbers)),
        };
        add(pair.ends[1], [1.0, 0.0, 0.0, 1.0]);
        add(pair.ends[0], [-1.0, 0.0, 0.0, -1.0]);
        // Mean gradients and director of the two ends, and their reference values.
        let mut mean = [Vec3::zeros(); 3];
        for end in [a, b] {
            let frame = &cloud.frames[end];
            let stencil = gradients.stencil(end);
            let along = [d.dot(&frame.t1), d.dot(&frame.t2), d.dot(&frame.n)];
            add(end as u32, [0.0, -0.5 * along[2], 0.0, 0.0]);
            mean[2] += frame.n * 0.5;
            for (k, &c) in stencil.particles.iter().enumerate() {
                let slope = -0.5 * (along[0] * stencil.g1[k] + along[1] * stencil.g2[k]);
                add(c, [slope, 0.0, 0.0, slope]);
                mean[0] += cloud.positions[c as usize] * (0.5 * stencil.g1[k]);
                mean[1] += cloud.positions[c as usize] * (0.5 * stencil.g2[k]);
            }
        }
        let (mut e0, mut g0) = (Vec3::zeros(), Vec3::zeros());
        for (c, [ex, ed, gx, gd]) in &shares {
            let (x, n) = (cloud.positions[*c as usize], cloud.frames[*c as usize].n);
            e0 += x * *ex + n * *ed;
            g0 += x * *gx + n * *gd;
        }
        // The mean vectors are nearly orthonormal; on a cloud whose frames face each other they could be singular.
        let inverse = Matrix3::from_columns(&mean).try_inverse().unwrap_or_else(Matrix3::zeros);
        let (c, c_prime) = (inverse * e0, inverse * g0);
        let mut ride = |particle: u32, numbers: [f64; 4]| {
            if let Some(share) = shares.iter_mut().find(|s| s.0 == particle) {
                (0..4).for_each(|i| share.1[i] -= numbers[i]);
            }
        };
        for end in [a, b] {
            let stencil = gradients.stencil(end);
            ride(end as u32, [0.0, 0.5 * c[2], 0.0, 0.5 * c_prime[2]]);
            for (k, &particle) in stencil.particles.iter().enumerate() {
                let (g1, g2) = (0.5 * stencil.g1[k], 0.5 * stencil.g2[k]);
                ride(particle, [g1 * c[0] + g2 * c[1], 0.0, g1 * c_prime[0] + g2 * c_prime[1], 0.0]);
            }
        }
        let t2 = section.thickness * section.thickness;
        let square = 0.5 * (cloud.areas[a] + cloud.areas[b]);
        let thick = t2 / (t2 + square);
        // Bending of radius R pre-stresses the patterns by −EIκ²: thick shells need the larger share.
        let beta = 0.1 * (1.0 + 4.0 * thick);
        let scale = pair.weight / d.norm_squared();
        Self { shares, stiffness: [scale * beta * section.shear * thick, scale * beta * section.bending] }
    }
}
