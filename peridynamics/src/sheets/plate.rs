//! The two sheets of a plate with their columns, as its mechanics.

use implicit_statics::BlockPattern;
use nalgebra::Matrix3;
use sph_core::{Block, Vec3};

use super::columns::Columns;
use super::rest_shape::{directors, plan};
use super::shear::Shear;
use super::sheet::{Cloth, Sheet};
use crate::bonds::balance::Balance;
use crate::bonds::correction::weights;
use crate::bonds::couplings::Coupling;
use crate::bonds::faces::areas;
use crate::bonds::families::{Families, Nodes};
use crate::bonds::flatness::refuse_flat;
use crate::bonds::fragments::fragments;
use crate::bonds::limits::Lattice;
use crate::bonds::mechanics::{Evaluation, Mechanics};
use crate::bonds::network::Row;
use crate::error::SolidError;
use crate::formulation::Correction;
use crate::fracture::Breakage;
use crate::material::{Elastic, Moduli, Space};
use crate::mirror::Mirror;
use crate::parts::Sheets;

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
        let mut weights = weights(&families, &plan, &formulation, &moduli, 0.5 * thickness);
        if formulation.correction == Correction::Balanced {
            let flat = Block { positions: plan.clone(), ..block.clone() };
            let mut areas = areas(&flat, mirrors, families.images.as_deref())?;
            areas.iter_mut().for_each(|area| *area *= 0.5);
            Balance {
                families: &families,
                positions: &families.extended(&plan),
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
        let cloth = Cloth {
            families: &families,
            weights: &weights,
            volumes: &volumes,
            moduli: &moduli,
            breakage,
            limit,
        };
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
    fn evaluate(&mut self, rows: &mut [Row], forces: &mut [Row], wanted: Evaluation) -> f64 {
        let [upper, lower] = &mut self.sheets;
        let z = self.columns.height;
        let stored = upper.evaluate(rows, z, wanted) + lower.evaluate(rows, -z, wanted);
        let long = self.columns.extended(rows, true);
        let of_columns = self.columns.gather(&long, [&upper.forces, &lower.forces], forces, wanted.threads);
        if wanted.energy { stored + of_columns } else { 0.0 }
    }

    fn tangent(&mut self, rows: &mut [Row], along: &mut [Row], out: &mut [Row], threads: usize) {
        let [upper, lower] = &mut self.sheets;
        let z = self.columns.height;
        upper.tangent(rows, along, z, threads);
        lower.tangent(rows, along, -z, threads);
        let (rows, along) = (self.columns.extended(rows, true), self.columns.extended(along, false));
        self.columns.gather_tangent(&rows, &along, [&upper.forces, &lower.forces], out);
    }

    fn noted(&self) -> bool {
        self.sheets.iter().any(Sheet::noted)
    }

    fn break_bonds(&mut self, rows: &[Row]) -> f64 {
        self.break_noted(rows)
    }

    fn utilisation(&self, _rows: &[Row]) -> f64 {
        let [upper, lower] = self.sheets.each_ref().map(Sheet::utilisation);
        upper.max(lower)
    }

    fn break_from(&mut self, least: f64, share: f64, rows: &[Row]) -> f64 {
        let lost: f64 = self.sheets.iter_mut().map(|sheet| sheet.break_from(least, share)).sum();
        let rows = self.columns.extended(rows, true);
        lost + self.slacken(Some((&rows, share)))
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
}
