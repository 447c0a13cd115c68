//! When bonds break, and cracks that are there at the start.

use sph_core::Vec3;

use crate::contact::Contact;

/// When bonds break.
#[derive(Clone, Debug, PartialEq)]
pub struct Fracture {
    /// The limit of a bond.
    pub criterion: Criterion,
    /// Nodes whose bonds never break: zones where loads enter.
    pub unbreakable: Vec<u32>,
}

/// The limit of a bond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Criterion {
    /// Stretches s = e/r beyond which a bond breaks: `tension > 0`, `-1 < compression < 0` or none \[–\].
    Stretch {
        /// Greatest stretch.
        tension: f64,
        /// Least stretch.
        compression: Option<f64>,
    },
    /// The critical stretch in tension that spends the energy `G₀` on a unit area of crack \[F/L\].
    EnergyByStretch(f64),
    /// The work done on a bond in tension, its share of the energy `G₀` of a unit area of crack \[F/L\]. It counts what the
    /// dilatation pulls with; where λ = μ it breaks the bonds that the stretch breaks.
    EnergyByWork(f64),
}

/// A crack that is there at the start: it breaks every bond that it cuts.
#[derive(Clone, Debug, PartialEq)]
pub enum Crack {
    /// From one point to another, in plane problems.
    Segment([Vec3; 2]),
    /// A plane convex polygon in space, corners in order.
    Polygon(Vec<Vec3>),
}

/// All that breaks a body.
pub(crate) struct Breakage {
    pub fracture: Option<Fracture>,
    pub cracks: Vec<Crack>,
    pub contact: Option<Contact>,
}

impl Breakage {
    /// Whether a bond is, or may be, broken.
    pub fn breaks(&self) -> bool {
        self.fracture.is_some() || !self.cracks.is_empty() || self.contact.is_some()
    }
}
