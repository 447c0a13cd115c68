//! Four linear sections that are under stress before they are strained.
//!
//! ```text
//! N = N₀ + A e + B κ        M = M₀ + Bᵀ e + D κ        Q = S γ        ψ = ψ₀ + N₀·e + M₀·κ + ½ (N − N₀)·e + ½ (M − M₀)·κ + ½ Q·γ
//! ```
//!
//! N₀ and M₀ are the resultants of the unstrained state about the surface of the particles, in the frame of the point at rest, and do work on
//! the strains of whatever measure there is. ψ is counted from the unstrained state, ψ₀ = 0: what the stress stored before is not known. Of heat it is ([`crate::Expansion`]), and
//! N₀ and M₀ go with the level: they are put anew.

use crate::pack::{LANES, Pack};
use crate::section::{Section, SectionOf, SectionScales};
use crate::section_pack::SectionPack;
use crate::strains::{Resultants, Strains};
use crate::tangent::Matrix8;

/// Sections of four points with resultants of their own where nothing is strained.
#[derive(Clone, Debug)]
pub struct StressedPack {
    section: SectionPack,
    /// N₀ \[F/L\] and M₀ \[F\], `11, 22, 12` of each.
    initial: [Pack; 6],
    /// Part of them that is there \[–\].
    share: f64,
    /// ψ₀ \[F/L\].
    stored: Pack,
}

impl StressedPack {
    /// Puts the resultants `N11, N22, N12, M11, M22, M12` of four unstrained points on their sections, in full.
    pub fn new(section: SectionPack, resultants: [[f64; 6]; LANES]) -> Self {
        let initial = std::array::from_fn(|i| Pack::from_fn(|lane| resultants[lane][i]));
        Self { section, initial, share: 1.0, stored: Pack::ZERO }
    }

    /// Leaves a part of the stress \[–\]; one is all of it.
    pub fn set_share(&mut self, share: f64) {
        self.share = share;
    }

    /// Puts other resultants in their place, in full, and what four unstrained points store \[F/L\].
    pub fn put(&mut self, resultants: [[f64; 6]; LANES], stored: [f64; LANES]) {
        self.initial = std::array::from_fn(|i| Pack::from_fn(|lane| resultants[lane][i]));
        (self.share, self.stored) = (1.0, Pack::new(stored));
    }
}

impl Section for StressedPack {
    #[inline(always)]
    fn resultants(&self, strains: &Strains) -> Resultants {
        let mut out = self.section.resultants(strains);
        for i in 0..3 {
            out.membrane[i] += self.initial[i] * self.share;
            out.moment[i] += self.initial[3 + i] * self.share;
        }
        out
    }

    fn tangent(&self, strains: &Strains) -> Matrix8 {
        self.section.tangent(strains)
    }

    #[inline(always)]
    fn energy(&self, strains: &Strains) -> Pack {
        let mut work = Pack::ZERO;
        for i in 0..3 {
            work += self.initial[i] * strains.membrane[i] + self.initial[3 + i] * strains.curvature[i];
        }
        self.section.energy(strains) + work * self.share + self.stored
    }

    fn scales(&self) -> SectionScales {
        self.section.scales()
    }
}

impl SectionOf<Pack> for StressedPack {
    #[inline(always)]
    fn resultants_of(&self, strains: &Strains) -> Resultants {
        self.resultants(strains)
    }

    #[inline(always)]
    fn energy_of(&self, strains: &Strains) -> Pack {
        self.energy(strains)
    }
}
