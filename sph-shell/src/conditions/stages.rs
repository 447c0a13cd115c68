//! Stages of stiffness in which Newton's method finds what touches: contact that gives over a length, halved from stage to stage.
//!
//! A strip of bending stiffness B on a foundation κ gives over the length λ of `κ = 4B/λ⁴`. Where contact is stiff, λ is shorter than a cell, and an
//! iterate lets go of one row of vertices; where it is soft, of all within λ.

use implicit_statics::Front;
use sph_core::{Cloud, Vec3};

/// The first length over the extent of the shell, and over the spacing at least; the last over the spacing.
const OF_EXTENT: f64 = 0.1;
const LONGEST: f64 = 4.0;
const SHORTEST: f64 = 0.5;

/// The lengths of a shell, and its bending stiffness.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Stages {
    /// Ascending in stiffness \[L\].
    lengths: Vec<f64>,
    /// B \[F L\].
    bending: f64,
}

impl Stages {
    /// Those of a shell with a bending stiffness B \[F L\].
    pub fn new(cloud: &Cloud, bending: f64) -> Self {
        let (mut low, mut high) = (Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY));
        for place in &cloud.positions {
            (low, high) = (low.inf(place), high.sup(place));
        }
        let spacing = cloud.spacing();
        let first = (OF_EXTENT * (high - low).norm()).max(LONGEST * spacing);
        let halved = std::iter::successors(Some(first), |length| Some(0.5 * length));
        let lengths = halved.take_while(|length| *length >= SHORTEST * spacing).collect();
        Self { lengths, bending }
    }

    /// Stiffness by area of a contact that gives over a length \[F/L³\].
    fn of(&self, length: f64) -> f64 {
        4.0 * self.bending / length.powi(4)
    }

    /// The lengths that are softer than a contact of this stiffness.
    pub fn softer_than(&self, stiffness: f64) -> impl Iterator<Item = f64> {
        self.lengths.iter().copied().filter(move |&length| self.of(length) < stiffness)
    }

    /// A stiffness in the stage of a length, if any; else as it is.
    pub fn softened(&self, stiffness: f64, stage: Option<f64>) -> f64 {
        stage.map_or(stiffness, |length| stiffness.min(self.of(length)))
    }
}

/// Takes a vertex that touches into what is known of all that do: the set by a number that any change of it changes.
pub(crate) fn take(front: &mut Front, number: u64, depth: f64) {
    const PRIME: u64 = 0x0100_0000_01b3; // of the FNV hash
    front.set = (front.set ^ (number + 1)).wrapping_mul(PRIME);
    front.depth = front.depth.max(depth);
}
