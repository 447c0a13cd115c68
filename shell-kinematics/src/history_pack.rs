//! Four points of a section with memory, and the history that each has.

use std::any::Any;
use std::sync::Arc;

use crate::inelastic::{PlasticSection, Tallies};
use crate::memory::Memory;
use crate::mixed_section::{MixedSection, chosen};
use crate::pack::{LANES, Pack};
use crate::section::{Section, SectionOf, SectionScales};
use crate::strains::{Resultants, Strains};
use crate::tangent::Matrix8;

/// Four points of a section with their history: a section in its own right between two commits.
#[derive(Clone)]
pub struct HistoryPack {
    section: Arc<dyn Section>,
    committed: Vec<Pack>,
    /// What the next commit finds.
    trial: Vec<Pack>,
    /// Strains of the last commit, in the order of membrane, curvature, shear, and the resultants that they meet in the same order.
    at: [Pack; 8],
    met: [Pack; 8],
    /// Whether the history stays as it is whatever the strains.
    held: bool,
}

impl HistoryPack {
    /// Four points that nothing has strained.
    pub fn new(section: Arc<dyn Section>) -> Self {
        let count = section.memory().map_or(0, Memory::history_len);
        let committed = vec![Pack::ZERO; count];
        Self {
            section,
            trial: committed.clone(),
            committed,
            at: [Pack::ZERO; 8],
            met: [Pack::ZERO; 8],
            held: false,
        }
    }

    /// Commits what strains make of the history at rest; strains of the last commit leave every bit as it is.
    pub fn commit(&mut self, strains: &Strains) {
        self.commit_in(strains, f64::INFINITY);
    }

    /// The same in a step that takes a time \[T\].
    pub fn commit_in(&mut self, strains: &Strains, duration: f64) {
        let Some(Commit { section, committed, trial }) = self.begin_commit(strains) else { return };
        let met = section.memory().map(|memory| memory.history_from(strains, duration, committed, trial));
        self.end_commit(strains, &met.unwrap_or_default());
    }

    /// What a commit reads and writes; none where these strains were committed last, which leaves every bit as it is.
    pub fn begin_commit(&mut self, strains: &Strains) -> Option<Commit<'_>> {
        let Self { section, committed, trial, at, .. } = self;
        (eight(strains) != *at).then_some(Commit { section: &**section, committed, trial })
    }

    /// Takes over what was written, of strains that meet these resultants.
    pub fn end_commit(&mut self, strains: &Strains, met: &Resultants) {
        let Resultants { membrane: [a, b, c], moment: [d, e, f], shear: [g, h] } = *met;
        std::mem::swap(&mut self.committed, &mut self.trial);
        (self.at, self.met) = (eight(strains), [a, b, c, d, e, f, g, h]);
    }

    /// The section, if it yields and its history does not stay as it is.
    pub fn yielding(&self) -> Option<YieldingPack<'_>> {
        let section = (&*self.section as &dyn Any).downcast_ref().filter(|_| !self.held)?;
        Some(YieldingPack { section, committed: &self.committed, at: &self.at, met: &self.met })
    }

    /// [`Memory::kept_share`] of the committed history; one without memory.
    pub fn kept_share(&self) -> Pack {
        self.section.memory().map_or(Pack::splat(1.0), |memory| memory.kept_share(&self.committed))
    }

    /// What the committed history says of points that yield; none where no section does.
    pub fn flowed(&self) -> Option<Flowed> {
        let any = &*self.section as &dyn Any;
        if let Some(section) = any.downcast_ref::<PlasticSection>() {
            return Some(Flowed::of(&section.tallies(&self.committed)));
        }
        let mut out = None;
        for member in any.downcast_ref::<MixedSection>()?.members() {
            let Some(section) = (&*member.section as &dyn Any).downcast_ref::<PlasticSection>() else {
                continue;
            };
            let found = Flowed::of(&section.tallies(&self.committed[member.numbers.clone()]));
            out = Some(out.unwrap_or_else(Flowed::not_at_all).with(&found, &member.lanes));
        }
        out
    }

    /// Lets [`Section::resultants`] be those of a history that stays as it is, or no longer.
    pub fn hold(&mut self, held: bool) {
        self.held = held;
    }

    /// How many numbers [`HistoryPack::numbers`] gives.
    pub fn count(&self) -> usize {
        LANES * (self.committed.len() + self.at.len() + self.met.len())
    }

    /// The committed history with the strains of its commit and what they meet: all that changes.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        self.committed.iter().chain(&self.at).chain(&self.met).flat_map(|pack| pack.lanes())
    }

    /// Takes up what [`HistoryPack::numbers`] gave, to the same bits.
    pub fn take_up(&mut self, numbers: &[f64]) {
        let packs = self.committed.iter_mut().chain(&mut self.at).chain(&mut self.met);
        for (pack, lanes) in packs.zip(numbers.as_chunks::<LANES>().0) {
            *pack = Pack::new(*lanes);
        }
    }

    /// Bytes of its lists.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(&self.committed[..]) + size_of_val(&self.trial[..])
    }
}

/// What four points of sections that yield have gone through; points of other sections have not flowed.
#[derive(Clone, Copy, Debug)]
pub struct Flowed {
    /// [`Tallies::plastic_strain`].
    pub plastic_strain: Pack,
    /// [`Tallies::thickness`].
    pub thickness: Pack,
    /// [`Tallies::yielded_share`].
    pub share: Pack,
    /// [`Tallies::dissipated`].
    pub dissipated: Pack,
    /// [`Tallies::hardened`].
    pub hardened: Pack,
}

impl Flowed {
    fn of(tallies: &Tallies<'_>) -> Self {
        Self {
            plastic_strain: tallies.plastic_strain(),
            thickness: tallies.thickness(),
            share: tallies.yielded_share(),
            dissipated: tallies.dissipated(),
            hardened: tallies.hardened(),
        }
    }

    fn not_at_all() -> Self {
        let zero = Pack::ZERO;
        Self {
            plastic_strain: zero,
            thickness: Pack::splat(1.0),
            share: zero,
            dissipated: zero,
            hardened: zero,
        }
    }

    /// The same with some points of another.
    fn with(self, other: &Self, lanes: &[bool; LANES]) -> Self {
        Self {
            plastic_strain: chosen(self.plastic_strain, other.plastic_strain, lanes),
            thickness: chosen(self.thickness, other.thickness, lanes),
            share: chosen(self.share, other.share, lanes),
            dissipated: chosen(self.dissipated, other.dissipated, lanes),
            hardened: chosen(self.hardened, other.hardened, lanes),
        }
    }
}

/// What a commit reads and writes, as [`Memory::history_from`] has it.
pub struct Commit<'a> {
    /// The section.
    pub section: &'a dyn Section,
    /// The committed history.
    pub committed: &'a [Pack],
    /// The next one.
    pub trial: &'a mut [Pack],
}

/// Strains in the order of membrane, curvature, shear.
fn eight(strains: &Strains) -> [Pack; 8] {
    let Strains { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] } = *strains;
    [a, b, c, d, e, f, g, h]
}

/// A section that yields, with the history that four points have: for registers of any kind.
#[derive(Clone, Copy)]
pub struct YieldingPack<'a> {
    /// The section.
    pub section: &'a PlasticSection,
    /// The committed history.
    pub committed: &'a [Pack],
    /// Strains of the last commit, membrane, curvature, shear.
    pub at: &'a [Pack; 8],
    /// The resultants that they meet, membrane, moment, shear.
    pub met: &'a [Pack; 8],
}

impl std::fmt::Debug for HistoryPack {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("HistoryPack").field("committed", &self.committed).finish_non_exhaustive()
    }
}

impl Section for HistoryPack {
    fn resultants(&self, strains: &Strains) -> Resultants {
        match self.section.memory() {
            Some(memory) if self.held => memory.held_resultants(strains, &self.committed),
            Some(_) if eight(strains) == self.at => {
                let [a, b, c, d, e, f, g, h] = self.met;
                Resultants { membrane: [a, b, c], moment: [d, e, f], shear: [g, h] }
            }
            Some(memory) => memory.resultants_from(strains, &self.committed),
            None => self.section.resultants(strains),
        }
    }

    fn tangent(&self, strains: &Strains) -> Matrix8 {
        match self.section.memory() {
            Some(memory) => memory.tangent_from(strains, &self.committed),
            None => self.section.tangent(strains),
        }
    }

    fn energy(&self, strains: &Strains) -> Pack {
        match self.section.memory() {
            Some(memory) => memory.energy_from(strains, &self.committed),
            None => self.section.energy(strains),
        }
    }

    fn scales(&self) -> SectionScales {
        self.section.scales()
    }

    fn homogeneous(&self) -> bool {
        self.section.homogeneous()
    }
}

impl SectionOf<Pack> for HistoryPack {
    fn resultants_of(&self, strains: &Strains) -> Resultants {
        self.resultants(strains)
    }

    fn energy_of(&self, strains: &Strains) -> Pack {
        self.energy(strains)
    }
}
