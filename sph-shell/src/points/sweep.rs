//! The sweep over all sampling points: forces into slots, halves for threads, one copy for the default strain and section.

use std::any::Any;
use std::ops::Range;

use shell_kinematics::{
    LANES, Logarithmic, Pack, Pack3, SectionOf, StrainMeasure, StrainsOf, StretchCorrected,
};

use crate::control::yielding::YieldingControl;
use crate::dispatch::{Work, widest};
use crate::packs::Row;
use crate::points::point::{PointForces, PointLaw, Treated, signed};
use crate::points::ring::{Ring, groups};
use crate::points::scheme::{Points, Sections};
use crate::registers::{Baseline, Registers, in_all};

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

    /// Sweeps some packs of cells into a ring, and for their energies if they are asked for.
    #[inline(always)]
    pub fn block<const P: usize, R: Registers<P>>(
        &self,
        registers: R,
        packs: Range<usize>,
        ring: &mut Ring,
        energies: &mut [f64],
    ) {
        match &self.points.sections {
            Sections::One => {}
            Sections::Own(own) => return self.cells_of_sections(own, packs, ring, energies),
            Sections::Stressed(own) => return self.cells_of_sections(own, packs, ring, energies),
            Sections::Remembering(own) => {
                return self.cells_that_remember(registers.single(), own, packs, ring, energies);
            }
        }
        if self.energy {
            self.cells::<true, 1, _, _, _>(Baseline, self.law, packs, ring, energies);
        } else if let Some(law) = self.law.of_pair::<StretchCorrected>() {
            self.cells::<false, P, _, _, _>(registers, law, packs, ring, energies);
        } else if let Some(law) = self.law.of_pair::<Logarithmic>() {
            self.cells::<false, P, _, _, _>(registers, law, packs, ring, energies);
        } else {
            self.cells::<false, 1, _, _, _>(Baseline, self.law, packs, ring, energies);
        }
    }

    /// Packs with sections of their own, one after the other.
    #[inline(always)]
    fn cells_of_sections<S: SectionOf<Pack>>(
        &self,
        sections: &[S],
        packs: Range<usize>,
        ring: &mut Ring,
        energies: &mut [f64],
    ) {
        if !self.points.strains.is_empty() {
            return self.cells_of_strains(sections, packs, ring, energies);
        }
        let strain = (self.law.strain as &dyn Any).downcast_ref::<StretchCorrected>();
        for (index, energy) in packs.zip(energies) {
            let (pack, section) = (index..index + 1, &sections[index]);
            let energy = std::slice::from_mut(energy);
            match (strain, self.energy) {
                (Some(strain), false) => {
                    self.cells::<false, 1, _, _, _>(
                        Baseline,
                        PointLaw { strain, section, yielding: None },
                        pack,
                        ring,
                        energy,
                    );
                }
                (_, false) => {
                    let law = PointLaw { strain: self.law.strain, section, yielding: None };
                    self.cells::<false, 1, _, _, _>(Baseline, law, pack, ring, energy);
                }
                (_, true) => {
                    let law = PointLaw { strain: self.law.strain, section, yielding: None };
                    self.cells::<true, 1, _, _, _>(Baseline, law, pack, ring, energy);
                }
            }
        }
    }

    /// The same with strain measures of their own.
    fn cells_of_strains<S: SectionOf<Pack>>(
        &self,
        sections: &[S],
        packs: Range<usize>,
        ring: &mut Ring,
        energies: &mut [f64],
    ) {
        for (index, energy) in packs.zip(energies) {
            let strain: &dyn StrainMeasure = &self.points.strains[index];
            let law = PointLaw { strain, section: &sections[index], yielding: None };
            let (pack, energy) = (index..index + 1, std::slice::from_mut(energy));
            match self.energy {
                false => self.cells::<false, 1, _, _, _>(Baseline, law, pack, ring, energy),
                true => self.cells::<true, 1, _, _, _>(Baseline, law, pack, ring, energy),
            }
        }
    }

    /// Packs of one law: several at once where the registers hold them.
    #[inline(always)]
    pub(super) fn cells<const ENERGY: bool, const P: usize, R, M, S>(
        &self,
        registers: R,
        law: PointLaw<'_, M, S>,
        packs: Range<usize>,
        ring: &mut Ring,
        energies: &mut [f64],
    ) where
        R: Registers<P>,
        M: StrainsOf<R::Numbers> + StrainsOf<<R::Single as Registers>::Numbers> + ?Sized,
        S: SectionOf<R::Numbers> + SectionOf<<R::Single as Registers>::Numbers> + ?Sized,
    {
        let mut pack = packs.start;
        while pack < packs.end {
            if P > 1 && !ENERGY && pack + P <= packs.end && ring.begins(pack, P) {
                let points = Treated { registers, of: self.points.several(pack) };
                if points.are_alike() {
                    sweep_packs::<true, false, P, _, M, S>(&points, law, self.state, ring.of(pack, P));
                    pack += P;
                    continue;
                }
            }
            let points = self.points.point(pack).treated_in(registers.single());
            let found = sweep_packs::<true, ENERGY, 1, _, M, S>(&points, law, self.state, ring.of(pack, 1));
            if ENERGY {
                energies[pack - packs.start] = found;
            }
            pack += 1;
        }
    }

    #[inline(always)]
    fn range<const ENERGY: bool, R: Registers, M, S>(
        &self,
        registers: R,
        law: PointLaw<'_, M, S>,
        first: usize,
        mut slots: &mut [Row],
        energies: &mut [f64],
    ) where
        M: StrainsOf<R::Numbers> + ?Sized,
        S: SectionOf<R::Numbers> + ?Sized,
    {
        for (i, energy) in energies.iter_mut().enumerate() {
            let point = self.points.point(first + i);
            let (own, rest) = slots.split_at_mut(point.place.slot_count());
            let points = point.treated_in(registers);
            let found = sweep_packs::<false, ENERGY, 1, _, M, S>(&points, law, self.state, groups(own));
            if ENERGY {
                *energy = found;
            }
            slots = rest;
        }
    }
}

/// The packs of wide stencils that one thread sweeps at a time.
struct Leaf<'a, 'b> {
    sweep: &'b Sweep<'a>,
    first: usize,
    slots: &'b mut [Row],
    energies: &'b mut [f64],
}

impl Work for Leaf<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) {
        let Self { sweep, first, slots, energies } = self;
        match (sweep.law.of_pair::<StretchCorrected>(), sweep.energy) {
            (_, true) => sweep.range::<true, _, _, _>(Baseline, sweep.law, first, slots, energies),
            (None, false) => sweep.range::<false, _, _, _>(Baseline, sweep.law, first, slots, energies),
            (Some(law), false) => sweep.range::<false, _, _, _>(registers, law, first, slots, energies),
        }
    }
}

/// Some packs: reads their particles, writes their slots, returns their energy \[F L\] if `ENERGY`.
#[inline(always)]
fn sweep_packs<const CELL: bool, const ENERGY: bool, const P: usize, R: Registers<P>, M, S>(
    points: &Treated<'_, R, P>,
    law: PointLaw<'_, M, S>,
    state: &[Row],
    slots: &mut [[Row; LANES]],
) -> f64
where
    M: StrainsOf<R::Numbers> + ?Sized,
    S: SectionOf<R::Numbers> + ?Sized,
{
    let registers = points.registers;
    let now = points.strained::<CELL, M>(law.strain, state);
    let PointForces { on_vectors: mut f, density, released } = points.forces::<ENERGY, M, S>(law, &now);
    let w = points.weight();
    f.n1 = f.n1 * w;
    f.n2 = f.n2 * w;
    f.q = f.q * w;
    f.m1 = f.m1 * w;
    f.m2 = f.m2 * w;
    let mut energy = density * w;
    let zero = Pack3([registers.splat(0.0); 3]);
    let mut pattern = [zero; 2];
    if let Some((cell, state)) = &now.control {
        let (pulls, more) = match law.yielding {
            None => cell.pulls(state, released),
            Some(own) => {
                // Of one pack: those that remember are swept one by one.
                let own = YieldingControl::load([own; P], registers);
                let (mut pulls, work) = own.pulls(cell.stiffnesses(), state.components());
                let [more, again] = state.pulled_by_scale(released);
                pulls[3] += more;
                pulls[4] += again;
                (pulls, work)
            }
        };
        let forces = cell.add(&now.placement, state, released, pulls, &mut f);
        pattern = [forces.position, forces.director];
        energy += more;
    }
    // The base takes what is left: positions by Σ G = 0, directors by Σ φ = 1 and Σ G = 0.
    let mut base = [zero, f.q];
    let (width, stride) = (points.width(), slots.len() / P);
    let (entries, slots) = (points.entries(width), &mut slots[..(P - 1) * stride + width + 1]);
    for k in 0..width {
        let [phi, g1, g2] = points.numbers(in_all(entries, |of| &of[k]));
        let mut on_x = f.n1 * g1 + f.n2 * g2;
        let mut on_d = f.q * phi + f.m1 * g1 + f.m2 * g2;
        if CELL {
            on_x = signed(k, on_x, pattern[0]);
            on_d = signed(k, on_d, pattern[1]);
        }
        base = [base[0] - on_x, base[1] - on_d];
        store(registers, slots, (1 + k, stride), on_x, on_d);
    }
    store(registers, slots, (0, stride), base[0], base[1]);
    if ENERGY { registers.store(energy).as_flattened().iter().sum() } else { 0.0 }
}

/// Forces and couples of the points on a particle of each, into slots of an entry; those of the packs are a stride apart.
#[inline(always)]
fn store<const P: usize, R: Registers<P>>(
    registers: R,
    slots: &mut [[Row; LANES]],
    (entry, stride): (usize, usize),
    f: Pack3<R::Numbers>,
    t: Pack3<R::Numbers>,
) {
    let ([x, y, z], [u, v, w]) = (f.0, t.0);
    let rows = registers.rows([x, y, z, u, v, w]);
    for part in 0..P {
        slots[part * stride + entry] = rows[part];
    }
}

#[cfg(test)]
mod tests {
    use shell_kinematics::{Isotropic, IsotropicSection, Section, StrainMeasure, StretchCorrected};
    use sph_core::{Cloud, Cylinder, EndWeights, jittered_lattice, lattice};

    use super::*;
    use crate::dispatch::{Narrow, WideWork, fullest};
    use crate::formulation::{Formulation, Reach};
    use crate::reference::Reference;
    use crate::regions::Scales;
    use crate::time::march::tests::with_triangles;

    /// The copies for this machine, the baseline copy, and the copy for any pair give the same bits: on a lattice, on uneven cells, and where triangles and
    /// quadrangles lie side by side.
    #[test]
    fn all_copies_of_the_sweep_agree_to_the_last_bit() {
        let patch = Cylinder { radius: 3.0, angles: [-0.5, 0.4], length: 2.5 };
        let even = lattice(&patch, [7, 6], EndWeights::Trapezoid).unwrap();
        let uneven = jittered_lattice(&patch, [9, 7], 0.25, 3).unwrap();
        let cut = with_triangles(&even, 7);
        for cloud in [even, uneven, cut] {
            agree(&StretchCorrected, cloud.clone());
            agree(&Logarithmic, cloud);
        }
    }

    fn agree<M: StrainMeasure + StrainsOf<Pack>>(strain: &M, cloud: Cloud) {
        let section = IsotropicSection::new(Isotropic::new(10.0, 0.3).unwrap(), 0.1).unwrap();
        let (formulation, scales) = (Formulation::StressPoint(Reach::Cell), section.scales());
        let reference = Reference::new(cloud, &formulation, &scales, 1.0, None).unwrap();
        let scales = Scales { uniform: scales, own: Vec::new() };
        let points = Points::new(&reference, &formulation, &scales, 1.0).unwrap();
        let mut state = reference.rest();
        for (i, row) in state.iter_mut().enumerate() {
            for (k, value) in row.iter_mut().enumerate() {
                *value += 0.01 * libm::sin((7 * i + 3 * k) as f64);
            }
        }
        let law = PointLaw {
            strain: strain as &dyn StrainMeasure,
            section: &section as &dyn Section,
            yielding: None,
        };
        let sweep = Sweep { points: &points, law, state: &state, energy: false };
        let count = points.packs.points.len();
        let mut energies = vec![0.0; count];
        let mut run = |how: &dyn Fn(&mut Ring, &mut [f64])| {
            let mut ring = Ring::new(&points.packs, 0, count);
            how(&mut ring, &mut energies);
            ring.rows().iter().flatten().map(|value| value.to_bits()).collect::<Vec<_>>()
        };
        let here = run(&|ring, energies| widest(Narrow(Cells { sweep, ring, energies })));
        let fullest = run(&|ring, energies| fullest(Cells { sweep, ring, energies }));
        let static_law = PointLaw { strain, section: &section, yielding: None };
        let baseline = run(&|ring, energies| {
            sweep.cells::<false, 1, _, _, _>(Baseline, static_law, 0..count, ring, energies)
        });
        let any =
            run(&|ring, energies| sweep.cells::<false, 1, _, _, _>(Baseline, law, 0..count, ring, energies));
        assert!(here == baseline && here == fullest && here == any);
        assert!(here.iter().any(|&bits| f64::from_bits(bits) != 0.0));
    }

    /// All cells, in the copy for this machine.
    struct Cells<'a, 'b> {
        sweep: Sweep<'a>,
        ring: &'b mut Ring,
        energies: &'b mut [f64],
    }

    impl WideWork for Cells<'_, '_> {
        type Output = ();

        fn run<const P: usize, R: Registers<P>>(self, registers: R) {
            self.sweep.block(registers, 0..self.energies.len(), self.ring, self.energies);
        }
    }
}
