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
//! of the membrane strain: Δ²k²/24 on a lattice, and there a smooth field that the particles make up for by moving a little. Where cells are uneven it
//! differs from cell to cell and cannot be made up: a disordered shell locks in the membrane, by (Δ²/12Rt)² of its bending
//! energy. The strain is therefore given back what is lost by the uneven part of T
//! ([`SamplingOperator::uneven_third_moments`]) and by E, which is nought on parallelograms. Given back whole, lattices would do worse in
//! coarse large rotations; measurements are in docs/zero-energy-control.md.
//!
//! k is the curvature along arcs, sampled from directors, and l a quadratic form of it. Directors that swing from row to row have
//! curvature but no shear at the middle of a cell, and only the bending stiffness D against them: where the membrane carries
//! N > D/|Q|, forces N·Q of either sign would set them going. So with e the strain of chords the strain is
//!
//! ```text
//! e + g(e + l) l,    g(y) = 1/(1 + y·y/e_c²),    e_c = t²/(12|Q|)
//! ```
//!
//! all of l where the membrane is at rest, and never more bending stiffness taken than half of what there is. Rigid motion leaves
//! k alone, and on flat bodies nothing changes (patch tests). Forces and tangent are exact derivatives.

use shell_kinematics::{LANES, Matrix8, MeasureForces, Measures, Pack};
use sph_core::SamplingOperator;

/// Forms of four points: for each membrane measure the entries 11, 22, 33, 12, 13, 23 of Q over `k11, k22, 2k12` \[L²\].
#[derive(Clone, Debug)]
pub(crate) struct ArcPack {
    forms: [[Pack; 6]; 3],
    /// What chords of the reference configuration lose \[–\].
    reference: [Pack; 3],
    /// `1/e_c²` \[–\].
    limit: Pack,
}

/// What chords lose now, and what follows from it for derivatives.
pub(crate) struct ArcState {
    /// l less its reference value \[–\].
    lost: [Pack; 3],
    /// `∂l_m/∂k_a` \[L\].
    by_curvature: [[Pack; 3]; 3],
    /// The share g that is given back, and ∂g/∂y \[–\].
    share: Pack,
    by_strain: [Pack; 3],
    /// `−4 g W y/e_c²`, of which the second derivative of g is made.
    second: [Pack; 3],
}

/// W of the norm of a strain `e11, e22, 2e12`.
const NORM: [f64; 3] = [1.0, 1.0, 0.5];

impl ArcPack {
    /// One pack for each four points of `order`; none where nothing is lost (lattices on developable surfaces).
    ///
    /// `second` are the moments E \[L\], `third` the uneven part of T \[L²\]; without it nothing is given back.
    pub fn all(
        operator: &SamplingOperator,
        order: &[[u32; LANES]],
        second: &[[f64; 6]],
        third: &[[[f64; 4]; 2]],
        thickness: f64,
    ) -> Vec<Self> {
        let forms: Vec<[[f64; 6]; 3]> = second.iter().zip(third).map(|(e, t)| forms(e, t)).collect();
        // Round-off of an area is no loss.
        let area = operator.points.iter().fold(0.0_f64, |most, p| most.max(p.weight));
        if forms.iter().flatten().flatten().all(|q| q.abs() < 1e-12 * area) {
            return Vec::new();
        }
        let limit = |p: usize| (12.0 * size(&second[p], &third[p]) / (thickness * thickness)).powi(2);
        let pack = |points: &[u32; LANES]| Self {
            forms: std::array::from_fn(|m| {
                std::array::from_fn(|i| Pack::from_fn(|lane| forms[points[lane] as usize][m][i]))
            }),
            reference: [Pack::ZERO; 3],
            limit: Pack::from_fn(|lane| limit(points[lane] as usize)),
        };
        order.iter().map(pack).collect()
    }

    /// Takes the present curvature as the reference.
    pub fn rest(&mut self, k: &[Pack; 3]) {
        self.reference = std::array::from_fn(|m| self.value(&self.product(m, k), k));
    }

    /// `Q_m k`.
    #[inline(always)]
    fn product(&self, m: usize, k: &[Pack; 3]) -> [Pack; 3] {
        let [q11, q22, q33, q12, q13, q23] = self.forms[m];
        [
            q11 * k[0] + q12 * k[1] + q13 * k[2],
            q12 * k[0] + q22 * k[1] + q23 * k[2],
            q13 * k[0] + q23 * k[1] + q33 * k[2],
        ]
    }

    #[inline(always)]
    fn value(&self, product: &[Pack; 3], k: &[Pack; 3]) -> Pack {
        dot(product, k) * 0.5
    }

    /// Gives the membrane measures back what chords lose.
    #[inline(always)]
    pub fn adjust(&self, now: &mut Measures, reference: &Measures) -> ArcState {
        let k = now.curvature;
        let by_curvature: [[Pack; 3]; 3] = std::array::from_fn(|m| self.product(m, &k));
        let lost: [Pack; 3] = std::array::from_fn(|m| self.value(&by_curvature[m], &k) - self.reference[m]);
        let strain: [Pack; 3] = std::array::from_fn(|m| now.membrane[m] - reference.membrane[m] + lost[m]);
        let weighed: [Pack; 3] = std::array::from_fn(|m| strain[m] * self.limit * NORM[m]);
        let one = Pack::splat(1.0);
        let share = one / (one + dot(&weighed, &strain));
        let by_strain = weighed.map(|w| w * share * share * -2.0);
        let second = weighed.map(|w| w * share * -4.0);
        for (measure, lost) in now.membrane.iter_mut().zip(&lost) {
            *measure += *lost * share;
        }
        ArcState { lost, by_curvature, share, by_strain, second }
    }

    /// Turns second derivatives and forces over adjusted measures into those over plain ones.
    pub fn tangent(&self, state: &ArcState, over: &mut Matrix8, forces: &mut MeasureForces) {
        let ArcState { lost, by_curvature: l, share, by_strain, second } = state;
        let n = forces.membrane;
        let along = |v: &[Pack; 3]| [0, 1, 2].map(|a| v[0] * l[0][a] + v[1] * l[1][a] + v[2] * l[2][a]);
        // Gradient of the adjusted strains over plain strains and curvatures.
        let of_share = along(by_strain);
        let gradient: [[Pack; 6]; 3] = std::array::from_fn(|i| {
            std::array::from_fn(|c| match c {
                0..3 => lost[i] * by_strain[c] + Pack::splat(if i == c { 1.0 } else { 0.0 }),
                _ => *share * l[i][c - 3] + lost[i] * of_share[c - 3],
            })
        });
        let mut wide = *over;
        for row in wide.iter_mut() {
            let m = [row[0], row[1], row[2]];
            for c in 0..6 {
                let sum = m[0] * gradient[0][c] + m[1] * gradient[1][c] + m[2] * gradient[2][c];
                row[c] = if c < 3 { sum } else { row[c] + sum };
            }
        }
        let rows: [[Pack; 8]; 3] = [wide[0], wide[1], wide[2]];
        for c in 0..6 {
            for k in 0..8 {
                let sum =
                    rows[0][k] * gradient[0][c] + rows[1][k] * gradient[1][c] + rows[2][k] * gradient[2][c];
                wide[c][k] = if c < 3 { sum } else { wide[c][k] + sum };
            }
        }
        *over = wide;
        // Second derivatives of the adjusted strains, times the forces on them.
        let s = dot(&n, lost);
        let pull = along(&n);
        let curved: [[Pack; 3]; 3] = std::array::from_fn(|j| {
            std::array::from_fn(|k| {
                let diagonal =
                    if j == k { self.limit * *share * *share * (-2.0 * NORM[j]) } else { Pack::ZERO };
                by_strain[j] * second[k] + diagonal
            })
        });
        for j in 0..3 {
            let row = along(&curved[j]);
            for k in 0..3 {
                over[j][k] += s * curved[j][k];
                let mixed = by_strain[j] * pull[k] + s * row[k];
                over[j][3 + k] += mixed;
                over[3 + k][j] += mixed;
            }
        }
        let half: [[Pack; 3]; 3] = std::array::from_fn(|k| along(&curved[k]));
        for a in 0..3 {
            let turned = [l[0][a], l[1][a], l[2][a]];
            for b in 0..3 {
                let across = [half[0][b], half[1][b], half[2][b]];
                over[3 + a][3 + b] +=
                    pull[a] * of_share[b] + of_share[a] * pull[b] + s * dot(&turned, &across);
            }
        }
        for (m, form) in self.forms.iter().enumerate() {
            let factor = n[m] * *share + s * by_strain[m];
            let places = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
            for ((i, j), &q) in places.into_iter().zip(form) {
                over[3 + i][3 + j] += factor * q;
                if i != j {
                    over[3 + j][3 + i] += factor * q;
                }
            }
        }
        state.transpose(forces);
    }
}

impl ArcState {
    /// Transpose of the derivative of [`ArcPack::adjust`].
    #[inline(always)]
    pub fn transpose(&self, forces: &mut MeasureForces) {
        let n = forces.membrane;
        let s = dot(&n, &self.lost);
        for m in 0..3 {
            let onto = n[m] * self.share + s * self.by_strain[m];
            for (force, l) in forces.curvature.iter_mut().zip(&self.by_curvature[m]) {
                *force += onto * *l;
            }
            forces.membrane[m] += s * self.by_strain[m];
        }
    }
}

#[inline(always)]
fn dot(a: &[Pack; 3], b: &[Pack; 3]) -> Pack {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Bound of |l| = ½|k·Q·k| over |k|², twice: whatever the frame \[L²\].
fn size(e: &[f64; 6], t: &[[f64; 4]; 2]) -> f64 {
    let e2: f64 = e.chunks_exact(3).map(|e| e[0] * e[0] + e[1] * e[1] + 2.0 * e[2] * e[2]).sum();
    let t2: f64 = t.iter().map(|t| t[0] * t[0] + 3.0 * (t[1] * t[1] + t[2] * t[2]) + t[3] * t[3]).sum();
    t2.sqrt() / 3.0 + e2
}

/// Q of the three measures, from the values of the loss by polarisation.
fn forms(e: &[f64; 6], t: &[[f64; 4]; 2]) -> [[f64; 6]; 3] {
    let of =
        |along: &[usize]| lost(e, t, std::array::from_fn(|i| if along.contains(&i) { 1.0 } else { 0.0 }));
    let single = [of(&[0]), of(&[1]), of(&[2])];
    std::array::from_fn(|m| {
        let mixed = |i: usize, j: usize| of(&[i, j])[m] - single[i][m] - single[j][m];
        [2.0 * single[0][m], 2.0 * single[1][m], 2.0 * single[2][m], mixed(0, 1), mixed(0, 2), mixed(1, 2)]
    })
}

/// What the measures `½x,1·x,1`, `½x,2·x,2`, `x,1·x,2` lose at curvatures `k11, k22, 2k12` \[–\].
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
