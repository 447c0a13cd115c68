//! The consistent tangent of the discrete energy, particle block by particle block.
//!
//! Every sampling point contributes the second derivative of its energy with respect to its vectors (the five of a
//! placement, and the two hourglass patterns of a cell), carried to its particles by the stencil; the pair control
//! is a constant matrix. Directors live on spheres: their blocks lose `(d·∂U/∂d) I` on the tangent plane.

use shell_kinematics::{LANES, Matrix8, MeasureForces, Pack, Placement, congruence};

use crate::Shell;
use crate::conditions::loads::Block;
use crate::control::cells::{CellState, PointTangent, ScaleTangent, VECTORS};
use crate::packs::Row;
use crate::points::point::{Point, PointState, sign};
use crate::points::scheme::Scheme;

/// Those of a point's vectors that are made of positions.
const OF_POSITIONS: [bool; VECTORS] = [true, true, false, false, false, true, false];

/// Which pairs of particles (row not below column) share a block, row by row.
#[derive(Clone, Debug)]
pub(crate) struct BlockPattern {
    pub offsets: Vec<u32>,
    pub columns: Vec<u32>,
}

impl BlockPattern {
    pub fn new(shell: &Shell) -> Self {
        let mut rows: Vec<Vec<u32>> = (0..shell.len()).map(|a| vec![a as u32]).collect();
        let operator = &shell.reference.operator;
        for p in 0..operator.points.len() {
            let particles = operator.stencil(p).particles;
            for &a in particles {
                rows[a as usize].extend(particles.iter().filter(|&&b| b < a));
            }
        }
        shell.load_stiffness(1.0, &mut |a, b, _| rows[a.max(b) as usize].push(a.min(b)));
        if let Scheme::Wide { control, .. } = &shell.points.scheme {
            for (a, row) in rows.iter_mut().enumerate() {
                row.extend(control.blocks_of(a).map(|(b, _)| b).filter(|&b| (b as usize) < a));
            }
        }
        let mut pattern = Self { offsets: vec![0], columns: Vec::new() };
        for mut row in rows {
            row.sort_unstable();
            row.dedup();
            pattern.columns.extend(row);
            pattern.offsets.push(pattern.columns.len() as u32);
        }
        pattern
    }

    /// Number of the block of particles `a ≥ b`.
    pub fn find(&self, a: u32, b: u32) -> Option<usize> {
        let first = self.offsets[a as usize] as usize;
        let row = &self.columns[first..self.offsets[a as usize + 1] as usize];
        row.binary_search(&b).ok().map(|i| first + i)
    }
}

impl Shell {
    /// Second derivatives of the internal energy at the present state, into one block a pair of the pattern; the
    /// stresses are those of another state, if one is given.
    pub(crate) fn second_derivatives(
        &self,
        pattern: &BlockPattern,
        stressed: Option<&[Row]>,
        blocks: &mut [Block],
    ) {
        blocks.fill([[0.0; 6]; 6]);
        for index in 0..self.points.packs.points.len() {
            let point = self.points.point(index);
            let tangent = self.point_tangent(&point, stressed);
            for lane in 0..LANES {
                if point.pack.weight.lanes()[lane] == 0.0 {
                    continue;
                }
                let shares = shares(&point, lane);
                scatter(&tangent, lane, &shares, pattern, blocks);
            }
        }
        if let Scheme::Wide { control, .. } = &self.points.scheme {
            for a in 0..self.len() {
                for (b, [xx, xd, dx, dd]) in control.blocks_of(a) {
                    let Some(block) = (b as usize <= a).then(|| pattern.find(a as u32, b)).flatten() else {
                        continue;
                    };
                    for i in 0..3 {
                        blocks[block][i][i] += xx;
                        blocks[block][i][3 + i] += xd;
                        blocks[block][3 + i][i] += dx;
                        blocks[block][3 + i][3 + i] += dd;
                    }
                }
            }
        }
    }

    /// Second derivatives of four points over their vectors, weights included.
    ///
    /// With stresses of another state, resultants and what the control pulls are taken from there, all else from here.
    fn point_tangent(&self, point: &Point<'_>, stressed: Option<&[Row]>) -> PointTangent {
        let pack = point.pack;
        let PointState { placement: p, measures: now, strains, mut control } =
            point.strained::<true, _>(self.strain, &self.state);
        let section = self.section_of(point);
        let mut stress = section.resultants(&strains);
        if let Some(state) = stressed {
            let there = point.strained::<true, _>(self.strain, state);
            stress = section.resultants(&there.strains);
            if let (Some((_, here)), Some((_, there))) = (&mut control, &there.control) {
                here.pull_as(there);
            }
        }
        let mut gradient = self.strain.gradient(&now, &pack.reference);
        if let Some(shear) = point.shear {
            shear.adjust_gradient(&mut gradient);
        }
        let mut over = congruence(&gradient, &section.tangent(&strains));
        if let Some(shear) = point.shear {
            shear.transpose(&mut stress);
        }
        for (row, add) in over.iter_mut().zip(self.strain.second_gradient(&stress)) {
            row.iter_mut().zip(add).for_each(|(value, more)| *value += more);
        }
        let mut forces = self.strain.transpose(&now, &pack.reference, &stress);
        if let Some(arcs) = point.arcs {
            arcs.tangent(&mut over, &mut forces);
        }
        let scale =
            control.as_ref().map(|(_, state)| scale_tangent(&p, state, pack.weight, &mut over, &mut forces));
        let placement = p.tangent(&over, &forces);
        let mut out = [[Pack::ZERO; 3 * VECTORS]; 3 * VECTORS];
        for (row, from) in out.iter_mut().zip(&placement) {
            for (value, v) in row.iter_mut().zip(from) {
                *value = *v * pack.weight;
            }
        }
        if let (Some((cell, state)), Some(scale)) = (&control, &scale) {
            cell.add_tangent(&p, state, scale, &mut out);
        }
        out
    }
}

/// How each particle of a point enters its vectors: `[G₁, G₂, φ, G₁, G₂, γ, γ]`.
fn shares(point: &Point<'_>, lane: usize) -> Vec<(u32, [f64; VECTORS])> {
    let number = |h: f64, phi: f64, g1: f64, g2: f64| {
        let gamma = point.cell.map_or(0.0, |cell| cell.gamma(lane, h, g1, g2));
        [g1, g2, phi, g1, g2, gamma, gamma]
    };
    let own = point.pack.base[lane];
    let mut base = (1.0, 0.0, 0.0);
    let mut shares = Vec::with_capacity(point.entries.len() + 1);
    for (k, entry) in point.entries.iter().enumerate() {
        let (phi, g1, g2) = (entry.phi.lanes()[lane], entry.g1.lanes()[lane], entry.g2.lanes()[lane]);
        base = (base.0 - phi, base.1 - g1, base.2 - g2);
        // Filled-up places repeat the base with zero: a triangle has no fourth particle and no pattern.
        if entry.particles[lane] != own {
            shares.push((entry.particles[lane], number(sign(k), phi, g1, g2)));
        }
    }
    shares.push((own, number(1.0, base.0, base.1, base.2)));
    shares
}

/// Turns second derivatives and forces over measures with the curvature k̂ = c k into those with k, and finds the
/// couplings with c: `∂²ψ = … + (c P k + b)·∂k ⊗ ∂c + … + (k·P·k) ∂c ⊗ ∂c + (b·k) ∂²c`, P and b over k̂.
fn scale_tangent(
    p: &Placement,
    state: &CellState,
    weight: Pack,
    over: &mut Matrix8,
    forces: &mut MeasureForces,
) -> ScaleTangent {
    let k = state.curvature;
    let of = |i: usize| if (3..6).contains(&i) { state.scale } else { Pack::splat(1.0) };
    let along: [Pack; 8] = std::array::from_fn(|i| over[i][3] * k[0] + over[i][4] * k[1] + over[i][5] * k[2]);
    let twice = along[3] * k[0] + along[4] * k[1] + along[5] * k[2];
    let released = state.released(&forces.curvature);
    let mut mixed = [Pack::ZERO; 3 * VECTORS];
    for (i, row) in p.measure_gradients().iter().enumerate() {
        let direct = if (3..6).contains(&i) { forces.curvature[i - 3] } else { Pack::ZERO };
        let factor = (along[i] * of(i) + direct) * weight;
        mixed.iter_mut().zip(row).for_each(|(value, gradient)| *value += factor * *gradient);
    }
    for (i, row) in over.iter_mut().enumerate() {
        for (j, value) in row.iter_mut().enumerate() {
            *value = *value * of(i) * of(j);
        }
    }
    forces.curvature = forces.curvature.map(|b| b * state.scale);
    ScaleTangent { mixed, twice: twice * weight, released: released * weight }
}

/// Adds one point's second derivatives to the blocks of its particles.
fn scatter(
    tangent: &PointTangent,
    lane: usize,
    shares: &[(u32, [f64; VECTORS])],
    pattern: &BlockPattern,
    blocks: &mut [Block],
) {
    for &(b, of_b) in shares {
        // H times the columns of b: rows are vectors of the point, columns are [x, d] of b.
        let mut product = [[0.0; 6]; 3 * VECTORS];
        for (r, row) in product.iter_mut().enumerate() {
            for z in 0..VECTORS {
                let first = if OF_POSITIONS[z] { 0 } else { 3 };
                for k in 0..3 {
                    row[first + k] += of_b[z] * tangent[r][3 * z + k].lanes()[lane];
                }
            }
        }
        for &(a, of_a) in shares.iter().filter(|share| share.0 >= b) {
            let Some(block) = pattern.find(a, b) else { continue };
            for y in 0..VECTORS {
                let first = if OF_POSITIONS[y] { 0 } else { 3 };
                for k in 0..3 {
                    for column in 0..6 {
                        blocks[block][first + k][column] += of_a[y] * product[3 * y + k][column];
                    }
                }
            }
        }
    }
}
