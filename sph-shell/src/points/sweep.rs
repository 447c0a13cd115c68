//! The sweep over all sampling points: forces into slots, halves for threads, one copy for the default strain and section.

use std::any::Any;
use std::ops::Range;

use shell_kinematics::{
    IsotropicSection, LANES, Pack, Pack3, Section, SectionPack, StrainMeasure, StretchCorrected,
};

use crate::packs::Row;
use crate::points::dispatch::widest;
use crate::points::point::{Point, PointForces, PointLaw, sign};
use crate::points::scheme::{Points, Scheme};

/// Packs under which a sweep is not split further between threads.
const PACK_CHUNK: usize = 64;

/// One evaluation of all points.
#[derive(Clone, Copy)]
pub(crate) struct Sweep<'a> {
    pub points: &'a Points,
    pub law: PointLaw<'a>,
    pub state: &'a [Row],
    pub energy: bool,
}

impl<'a> Sweep<'a> {
    /// Packs from number `first` on, as many as there are energies; halves go to two threads.
    pub fn run(&self, first: usize, slots: &mut [Row], energies: &mut [f64], split: bool) {
        let count = energies.len();
        if split && count >= 2 * PACK_CHUNK {
            let half = count / 2;
            let points = &self.points.packs.points;
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
        match (self.default_pair(), self.default_strain()) {
            (Some(law), _) => self.ring(|_| law, packs, ring, mask),
            (None, Some(strain)) => self.ring(|index| self.own(strain, index), packs, ring, mask),
            (None, None) => self.ring(|index| self.any(index), packs, ring, mask),
        }
    }

    #[inline(always)]
    fn ring<M: StrainMeasure + ?Sized + 'a, S: Section + ?Sized + 'a>(
        &self,
        law: impl Fn(usize) -> PointLaw<'a, M, S>,
        packs: Range<usize>,
        ring: &mut [Row],
        mask: usize,
    ) {
        for index in packs {
            let point = self.points.point(index);
            let first = point.pack.first_slot(index) & mask;
            let own = &mut ring[first..first + point.pack.slot_count()];
            sweep_pack::<true, false, M, S>(&point, law(index), self.state, own);
        }
    }

    /// The strain measure and section of most scenes, for which the sweep is compiled in.
    #[inline(always)]
    fn default_pair(&self) -> Option<PointLaw<'a, StretchCorrected, IsotropicSection>> {
        if !self.points.sections.is_empty() {
            return None;
        }
        let strain = (self.law.strain as &dyn Any).downcast_ref()?;
        let section = (self.law.section as &dyn Any).downcast_ref()?;
        Some(PointLaw { strain, section })
    }

    /// The strain measure of most scenes, where points have sections of their own.
    #[inline(always)]
    fn default_strain(&self) -> Option<&'a StretchCorrected> {
        (self.law.strain as &dyn Any).downcast_ref().filter(|_| !self.points.sections.is_empty())
    }

    /// That measure with the sections of a pack.
    #[inline(always)]
    fn own(&self, strain: &'a StretchCorrected, index: usize) -> PointLaw<'a, StretchCorrected, SectionPack> {
        PointLaw { strain, section: &self.points.sections[index] }
    }

    /// Any measure with any section of a pack.
    #[inline(always)]
    fn any(&self, index: usize) -> PointLaw<'a> {
        let section = self.points.sections.get(index).map_or(self.law.section, |own| own);
        PointLaw { section, ..self.law }
    }

    #[inline(always)]
    fn range<
        const CELL: bool,
        const ENERGY: bool,
        M: StrainMeasure + ?Sized + 'a,
        S: Section + ?Sized + 'a,
    >(
        &self,
        law: impl Fn(usize) -> PointLaw<'a, M, S>,
        first: usize,
        mut slots: &mut [Row],
        energies: &mut [f64],
    ) {
        for (i, energy) in energies.iter_mut().enumerate() {
            let point = self.points.point(first + i);
            let (own, rest) = slots.split_at_mut(point.pack.slot_count());
            let found = sweep_pack::<CELL, ENERGY, M, S>(&point, law(first + i), self.state, own);
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
        let cells = matches!(sweep.points.scheme, Scheme::Cells { .. });
        let any = |index: usize| sweep.any(index);
        match (sweep.default_pair(), cells, sweep.energy) {
            (Some(law), true, false) => sweep.range::<true, false, _, _>(|_| law, first, slots, energies),
            (_, true, false) => sweep.range::<true, false, _, _>(any, first, slots, energies),
            (_, true, true) => sweep.range::<true, true, _, _>(any, first, slots, energies),
            (_, false, false) => sweep.range::<false, false, _, _>(any, first, slots, energies),
            (_, false, true) => sweep.range::<false, true, _, _>(any, first, slots, energies),
        }
    }
}

#[inline(always)]
fn store(slots: &mut [Row], force: [Pack3; 2]) {
    let [f, t] = [force[0].0.map(Pack::lanes), force[1].0.map(Pack::lanes)];
    for (lane, slot) in slots.iter_mut().enumerate().take(LANES) {
        *slot = [f[0][lane], f[1][lane], f[2][lane], t[0][lane], t[1][lane], t[2][lane]];
    }
}

/// One pack: reads its particles, writes its slots, returns its energy \[F L\] if `ENERGY`.
#[inline(always)]
fn sweep_pack<const CELL: bool, const ENERGY: bool, M: StrainMeasure + ?Sized, S: Section + ?Sized>(
    point: &Point<'_>,
    law: PointLaw<'_, M, S>,
    state: &[Row],
    slots: &mut [Row],
) -> f64 {
    let now = point.strained::<CELL, M>(law.strain, state);
    let PointForces { on_vectors: mut f, density, released } = point.forces::<ENERGY, M, S>(law, &now);
    let w = point.pack.weight;
    f.n1 = f.n1 * w;
    f.n2 = f.n2 * w;
    f.q = f.q * w;
    f.m1 = f.m1 * w;
    f.m2 = f.m2 * w;
    let mut energy = density * w;
    let mut pattern = [Pack3::ZERO; 2];
    if let Some((cell, state)) = &now.control {
        let (forces, more) = cell.add(&now.placement, state, released, &mut f);
        pattern = [forces.position, forces.director];
        energy += more;
    }
    // The base takes what is left: positions by Σ G = 0, directors by Σ φ = 1 and Σ G = 0.
    let (mut base_x, mut base_d) = (Pack3::ZERO, f.q);
    for (k, entry) in point.entries.iter().enumerate() {
        let mut on_x = f.n1 * entry.g1 + f.n2 * entry.g2;
        let mut on_d = f.q * entry.phi + f.m1 * entry.g1 + f.m2 * entry.g2;
        if CELL {
            let h = Pack::splat(sign(k));
            on_x += pattern[0] * h;
            on_d += pattern[1] * h;
        }
        base_x = base_x - on_x;
        base_d = base_d - on_d;
        let first = (k + 1) * LANES;
        store(&mut slots[first..first + LANES], [on_x, on_d]);
    }
    store(&mut slots[..LANES], [base_x, base_d]);
    if ENERGY { energy.sum() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use shell_kinematics::Isotropic;
    use sph_core::{Cylinder, EndWeights, lattice};

    use super::*;
    use crate::formulation::{Formulation, Reach};
    use crate::reference::Reference;
    use crate::regions::Scales;

    /// The copy for this machine, the baseline copy, and the copy for any pair give the same bits.
    #[test]
    fn all_copies_of_the_sweep_agree_to_the_last_bit() {
        let patch = Cylinder { radius: 3.0, angles: [-0.5, 0.4], length: 2.5 };
        let cloud = lattice(&patch, [7, 6], EndWeights::Trapezoid).unwrap();
        let section = IsotropicSection::new(Isotropic::new(10.0, 0.3).unwrap(), 0.1).unwrap();
        let (formulation, scales) = (Formulation::StressPoint(Reach::Cell), section.scales());
        let reference = Reference::new(cloud, &formulation, &scales, 1.0, None).unwrap();
        let scales = Scales { uniform: scales, own: Vec::new() };
        let (points, _) = Points::new(&reference, &formulation, &scales, 1.0).unwrap();
        let mut state = reference.rest();
        for (i, row) in state.iter_mut().enumerate() {
            for (k, value) in row.iter_mut().enumerate() {
                *value += 0.01 * ((7 * i + 3 * k) as f64).sin();
            }
        }
        let law =
            PointLaw { strain: &StretchCorrected as &dyn StrainMeasure, section: &section as &dyn Section };
        let sweep = Sweep { points: &points, law, state: &state, energy: false };
        let count = points.packs.points.len();
        let run = |how: &dyn Fn(&mut [Row], &mut [f64])| {
            let mut slots = vec![[0.0; 6]; points.packs.slot_count()];
            how(&mut slots, &mut vec![0.0; count]);
            slots.into_iter().flatten().map(f64::to_bits).collect::<Vec<_>>()
        };
        let here = run(&|slots, energies| sweep.run(0, slots, energies, false));
        let static_law = PointLaw { strain: &StretchCorrected, section: &section };
        let baseline =
            run(&|slots, energies| sweep.range::<true, false, _, _>(|_| static_law, 0, slots, energies));
        let any = run(&|slots, energies| sweep.range::<true, false, _, _>(|_| law, 0, slots, energies));
        assert!(here == baseline && here == any);
        assert!(here.iter().any(|&bits| f64::from_bits(bits) != 0.0));
    }
}
