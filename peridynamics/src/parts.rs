//! What a solid is built from.

use sph_core::Block;

use crate::conditions::{AppliedLoad, Supported};
use crate::contact::Contact;
use crate::formulation::Formulation;
use crate::fracture::{Crack, Fracture};
use crate::material::Elastic;
use crate::plastic::Plastic;

/// What a solid is built from.
#[derive(Clone, Debug)]
pub struct Parts {
    /// Its nodes.
    pub block: Block,
    /// What it is made of.
    pub material: Elastic,
    /// How it yields; never without. State-based bonds in space, in marches.
    pub plastic: Option<Plastic>,
    /// How bonds carry it.
    pub formulation: Idealisation,
    /// When bonds break; never without.
    pub fracture: Option<Fracture>,
    /// Cracks that are there at the start.
    pub cracks: Vec<Crack>,
    /// Contact of fragments with each other and with walls.
    pub contact: Option<Contact>,
    /// Supports and prescribed motions.
    pub supports: Vec<Supported>,
    /// Loads.
    pub loads: Vec<AppliedLoad>,
    /// Threads, at least one; results are the same for any number.
    pub threads: usize,
}

/// How bonds carry a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Idealisation {
    /// Between nodes of a solid.
    Bonds(Formulation),
    /// In two plane-stress sheets of a thin plate, on directors; the block is plane and its nodes are columns, which may stand
    /// somewhat out of its plane: the plate is then bent so at rest.
    Sheets(Sheets),
}

/// A plate of two plane-stress sheets at the Gauss heights `±t/(2√3)` of its thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheets {
    /// Thickness t of the plate \[L\].
    pub thickness: f64,
    /// Bonds of each sheet; its space is plane stress.
    pub formulation: Formulation,
}
