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
//! k is the curvature along arcs, sampled from directors: the measure `m_αβ` becomes `m_αβ + ½ k·Q_αβ·k`, quadratic forms whose
//! forces and tangent follow. Rigid motion leaves k alone, and on flat bodies at rest nothing changes (patch tests).

use shell_kinematics::{LANES, Matrix8, MeasureForces, Measures, Pack};
use sph_core::SamplingOperator;

/// Forms of four points: for each membrane measure the entries 11, 22, 33, 12, 13, 23 of Q over `k11, k22, 2k12` \[L²\].
#[derive(Clone, Debug)]
pub(crate) struct ArcPack {
    forms: [[Pack; 6]; 3],
}

impl ArcPack {
    /// One pack for each four points of `order`; none where nothing is lost (lattices on developable surfaces).
    ///
    /// `second` are the moments E \[L\], `third` the uneven part of T \[L²\].
    pub fn all(
        operator: &SamplingOperator,
        order: &[[u32; LANES]],
        second: &[[f64; 6]],
        third: &[[[f64; 4]; 2]],
    ) -> Vec<Self> {
        let forms: Vec<[[f64; 6]; 3]> = second.iter().zip(third).map(|(e, t)| forms(e, t)).collect();
        // Round-off of an area is no loss.
        let area = operator.points.iter().fold(0.0_f64, |most, p| most.max(p.weight));
        if forms.iter().flatten().flatten().all(|q| q.abs() < 1e-12 * area) {
            return Vec::new();
        }
        let pack = |points: &[u32; LANES]| Self {
            forms: std::array::from_fn(|m| {
                std::array::from_fn(|i| Pack::from_fn(|lane| forms[points[lane] as usize][m][i]))
            }),
        };
        order.iter().map(pack).collect()
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

    /// Gives the membrane measures back what chords lose.
    #[inline(always)]
    pub fn adjust(&self, now: &mut Measures) {
        let k = now.curvature;
        for m in 0..3 {
            let q = self.product(m, &k);
            now.membrane[m] += (q[0] * k[0] + q[1] * k[1] + q[2] * k[2]) * 0.5;
        }
    }

    /// Transpose of the derivative of [`ArcPack::adjust`].
    #[inline(always)]
    pub fn transpose(&self, k: &[Pack; 3], forces: &mut MeasureForces) {
        for m in 0..3 {
            let (q, n) = (self.product(m, k), forces.membrane[m]);
            for (force, q) in forces.curvature.iter_mut().zip(q) {
                *force += n * q;
            }
        }
    }

    /// Turns second derivatives and forces over adjusted measures into those over plain ones.
    pub fn tangent(&self, k: &[Pack; 3], over: &mut Matrix8, forces: &mut MeasureForces) {
        let products: [[Pack; 3]; 3] = std::array::from_fn(|m| self.product(m, k));
        for row in over.iter_mut() {
            for i in 0..3 {
                row[3 + i] += row[0] * products[0][i] + row[1] * products[1][i] + row[2] * products[2][i];
            }
        }
        let membrane = [over[0], over[1], over[2]];
        for i in 0..3 {
            for (c, value) in over[3 + i].iter_mut().enumerate() {
                *value += membrane[0][c] * products[0][i]
                    + membrane[1][c] * products[1][i]
                    + membrane[2][c] * products[2][i];
            }
        }
        for (form, &n) in self.forms.iter().zip(&forces.membrane) {
            let places = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
            for ((i, j), &q) in places.into_iter().zip(form) {
                over[3 + i][3 + j] += n * q;
                if i != j {
                    over[3 + j][3 + i] += n * q;
                }
            }
        }
        self.transpose(k, forces);
    }
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
