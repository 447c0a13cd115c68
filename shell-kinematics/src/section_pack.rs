//! Four linear sections side by side, each at a height of its own over the surface of the particles.
//!
//! A section whose middle lies at the height e along the director meets the strain `e_m + e κ` there, and its membrane force has
//! the arm e about the surface of the particles:
//!
//! ```text
//! N = A (e_m + e κ) + B κ                         A' = A
//! M = Bᵀ(e_m + e κ) + D κ + e N                   B' = B + e A
//! Q = S γ                                         D' = D + e (B + Bᵀ) + e² A
//! ```
//!
//! with A, B, D, S those of the section about its own middle.

use crate::pack::{LANES, Pack};
use crate::section::{Section, SectionOf, SectionScales};
use crate::strains::{Resultants, Strains};
use crate::tangent::{Matrix8, ZERO8};

/// Row and column of the entries of a symmetric 3×3 matrix.
const SYMMETRIC: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Sections of four points, linear in the strains.
#[derive(Clone, Debug)]
pub struct SectionPack {
    /// A' \[F/L\], in the order of [`SYMMETRIC`].
    membrane: [Pack; 6],
    /// B' \[F\].
    coupling: [[Pack; 3]; 3],
    /// D' \[F L\].
    bending: [Pack; 6],
    /// S11, S22, S12 \[F/L\].
    shear: [Pack; 3],
    scales: SectionScales,
}

impl SectionPack {
    /// The sections of four points, and the height of the middle of each over the particles \[L\].
    ///
    /// Of each its stiffness without strain is taken, membrane with bending and shear by itself: that is all there is of a
    /// section that is [linear](Section::linear). Others go into a [`crate::MixedSection`].
    pub fn new(sections: [&dyn Section; LANES], heights: [f64; LANES]) -> Self {
        let tangents = sections.map(|section| section.tangent(&Strains::default()));
        let at = |row: usize, column: usize| Pack::from_fn(|lane| tangents[lane][row][column].lanes()[lane]);
        let e = Pack::new(heights);
        let symmetric = |first: usize| SYMMETRIC.map(|(i, j)| at(first + i, first + j));
        let membrane = symmetric(0);
        let own: [[Pack; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| at(i, 3 + j)));
        let mut coupling = own;
        let mut bending = symmetric(3);
        for (number, (i, j)) in SYMMETRIC.into_iter().enumerate() {
            let lever = membrane[number] * e;
            coupling[i][j] += lever;
            if i != j {
                coupling[j][i] += lever;
            }
            bending[number] += (own[i][j] + own[j][i] + lever) * e;
        }
        let shear = [at(6, 6), at(7, 7), at(6, 7)];
        Self { membrane, coupling, bending, shear, scales: sections[0].scales() }
    }
}

/// `S v` for a symmetric matrix in the order of [`SYMMETRIC`].
#[inline(always)]
fn times(m: &[Pack; 6], v: &[Pack; 3]) -> [Pack; 3] {
    let [m11, m22, m33, m12, m13, m23] = *m;
    [
        m11 * v[0] + m12 * v[1] + m13 * v[2],
        m12 * v[0] + m22 * v[1] + m23 * v[2],
        m13 * v[0] + m23 * v[1] + m33 * v[2],
    ]
}

impl Section for SectionPack {
    fn linear(&self) -> bool {
        true
    }

    #[inline(always)]
    fn resultants(&self, strains: &Strains) -> Resultants {
        let (e, k) = (&strains.membrane, &strains.curvature);
        let (mut membrane, mut moment) = (times(&self.membrane, e), times(&self.bending, k));
        for i in 0..3 {
            for j in 0..3 {
                membrane[i] += self.coupling[i][j] * k[j];
                moment[j] += self.coupling[i][j] * e[i];
            }
        }
        let ([s11, s22, s12], [g1, g2]) = (self.shear, strains.shear);
        Resultants { membrane, moment, shear: [s11 * g1 + s12 * g2, s12 * g1 + s22 * g2] }
    }

    fn tangent(&self, _: &Strains) -> Matrix8 {
        let mut out = ZERO8;
        for (number, (i, j)) in SYMMETRIC.into_iter().enumerate() {
            (out[i][j], out[j][i]) = (self.membrane[number], self.membrane[number]);
            (out[3 + i][3 + j], out[3 + j][3 + i]) = (self.bending[number], self.bending[number]);
        }
        for i in 0..3 {
            for j in 0..3 {
                (out[i][3 + j], out[3 + j][i]) = (self.coupling[i][j], self.coupling[i][j]);
            }
        }
        let [s11, s22, s12] = self.shear;
        (out[6][6], out[7][7], out[6][7], out[7][6]) = (s11, s22, s12, s12);
        out
    }

    #[inline(always)]
    fn energy(&self, strains: &Strains) -> Pack {
        self.resultants(strains).work(strains) * 0.5
    }

    /// Those of the first.
    fn scales(&self) -> SectionScales {
        self.scales
    }
}

impl SectionOf<Pack> for SectionPack {
    #[inline(always)]
    fn resultants_of(&self, strains: &Strains) -> Resultants {
        self.resultants(strains)
    }

    #[inline(always)]
    fn energy_of(&self, strains: &Strains) -> Pack {
        self.energy(strains)
    }
}
