//! The sweep over all sampling points: halves for threads, one copy for the default strain and section.

use std::any::Any;
use std::ops::Range;

use shell_kinematics::{IsotropicSection, Section, StrainMeasure, StretchCorrected};

use crate::cell_control::CellPack;
use crate::dispatch::widest;
use crate::membrane_arcs::ArcPack;
use crate::packs::Packs;
use crate::point::{PointLaw, Row, sweep_pack};
use crate::shear::ShearPack;

/// Packs under which a sweep is not split further between threads.
const PACK_CHUNK: usize = 64;

/// One evaluation of all points.
#[derive(Clone, Copy)]
pub(crate) struct Sweep<'a> {
    pub packs: &'a Packs,
    pub cells: &'a [CellPack],
    pub shear: &'a [ShearPack],
    pub arcs: &'a [ArcPack],
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

    /// Sweeps some packs of cells into a ring of slots; the mask is the ring's length less one.
    #[inline(always)]
    pub fn block(&self, packs: Range<usize>, ring: &mut [Row], mask: usize) {
        match self.default_pair() {
            Some(law) => self.ring(law, packs, ring, mask),
            None => self.ring(self.law, packs, ring, mask),
        }
    }

    #[inline(always)]
    fn ring<M: StrainMeasure + ?Sized, S: Section + ?Sized>(
        &self,
        law: PointLaw<'_, M, S>,
        packs: Range<usize>,
        ring: &mut [Row],
        mask: usize,
    ) {
        for index in packs {
            let pack = &self.packs.points[index];
            let entries = &self.packs.entries[pack.first as usize..][..pack.width as usize];
            let first = pack.first_slot(index) & mask;
            let own = &mut ring[first..first + pack.slot_count()];
            sweep_pack::<true, false, M, S>(
                pack,
                entries,
                self.shear(index),
                self.arcs.get(index),
                self.cells.get(index),
                law,
                self.state,
                own,
            );
        }
    }

    /// The strain measure and section of most scenes, for which the sweep is compiled in.
    #[inline(always)]
    fn default_pair(&self) -> Option<PointLaw<'_, StretchCorrected, IsotropicSection>> {
        let strain = (self.law.strain as &dyn Any).downcast_ref()?;
        let section = (self.law.section as &dyn Any).downcast_ref()?;
        Some(PointLaw { strain, section })
    }

    /// Shear constants of a pack, unless the cloud is a lattice of parallelograms.
    #[inline(always)]
    fn shear(&self, index: usize) -> Option<&ShearPack> {
        self.shear.get(index)
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
            let found = sweep_pack::<CELL, ENERGY, M, S>(
                pack,
                entries,
                self.shear(first + i),
                self.arcs.get(first + i),
                cell,
                law,
                self.state,
                own,
            );
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
        match (sweep.default_pair(), sweep.cells.is_empty(), sweep.energy) {
            (Some(law), false, false) => sweep.range::<true, false, _, _>(law, first, slots, energies),
            (_, false, false) => sweep.range::<true, false, _, _>(sweep.law, first, slots, energies),
            (_, false, true) => sweep.range::<true, true, _, _>(sweep.law, first, slots, energies),
            (_, true, false) => sweep.range::<false, false, _, _>(sweep.law, first, slots, energies),
            (_, true, true) => sweep.range::<false, true, _, _>(sweep.law, first, slots, energies),
        }
    }
}

#[cfg(test)]
mod tests {
    use shell_kinematics::Isotropic;
    use sph_core::{Cylinder, EndWeights, cell_operator, lattice};

    use super::*;
    use crate::point::interpolate;

    /// The copy for this machine, the baseline copy, and the copy for any pair give the same bits.
    #[test]
    fn all_copies_of_the_sweep_agree_to_the_last_bit() {
        let patch = Cylinder { radius: 3.0, angles: [-0.5, 0.4], length: 2.5 };
        let cloud = lattice(&patch, [7, 6], EndWeights::Trapezoid).unwrap();
        let section = IsotropicSection::new(Isotropic::new(10.0, 0.3).unwrap(), 0.1).unwrap();
        let operator = cell_operator(&cloud).unwrap();
        let mut packs = Packs::new(&operator);
        let mut cells: Vec<CellPack> = packs
            .points
            .iter()
            .zip(&packs.order)
            .map(|(pack, points)| {
                CellPack::new(&operator, points, pack.weight, &cloud.positions, &section.scales())
            })
            .collect();
        let second = operator.second_moments(&cloud.positions);
        let third = operator.uneven_third_moments(&cloud.positions);
        let shear = ShearPack::all(&operator, &packs.order, &second, &third, 0.1);
        let mut state: Vec<Row> = cloud
            .positions
            .iter()
            .zip(&cloud.frames)
            .map(|(x, f)| [x.x, x.y, x.z, f.n.x, f.n.y, f.n.z])
            .collect();
        for (pack, cell) in packs.points.iter_mut().zip(&mut cells) {
            let entries = &packs.entries[pack.first as usize..][..pack.width as usize];
            let (p, raw) = interpolate::<true>(pack, entries, &state);
            pack.reference = p.measures();
            pack.reference.curvature = cell.rest(&p, &pack.reference.curvature, raw);
        }
        let (arcs, _) = ArcPack::all(&operator, &packs, &second, &third, 0.1);
        for (i, row) in state.iter_mut().enumerate() {
            for (k, value) in row.iter_mut().enumerate() {
                *value += 0.01 * ((7 * i + 3 * k) as f64).sin();
            }
        }
        let law =
            PointLaw { strain: &StretchCorrected as &dyn StrainMeasure, section: &section as &dyn Section };
        let sweep = Sweep {
            packs: &packs,
            cells: &cells,
            shear: &shear,
            arcs: &arcs,
            law,
            state: &state,
            energy: false,
        };
        let count = packs.points.len();
        let run = |how: &dyn Fn(&mut [Row], &mut [f64])| {
            let mut slots = vec![[0.0; 6]; packs.slot_count()];
            how(&mut slots, &mut vec![0.0; count]);
            slots.into_iter().flatten().map(f64::to_bits).collect::<Vec<_>>()
        };
        let here = run(&|slots, energies| sweep.run(0, slots, energies, false));
        let static_law = PointLaw { strain: &StretchCorrected, section: &section };
        let baseline =
            run(&|slots, energies| sweep.range::<true, false, _, _>(static_law, 0, slots, energies));
        let any = run(&|slots, energies| sweep.range::<true, false, _, _>(law, 0, slots, energies));
        assert!(here == baseline && here == any);
        assert!(here.iter().any(|&bits| f64::from_bits(bits) != 0.0));
    }
}
