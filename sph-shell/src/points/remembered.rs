//! Points whose section has a memory in a sweep, and the commit of what they went through.

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
use crate::points::scheme::{Points, Sections};
use crate::points::sweep::{Ring, Sweep};
use crate::registers::{Baseline, Registers};

/// A section that yields, in registers. The strains of the last commit meet what they met there: in a march each point comes back to its yield
/// surface once a step.
struct Yielding<'a, R> {
    pack: YieldingPack<'a>,
    registers: R,
}

impl<R: Registers> SectionOf<R::Four> for Yielding<'_, R> {
    #[inline(always)]
    fn resultants_of(&self, strains: &Strains<R::Four>) -> Resultants<R::Four> {
        let Strains { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] } = *strains;
        let (now, at) = ([a, b, c, d, e, f, g, h], self.registers.loads(self.pack.at));
        let mut apart = self.registers.splat(0.0);
        for i in 0..8 {
            let way = now[i] - at[i];
            apart += way.max(at[i] - now[i]);
        }
        if apart.below(f64::MIN_POSITIVE) {
            let [a, b, c, d, e, f, g, h] = self.registers.loads(self.pack.met);
            return Resultants { membrane: [a, b, c], moment: [d, e, f], shear: [g, h] };
        }
        self.pack.section.resultants_in(strains, |i| self.registers.load(&self.pack.committed[i]))
    }

    #[inline(always)]
    fn energy_of(&self, strains: &Strains<R::Four>) -> R::Four {
        self.pack.section.energy_in(strains, |i| self.registers.load(&self.pack.committed[i]))
    }
}

impl Sweep<'_> {
    /// Packs whose sections have a memory, one after the other.
    #[inline(always)]
    pub(super) fn cells_that_remember<R: Registers>(
        &self,
        registers: R,
        own: &[RememberingPack],
        packs: Range<usize>,
        ring: &mut Ring,
        energies: &mut [f64],
    ) {
        let strain = (self.law.strain as &dyn Any).downcast_ref::<Logarithmic>();
        for (index, energy) in packs.zip(energies) {
            let RememberingPack { section, control } = &own[index];
            let (pack, energy) = (index..index + 1, std::slice::from_mut(energy));
            let yielding = Some(control);
            let law = PointLaw { strain: self.law.strain, section, yielding };
            match (strain.zip(section.yielding()), self.energy) {
                (Some((strain, pack_of)), false) => {
                    let law = PointLaw { strain, section: &Yielding { pack: pack_of, registers }, yielding };
                    self.cells::<false, _, _, _>(registers, law, pack, ring, energy);
                }
                (None, false) => self.cells::<false, _, _, _>(Baseline, law, pack, ring, energy),
                (_, true) => self.cells::<true, _, _, _>(Baseline, law, pack, ring, energy),
            }
        }
    }
}

impl Points {
    /// Commits what a state makes of the history of each point.
    pub fn commit(&mut self, strain: &dyn StrainMeasure, state: &[Row], threads: usize) {
        let Sections::Remembering(packs) = &mut self.sections else { return };
        let mut packs = std::mem::take(packs);
        parallel::chunks(threads, &mut packs[..], |first, chunk: &mut [RememberingPack]| {
            widest(Committing { points: self, strain, state, first, packs: chunk });
        });
        self.sections = Sections::Remembering(packs);
    }
}

/// Commits what a state makes of the history of some packs, from number `first` on; a state that was committed last changes nothing.
struct Committing<'a> {
    points: &'a Points,
    strain: &'a dyn StrainMeasure,
    state: &'a [Row],
    first: usize,
    packs: &'a mut [RememberingPack],
}

impl Work for Committing<'_> {
    type Output = ();

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) {
        let strain = (self.strain as &dyn Any).downcast_ref::<Logarithmic>();
        for (i, pack) in self.packs.iter_mut().enumerate() {
            let place = self.first + i;
            match strain {
                Some(strain) => commit(self.points, registers, strain, self.state, place, pack),
                None => commit(self.points, Baseline, self.strain, self.state, place, pack),
            }
        }
    }
}

#[inline(always)]
fn commit<R: Registers, M: StrainsOf<R::Four> + ?Sized>(
    points: &Points,
    registers: R,
    strain: &M,
    state: &[Row],
    place: usize,
    pack: &mut RememberingPack,
) {
    let point = points.point(place).treated_in(registers);
    let now = point.strained::<true, M>(strain, state);
    let strains = stored(registers, &now.strains);
    let Some(Commit { section, committed, trial }) = pack.section.begin_commit(&strains) else { return };
    let met = match ((section as &dyn Any).downcast_ref::<PlasticSection>(), section.memory()) {
        (Some(plastic), _) => {
            let read = |i: usize| registers.load(&committed[i]);
            let Resultants { membrane: [a, b, c], moment: [d, e, f], shear: [g, h] } =
                plastic.commit_in(&now.strains, read, |i, number| trial[i] = registers.store(number));
            Resultants {
                membrane: [registers.store(a), registers.store(b), registers.store(c)],
                moment: [registers.store(d), registers.store(e), registers.store(f)],
                shear: [registers.store(g), registers.store(h)],
            }
        }
        (None, Some(memory)) => memory.history_from(&strains, committed, trial),
        (None, None) => Resultants::default(),
    };
    pack.section.end_commit(&strains, &met);
    if let Some((cell, hourglass)) = &now.control {
        let (k, s) = (cell.stiffnesses(), hourglass.components());
        let [mut at_rest, mut components] = [[Pack::ZERO; 6]; 2];
        for i in 0..6 {
            (at_rest[i], components[i]) = (registers.store(k[i]), registers.store(s[i]));
        }
        pack.control.commit(at_rest, &components, pack.section.kept_share());
    }
}

/// Strains to memory.
#[inline(always)]
fn stored<R: Registers>(registers: R, strains: &Strains<R::Four>) -> Strains {
    let Strains { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] } = *strains;
    Strains {
        membrane: [registers.store(a), registers.store(b), registers.store(c)],
        curvature: [registers.store(d), registers.store(e), registers.store(f)],
        shear: [registers.store(g), registers.store(h)],
    }
}
