//! What holds, moves and loads nodes.

use explicit_dynamics::{Amplitude, Instant};
use sph_core::Vec3;

/// A support of a set of nodes.
#[derive(Clone, Debug)]
pub struct Supported {
    /// The nodes.
    pub nodes: Vec<u32>,
    /// What holds them.
    pub support: Support,
}

/// What holds a node.
#[derive(Clone, Debug, PartialEq)]
pub enum Support {
    /// No displacement along these directions; of a plate of two sheets no director component along these.
    Held {
        /// Directions of no displacement; their length does not matter.
        displacement: Vec<Vec3>,
        /// Directions along which a director keeps its component; none but on plates of two sheets.
        director: Vec<Vec3>,
    },
    /// A prescribed displacement along a direction; the others stay free.
    Moved {
        /// Direction; its length does not matter.
        direction: Vec3,
        /// Displacement at level one and amplitude one \[L\].
        by: f64,
        /// Its course in time.
        amplitude: Amplitude,
    },
    /// The nodes turn as one body about an axis, and of a plate of two sheets their directors with them.
    Turned {
        /// Axis; its length does not matter.
        axis: Vec3,
        /// A point of the axis \[L\].
        point: Vec3,
        /// Angle at level one and amplitude one, right-handed \[rad\].
        by: f64,
        /// Its course in time.
        amplitude: Amplitude,
    },
}

/// Dead forces on nodes.
#[derive(Clone, Debug)]
pub struct AppliedLoad {
    /// Nodes with their forces at level one and amplitude one \[F\].
    pub forces: Vec<(u32, Vec3)>,
    /// Their course in time.
    pub amplitude: Amplitude,
}

impl AppliedLoad {
    /// The factor of its forces at an instant.
    pub(crate) fn factor(&self, at: Instant) -> f64 {
        at.level * self.amplitude.value(at.time)
    }
}
