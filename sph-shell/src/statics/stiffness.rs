//! The consistent tangent of the discrete energy, particle block by particle block.
//!
//! Every sampling point contributes the second derivative of its energy with respect to its vectors (the five of a
//! placement, and the two hourglass patterns of a cell), carried to its particles by the stencil; the pair control
//! is a constant matrix. Directors live on spheres: their blocks lose `(d·∂U/∂d) I` on the tangent plane.
//!
//! Four points are treated at a time. Each thread owns some rows of blocks and sweeps the packs that touch them, so that
//! every block sums its points in one order: the same bits for any number of threads.

use std::ops::Range;

use shell_kinematics::{
    LANES, Matrix8, MeasureForces, Pack, Placement, Section, StrainMeasure, StrainsOf, StretchCorrected,
    congruence,
};

use crate::Shell;
use crate::conditions::body::Block;
use crate::control::cells::{CellState, PointTangent, ScaleTangent, VECTORS};
use crate::dispatch::{Work, widest};
use crate::packs::Row;
use crate::points::point::{Point, PointLaw, PointState, sign};
use crate::points::scheme::Scheme;
use crate::registers::Registers;
use crate::statics::blocks::{ShellPattern, Target};

/// Vectors of a point that are made of positions: x,1 x,2 q_x.
const OF_POSITIONS: [usize; 3] = [0, 1, 5];
/// Those made of directors: d d,1 d,2 q_d.
const OF_DIRECTORS: [usize; 4] = [2, 3, 4, 6];
/// Blocks below which a thread's share is not divided.
const SHARE: usize = 256;

impl Shell {
    /// Second derivatives of the internal energy at the present state, into one block a pair of the pattern; the
    /// stresses are those of another state, if one is given.
    pub(crate) fn second_derivatives(
        &self,
        pattern: &ShellPattern,
        stressed: Option<&[Row]>,
        blocks: &mut [Block],
    ) {
        let assembly = Assembly { shell: self, pattern, stressed };
        assembly.run(0..self.len(), blocks, self.evaluation.threads.next_power_of_two());
        self.stiffeners.add_blocks(&self.motion.state, stressed, &pattern.pairs, blocks);
    }
}

/// One evaluation of all blocks.
#[derive(Clone, Copy)]
struct Assembly<'a> {
    shell: &'a Shell,
    pattern: &'a ShellPattern,
    stressed: Option<&'a [Row]>,
}

impl Assembly<'_> {
    /// Fills the blocks of some rows, halves of them on two threads.
    fn run(&self, rows: Range<usize>, blocks: &mut [Block], threads: usize) {
        if threads > 1 && blocks.len() >= 2 * SHARE {
            let first = self.pattern.pairs.of(rows.start).start;
            let offsets = &self.pattern.pairs.offsets()[rows.start..=rows.end];
            let half = first + blocks.len() / 2;
            let cut = rows.start + offsets.partition_point(|&offset| (offset as usize) < half);
            let (left, right) = blocks.split_at_mut(self.pattern.pairs.of(cut).start - first);
            rayon::join(
                || self.run(rows.start..cut, left, threads / 2),
                || self.run(cut..rows.end, right, threads / 2),
            );
            return;
        }
        widest(Leaf { assembly: *self, rows: rows.clone(), blocks });
        if let Scheme::Wide { control, .. } = &self.shell.points.scheme {
            let first = self.pattern.pairs.of(rows.start).start;
            for a in rows {
                for (b, [xx, xd, dx, dd]) in control.blocks_of(a).filter(|block| block.0 as usize <= a) {
                    let Some(block) = self.pattern.pairs.find(a as u32, b) else { continue };
                    for i in 0..3 {
                        blocks[block - first][i][i] += xx;
                        blocks[block - first][i][3 + i] += xd;
                        blocks[block - first][3 + i][i] += dx;
                        blocks[block - first][3 + i][3 + i] += dd;
                    }
                }
            }
        }
    }

    #[inline(always)]
    fn packs<M: StrainMeasure + StrainsOf<Pack> + ?Sized, S: Section + ?Sized>(
        &self,
        law: PointLaw<'_, M, S>,
        rows: &Range<usize>,
        blocks: &mut [Block],
    ) {
        blocks.fill([[0.0; 6]; 6]);
        let first = self.pattern.pairs.of(rows.start).start;
        let mut stencil = Stencil::default();
        for index in (0..self.shell.points.packs.points.len()).filter(|&i| self.pattern.touches(i, rows)) {
            let point = self.shell.points.point(index);
            let yielding = self.shell.points.sections.yielding(index);
            let tangent = match (point.section, point.strain) {
                (Some(section), Some(strain)) => {
                    self.point_tangent(&point, PointLaw { strain, section, yielding })
                }
                (Some(section), None) => {
                    self.point_tangent(&point, PointLaw { strain: law.strain, section, yielding })
                }
                (None, _) => self.point_tangent(&point, law),
            };
            stencil.take(&point);
            scatter(&tangent, &stencil, self.pattern.targets(index), first, blocks);
        }
    }

    /// Second derivatives of four points over their vectors, weights included.
    ///
    /// With stresses of another state, resultants and what the control pulls are taken from there, all else from here.
    #[inline(always)]
    fn point_tangent<M: StrainMeasure + StrainsOf<Pack> + ?Sized, S: Section + ?Sized>(
        &self,
        point: &Point<'_>,
        law: PointLaw<'_, M, S>,
    ) -> PointTangent {
        let pack = point.pack;
        let PointState { placement: p, measures: now, strains, mut control } =
            point.treated().strained::<true, M>(law.strain, &self.shell.motion.state);
        let mut stress = law.section.resultants(&strains);
        if let Some(state) = self.stressed {
            let there = point.treated().strained::<true, M>(law.strain, state);
            stress = law.section.resultants(&there.strains);
            if let (Some((_, here)), Some((_, there))) = (&mut control, &there.control) {
                here.pull_as(there);
            }
        }
        let mut gradient = law.strain.gradient(&now, &pack.reference);
        if let Some(shear) = point.shear {
            shear.adjust_gradient(&mut gradient);
        }
        let mut over = congruence(&gradient, &law.section.tangent(&strains));
        if let Some(shear) = point.shear {
            shear.transpose(&mut stress);
        }
        for (row, add) in over.iter_mut().zip(law.strain.second_gradient(&now, &pack.reference, &stress)) {
            row.iter_mut().zip(add).for_each(|(value, more)| *value += more);
        }
        let mut forces = law.strain.transpose(&now, &pack.reference, &stress);
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
            cell.add_tangent(&p, state, scale, law.yielding, &mut out);
        }
        for row in 0..3 * VECTORS {
            for column in 0..row {
                out[row][column] = out[column][row];
            }
        }
        out
    }
}

/// The rows that one thread fills.
struct Leaf<'a, 'b> {
    assembly: Assembly<'a>,
    rows: Range<usize>,
    blocks: &'b mut [Block],
}

impl Work for Leaf<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<R: Registers>(self, _: R) {
        let Self { assembly, rows, blocks } = self;
        let law = assembly.shell.material.law();
        match law.of_pair::<StretchCorrected>() {
            Some(law) => assembly.packs(law, &rows, blocks),
            None => assembly.packs(law, &rows, blocks),
        }
    }
}

/// How each particle of four points enters their vectors.
#[derive(Default)]
struct Stencil {
    /// Its shares `[G₁, G₂, φ, G₁, G₂, γ, γ]`, the base first.
    shares: Vec<[Pack; VECTORS]>,
}

impl Stencil {
    #[inline(always)]
    fn take(&mut self, point: &Point<'_>) {
        let number = |h: f64, phi: Pack, g1: Pack, g2: Pack| {
            let gamma = point.cell.map_or(Pack::ZERO, |cell| cell.gamma(h, g1, g2));
            [g1, g2, phi, g1, g2, gamma, gamma]
        };
        self.shares.clear();
        self.shares.push([Pack::ZERO; VECTORS]);
        let mut base = (Pack::splat(1.0), Pack::ZERO, Pack::ZERO);
        for (k, entry) in point.entries.iter().enumerate() {
            base = (base.0 - entry.phi, base.1 - entry.g1, base.2 - entry.g2);
            self.shares.push(number(sign(k), entry.phi, entry.g1, entry.g2));
        }
        self.shares[0] = number(1.0, base.0, base.1, base.2);
    }
}

/// Turns second derivatives and forces over measures with the curvature k̂ = c k into those with k, and finds the
/// couplings with c: `∂²ψ = … + (c P k + b)·∂k ⊗ ∂c + … + (k·P·k) ∂c ⊗ ∂c + (b·k) ∂²c`, P and b over k̂.
#[inline(always)]
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
    let factors: [Pack; 8] = std::array::from_fn(|i| {
        let direct = if (3..6).contains(&i) { forces.curvature[i - 3] } else { Pack::ZERO };
        (along[i] * of(i) + direct) * weight
    });
    let mixed = p.along_gradients(&factors);
    for (i, row) in over.iter_mut().enumerate() {
        for (j, value) in row.iter_mut().enumerate() {
            *value = *value * of(i) * of(j);
        }
    }
    forces.curvature = forces.curvature.map(|b| b * state.scale);
    ScaleTangent { mixed, twice: twice * weight, released: released * weight }
}

/// Adds second derivatives of four points to the blocks of their particles, as far as these are among the blocks from
/// number `first` on.
#[inline(always)]
fn scatter(
    tangent: &PointTangent,
    stencil: &Stencil,
    targets: &[[Target; LANES]],
    first: usize,
    blocks: &mut [Block],
) {
    let mut targets = targets.iter();
    for (l, of_l) in stencil.shares.iter().enumerate() {
        // H times the columns of l: rows are vectors of the point, columns are [x, d] of l.
        let mut product = [[Pack::ZERO; 6]; 3 * VECTORS];
        for (row, from) in product.iter_mut().zip(tangent) {
            for k in 0..3 {
                for z in OF_POSITIONS {
                    row[k] += of_l[z] * from[3 * z + k];
                }
                for z in OF_DIRECTORS {
                    row[3 + k] += of_l[z] * from[3 * z + k];
                }
            }
        }
        for (of_k, targets) in stencil.shares[l..].iter().zip(&mut targets) {
            let mut block = [[Pack::ZERO; 6]; 6];
            for i in 0..3 {
                for column in 0..6 {
                    for y in OF_POSITIONS {
                        block[i][column] += of_k[y] * product[3 * y + i][column];
                    }
                    for y in OF_DIRECTORS {
                        block[3 + i][column] += of_k[y] * product[3 * y + i][column];
                    }
                }
            }
            let block = block.map(|row| row.map(Pack::lanes));
            for (lane, target) in targets.iter().enumerate() {
                let Some((place, turned)) = target.within(first, blocks.len()) else { continue };
                let sum = &mut blocks[place];
                for i in 0..6 {
                    for j in 0..6 {
                        sum[i][j] += if turned { block[j][i][lane] } else { block[i][j][lane] };
                    }
                }
            }
        }
    }
}
