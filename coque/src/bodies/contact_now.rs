//! A contact of a body, with what it does now and what particles feel of it.

use contact::NodalContact;
use sph_core::Vec3;

/// What a body touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum With {
    /// A tool, by its number in the scene.
    Tool(usize),
    /// Itself.
    Itself,
    /// Another body, by its number.
    Body(usize),
}

/// A contact, for the forces last evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactNow {
    /// The body that touches, by its number.
    pub body: usize,
    /// What it touches.
    pub with: With,
    /// Stiffness κ of a unit of area \[F/L³\].
    pub stiffness: f64,
    /// Whether that is what the thickness gives, not what steps in time bear; none where two bodies give it.
    pub by_thickness: Option<bool>,
    /// Greatest depth over the distance at which faces touch \[–\]; mid-surfaces meet at one.
    pub depth: f64,
    /// Area that touches \[L²\].
    pub area: f64,
    /// The place that is deepest \[L\]; none where nothing is deep.
    pub place: Option<Vec3>,
}

impl ContactNow {
    /// Depth from which a contact is deep: beyond it forces depend on the stiffness of contact, and what is in the way is no longer the face.
    pub const DEEP: f64 = 0.25;
}

/// What fields show of contact.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactFields {
    /// What each particle feels.
    pub nodal: Vec<NodalContact>,
    /// Gap at each particle \[L\].
    pub gaps: Vec<f64>,
}
