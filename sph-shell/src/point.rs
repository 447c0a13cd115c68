//! The sweep over sampling points: particles → strains → resultants → forces in slots.

use shell_kinematics::{
    LANES, MeasureForces, Measures, Pack, Pack3, Placement, Section, StrainMeasure, Strains,
};

use crate::cell_control::CellPack;
use crate::membrane_arcs::ArcPack;
use crate::packs::{Entry, PointPack};
use crate::shear::ShearPack;

/// Position and director of a particle, or the forces on them: `[x, y, z, d_x, d_y, d_z]`.
pub(crate) type Row = [f64; 6];

/// What a point knows how to do.
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

/// Rows of four particles, turned into columns.
#[inline(always)]
fn load(state: &[Row], particles: &[u32; LANES]) -> [Pack; 6] {
    let rows = particles.map(|b| state[b as usize]);
    std::array::from_fn(|c| Pack::from_fn(|lane| rows[lane][c]))
}

#[inline(always)]
fn store(slots: &mut [Row], force: [Pack3; 2]) {
    let [f, t] = [force[0].0.map(Pack::lanes), force[1].0.map(Pack::lanes)];
    for (lane, slot) in slots.iter_mut().enumerate().take(LANES) {
        *slot = [f[0][lane], f[1][lane], f[2][lane], t[0][lane], t[1][lane], t[2][lane]];
    }
}

/// Sign of the hourglass pattern (1, −1, 1, −1) at entry `k` beyond the base.
#[inline(always)]
fn sign(k: usize) -> f64 {
    if k.is_multiple_of(2) { -1.0 } else { 1.0 }
}

/// The five vectors of a point, and the raw hourglass sums if the pack is one of cells.
#[inline(always)]
pub(crate) fn interpolate<const CELL: bool>(
    pack: &PointPack,
    entries: &[Entry],
    state: &[Row],
) -> (Placement, [Pack3; 2]) {
    let base = load(state, &pack.base);
    let mut p = Placement { d: Pack3([base[3], base[4], base[5]]), ..Placement::default() };
    let mut raw = [Pack3::ZERO; 2];
    for (k, entry) in entries.iter().enumerate() {
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

/// Strains of a point, with the Kirchhoff-consistent shear of [`ShearPack`].
#[inline(always)]
pub(crate) fn point_strains<M: StrainMeasure + ?Sized>(
    pack: &PointPack,
    shear: Option<&ShearPack>,
    measure: &M,
    now: &Measures,
) -> Strains {
    let mut strains = measure.strains(now, &pack.reference);
    if let Some(shear) = shear {
        shear.adjust(&mut strains);
    }
    strains
}

/// Forces on the measures of a point per area: strain, section, transpose.
///
/// Returns the energy per area if `ENERGY`.
#[inline(always)]
pub(crate) fn measure_forces<const ENERGY: bool, M: StrainMeasure + ?Sized, S: Section + ?Sized>(
    pack: &PointPack,
    shear: Option<&ShearPack>,
    law: PointLaw<'_, M, S>,
    measures: &Measures,
) -> (MeasureForces, Pack) {
    let strains = point_strains(pack, shear, law.strain, measures);
    let mut stress = law.section.resultants(&strains);
    let energy = if ENERGY { law.section.energy(&strains) } else { Pack::ZERO };
    if let Some(shear) = shear {
        shear.transpose(&mut stress);
    }
    (law.strain.transpose(measures, &pack.reference, &stress), energy)
}

/// One pack: reads its particles, writes its slots, returns its energy \[F L\] if `ENERGY`.
#[inline(always)]
pub(crate) fn sweep_pack<
    const CELL: bool,
    const ENERGY: bool,
    M: StrainMeasure + ?Sized,
    S: Section + ?Sized,
>(
    pack: &PointPack,
    entries: &[Entry],
    shear: Option<&ShearPack>,
    arcs: Option<&ArcPack>,
    cell: Option<&CellPack>,
    law: PointLaw<'_, M, S>,
    state: &[Row],
    slots: &mut [Row],
) -> f64 {
    let (p, raw) = interpolate::<CELL>(pack, entries, state);
    let mut measures = p.measures();
    let control = if CELL { cell.map(|cell| (cell, cell.state(&p, &measures.curvature, raw))) } else { None };
    if let Some((_, state)) = &control {
        measures.curvature = state.arc(measures.curvature);
    }
    if let Some(arcs) = arcs {
        arcs.adjust(&mut measures, &pack.reference);
    }
    let (mut on_measures, density) = measure_forces::<ENERGY, M, S>(pack, shear, law, &measures);
    if let Some(arcs) = arcs {
        arcs.transpose(&mut on_measures);
    }
    let mut released = Pack::ZERO;
    if let Some((_, state)) = &control {
        released = state.released(&on_measures.curvature) * pack.weight;
        on_measures.curvature = on_measures.curvature.map(|b| b * state.scale);
    }
    let mut f = p.transpose(&on_measures);
    let w = pack.weight;
    f.n1 = f.n1 * w;
    f.n2 = f.n2 * w;
    f.q = f.q * w;
    f.m1 = f.m1 * w;
    f.m2 = f.m2 * w;
    let mut energy = density * w;
    let mut pattern = [Pack3::ZERO; 2];
    if let Some((cell, state)) = &control {
        let (forces, more) = cell.add(&p, state, released, &mut f);
        pattern = [forces.position, forces.director];
        energy += more;
    }
    // The base takes what is left: positions by Σ G = 0, directors by Σ φ = 1 and Σ G = 0.
    let (mut base_x, mut base_d) = (Pack3::ZERO, f.q);
    for (k, entry) in entries.iter().enumerate() {
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
