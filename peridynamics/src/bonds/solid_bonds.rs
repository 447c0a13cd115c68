//! Bonds between the nodes of a solid, as its mechanics.

use super::balance::Balance;
use super::breaking::Breaking;
use super::correction::weights;
use super::couplings::Coupling;
use super::faces::areas;
use super::families::{Families, Nodes};
use super::flatness::refuse_flat;
use super::flow::{Flow, Past};
use super::forces::{Scratch, Wanted};
use super::fragments::fragments;
use super::limits::Lattice;
use super::mechanics::{Evaluation, Mechanics};
use super::network::{Network, Row};
use super::repulsion::{Repulsion, Touching};
use crate::error::SolidError;
use crate::formulation::{Correction, Formulation};
use crate::fracture::Breakage;
use crate::material::Elastic;
use crate::mirror::Mirror;
use crate::plastic::Plastic;
use crate::share::{Reach, Share};
use crate::unknowns::Unknowns;
use implicit_statics::BlockPattern;
use nalgebra::Matrix3;
use sph_core::{Block, Vec3};

/// Bonds between nodes.
pub(crate) struct SolidBonds {
    pub network: Network,
    scratch: Scratch,
    /// Which bonds are whole; none where nothing breaks.
    breaking: Option<Breaking>,
    contact: Option<Repulsion>,
    /// Rows and displacements with those of images behind them; empty without planes of symmetry.
    long: [Vec<Row>; 2],
}

impl SolidBonds {
    /// Joins the nodes of a block.
    ///
    /// # Errors
    /// [`SolidError`] for the material, the horizon, the nodes, a body in space without thickness, and for what breaks it.
    pub fn new(
        block: &Block,
        (material, plastic): (&Elastic, Option<&Plastic>),
        formulation: &Formulation,
        breakage: &Breakage,
        mirrors: &[Mirror],
    ) -> Result<Self, SolidError> {
        let moduli = formulation.moduli(material)?;
        plastic.map_or(Ok(()), |plastic| plastic.check(formulation))?;
        let spacing = block.greatest_spacing();
        let nodes = Nodes { positions: &block.positions, volumes: &block.volumes, spacing, mirrors };
        let families = Families::new(&nodes, formulation.horizon, formulation.volumes)?;
        let places = &families.places[..];
        if moduli.dimensions == 3 && flat(&families, places) {
            return Err(SolidError::OneLayer);
        }
        refuse_flat(&families, places, formulation, moduli.dimensions)?;
        let thickness = if moduli.dimensions == 2 { block.spacing[2] } else { 1.0 };
        let mut weights = weights(&families, formulation, &moduli, thickness);
        if formulation.correction == Correction::Balanced {
            let areas = areas(block, mirrors, families.images.as_deref())?;
            let (families, volumes) = (&families, &block.volumes);
            let body =
                Balance { families, positions: places, volumes, areas: &areas, spacing, moduli: &moduli };
            body.bring(&mut weights)?;
        }
        let mut network = Network::new(&families, &weights, None, &moduli);
        if let Some(&plastic) = plastic {
            network.flow = Some(Box::new(Flow::new(&network, plastic, places, &block.volumes)));
        }
        let scratch = Scratch::new(&network);
        let mut breaking = breakage.breaks().then(|| Breaking::new(&network, &families));
        if let Some(breaking) = &mut breaking {
            for (number, crack) in breakage.cracks.iter().enumerate() {
                let cut = crack.cut(number, moduli.dimensions)?;
                if breaking.cut(&mut network, places, &cut) == 0 {
                    return Err(SolidError::Crack { number, problem: "cuts no bond; move it into the body" });
                }
            }
            if let Some(fracture) = &breakage.fracture {
                let lattice = Lattice { formulation, moduli: &moduli, spacing: block.spacing };
                breaking.limit(&network, lattice.limit(&fracture.criterion)?, &fracture.unbreakable)?;
            }
        }
        let lengths = [spacing, families.horizon, thickness];
        let contact = breakage.contact.as_ref();
        let contact =
            contact.map(|c| Repulsion::new(c, &moduli, material, &block.volumes, lengths)).transpose()?;
        let images = network.images.as_ref().map_or(0, |images| network.len() + images.len());
        let long = [vec![[0.0; 4]; images], vec![[0.0; 4]; images]];
        Ok(Self { network, scratch, breaking, contact, long })
    }
}

/// Whether all nodes lie in a plane through the first bonds.
fn flat(families: &Families, places: &[Vec3]) -> bool {
    let spread = places.iter().fold(Matrix3::zeros(), |sum, x| {
        let from = x - places[0];
        sum + from * from.transpose()
    });
    let eigen = nalgebra::SymmetricEigen::new(spread).eigenvalues;
    let least = eigen.iter().fold(f64::INFINITY, |least, value| least.min(value.abs()));
    least <= 1e-9 * families.horizon * families.horizon * places.len() as f64
}

impl SolidBonds {
    /// The rows last evaluated, with those of images if there are any.
    fn evaluated<'a>(&'a self, rows: &'a [Row]) -> &'a [Row] {
        if self.long[0].is_empty() { rows } else { &self.long[0] }
    }
}

/// Rows, or where there are images a longer list of them that begins with these.
fn longer<'a>(long: &'a mut [Row], rows: &'a mut [Row]) -> &'a mut [Row] {
    if long.is_empty() {
        return rows;
    }
    long[..rows.len()].copy_from_slice(rows);
    long
}

impl Mechanics for SolidBonds {
    fn evaluate(&mut self, rows: &mut [Row], forces: &mut [Row], wanted: Evaluation<'_>) -> f64 {
        let Evaluation { energy, watch, share } = wanted;
        let limit = self.breaking.as_ref().and_then(|breaking| breaking.watch.as_ref()).filter(|_| watch);
        let wanted = Wanted { energy, watch: limit, share };
        let rows = longer(&mut self.long[0], rows);
        let mut stored = self.network.evaluate(rows, forces, &mut self.scratch, wanted);
        let Some(breaking) = &mut self.breaking else { return stored };
        if let Some(works) = breaking.works.as_mut().filter(|_| watch) {
            works.add(&self.network, rows, share);
        }
        if let Some(contact) = &mut self.contact {
            let body = Touching { network: &self.network, bonds: &breaking.bonds, rows, share };
            stored += contact.add(&body, forces, energy);
        }
        stored
    }

    fn tangent(&mut self, rows: &mut [Row], along: &mut [Row], out: &mut [Row], share: &Share) {
        let [long, moved] = &mut self.long;
        self.network.tangent(longer(long, rows), longer(moved, along), out, &mut self.scratch, share);
    }

    fn breaks(&self) -> bool {
        self.breaking.as_ref().is_some_and(Breaking::is_watched)
    }

    fn noted(&self, share: &Share) -> bool {
        self.breaking.as_ref().is_some_and(|breaking| breaking.noted(&self.scratch, share).next().is_some())
    }

    fn break_bonds(&mut self, rows: &[Row], share: &Share) -> f64 {
        let Some(breaking) = &mut self.breaking else { return 0.0 };
        breaking.break_noted(&mut self.network, &self.scratch, rows, self.contact.as_ref(), share)
    }

    fn utilisation(&self, rows: &[Row]) -> f64 {
        self.breaking.as_ref().map_or(0.0, |breaking| breaking.utilisation(&self.network, rows))
    }

    fn break_from(&mut self, least: f64, counted: f64, rows: &[Row], share: &Share) -> f64 {
        let Some(breaking) = &mut self.breaking else { return 0.0 };
        breaking.break_from(&mut self.network, (least, counted), rows, self.contact.as_ref(), share)
    }

    fn couplings(&self) -> BlockPattern {
        self.network.couplings()
    }

    fn second_derivatives(
        &self,
        (rows, stressed): (&[Row], Option<&[Row]>),
        pattern: &BlockPattern,
        blocks: &mut [Coupling],
        threads: usize,
    ) {
        self.network.linearised(rows, stressed).second_derivatives(pattern, blocks, threads);
    }

    fn row_sums(&self, rows: &[Row], unknowns: &Unknowns, out: &mut [f64]) -> bool {
        self.network.linearised(rows, None).row_sums(unknowns, out);
        true
    }

    fn shortest(&self, rows: &[Row]) -> (usize, f64) {
        self.network.shortest(rows)
    }

    fn bytes(&self) -> usize {
        self.network.bytes() + self.breaking.as_ref().map_or(0, Breaking::bytes)
    }

    fn bonds(&self) -> usize {
        self.network.bonds
    }

    fn pairs(&self) -> Option<Vec<(u32, u32, f64)>> {
        Some(self.network.pairs())
    }

    fn contact_spectrum(&self) -> f64 {
        self.contact.as_ref().map_or(0.0, Repulsion::spectrum)
    }

    fn damage(&self, node: usize) -> f64 {
        self.breaking.as_ref().map_or(0.0, |breaking| breaking.damage(&self.network, node))
    }

    fn fracture_energy(&self, node: usize) -> f64 {
        self.breaking.as_ref().map_or(0.0, |breaking| breaking.energy(node))
    }

    fn stored(&self, rows: &[Row], node: usize) -> f64 {
        self.network.stored(self.evaluated(rows), node)
    }

    fn virial(&self, rows: &[Row], node: usize) -> Matrix3<f64> {
        self.network.virial(self.evaluated(rows), node)
    }

    fn across(&self, rows: &[Row], node: usize, plane: (usize, i32)) -> f64 {
        self.network.across(self.evaluated(rows), node, plane)
    }

    fn fragments(&self) -> Vec<usize> {
        match &self.breaking {
            Some(breaking) => fragments(&self.network, |lane| breaking.bonds.is_whole(lane)),
            None => fragments(&self.network, |_| true),
        }
    }

    fn broken(&self) -> [Vec<f64>; 3] {
        self.breaking.as_ref().map_or_else(Default::default, Breaking::state)
    }

    fn take_up(&mut self, broken: [&[f64]; 3]) -> bool {
        match &mut self.breaking {
            Some(breaking) => breaking.take_up(&mut self.network, broken),
            None => broken.iter().all(|array| array.is_empty()),
        }
    }

    fn yields(&self) -> bool {
        self.network.flow.is_some()
    }

    fn keep_flow(&mut self, rows: &[Row], share: &Share) -> f64 {
        let rows = if self.long[0].is_empty() { rows } else { &self.long[0] };
        self.network.keep_flow(rows, share)
    }

    fn past(&self, node: usize) -> Option<Past> {
        self.network.flow.as_ref().map(|flow| flow.past[node])
    }

    fn flowed(&self) -> [Vec<f64>; 2] {
        self.network.flow.as_ref().map_or_else(Default::default, |flow| flow.state())
    }

    fn take_up_flow(&mut self, flowed: [&[f64]; 2]) -> bool {
        match &mut self.network.flow {
            Some(flow) => flow.take_up(flowed),
            None => flowed.iter().all(|array| array.is_empty()),
        }
    }

    fn reach(&self) -> Result<Reach<'_>, &'static str> {
        let network = &self.network;
        Ok(Reach {
            everywhere: self.contact.is_some(),
            ends: Box::new(|node, ends| network.ends(node, ends)),
            in_turn: network.images.is_none(),
            found: network.found(),
        })
    }

    fn warm(&mut self, strains: &[f64]) -> Option<f64> {
        Some(self.network.warm(strains))
    }

    fn expand(&mut self, level: f64) {
        self.network.expand(level);
    }

    fn bring(&mut self, share: &Share) {
        if let Some(breaking) = &mut self.breaking {
            breaking.bring(&mut self.network, share);
        }
        self.network.bring_flow(share);
        self.network.bring_evaluated(&mut self.long[0], share);
    }
}
