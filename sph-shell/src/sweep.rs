//! The sweep over all sampling points: halves for threads, one copy for the default strain and section.

use std::any::Any;

use shell_kinematics::{IsotropicSection, Section, StrainMeasure, StretchCorrected};

use crate::cell_control::CellPack;
use crate::dispatch::widest;
use crate::packs::Packs;
use crate::point::{PointLaw, Row, sweep_pack};

/// Packs under which a sweep is not split further between threads.
const PACK_CHUNK: usize = 64;

/// One evaluation of all points.
#[derive(Clone, Copy)]
pub(crate) struct Sweep<'a> {
    pub packs: &'a Packs,
    pub cells: &'a [CellPack],
    pub law: PointLaw<'a>,
    pub state: &'a [Row],
    pub energy: bool,
}

impl Sweep<'_> {
    /// Packs from number `first` on, as many as there are energies; halves go to two threads.
    pub fn run(&self, first: usize, slots: &mut [Row], energies: &mut [f64], split: bool) {
        let count = energies.len();
        if split && count >= 2 * PACK_CHUNK {
            let half = count / 2;
            let points = &self.packs.points;
            let cut = points[first + half].first_slot(first + half) - points[first].first_slot(first);
            let (left_slots, right_slots) = slots.split_at_mut(cut);
            let (left, right) = energies.split_at_mut(half);
            rayon::join(
                || self.run(first, left_slots, left, true),
                || self.run(first + half, right_slots, right, true),
            );
            return;
        }
        widest(Leaf { sweep: self, first, slots, energies });
    }

    #[inline(always)]
    fn range<const CELL: bool, const ENERGY: bool, M: StrainMeasure + ?Sized, S: Section + ?Sized>(
        &self,
        law: PointLaw<'_, M, S>,
        first: usize,
        mut slots: &mut [Row],
        energies: &mut [f64],
    ) {
        for (i, energy) in energies.iter_mut().enumerate() {
            let pack = &self.packs.points[first + i];
            let entries = &self.packs.entries[pack.first as usize..][..pack.width as usize];
            let (own, rest) = slots.split_at_mut(pack.slot_count());
            let cell = if CELL { self.cells.get(first + i) } else { None };
            let found = sweep_pack::<CELL, ENERGY, M, S>(pack, entries, cell, law, self.state, own);
            if ENERGY {
                *energy = found;
            }
            slots = rest;
        }
    }
}

/// The packs that one thread sweeps at a time.
struct Leaf<'a, 'b> {
    sweep: &'b Sweep<'a>,
    first: usize,
    slots: &'b mut [Row],
    energies: &'b mut [f64],
}

impl pulp::NullaryFnOnce for Leaf<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { sweep, first, slots, energies } = self;
        let PointLaw { strain, section } = sweep.law;
        let default_pair = (
            (strain as &dyn Any).downcast_ref::<StretchCorrected>(),
            (section as &dyn Any).downcast_ref::<IsotropicSection>(),
        );
        match (default_pair, sweep.cells.is_empty(), sweep.energy) {
            ((Some(strain), Some(section)), false, false) => {
                sweep.range::<true, false, _, _>(PointLaw { strain, section }, first, slots, energies);
            }
            (_, false, false) => sweep.range::<true, false, _, _>(sweep.law, first, slots, energies),
            (_, false, true) => sweep.range::<true, true, _, _>(sweep.law, first, slots, energies),
            (_, true, false) => sweep.range::<false, false, _, _>(sweep.law, first, slots, energies),
            (_, true, true) => sweep.range::<false, true, _, _>(sweep.law, first, slots, energies),
        }
    }
}
