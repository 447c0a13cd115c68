//! Four sampling points: particles → vectors → measures → strains → resultants → forces on the vectors.
//!
//! Forces, results, tangent and strong form share this pipeline; every correction of a strain stands here beside its transpose.

use shell_kinematics::{
    LANES, Measures, Pack, Pack3, Placement, PlacementForces, Section, SectionPack, StrainMeasure, Strains,
};

use crate::control::arcs::ArcPack;
use crate::control::cells::{CellPack, CellState};
use crate::control::shear::ShearPack;
use crate::packs::{Entry, Packs, PointPack, Row};

/// Strain measure and section of the points.
///
/// Generic so that the sweep can be compiled for the default pair; any other pair runs through `dyn`.
pub(crate) struct PointLaw<'a, M: ?Sized = dyn StrainMeasure, S: ?Sized = dyn Section> {
    pub strain: &'a M,
    pub section: &'a S,
}

impl<M: ?Sized, S: ?Sized> Clone for PointLaw<'_, M, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: ?Sized, S: ?Sized> Copy for PointLaw<'_, M, S> {}

/// Four points: their stencils, and what corrects their strains where something does.
#[derive(Clone, Copy)]
pub(crate) struct Point<'a> {
    pub pack: &'a PointPack,
    pub entries: &'a [Entry],
    pub shear: Option<&'a ShearPack>,
    pub arcs: Option<&'a ArcPack>,
    pub cell: Option<&'a CellPack>,
    /// Their sections, where not all points have the same.
    pub section: Option<&'a SectionPack>,
}

/// Four points in a state: from their vectors to their strains.
pub(crate) struct PointState<'a> {
    pub placement: Placement,
    /// Curvature along arcs, membrane with what chords lose.
    pub measures: Measures,
    /// With the Kirchhoff-consistent shear of [`ShearPack`].
    pub strains: Strains,
    pub control: Option<(&'a CellPack, CellState)>,
}

/// What the resultants of four points do.
pub(crate) struct PointForces {
    /// Forces on the vectors, per area.
    pub on_vectors: PlacementForces,
    /// Energy per area, if it was asked for.
    pub density: Pack,
    /// w M:k of [`CellState::released`].
    pub released: Pack,
}

/// Rows of four particles, turned into columns.
#[inline(always)]
fn load(state: &[Row], particles: &[u32; LANES]) -> [Pack; 6] {
    let rows = particles.map(|b| state[b as usize]);
    std::array::from_fn(|c| Pack::from_fn(|lane| rows[lane][c]))
}

/// Sign of the hourglass pattern (1, −1, 1, −1) at entry `k` beyond the base.
#[inline(always)]
pub(crate) fn sign(k: usize) -> f64 {
    if k.is_multiple_of(2) { -1.0 } else { 1.0 }
}

impl<'a> Point<'a> {
    /// The points of a pack, their strains not corrected.
    #[inline(always)]
    pub fn new(packs: &'a Packs, index: usize) -> Self {
        let pack = &packs.points[index];
        let entries = &packs.entries[pack.first as usize..][..pack.width as usize];
        Self { pack, entries, shear: None, arcs: None, cell: None, section: None }
    }

    /// The five vectors, and with `CELL` the raw hourglass sums.
    #[inline(always)]
    pub fn interpolate<const CELL: bool>(&self, state: &[Row]) -> (Placement, [Pack3; 2]) {
        let base = load(state, &self.pack.base);
        let mut p = Placement { d: Pack3([base[3], base[4], base[5]]), ..Placement::default() };
        let mut raw = [Pack3::ZERO; 2];
        for (k, entry) in self.entries.iter().enumerate() {
            let row = load(state, &entry.particles);
            let dx = Pack3([row[0] - base[0], row[1] - base[1], row[2] - base[2]]);
            let dd = Pack3([row[3] - base[3], row[4] - base[4], row[5] - base[5]]);
            p.x1 += dx * entry.g1;
            p.x2 += dx * entry.g2;
            p.d += dd * entry.phi;
            p.d1 += dd * entry.g1;
            p.d2 += dd * entry.g2;
            if CELL {
                // Σh = 0, so the pattern needs differences only; entry 0 here is particle 1 of the cell.
                let h = Pack::splat(sign(k));
                raw[0] += dx * h;
                raw[1] += dd * h;
            }
        }
        (p, raw)
    }

    /// Particles → vectors → measures → arcs → strains → shear; the control of cells with `CELL`.
    #[inline(always)]
    pub fn strained<const CELL: bool, M: StrainMeasure + ?Sized>(
        &self,
        measure: &M,
        state: &[Row],
    ) -> PointState<'a> {
        let (placement, raw) = self.interpolate::<CELL>(state);
        let mut measures = placement.measures();
        let cell = if CELL { self.cell } else { None };
        let control = cell.map(|cell| (cell, cell.state(&placement, &measures.curvature, raw)));
        if let Some((_, state)) = &control {
            measures.curvature = state.arc(measures.curvature);
        }
        if let Some(arcs) = self.arcs {
            arcs.adjust(&mut measures, &self.pack.reference);
        }
        let mut strains = measure.strains(&measures, &self.pack.reference);
        if let Some(shear) = self.shear {
            shear.adjust(&mut strains);
        }
        PointState { placement, measures, strains, control }
    }

    /// Strains → resultants and, transposed, back to forces on the vectors; the energy with `ENERGY`.
    #[inline(always)]
    pub fn forces<const ENERGY: bool, M: StrainMeasure + ?Sized, S: Section + ?Sized>(
        &self,
        law: PointLaw<'_, M, S>,
        now: &PointState<'_>,
    ) -> PointForces {
        let mut stress = law.section.resultants(&now.strains);
        let density = if ENERGY { law.section.energy(&now.strains) } else { Pack::ZERO };
        if let Some(shear) = self.shear {
            shear.transpose(&mut stress);
        }
        let mut on_measures = law.strain.transpose(&now.measures, &self.pack.reference, &stress);
        if let Some(arcs) = self.arcs {
            arcs.transpose(&mut on_measures);
        }
        let mut released = Pack::ZERO;
        if let Some((_, state)) = &now.control {
            released = state.released(&on_measures.curvature) * self.pack.weight;
            on_measures.curvature = on_measures.curvature.map(|b| b * state.scale);
        }
        PointForces { on_vectors: now.placement.transpose(&on_measures), density, released }
    }
}
