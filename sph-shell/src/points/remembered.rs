//! Points with a history in a sweep, and the commit of what they went through.

use std::any::Any;
use std::ops::Range;

use shell_kinematics::{
    Commit, Logarithmic, Number, Pack, PlasticSection, Resultants, SectionOf, StrainMeasure, Strains,
    StrainsOf, YieldingPack,
};

use crate::dispatch::{Work, widest};
use crate::packs::Row;
use crate::points::point::PointLaw;
use crate::points::remembering::RememberingPack;

use crate::points::ring::Ring;
use crate::points::scheme::{Points, Sections};
use crate::points::sweep::Sweep;
use crate::registers::{Baseline, Registers, pack_of};

/// A section that yields, in registers. The strains of the last commit meet what they met there: in a march each point comes back to its yield
/// surface once a step.
struct Yielding<'a, R> {
    pack: YieldingPack<'a>,
    registers: R,
}

impl<R: Registers> SectionOf<R::Numbers> for Yielding<'_, R> {
    #[inline(always)]
    fn resultants_of(&self, strains: &Strains<R::Numbers>) -> Resultants<R::Numbers> {
        let Strains { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] } = *strains;
        let (now, at) = ([a, b, c, d, e, f, g, h], self.registers.loads([self.pack.at]));
        let mut apart = self.registers.splat(0.0);
        for i in 0..8 {
            let way = now[i] - at[i];
            apart += way.max(at[i] - now[i]);
        }
        if apart.below(f64::MIN_POSITIVE) {
            let [a, b, c, d, e, f, g, h] = self.registers.loads([self.pack.met]);
            return Resultants { membrane: [a, b, c], moment: [d, e, f], shear: [g, h] };
        }
        self.pack.section.resultants_in(strains, |i| self.registers.load([&self.pack.committed[i]]))
    }

    #[inline(always)]
    fn energy_of(&self, strains: &Strains<R::Numbers>) -> R::Numbers {
        self.pack.section.energy_in(strains, |i| self.registers.load([&self.pack.committed[i]]))
    }
}

impl Sweep<'_> {
    /// Packs whose sections have a memory, one after the other.
    #[inline(always)]
    pub(super) fn cells_that_remember<R: Registers<Single = R>>(
        &self,
        registers: R,
        own: &[RememberingPack],
        packs: Range<usize>,
        ring: &mut Ring,
        energies: &mut [f64],
    ) {
        for (index, energy) in packs.zip(energies) {
            let RememberingPack { section, control } = &own[index];
            let (pack, energy) = (index..index + 1, std::slice::from_mut(energy));
            let yielding = Some(control);
            let of_pack: &dyn StrainMeasure =
                self.points.strains.get(index).map_or(self.law.strain, |own| own);
            let strain = (of_pack as &dyn Any).downcast_ref::<Logarithmic>();
            let law = PointLaw { strain: of_pack, section, yielding };
            match (strain.zip(section.yielding()), self.energy) {
                (Some((strain, pack_of)), false) => {
                    let law = PointLaw { strain, section: &Yielding { pack: pack_of, registers }, yielding };
                    self.cells::<false, 1, _, _, _>(registers, law, pack, ring, energy);
                }
                (None, false) => self.cells::<false, 1, _, _, _>(Baseline, law, pack, ring, energy),
                (_, true) => self.cells::<true, 1, _, _, _>(Baseline, law, pack, ring, energy),
            }
        }
    }
}

impl Points {
    /// Commits what a state makes of the history of each point in a step that takes a time \[T\]; of the touched packs alone if any are said to be.
    pub fn commit(
        &mut self,
        strain: &dyn StrainMeasure,
        (state, duration): (&[Row], f64),
        touched: &[bool],
        threads: usize,
    ) {
        let Sections::Remembering(packs) = &mut self.sections else { return };
        let mut packs = std::mem::take(packs);
        parallel::chunks(threads, &mut packs[..], |first, chunk: &mut [RememberingPack]| {
            widest(Committing { points: self, strain, state, duration, touched, first, packs: chunk });
        });
        self.sections = Sections::Remembering(packs);
    }
}

/// Commits what a state makes of the history of some packs, from number `first` on; a state that was committed last changes nothing.
struct Committing<'a> {
    points: &'a Points,
    strain: &'a dyn StrainMeasure,
    state: &'a [Row],
    /// Time of the step \[T\]; infinite at rest.
    duration: f64,
    /// Whether each pack is to be committed; all if there is none.
    touched: &'a [bool],
    first: usize,
    packs: &'a mut [RememberingPack],
}

impl Work for Committing<'_> {
    type Output = ();

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) {
        for (i, pack) in self.packs.iter_mut().enumerate() {
            let place = self.first + i;
            if self.touched.get(place) == Some(&false) {
                continue;
            }
            let strain: &dyn StrainMeasure = self.points.strains.get(place).map_or(self.strain, |own| own);
            match (strain as &dyn Any).downcast_ref::<Logarithmic>() {
                Some(strain) => {
                    commit(self.points, registers, strain, (self.state, self.duration), place, pack)
                }
                None => commit(self.points, Baseline, strain, (self.state, self.duration), place, pack),
            }
        }
    }
}

#[inline(always)]
fn commit<R: Registers, M: StrainsOf<R::Numbers> + ?Sized>(
    points: &Points,
    registers: R,
    strain: &M,
    (state, duration): (&[Row], f64),
    place: usize,
    pack: &mut RememberingPack,
) {
    let point = points.point(place).treated_in(registers);
    let now = point.strained::<true, M>(strain, state);
    let strains = stored(registers, &now.strains);
    let Some(Commit { section, committed, trial }) = pack.section.begin_commit(&strains) else { return };
    let met = match ((section as &dyn Any).downcast_ref::<PlasticSection>(), section.memory()) {
        (Some(plastic), _) => {
            let read = |i: usize| registers.load([&committed[i]]);
            let Resultants { membrane: [a, b, c], moment: [d, e, f], shear: [g, h] } =
                plastic.commit_in(&now.strains, duration, read, |i, number| {
                    trial[i] = pack_of(registers, number)
                });
            Resultants {
                membrane: [pack_of(registers, a), pack_of(registers, b), pack_of(registers, c)],
                moment: [pack_of(registers, d), pack_of(registers, e), pack_of(registers, f)],
                shear: [pack_of(registers, g), pack_of(registers, h)],
            }
        }
        (None, Some(memory)) => memory.history_from(&strains, duration, committed, trial),
        (None, None) => Resultants::default(),
    };
    pack.section.end_commit(&strains, &met);
    if let Some((cell, hourglass)) = &now.control {
        let (k, s) = (cell.stiffnesses(), hourglass.components());
        let [mut at_rest, mut components] = [[Pack::ZERO; 6]; 2];
        for i in 0..6 {
            (at_rest[i], components[i]) = (pack_of(registers, k[i]), pack_of(registers, s[i]));
        }
        pack.control.commit(at_rest, &components, pack.section.kept_share());
    }
}

/// Strains to memory.
#[inline(always)]
fn stored<R: Registers>(registers: R, strains: &Strains<R::Numbers>) -> Strains {
    let Strains { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] } = *strains;
    Strains {
        membrane: [pack_of(registers, a), pack_of(registers, b), pack_of(registers, c)],
        curvature: [pack_of(registers, d), pack_of(registers, e), pack_of(registers, f)],
        shear: [pack_of(registers, g), pack_of(registers, h)],
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use shell_kinematics::{Hardening, Isotropic, Plastic, Section};
    use sph_core::{Cylinder, EndWeights, lattice};

    use super::*;
    use crate::formulation::{Formulation, Reach};
    use crate::reference::Reference;
    use crate::regions::Scales;

    /// Forces, energies or none of them, in the copy of the registers.
    struct Swept<'a, 'b> {
        sweep: Sweep<'a>,
        ring: &'b mut Ring,
    }

    impl Work for Swept<'_, '_> {
        type Output = ();

        fn run<R: Registers>(self, registers: R) {
            let count = self.sweep.points.packs.points.len();
            self.sweep.block(registers, 0..count, self.ring, &mut vec![0.0; count]);
        }
    }

    /// What three steps leave of histories and forces, of states that were committed and of others, in the copy for this machine or in the baseline copy.
    fn bits(section: &Arc<dyn Section>, wide: bool) -> Vec<u64> {
        let patch = Cylinder { radius: 3.0, angles: [-0.5, 0.4], length: 2.5 };
        let cloud = lattice(&patch, [7, 6], EndWeights::Trapezoid).unwrap();
        let (formulation, scales) = (Formulation::StressPoint(Reach::Cell), section.scales());
        let reference = Reference::new(cloud, &formulation, &scales, 1.0, None).unwrap();
        let scales = Scales { uniform: scales, own: Vec::new() };
        let mut points = Points::new(&reference, &formulation, &scales, 1.0).unwrap();
        let count = points.packs.points.len();
        points.sections = Sections::Remembering(vec![RememberingPack::new(Arc::clone(section)); count]);
        let (mut state, mut bits) = (reference.rest(), Vec::new());
        for step in 0..6 {
            for (i, row) in state.iter_mut().enumerate() {
                for (k, value) in row.iter_mut().enumerate() {
                    *value += 0.01 * libm::sin((7 * i + 3 * k + 5 * step) as f64);
                }
            }
            if step % 2 == 0 {
                let Sections::Remembering(mut packs) = std::mem::replace(&mut points.sections, Sections::One)
                else {
                    unreachable!("they remember")
                };
                let work = Committing {
                    points: &points,
                    strain: &Logarithmic,
                    state: &state,
                    duration: 1e-4,
                    touched: &[],
                    first: 0,
                    packs: &mut packs,
                };
                if wide {
                    widest(work)
                } else {
                    work.run(Baseline)
                }
                bits.extend(packs.iter().flat_map(|pack| pack.numbers()).map(f64::to_bits));
                points.sections = Sections::Remembering(packs);
            }
            let law =
                PointLaw { strain: &Logarithmic as &dyn StrainMeasure, section: &**section, yielding: None };
            let mut ring = Ring::new(&points.packs, 0, count);
            let work = Swept {
                sweep: Sweep { points: &points, law, state: &state, energy: false },
                ring: &mut ring,
            };
            if wide {
                widest(work)
            } else {
                work.run(Baseline)
            }
            bits.extend(ring.rows().iter().flatten().map(|value| value.to_bits()));
        }
        bits
    }

    #[test]
    fn registers_change_no_bit_of_a_shell_that_yields() {
        let elastic = Isotropic::new(10.0, 0.3).unwrap();
        let plastic = Plastic::new(elastic, Hardening::voce(0.05, 0.02, 10.0).unwrap());
        let section: Arc<dyn Section> = Arc::new(PlasticSection::new(plastic, 0.1, 6).unwrap());
        let (here, baseline) = (bits(&section, true), bits(&section, false));
        assert!(here == baseline && here.iter().filter(|&&bits| f64::from_bits(bits) != 0.0).count() > 1000);
    }
}
