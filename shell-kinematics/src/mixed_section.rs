//! Four sections side by side that need be neither linear nor without memory, each at a height of its own over the surface of the particles.
//!
//! A section whose middle lies at the height e along the director meets the strain `e_m + e κ` there; its membrane force has the arm e:
//!
//! ```text
//! N = N₀(e_m + e κ, κ)        M = M₀ + e N₀        Q = Q₀        C = Lᵀ C₀ L,    L = [1 e; 0 1]
//! ```
//!
//! Each section that differs from the others answers for all four points, of which those are taken that have it.

use std::ops::Range;
use std::sync::Arc;

use crate::memory::Memory;
use crate::pack::{LANES, Pack};
use crate::section::{Section, SectionScales};
use crate::strains::{Resultants, Strains};
use crate::tangent::{Matrix8, ZERO8};

/// Sections of four points.
pub struct MixedSection {
    members: Vec<Member>,
    /// Height of the middle of the section of each point \[L\].
    heights: Pack,
}

/// A section, the points that have it, and where their numbers stand in a history.
pub(crate) struct Member {
    pub section: Arc<dyn Section>,
    pub lanes: [bool; LANES],
    pub numbers: Range<usize>,
}

impl MixedSection {
    /// The sections of four points, and the height of the middle of each over the particles \[L\].
    pub fn new(sections: [Arc<dyn Section>; LANES], heights: [f64; LANES]) -> Self {
        let mut members: Vec<Member> = Vec::new();
        for (lane, section) in sections.into_iter().enumerate() {
            if let Some(known) = members.iter_mut().find(|known| Arc::ptr_eq(&known.section, &section)) {
                known.lanes[lane] = true;
                continue;
            }
            let first = members.last().map_or(0, |last| last.numbers.end);
            let count = section.memory().map_or(0, Memory::history_len);
            let lanes = std::array::from_fn(|of| of == lane);
            members.push(Member { section, lanes, numbers: first..first + count });
        }
        Self { members, heights: Pack::new(heights) }
    }

    /// The sections that differ.
    pub(crate) fn members(&self) -> &[Member] {
        &self.members
    }

    /// What the points meet at the middles of their sections.
    fn raised(&self, strains: &Strains) -> Strains {
        let mut out = *strains;
        for i in 0..3 {
            out.membrane[i] += strains.curvature[i] * self.heights;
        }
        out
    }

    /// Moments about the surface of the particles.
    fn lowered(&self, mut found: Resultants) -> Resultants {
        for i in 0..3 {
            found.moment[i] += found.membrane[i] * self.heights;
        }
        found
    }

    /// Of each point the resultants of its own section.
    fn resultants_by(&self, strains: &Strains, find: impl Fn(&Member, &Strains) -> Resultants) -> Resultants {
        let strains = self.raised(strains);
        let mut out = Resultants::default();
        for member in &self.members {
            take(&mut out, &find(member, &strains), &member.lanes);
        }
        self.lowered(out)
    }

    fn tangent_by(&self, strains: &Strains, find: impl Fn(&Member, &Strains) -> Matrix8) -> Matrix8 {
        let strains = self.raised(strains);
        let mut out = ZERO8;
        for member in &self.members {
            let found = find(member, &strains);
            for i in 0..8 {
                (0..8).for_each(|j| out[i][j] = chosen(out[i][j], found[i][j], &member.lanes));
            }
        }
        // Columns first, then rows.
        for i in 0..8 {
            (0..3).for_each(|j| out[i][3 + j] += out[i][j] * self.heights);
        }
        for i in 0..3 {
            (0..8).for_each(|j| out[3 + i][j] += out[i][j] * self.heights);
        }
        out
    }

    fn energy_by(&self, strains: &Strains, find: impl Fn(&Member, &Strains) -> Pack) -> Pack {
        let strains = self.raised(strains);
        let add = |sum, member: &Member| chosen(sum, find(member, &strains), &member.lanes);
        self.members.iter().fold(Pack::ZERO, add)
    }
}

/// The second where a point has it, else the first.
pub(crate) fn chosen(first: Pack, second: Pack, lanes: &[bool; LANES]) -> Pack {
    let (first, second) = (first.lanes(), second.lanes());
    Pack::from_fn(|lane| if lanes[lane] { second[lane] } else { first[lane] })
}

fn take(out: &mut Resultants, found: &Resultants, lanes: &[bool; LANES]) {
    for i in 0..3 {
        out.membrane[i] = chosen(out.membrane[i], found.membrane[i], lanes);
        out.moment[i] = chosen(out.moment[i], found.moment[i], lanes);
    }
    (0..2).for_each(|i| out.shear[i] = chosen(out.shear[i], found.shear[i], lanes));
}

impl Section for MixedSection {
    fn resultants(&self, strains: &Strains) -> Resultants {
        self.resultants_by(strains, |member, strains| member.section.resultants(strains))
    }

    fn tangent(&self, strains: &Strains) -> Matrix8 {
        self.tangent_by(strains, |member, strains| member.section.tangent(strains))
    }

    fn energy(&self, strains: &Strains) -> Pack {
        self.energy_by(strains, |member, strains| member.section.energy(strains))
    }

    /// Those of the first.
    fn scales(&self) -> SectionScales {
        self.members[0].section.scales()
    }

    fn memory(&self) -> Option<&dyn Memory> {
        Some(self)
    }
}

impl Memory for MixedSection {
    fn history_len(&self) -> usize {
        self.members.last().map_or(0, |last| last.numbers.end)
    }

    fn history_from(
        &self,
        strains: &Strains,
        duration: f64,
        committed: &[Pack],
        trial: &mut [Pack],
    ) -> Resultants {
        let raised = self.raised(strains);
        let mut out = Resultants::default();
        for Member { section, lanes, numbers } in &self.members {
            let found = match section.memory() {
                Some(memory) => {
                    let own = &mut trial[numbers.clone()];
                    let found = memory.history_from(&raised, duration, &committed[numbers.clone()], own);
                    // Points of other sections have no history in this one.
                    own.iter_mut().for_each(|number| *number = chosen(Pack::ZERO, *number, lanes));
                    found
                }
                None => section.resultants(&raised),
            };
            take(&mut out, &found, lanes);
        }
        self.lowered(out)
    }

    fn resultants_from(&self, strains: &Strains, committed: &[Pack]) -> Resultants {
        self.resultants_by(strains, |member, strains| match member.section.memory() {
            Some(memory) => memory.resultants_from(strains, &committed[member.numbers.clone()]),
            None => member.section.resultants(strains),
        })
    }

    fn held_resultants(&self, strains: &Strains, committed: &[Pack]) -> Resultants {
        self.resultants_by(strains, |member, strains| match member.section.memory() {
            Some(memory) => memory.held_resultants(strains, &committed[member.numbers.clone()]),
            None => member.section.resultants(strains),
        })
    }

    fn tangent_from(&self, strains: &Strains, committed: &[Pack]) -> Matrix8 {
        self.tangent_by(strains, |member, strains| match member.section.memory() {
            Some(memory) => memory.tangent_from(strains, &committed[member.numbers.clone()]),
            None => member.section.tangent(strains),
        })
    }

    fn energy_from(&self, strains: &Strains, committed: &[Pack]) -> Pack {
        self.energy_by(strains, |member, strains| match member.section.memory() {
            Some(memory) => memory.energy_from(strains, &committed[member.numbers.clone()]),
            None => member.section.energy(strains),
        })
    }

    fn kept_share(&self, committed: &[Pack]) -> Pack {
        let share = |first, member: &Member| match member.section.memory() {
            Some(memory) => {
                chosen(first, memory.kept_share(&committed[member.numbers.clone()]), &member.lanes)
            }
            None => first,
        };
        self.members.iter().fold(Pack::splat(1.0), share)
    }
}
