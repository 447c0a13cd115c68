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
use shell_kinematics::{LANES, Pack, SectionScales};
use sph_core::{CubicSpline, Kernel, SamplingOperator, Vec3};

use crate::dispatch::{Work, widest};
use crate::error::ShellError;
use crate::packs::Row;
use crate::reference::{Reference, mean_cell_areas, pair_gradients};
use crate::registers::{Registers, columns, four_of};

/// `∂f_x/∂x, ∂f_x/∂d, ∂f_d/∂x, ∂f_d/∂d` of a pair of particles, each times the unit matrix.
type Numbers = [f64; 4];

/// The assembled control: row blocks of four particles at a time, as many for each of them. Shorter rows end in blocks of
/// zeros with the particle itself.
#[derive(Clone, Debug)]
pub(crate) struct PairControl {
    /// First blocks of each four particles, and the end.
    offsets: Vec<u32>,
    /// The other particle of four blocks.
    particles: Vec<[u32; LANES]>,
    /// Their numbers.
    numbers: Vec<[Pack; 4]>,
}

/// How x and d of one particle enter e and g of a pair: `[e from x, e from d, g from x, g from d]`.
type Share = (u32, [f64; 4]);

impl PairControl {
    /// The control of all pairs, `share` of what the formula says \[–\].
    pub fn new(reference: &Reference, section: &SectionScales, share: f64) -> Result<Self, ShellError> {
        let gradients = pair_gradients(&reference.cloud)?;
        let pairs = weighted_pairs(reference, &gradients);
        let residuals: Vec<Residual> =
            pairs.iter().map(|pair| Residual::new(reference, &gradients, pair, section, share)).collect();
        Ok(Self::assemble(reference.cloud.len(), &residuals))
    }

    fn assemble(count: usize, residuals: &[Residual]) -> Self {
        let mut of_particle: Vec<Vec<(u32, u32)>> = vec![Vec::new(); count];
        for (r, residual) in residuals.iter().enumerate() {
            for (s, share) in residual.shares.iter().enumerate() {
                of_particle[share.0 as usize].push((r as u32, s as u32));
            }
        }
        let mut rows: Vec<Vec<(u32, Numbers)>> = Vec::with_capacity(count);
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
            let mut take = |b: u32| {
                seen[b as usize] = false;
                (b, std::mem::take(&mut row[b as usize]))
            };
            rows.push(touched.drain(..).map(&mut take).collect());
        }
        Self::by_fours(&rows)
    }

    fn by_fours(rows: &[Vec<(u32, Numbers)>]) -> Self {
        let mut control = Self { offsets: vec![0], particles: Vec::new(), numbers: Vec::new() };
        for (group, four) in rows.chunks(LANES).enumerate() {
            let most = four.iter().map(Vec::len).max().unwrap_or(0);
            for k in 0..most {
                let block = |lane: usize| {
                    let own = LANES * group + lane.min(four.len() - 1);
                    four.get(lane).and_then(|row| row.get(k)).copied().unwrap_or((own as u32, [0.0; 4]))
                };
                let blocks: [(u32, Numbers); LANES] = std::array::from_fn(block);
                control.particles.push(blocks.map(|block| block.0));
                control.numbers.push(std::array::from_fn(|i| Pack::from_fn(|lane| blocks[lane].1[i])));
            }
            control.offsets.push(control.particles.len() as u32);
        }
        control
    }

    /// Forces `K (x, d)` into `forces`.
    pub fn evaluate(&self, state: &[Row], forces: &mut [Row], threads: usize) {
        parallel::chunks(threads, forces, |first, forces: &mut [Row]| {
            widest(Chunk { control: self, state, first, forces });
        });
    }

    /// The energy `½ (x, d)·K (x, d)` \[F L\] of the forces that [`PairControl::evaluate`] found.
    pub fn energy(state: &[Row], forces: &[Row]) -> f64 {
        // Positions count from the first particle: far from the origin the products would lose their digits.
        let origin = state[0];
        let work = |(row, force): (&Row, &Row)| -> f64 {
            (0..3).map(|k| (row[k] - origin[k]) * force[k] + row[3 + k] * force[3 + k]).sum()
        };
        0.5 * state.iter().zip(forces).map(work).sum::<f64>()
    }

    /// The forces on four particles in the rows `own`.
    #[inline(always)]
    fn four<R: Registers>(
        &self,
        registers: R,
        group: usize,
        own: &[Row; LANES],
        state: &[Row],
    ) -> [Row; LANES] {
        let own = columns(registers, std::array::from_ref(own));
        let mut force = [registers.splat(0.0); 6];
        let range = self.offsets[group] as usize..self.offsets[group + 1] as usize;
        for ([a, b, c, d], numbers) in self.particles[range.clone()].iter().zip(&self.numbers[range]) {
            let rows = [&state[*a as usize], &state[*b as usize], &state[*c as usize], &state[*d as usize]];
            let other = registers.columns([rows]);
            let [xx, xd, dx, dd] = registers.loads([numbers]);
            for k in 0..3 {
                // Rows add up to zero over positions: differences keep translation exact.
                let u = other[k] - own[k];
                let d = other[3 + k];
                force[k] += xx * u + xd * d;
                force[3 + k] += dx * u + dd * d;
            }
        }
        let [rows] = registers.rows(force);
        rows
    }

    /// The blocks of particle `a`: other particle, and `∂f_x/∂x, ∂f_x/∂d, ∂f_d/∂x, ∂f_d/∂d`.
    pub fn blocks_of(&self, a: usize) -> impl Iterator<Item = (u32, Numbers)> + '_ {
        let (group, lane) = (a / LANES, a % LANES);
        let range = self.offsets[group] as usize..self.offsets[group + 1] as usize;
        let blocks = self.particles[range.clone()].iter().zip(&self.numbers[range]);
        blocks.map(move |(particles, numbers)| (particles[lane], numbers.map(|pack| pack.lanes()[lane])))
    }

    /// Bytes of the assembled matrix.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.numbers[..]) + size_of_val(&self.particles[..]) + size_of_val(&self.offsets[..])
    }
}

/// A chunk of particles on its way to a thread, from number `first` on.
struct Chunk<'a, 'b> {
    control: &'a PairControl,
    state: &'a [Row],
    first: usize,
    forces: &'b mut [Row],
}

impl Work for Chunk<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) {
        let Self { control, state, first, forces } = self;
        for (i, forces) in forces.chunks_mut(LANES).enumerate() {
            let a = first + LANES * i;
            let found = control.four(registers, a / LANES, &four_of(state, a), state);
            forces.copy_from_slice(&found[..forces.len()]);
        }
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
        share: f64,
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
        let beta = 0.1 * share * (1.0 + 4.0 * thick);
        let scale = pair.weight / d.norm_squared();
        Self { shares, stiffness: [scale * beta * section.shear * thick, scale * beta * section.bending] }
    }
}
