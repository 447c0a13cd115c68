//! Membrane strain along arcs: what chords of curved cells lose, where cells are uneven.
//!
//! Positions in a stencil lie on a curved surface, and their differences are chords. With `x,αβ = −k_αβ n` and, for a surface
//! bent without stretch, `x,αγδ·x,β = −⅓(k_αβ k_γδ + k_βγ k_αδ + k_βδ k_αγ)` plus its reference value, the stencil finds
//! `x,α + E_α:x,γδ + (1/6)T^α∴x,γδε` and loses
//!
//! ```text
//! l_αβ = (1/12) (T^α_γδε k_εβ + T^β_γδε k_εα) k_γδ − ½ (E_α:k)(E_β:k)        E = ½ΣGξξ, T = ΣGξξξ
//! ```
//!
//! of the membrane strain: Δ²k²/24 on a lattice, and there a smooth field that the particles make up for by moving a little.
//! Where cells are uneven it differs from cell to cell and cannot be made up: a disordered curved shell locks in the membrane, by
//! (Δ²/12Rt)² of its bending energy. The strain is therefore given back what is lost by the uneven part of T
//! ([`sph_core::SamplingOperator::uneven_third_moments`]) and by E, to first order in the change of curvature:
//!
//! ```text
//! e_m + σ L_m·(k − K),   L_m = ∂l_m/∂k at rest,   σ = min(1, √(ε/12) t/|L|)
//! ```
//!
//! with k the curvature along arcs, from directors, and K its value at rest. L is zero for flat bodies and for lattices on
//! developable surfaces.
//!
//! The bound σ and the first order have one reason. Directors that swing from row to row have curvature, no shear at the middle of
//! a cell, and only the bending stiffness D against them. Through L they can take up membrane strain, each cell as its L goes: the
//! membrane is softened by 12 (σL/t)² ≤ ε at most. The term of second order would let membrane forces take from D. What σ leaves
//! of the locking is the rest: at ε = 0.2 a hemisphere of R/t = 250 and a sphere under pressure are both within about one
//! percent on any cloud. Measurements: docs/uneven-cells.md.

use shell_kinematics::{LANES, Matrix8, MeasureForces, Measures, Number, Pack};
use sph_core::SamplingOperator;

use crate::packs::Packs;
use crate::regions::Scales;
use crate::registers::{Registers, in_all};

/// ε, bound of the softening of the membrane of a cell \[–\]; a shell softens by a twentieth of it.
const SOFTENING: f64 = 0.2;

/// `L_m` of four points, one row for each membrane measure over `k11, k22, 2k12` \[L\].
#[derive(Clone, Debug)]
pub(crate) struct ArcPack<P = Pack> {
    rows: [[P; 3]; 3],
}

/// What chords of uneven curved cells do to the membrane, in the mean over the area.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ChordLoss {
    /// `12⟨((1−σ)|L|/t)²⟩` \[–\]: membrane energy over bending energy of a bending without stretch, from what is not given
    /// back, if no particle moves to make up for it. Above one the shell locks.
    pub locking: f64,
    /// `12⟨(σ|L|/t)²⟩` \[–\]: what is given back, as a part of the membrane stiffness; a shell softens by about a
    /// twentieth of it.
    pub softening: f64,
}

impl ArcPack {
    /// One pack for each four points of `packs`, which hold K; none where nothing is lost.
    ///
    /// `second` are the moments E \[L\], `third` the uneven part of T \[L²\]; without it nothing is given back.
    /// `scales` hold t \[L\]. With it goes what was lost and given back.
    pub fn all(
        operator: &SamplingOperator,
        packs: &Packs,
        second: &[[f64; 6]],
        third: &[[[f64; 4]; 2]],
        scales: &Scales,
    ) -> (Vec<Self>, ChordLoss) {
        if third.is_empty() {
            return (Vec::new(), ChordLoss::default());
        }
        let (mut loss, mut area) = (ChordLoss::default(), 0.0);
        let mut row = |point: u32, weight: f64, k: [f64; 3]| {
            let (e, t) = (&second[point as usize], &third[point as usize]);
            let thickness = scales.at(point as usize).thickness;
            let bent = (k[0] * k[0] + k[1] * k[1] + 0.5 * k[2] * k[2]).sqrt();
            let share = ((SOFTENING / 12.0).sqrt() * thickness / (size(e, t) * bent)).min(1.0);
            let whole = derivative(e, t, k);
            let squared = 12.0 * whole.iter().flatten().map(|l| l * l).sum::<f64>() / (thickness * thickness);
            loss.locking += weight * (1.0 - share).powi(2) * squared;
            loss.softening += weight * share.powi(2) * squared;
            area += weight;
            whole.map(|row| row.map(|l| share * l))
        };
        let rows: Vec<[[[f64; 3]; 3]; LANES]> = packs
            .order
            .iter()
            .enumerate()
            .map(|(index, points)| {
                let pack = packs.constants.get(index);
                let (k, weight) = (pack.reference.curvature.map(Pack::lanes), pack.weight.lanes());
                let at = |lane: usize| [k[0][lane], k[1][lane], k[2][lane]];
                std::array::from_fn(|lane| row(points[lane], weight[lane], at(lane)))
            })
            .collect();
        let loss = ChordLoss { locking: loss.locking / area, softening: loss.softening / area };
        // Round-off of a spacing is no loss.
        let spacing = operator.points.iter().fold(0.0_f64, |most, p| most.max(p.weight)).sqrt();
        if rows.iter().flatten().flatten().flatten().all(|l| l.abs() < 1e-12 * spacing) {
            return (Vec::new(), ChordLoss::default());
        }
        let pack = |rows: &[[[f64; 3]; 3]; LANES]| Self {
            rows: std::array::from_fn(|m| std::array::from_fn(|i| Pack::from_fn(|lane| rows[lane][m][i]))),
        };
        (rows.iter().map(pack).collect(), loss)
    }

    /// The constants in registers.
    #[inline(always)]
    pub fn load<const P: usize, R: Registers<P>>(of: [&Self; P], registers: R) -> ArcPack<R::Numbers> {
        let rows = |m: usize| in_all(of, |of| &of.rows[m]);
        ArcPack { rows: [registers.loads(rows(0)), registers.loads(rows(1)), registers.loads(rows(2))] }
    }

    /// Turns second derivatives and forces over adjusted measures into those over plain ones.
    pub fn tangent(&self, over: &mut Matrix8, forces: &mut MeasureForces) {
        let sum =
            |m: [Pack; 3], i: usize| m[0] * self.rows[0][i] + m[1] * self.rows[1][i] + m[2] * self.rows[2][i];
        for row in over.iter_mut() {
            let membrane = [row[0], row[1], row[2]];
            for i in 0..3 {
                row[3 + i] += sum(membrane, i);
            }
        }
        for c in 0..8 {
            let membrane = [over[0][c], over[1][c], over[2][c]];
            for i in 0..3 {
                over[3 + i][c] += sum(membrane, i);
            }
        }
        self.transpose(forces);
    }
}

impl<P: Number> ArcPack<P> {
    /// Gives the membrane measures back what chords lose.
    #[inline(always)]
    pub fn adjust(&self, now: &mut Measures<P>, reference: &Measures<P>) {
        let mut change = now.curvature;
        for i in 0..3 {
            change[i] = now.curvature[i] - reference.curvature[i];
        }
        for (measure, row) in now.membrane.iter_mut().zip(&self.rows) {
            *measure += row[0] * change[0] + row[1] * change[1] + row[2] * change[2];
        }
    }

    /// Transpose of the derivative of [`ArcPack::adjust`].
    #[inline(always)]
    pub fn transpose(&self, forces: &mut MeasureForces<P>) {
        let [n11, n22, n12] = forces.membrane;
        let [l11, l22, l12] = &self.rows;
        for (i, force) in forces.curvature.iter_mut().enumerate() {
            *force += n11 * l11[i] + n22 * l22[i] + n12 * l12[i];
        }
    }
}

/// Bound of |∂l/∂k| over |k|, whatever the frame \[L²\].
fn size(e: &[f64; 6], t: &[[f64; 4]; 2]) -> f64 {
    let e2: f64 = e.chunks_exact(3).map(|e| e[0] * e[0] + e[1] * e[1] + 2.0 * e[2] * e[2]).sum();
    let t2: f64 = t.iter().map(|t| t[0] * t[0] + 3.0 * (t[1] * t[1] + t[2] * t[2]) + t[3] * t[3]).sum();
    t2.sqrt() / 3.0 + e2
}

/// `∂l/∂k` of the measures `½x,1·x,1`, `½x,2·x,2`, `x,1·x,2`, l being quadratic in `k11, k22, 2k12`.
fn derivative(e: &[f64; 6], t: &[[f64; 4]; 2], k: [f64; 3]) -> [[f64; 3]; 3] {
    let mut rows = [[0.0; 3]; 3];
    let here = lost(e, t, k);
    for i in 0..3 {
        let unit: [f64; 3] = std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 });
        let (alone, both) = (lost(e, t, unit), lost(e, t, std::array::from_fn(|j| k[j] + unit[j])));
        // A quadratic form's mixed part.
        for m in 0..3 {
            rows[m][i] = both[m] - here[m] - alone[m];
        }
    }
    rows
}

/// What the measures lose at curvatures `k11, k22, 2k12` \[–\].
fn lost(e: &[f64; 6], t: &[[f64; 4]; 2], k: [f64; 3]) -> [f64; 3] {
    let tensor = [[k[0], 0.5 * k[2]], [0.5 * k[2], k[1]]];
    let bent = [&e[..3], &e[3..]].map(|e| e[0] * k[0] + e[1] * k[1] + e[2] * k[2]);
    // T^α_γδε k_γδ k_εβ
    let twice = t.map(|t| {
        let once = [t[0] * k[0] + t[1] * k[2] + t[2] * k[1], t[1] * k[0] + t[2] * k[2] + t[3] * k[1]];
        [0, 1].map(|b| once[0] * tensor[0][b] + once[1] * tensor[1][b])
    });
    [
        twice[0][0] / 6.0 - 0.5 * bent[0] * bent[0],
        twice[1][1] / 6.0 - 0.5 * bent[1] * bent[1],
        (twice[0][1] + twice[1][0]) / 6.0 - bent[0] * bent[1],
    ]
}
