//! Four points of a section with memory, and the history that each has.

use std::any::Any;
use std::sync::Arc;

use crate::inelastic::{PlasticSection, Tallies};
use crate::memory::Memory;
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
    /// Strains of the last commit, in the order of membrane, curvature, shear.
    at: [Pack; 8],
    /// Whether the history stays as it is whatever the strains.
    held: bool,
}

impl HistoryPack {
    /// Four points that nothing has strained.
    pub fn new(section: Arc<dyn Section>) -> Self {
        let count = section.memory().map_or(0, Memory::history_len);
        let committed = vec![Pack::ZERO; count];
        Self { section, trial: committed.clone(), committed, at: [Pack::ZERO; 8], held: false }
    }

    /// Commits what strains make of the history; strains of the last commit leave every bit as it is, which it tells.
    pub fn commit(&mut self, strains: &Strains) -> bool {
        let Strains { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] } = *strains;
        let at = [a, b, c, d, e, f, g, h];
        if at == self.at {
            return false;
        }
        if let Some(memory) = self.section.memory() {
            memory.history_from(strains, &self.committed, &mut self.trial);
            std::mem::swap(&mut self.committed, &mut self.trial);
            self.at = at;
        }
        true
    }

    /// [`Memory::kept_share`] of the committed history; one without memory.
    pub fn kept_share(&self) -> Pack {
        self.section.memory().map_or(Pack::splat(1.0), |memory| memory.kept_share(&self.committed))
    }

    /// What the committed history of a section that yields says.
    pub fn tallies(&self) -> Option<Tallies<'_>> {
        let section: &PlasticSection = (&*self.section as &dyn Any).downcast_ref()?;
        Some(section.tallies(&self.committed))
    }

    /// Lets [`Section::resultants`] be those of a history that stays as it is, or no longer.
    pub fn hold(&mut self, held: bool) {
        self.held = held;
    }

    /// How many numbers [`HistoryPack::numbers`] gives.
    pub fn count(&self) -> usize {
        LANES * (self.committed.len() + self.at.len())
    }

    /// The committed history with the strains of its commit: all that changes.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        self.committed.iter().chain(&self.at).flat_map(|pack| pack.lanes())
    }

    /// Takes up what [`HistoryPack::numbers`] gave, to the same bits.
    pub fn take_up(&mut self, numbers: &[f64]) {
        let packs = self.committed.iter_mut().chain(&mut self.at);
        for (pack, lanes) in packs.zip(numbers.as_chunks::<LANES>().0) {
            *pack = Pack::new(*lanes);
        }
    }

    /// Bytes of its lists.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(&self.committed[..]) + size_of_val(&self.trial[..])
    }
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
