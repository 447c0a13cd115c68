//! The two sheets of a plate with their columns, as its mechanics.
//!
//! They break each by its own bonds, so that cracks open on one side first.
//!
//! A pair shears as far as its bonds are whole, by half of its rigidity for each sheet. What a pair loses as a bond breaks is
//! counted with the energy of that bond. A column keeps its thickness.

use implicit_statics::BlockPattern;
use nalgebra::Matrix3;
use sph_core::{Block, Vec3};

use crate::bonds::balance::Balance;
use crate::bonds::breaking::Breaking;
use crate::bonds::correction::weights;
use crate::bonds::couplings::Coupling;
use crate::bonds::faces::areas;
use crate::bonds::families::{Families, Nodes};
use crate::bonds::flatness::refuse_flat;
use crate::bonds::fragments::fragments;
use crate::bonds::limits::Lattice;
use crate::bonds::mechanics::{Evaluation, Mechanics};
use crate::bonds::network::{LANES, Row};
use crate::error::SolidError;
use crate::formulation::Correction;
use crate::fracture::Breakage;
use crate::material::{Elastic, Moduli, Space};
use crate::mirror::Mirror;
use crate::parts::Sheets;
use crate::share::{Reach, Share};
use crate::sheets::columns::Columns;
use crate::sheets::rest_shape::{directors, plan};
use crate::sheets::shear::Shear;
use crate::sheets::sheet::{Cloth, Sheet};

/// Two sheets on directors; rows are places, then directors.
pub(crate) struct Plate {
    pub columns: Columns,
    /// The upper sheet and the lower.
    pub sheets: [Sheet; 2],
    /// Energy that pairs of each column held when their bonds broke, half of each pair's \[F L\]; empty where nothing breaks.
    pub sheared_off: Vec<f64>,
}

impl Plate {
    /// Joins the columns of a plane block, whose places may be somewhat out of its plane; returns the directors at rest too.
    /// Segments of cracks cut both sheets, polygons in space what they cross.
    ///
    /// # Errors
    /// [`SolidError`] for the material, the thickness, the horizon, the nodes, a plate that is not flat enough, and for what
    /// breaks it.
    pub fn new(
        block: &Block,
        material: &Elastic,
        sheets: &Sheets,
        breakage: &Breakage,
        mirrors: &[Mirror],
    ) -> Result<(Self, Vec<Vec3>), SolidError> {
        let Sheets { thickness, formulation } = *sheets;
        let moduli = sound(block, material, sheets, breakage)?;
        let plan = plan(block);
        let volumes: Vec<f64> = block.volumes.iter().map(|volume| 0.5 * volume).collect();
        let nodes = Nodes { positions: &plan, volumes: &volumes, spacing: block.greatest_spacing(), mirrors };
        let families = Families::new(&nodes, formulation.horizon, formulation.volumes)?;
        let places = &*families.extended(&block.positions);
        refuse_flat(&families, places, &formulation, moduli.dimensions)?;
        let directors = directors(places, &families, formulation.influence)?;
        let normals = &*families.reflected(&directors);
        let mut weights = weights(&families, &formulation, &moduli, 0.5 * thickness);
        if formulation.correction == Correction::Balanced {
            let flat = Block { positions: plan.clone(), ..block.clone() };
            let mut areas = areas(&flat, mirrors, families.images.as_deref())?;
            areas.iter_mut().for_each(|area| *area *= 0.5);
            Balance {
                families: &families,
                positions: &families.places,
                volumes: &volumes,
                areas: &areas,
                spacing: nodes.spacing,
                moduli: &moduli,
            }
            .bring(&mut weights)?;
        }
        let spacing = [block.spacing[0], block.spacing[1], 0.5 * thickness];
        let lattice = Lattice { formulation: &formulation, moduli: &moduli, spacing };
        let fracture = breakage.fracture.as_ref();
        let limit = fracture.map(|fracture| lattice.limit(&fracture.criterion)).transpose()?;
        let cloth = Cloth { families: &families, weights: &weights, moduli: &moduli, breakage, limit };
        let height = thickness / (2.0 * 3.0_f64.sqrt());
        let sheet = |z: f64| {
            let at_rest: Vec<Vec3> = places.iter().zip(normals).map(|(x, d)| x + d * z).collect();
            cloth.sheet(&at_rest)
        };
        let [(upper, above), (lower, below)] = [sheet(height)?, sheet(-height)?];
        if let Some(number) = above.iter().zip(&below).position(|(above, below)| !above && !below) {
            return Err(SolidError::Crack { number, problem: "cuts no bond; move it into the plate" });
        }
        let areas: Vec<f64> = block.volumes.iter().map(|volume| volume / thickness).collect();
        let at_rest = (places, normals);
        let columns = Columns {
            height,
            stiffness: block.volumes.iter().map(|volume| material.young * volume).collect(),
            rest: directors.iter().map(|d| 0.5 * d.norm_squared()).collect(),
            shear: Shear::new(&families, formulation.influence, at_rest, &areas, &moduli, thickness),
            images: families.images.clone(),
            energies: vec![0.0; block.len().div_ceil(parallel::CHUNK)],
        };
        let sheared_off = if breakage.breaks() { vec![0.0; block.len()] } else { Vec::new() };
        let mut plate = Self { columns, sheets: [upper, lower], sheared_off };
        plate.slacken(None);
        Ok((plate, directors))
    }
}

/// The constants of a plate that is thin, and of what sheets can do.
fn sound(
    block: &Block,
    material: &Elastic,
    sheets: &Sheets,
    breakage: &Breakage,
) -> Result<Moduli, SolidError> {
    if block.dimensions != 2 || sheets.formulation.space != Space::PlaneStress {
        return Err(SolidError::NotThin);
    }
    if breakage.contact.is_some() {
        return Err(SolidError::SheetContact);
    }
    let thickness = sheets.thickness;
    if !(thickness > 0.0 && thickness == block.spacing[2]) {
        let bound = "it must be positive, and the thickness of the block";
        return Err(SolidError::Limit { what: "the thickness of the plate", value: thickness, bound });
    }
    sheets.formulation.moduli(material)
}

impl Mechanics for Plate {
    fn evaluate(&mut self, rows: &mut [Row], forces: &mut [Row], wanted: Evaluation<'_>) -> f64 {
        let [upper, lower] = &mut self.sheets;
        let z = self.columns.height;
        let stored = upper.evaluate(rows, z, wanted) + lower.evaluate(rows, -z, wanted);
        let long = self.columns.extended(rows, true);
        let of_columns =
            self.columns.gather(&long, [&upper.forces, &lower.forces], forces, wanted.share.threads());
        if wanted.energy { stored + of_columns } else { 0.0 }
    }

    fn tangent(&mut self, rows: &mut [Row], along: &mut [Row], out: &mut [Row], share: &Share) {
        let [upper, lower] = &mut self.sheets;
        let z = self.columns.height;
        upper.tangent(rows, along, z, share);
        lower.tangent(rows, along, -z, share);
        let (rows, along) = (self.columns.extended(rows, true), self.columns.extended(along, false));
        self.columns.gather_tangent(&rows, &along, [&upper.forces, &lower.forces], out);
    }

    fn breaks(&self) -> bool {
        self.sheets.iter().any(Sheet::breaks)
    }

    fn noted(&self, share: &Share) -> bool {
        self.sheets.iter().any(|sheet| sheet.noted(share))
    }

    fn break_bonds(&mut self, rows: &[Row], share: &Share) -> f64 {
        self.break_noted(rows, share)
    }

    fn utilisation(&self, _rows: &[Row]) -> f64 {
        let [upper, lower] = self.sheets.each_ref().map(Sheet::utilisation);
        upper.max(lower)
    }

    fn break_from(&mut self, least: f64, counted: f64, rows: &[Row], share: &Share) -> f64 {
        let lost: f64 = self.sheets.iter_mut().map(|sheet| sheet.break_from(least, counted, share)).sum();
        let rows = self.columns.extended(rows, true);
        lost + self.slacken(Some((&rows, counted)))
    }

    fn couplings(&self) -> BlockPattern {
        self.pattern()
    }

    fn second_derivatives(
        &self,
        states: (&[Row], Option<&[Row]>),
        pattern: &BlockPattern,
        blocks: &mut [Coupling],
        threads: usize,
    ) {
        self.hessian(states, pattern, blocks, threads);
    }

    fn keeps_directions(&self) -> bool {
        true
    }

    fn shortest(&self, rows: &[Row]) -> (usize, f64) {
        self.shortest_bond(rows)
    }

    fn bytes(&self) -> usize {
        let pairs = size_of_val(&self.columns.shear.pairs[..]);
        self.sheets.iter().map(Sheet::bytes).sum::<usize>() + pairs
    }

    fn bonds(&self) -> usize {
        self.sheets.iter().map(|sheet| sheet.network.bonds).sum()
    }

    fn damage(&self, node: usize) -> f64 {
        let [upper, lower] = &self.sheets;
        0.5 * (upper.damage(node) + lower.damage(node))
    }

    fn damage_of_sheets(&self, node: usize) -> Option<[f64; 2]> {
        Some(self.sheets.each_ref().map(|sheet| sheet.damage(node)))
    }

    fn fracture_energy(&self, node: usize) -> f64 {
        self.broken_energy(node)
    }

    fn stored(&self, rows: &[Row], node: usize) -> f64 {
        let [upper, lower] = self.sheets.each_ref().map(|sheet| sheet.network.stored(&sheet.points, node));
        upper + lower + self.columns.stored(&self.columns.extended(rows, true), node)
    }

    /// The mean over the thickness.
    fn virial(&self, _rows: &[Row], node: usize) -> Matrix3<f64> {
        let [upper, lower] = self.sheets.each_ref().map(|sheet| sheet.network.virial(&sheet.points, node));
        upper + lower
    }

    fn across(&self, rows: &[Row], node: usize, plane: (usize, i32)) -> f64 {
        let [upper, lower] =
            self.sheets.each_ref().map(|sheet| sheet.network.across(&sheet.points, node, plane));
        upper + lower + self.columns.across(&self.columns.extended(rows, true), node, plane)
    }

    fn fragments(&self) -> Vec<usize> {
        fragments(&self.sheets[0].network, |lane| self.is_joined(lane))
    }

    fn broken(&self) -> [Vec<f64>; 3] {
        self.broken_state()
    }

    fn take_up(&mut self, broken: [&[f64]; 3]) -> bool {
        self.take_up_broken(broken)
    }

    fn reach(&self) -> Result<Reach<'_>, &'static str> {
        Err("a plate of two sheets")
    }

    fn bring(&mut self, _: &Share) {}
}

impl Plate {
    /// Breaks the bonds noted in the last evaluation; returns the energy that the plate loses at these rows \[F L\].
    pub fn break_noted(&mut self, rows: &[Row], share: &Share) -> f64 {
        let z = self.columns.height;
        let [upper, lower] = &mut self.sheets;
        if !(upper.noted(share) || lower.noted(share)) {
            return 0.0;
        }
        let lost = upper.break_noted(rows, z, share) + lower.break_noted(rows, -z, share);
        let rows = self.columns.extended(rows, true);
        lost + self.slacken(Some((&rows, 1.0)))
    }

    /// Sets the rigidities of pairs by the bonds that are whole; counts a share of the energy that pairs lose in these rows, and
    /// returns it \[F L\].
    pub fn slacken(&mut self, rows: Option<(&[Row], f64)>) -> f64 {
        let count = self.columns.rest.len();
        let shear = &mut self.columns.shear;
        let mut lost = 0.0;
        for node in 0..count {
            let lanes = self.sheets[0].network.lanes_of(node);
            let pairs = shear.starts[node] as usize..shear.starts[node + 1] as usize;
            for (lane, pair) in lanes.zip(&mut shear.pairs[pairs]) {
                let whole = self.sheets.iter().filter(|sheet| sheet.is_whole(lane)).count();
                let (before, after) = (pair.stiffness, 0.5 * whole as f64 * pair.rigidity);
                pair.stiffness = after;
                let (Some((rows, share)), true) = (rows, before != after) else { continue };
                let end = (&rows[pair.other as usize], &rows[pair.turned as usize]);
                let sheared = pair.sheared((&rows[node], &rows[count + node]), end);
                // The other half is lost at the other end.
                let held = share * 0.25 * (before - after) * sheared.strain * sheared.strain;
                self.sheared_off[node] += held;
                lost += held;
            }
        }
        lost
    }

    /// Whether the bond on a lane is whole in either sheet.
    pub fn is_joined(&self, lane: usize) -> bool {
        self.sheets.iter().any(|sheet| sheet.is_whole(lane))
    }

    /// Energy that the broken bonds and pairs of a column held \[F L\].
    pub fn broken_energy(&self, node: usize) -> f64 {
        let of = |sheet: &Sheet| sheet.breaking.as_ref().map_or(0.0, |breaking| breaking.energy(node));
        let of_pairs = self.sheared_off.get(node).copied().unwrap_or(0.0);
        of(&self.sheets[0]) + of(&self.sheets[1]) + of_pairs
    }

    /// All that changes as bonds break: the broken ones, those of the lower sheet behind those of the upper; the energies
    /// they held, those of pairs behind; the work on bonds.
    pub fn broken_state(&self) -> [Vec<f64>; 3] {
        let lanes = self.lanes() as f64;
        let mut out: [Vec<f64>; 3] = Default::default();
        for (sheet, offset) in self.sheets.iter().zip([0.0, lanes]) {
            let [broken, energies, works] =
                sheet.breaking.as_ref().map_or_else(Default::default, Breaking::state);
            out[0].extend(broken.iter().map(|lane| lane + offset));
            out[1].extend(energies);
            out[2].extend(works);
        }
        out[1].extend(&self.sheared_off);
        out
    }

    /// Takes up such a state; false, and nothing changed, for that of another plate, or one in which bonds are whole that are
    /// broken here.
    pub fn take_up_broken(&mut self, [broken, energies, works]: [&[f64]; 3]) -> bool {
        let (count, lanes) = (self.columns.rest.len(), self.lanes() as f64);
        if self.sheets[0].breaking.is_none() {
            return [broken, energies, works].iter().all(|array| array.is_empty());
        }
        let middle = broken.partition_point(|&lane| lane < lanes);
        let of_lower: Vec<f64> = broken[middle..].iter().map(|lane| lane - lanes).collect();
        if energies.len() != 3 * count || works.len() % 2 != 0 {
            return false;
        }
        let [of_upper, of_works] = [&broken[..middle], &works[..works.len() / 2]];
        let parts = [
            [of_upper, &energies[..count], of_works],
            [&of_lower, &energies[count..2 * count], &works[works.len() / 2..]],
        ];
        let mut taken = Vec::new();
        for (sheet, part) in self.sheets.iter().zip(parts) {
            let Some(mut breaking) = sheet.breaking.clone() else { return false };
            let mut network = sheet.network.clone();
            if !breaking.take_up(&mut network, part) {
                return false;
            }
            taken.push((breaking, network));
        }
        for (sheet, (breaking, network)) in self.sheets.iter_mut().zip(taken) {
            (sheet.breaking, sheet.network) = (Some(breaking), network);
        }
        self.slacken(None);
        self.sheared_off.copy_from_slice(&energies[2 * count..]);
        true
    }

    /// Lanes of a sheet.
    fn lanes(&self) -> usize {
        LANES * self.sheets[0].network.packs()
    }
}
