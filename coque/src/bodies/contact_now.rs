//! A contact of a body, with what it does now and what particles feel of it.

use contact::NodalContact;
use serde::{Deserialize, Serialize};
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
    /// Rows of nodes that it spans; none where nothing touches, and of what is no solid.
    pub rows: Option<Spanned>,
}

/// Rows of nodes of a solid that a contact spans, from the rim of what touches to its middle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spanned {
    /// How many; no more than those wanted are counted.
    pub rows: u32,
    /// From how many on greatest pressures under drums and balls were right to 3 %.
    pub wanted: u32,
    /// By how much greatest pressures were off at so many, at most \[%\].
    pub off: f64,
}

impl Spanned {
    /// The narrower of two.
    pub(crate) fn narrower(self, other: Self) -> Self {
        if other.rows < self.rows { other } else { self }
    }

    /// Whether pressures are off by more than 3 %.
    pub(crate) fn is_coarse(&self) -> bool {
        self.rows < self.wanted
    }
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
