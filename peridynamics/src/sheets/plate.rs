//! The two sheets of a plate with their columns, as its mechanics.

use sph_core::{Block, Vec3};

use super::columns::Columns;
use super::lie::{directors, plan};
use super::shear::Shear;
use crate::bonds::correction::weights;
use crate::bonds::couplings::{Coupling, Couplings};
use crate::bonds::families::{Families, Nodes};
use crate::bonds::forces::{Scratch, Wanted, Watch};
use crate::bonds::network::{Network, Row};
use crate::error::SolidError;
use crate::material::{Elastic, Space};
use crate::mechanics::{Evaluation, Mechanics};
use crate::parts::Sheets;

/// Two sheets on directors; rows are places, then directors.
pub(crate) struct Plate {
    pub columns: Columns,
    /// The upper sheet and the lower.
    pub sheets: [Sheet; 2],
}

/// A sheet with its points at the present.
pub(crate) struct Sheet {
    pub network: Network,
    pub watch: Option<Watch>,
    scratch: Scratch,
    points: Vec<Row>,
    forces: Vec<Row>,
}

impl Plate {
    /// Joins the columns of a plane block, whose places may be somewhat out of its plane; returns the directors at rest too.
    ///
    /// # Errors
    /// [`SolidError`] for the material, the thickness, the horizon, the nodes, and a plate that is not flat enough.
    pub fn new(block: &Block, material: &Elastic, sheets: &Sheets) -> Result<(Self, Vec<Vec3>), SolidError> {
        let Sheets { thickness, formulation } = *sheets;
        if block.dimensions != 2 || formulation.space != Space::PlaneStress {
            return Err(SolidError::NotThin);
        }
        if !(thickness > 0.0 && thickness == block.spacing[2]) {
            let bound = "positive, and the thickness of its block";
            return Err(SolidError::Limit { what: "the thickness of the plate", value: thickness, bound });
        }
        let moduli = formulation.moduli(material)?;
        let (plan, volumes) = (plan(block), half_of(&block.volumes));
        let nodes = Nodes { positions: &plan, volumes: &volumes, spacing: block.greatest_spacing() };
        let families = Families::new(&nodes, formulation.horizon, formulation.volumes)?;
        let directors = directors(block, &families, formulation.influence)?;
        let weights = weights(&families, &plan, &formulation, &moduli, 0.5 * thickness);
        let height = thickness / (2.0 * 3.0_f64.sqrt());
        let sheet = |side: f64| {
            let at = |node: usize| block.positions[node] + directors[node] * (side * height);
            let mut at_rest = families.clone();
            for node in 0..families.len() {
                for bond in families.of(node) {
                    at_rest.lengths[bond] = (at(families.others[bond] as usize) - at(node)).norm();
                }
            }
            Sheet::new(Network::new(&at_rest, &weights, &volumes, &moduli))
        };
        let areas: Vec<f64> = block.volumes.iter().map(|volume| volume / thickness).collect();
        let at_rest = (&block.positions[..], &directors[..]);
        let columns = Columns {
            height,
            stiffness: block.volumes.iter().map(|volume| material.young * volume).collect(),
            rest: directors.iter().map(|d| 0.5 * d.norm_squared()).collect(),
            shear: Shear::new(&families, formulation.influence, at_rest, &areas, &moduli, thickness),
            energies: vec![0.0; block.len().div_ceil(crate::bonds::forces::NODE_CHUNK)],
        };
        Ok((Self { columns, sheets: [sheet(1.0), sheet(-1.0)] }, directors))
    }
}

fn half_of(volumes: &[f64]) -> Vec<f64> {
    volumes.iter().map(|volume| 0.5 * volume).collect()
}

impl Sheet {
    fn new(network: Network) -> Self {
        let points = vec![[0.0; 4]; network.len()];
        Self { scratch: Scratch::new(&network), forces: points.clone(), points, network, watch: None }
    }

    /// Puts its points at `x + z d` and finds the forces on them; returns the stored energy \[F L\], zero unless wanted.
    fn evaluate(&mut self, rows: &[Row], z: f64, wanted: Evaluation) -> f64 {
        let Evaluation { energy, watch, threads } = wanted;
        let (places, directors) = rows.split_at(self.points.len());
        for (point, (x, d)) in self.points.iter_mut().zip(places.iter().zip(directors)) {
            (0..3).for_each(|k| point[k] = x[k] + z * d[k]);
        }
        let watch = self.watch.as_ref().filter(|_| watch);
        let wanted = Wanted { energy, watch, threads };
        self.network.evaluate(&mut self.points, &mut self.forces, &mut self.scratch, wanted)
    }

    fn bytes(&self) -> usize {
        self.network.bytes() + 2 * size_of::<Row>() * self.points.len()
    }
}

impl Mechanics for Plate {
    fn evaluate(&mut self, rows: &mut [Row], forces: &mut [Row], wanted: Evaluation) -> f64 {
        let [upper, lower] = &mut self.sheets;
        let z = self.columns.height;
        let stored = upper.evaluate(rows, z, wanted) + lower.evaluate(rows, -z, wanted);
        let of_columns = self.columns.gather(rows, [&upper.forces, &lower.forces], forces, wanted.threads);
        if wanted.energy { stored + of_columns } else { 0.0 }
    }

    fn break_bonds(&mut self) -> f64 {
        0.0
    }

    fn couplings(&self) -> Couplings {
        self.pattern()
    }

    fn second_derivatives(
        &self,
        states: (&[Row], Option<&[Row]>),
        pattern: &Couplings,
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
}
