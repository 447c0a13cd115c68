//! Four sampling points: particles → vectors → measures → strains → resultants → forces on the vectors.
//!
//! Forces, results, tangent and strong form share this pipeline; every correction of a strain stands here beside its transpose.

use std::any::Any;

use shell_kinematics::{
    IsotropicSection, LANES, Measures, Number, Pack, Pack3, Placement, PlacementForces, Section, SectionOf,
    StrainMeasure, Strains, StrainsOf,
};

use crate::control::arcs::ArcPack;
use crate::control::cells::{CellPack, CellState};
use crate::control::shear::ShearPack;
use crate::control::yielding::YieldingControl;
use crate::packs::{Constants, Entry, Packs, PointPack, Row};
use crate::registers::{Baseline, Registers, in_all};

/// Strain measure and section of the points.
///
/// Generic so that the sweep can be compiled for the default pair; any other pair runs through `dyn`.
pub(crate) struct PointLaw<'a, M: ?Sized = dyn StrainMeasure, S: ?Sized = dyn Section> {
    pub strain: &'a M,
    pub section: &'a S,
    /// The control of cells where it follows the section.
    pub yielding: Option<&'a YieldingControl>,
}

impl<M: ?Sized, S: ?Sized> Clone for PointLaw<'_, M, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: ?Sized, S: ?Sized> Copy for PointLaw<'_, M, S> {}

impl PointLaw<'_> {
    /// The strain measure and section of most scenes, or the measure of large strains with that section: pairs for which sweeps are compiled in.
    #[inline(always)]
    pub fn of_pair<M: StrainMeasure>(&self) -> Option<PointLaw<'_, M, IsotropicSection>> {
        let strain = (self.strain as &dyn Any).downcast_ref()?;
        let section = (self.section as &dyn Any).downcast_ref()?;
        Some(PointLaw { strain, section, yielding: None })
    }
}

/// Four points: their stencils, and what corrects their strains where something does.
#[derive(Clone, Copy)]
pub(crate) struct Point<'a> {
    pub place: &'a PointPack,
    pub pack: &'a Constants,
    pub particles: &'a [[u32; LANES]],
    pub entries: &'a [Entry],
    pub shear: Option<&'a ShearPack>,
    pub arcs: Option<&'a ArcPack>,
    pub cell: Option<&'a CellPack>,
    /// Their sections, where not all points have the same.
    pub section: Option<&'a dyn Section>,
    /// Their strain measures, where not all points have the same.
    pub strain: Option<&'a dyn StrainMeasure>,
}

/// The points of `P` packs, in the registers in which they are treated.
#[derive(Clone, Copy)]
pub(crate) struct Treated<'a, R = Baseline, const P: usize = 1> {
    pub registers: R,
    pub of: [Point<'a>; P],
}

/// Four points in a state: from their vectors to their strains.
pub(crate) struct PointState<P = Pack> {
    pub placement: Placement<P>,
    /// Curvature along arcs, membrane with what chords lose.
    pub measures: Measures<P>,
    /// With the Kirchhoff-consistent shear of [`ShearPack`].
    pub strains: Strains<P>,
    pub control: Option<(CellPack<P>, CellState<P>)>,
}

/// What the resultants of four points do.
pub(crate) struct PointForces<P = Pack> {
    /// Forces on the vectors, per area.
    pub on_vectors: PlacementForces<P>,
    /// Energy per area, if it was asked for.
    pub density: P,
    /// w M:k of [`CellState::released`].
    pub released: P,
}

/// Sign of the hourglass pattern (1, −1, 1, −1) at entry `k` beyond the base.
#[inline(always)]
pub(crate) fn sign(k: usize) -> f64 {
    if k.is_multiple_of(2) { -1.0 } else { 1.0 }
}

/// Adds a vector to a sum with its sign in the pattern; Σh = 0, so that differences from the base are enough.
#[inline(always)]
pub(crate) fn signed<P: Number>(k: usize, sum: Pack3<P>, vector: Pack3<P>) -> Pack3<P> {
    if k.is_multiple_of(2) { sum - vector } else { sum + vector }
}

impl<'a> Point<'a> {
    /// The points of a pack, their strains not corrected.
    #[inline(always)]
    pub fn new(packs: &'a Packs, index: usize) -> Self {
        let place = &packs.points[index];
        let width = place.width as usize;
        Self {
            place,
            pack: packs.constants.get(index),
            particles: &packs.particles[place.first as usize..][..width],
            entries: &packs.entries[place.entries as usize..][..width],
            shear: None,
            arcs: None,
            cell: None,
            section: None,
            strain: None,
        }
    }

    /// The same points in registers.
    #[inline(always)]
    pub fn treated_in<R: Registers>(self, registers: R) -> Treated<'a, R> {
        Treated { registers, of: [self] }
    }

    /// In those of any processor.
    #[inline(always)]
    pub fn treated(self) -> Treated<'a> {
        self.treated_in(Baseline)
    }
}

impl<'a, R: Registers<P>, const P: usize> Treated<'a, R, P> {
    /// One thing of each pack.
    #[inline(always)]
    fn each<T: ?Sized>(&self, thing: impl Fn(Point<'a>) -> &'a T) -> [&'a T; P] {
        in_all(self.of, thing)
    }

    /// One thing of each pack, if all have it.
    #[inline(always)]
    fn all<T>(&self, thing: impl Fn(&Point<'a>) -> Option<&'a T>) -> Option<[&'a T; P]> {
        let mut all = [thing(&self.of[0])?; P];
        for i in 1..P {
            all[i] = thing(&self.of[i])?;
        }
        Some(all)
    }

    /// Whether one law of one form goes for all: their stencils have as many entries.
    #[inline(always)]
    pub fn are_alike(&self) -> bool {
        (1..P).all(|i| self.of[i].entries.len() == self.width())
    }

    /// Rows of particles, turned into columns.
    #[inline(always)]
    fn columns(&self, state: &[Row], particles: [&[u32; LANES]; P]) -> [R::Numbers; 6] {
        self.registers.columns(in_all(particles, |[a, b, c, d]| {
            [&state[*a as usize], &state[*b as usize], &state[*c as usize], &state[*d as usize]]
        }))
    }

    /// Entries beyond the base.
    #[inline(always)]
    pub fn width(&self) -> usize {
        self.of[0].entries.len()
    }

    /// The entries of each pack, as many as are asked for: what is read of them in a loop up to there is not checked again.
    #[inline(always)]
    pub fn entries(&self, width: usize) -> [&'a [Entry]; P] {
        self.each(|point| &point.entries[..width])
    }

    /// The particles of the entries of each pack.
    #[inline(always)]
    fn particles(&self, width: usize) -> [&'a [[u32; LANES]]; P] {
        self.each(|point| &point.particles[..width])
    }

    /// φ, G₁ and G₂ of an entry of each pack.
    #[inline(always)]
    pub fn numbers(&self, entry: [&Entry; P]) -> [R::Numbers; 3] {
        let registers = self.registers;
        [
            registers.load(in_all(entry, |entry| &entry.phi)),
            registers.load(in_all(entry, |entry| &entry.g1)),
            registers.load(in_all(entry, |entry| &entry.g2)),
        ]
    }

    /// Areas w_p \[L²\].
    #[inline(always)]
    pub fn weight(&self) -> R::Numbers {
        self.registers.load(self.each(|point| &point.pack.weight))
    }

    /// Measures of the reference configuration.
    #[inline(always)]
    fn reference(&self) -> Measures<R::Numbers> {
        self.registers.load_measures(self.each(|point| &point.pack.reference))
    }

    /// The five vectors, and with `CELL` the raw hourglass sums.
    #[inline(always)]
    pub fn interpolate<const CELL: bool>(
        &self,
        state: &[Row],
    ) -> (Placement<R::Numbers>, [Pack3<R::Numbers>; 2]) {
        let base = self.columns(state, self.each(|point| &point.place.base));
        if CELL && self.width() == 3 {
            return self.quadrangle(state, &base);
        }
        let zero = Pack3([self.registers.splat(0.0); 3]);
        let mut p =
            Placement { x1: zero, x2: zero, d: Pack3([base[3], base[4], base[5]]), d1: zero, d2: zero };
        let mut raw = [zero; 2];
        let (entries, particles) = (self.entries(self.width()), self.particles(self.width()));
        for k in 0..self.width() {
            let [dx, dd] = self.difference(state, in_all(particles, |of| &of[k]), &base);
            let [phi, g1, g2] = self.numbers(in_all(entries, |of| &of[k]));
            p.x1 += dx * g1;
            p.x2 += dx * g2;
            p.d += dd * phi;
            p.d1 += dd * g1;
            p.d2 += dd * g2;
            if CELL {
                raw = [signed(k, raw[0], dx), signed(k, raw[1], dd)];
            }
        }
        (p, raw)
    }

    /// The same for three entries beyond the base, vector by vector: sums stay in registers.
    #[inline(always)]
    fn quadrangle(
        &self,
        state: &[Row],
        base: &[R::Numbers; 6],
    ) -> (Placement<R::Numbers>, [Pack3<R::Numbers>; 2]) {
        let zero = Pack3([self.registers.splat(0.0); 3]);
        let (entries, particles) = (self.entries(3), self.particles(3));
        let [[xa, da], [xb, db], [xc, dc]] = [
            self.difference(state, in_all(particles, |of| &of[0]), base),
            self.difference(state, in_all(particles, |of| &of[1]), base),
            self.difference(state, in_all(particles, |of| &of[2]), base),
        ];
        let [[phi_a, g1a, g2a], [phi_b, g1b, g2b], [phi_c, g1c, g2c]] = [
            self.numbers(in_all(entries, |of| &of[0])),
            self.numbers(in_all(entries, |of| &of[1])),
            self.numbers(in_all(entries, |of| &of[2])),
        ];
        let x1 = zero + xa * g1a + xb * g1b + xc * g1c;
        let x2 = zero + xa * g2a + xb * g2b + xc * g2c;
        let raw_x = signed(2, signed(1, signed(0, zero, xa), xb), xc);
        let d = Pack3([base[3], base[4], base[5]]) + da * phi_a + db * phi_b + dc * phi_c;
        let d1 = zero + da * g1a + db * g1b + dc * g1c;
        let d2 = zero + da * g2a + db * g2b + dc * g2c;
        let raw_d = signed(2, signed(1, signed(0, zero, da), db), dc);
        (Placement { x1, x2, d, d1, d2 }, [raw_x, raw_d])
    }

    /// Position and director of particles less those of the base.
    #[inline(always)]
    fn difference(
        &self,
        state: &[Row],
        particles: [&[u32; LANES]; P],
        base: &[R::Numbers; 6],
    ) -> [Pack3<R::Numbers>; 2] {
        let row = self.columns(state, particles);
        [
            Pack3([row[0] - base[0], row[1] - base[1], row[2] - base[2]]),
            Pack3([row[3] - base[3], row[4] - base[4], row[5] - base[5]]),
        ]
    }

    /// Particles → vectors → measures → arcs → strains → shear; the control of cells with `CELL`.
    #[inline(always)]
    pub fn strained<const CELL: bool, M: StrainsOf<R::Numbers> + ?Sized>(
        &self,
        measure: &M,
        state: &[Row],
    ) -> PointState<R::Numbers> {
        let (placement, raw) = self.interpolate::<CELL>(state);
        let reference = self.reference();
        let mut measures = placement.measures();
        let mut control = None;
        if CELL && let Some(cells) = self.all(|point| point.cell) {
            let cell = CellPack::load(cells, self.registers);
            let state = cell.state(&placement, &measures.curvature, raw);
            measures.curvature = state.arc(measures.curvature);
            control = Some((cell, state));
        }
        if let Some(arcs) = self.all(|point| point.arcs) {
            ArcPack::load(arcs, self.registers).adjust(&mut measures, &reference);
        }
        let mut strains = measure.strains_of(&measures, &reference);
        if let Some(shear) = self.all(|point| point.shear) {
            ShearPack::load(shear, self.registers).adjust(&mut strains);
        }
        PointState { placement, measures, strains, control }
    }

    /// Strains → resultants and, transposed, back to forces on the vectors; the energy with `ENERGY`.
    #[inline(always)]
    pub fn forces<
        const ENERGY: bool,
        M: StrainsOf<R::Numbers> + ?Sized,
        S: SectionOf<R::Numbers> + ?Sized,
    >(
        &self,
        law: PointLaw<'_, M, S>,
        now: &PointState<R::Numbers>,
    ) -> PointForces<R::Numbers> {
        let registers = self.registers;
        let mut stress = law.section.resultants_of(&now.strains);
        let density = if ENERGY { law.section.energy_of(&now.strains) } else { registers.splat(0.0) };
        if let Some(shear) = self.all(|point| point.shear) {
            ShearPack::load(shear, registers).transpose(&mut stress);
        }
        let reference = self.reference();
        let mut on_measures = law.strain.transpose_of(&now.measures, &reference, &stress);
        if let Some(arcs) = self.all(|point| point.arcs) {
            ArcPack::load(arcs, registers).transpose(&mut on_measures);
        }
        let mut released = registers.splat(0.0);
        if let Some((_, state)) = &now.control {
            released = state.released(&on_measures.curvature) * self.weight();
            on_measures.curvature = state.arc(on_measures.curvature);
        }
        PointForces { on_vectors: now.placement.transpose(&on_measures), density, released }
    }
}
