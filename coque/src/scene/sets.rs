//! Named sets of particles: those that every scene has, regions, and what is made of other sets.

use std::collections::BTreeSet;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::Positive;

/// Sets that every shell has.
pub(crate) const BUILT_IN: [&str; 11] =
    ["all", "u0", "u1", "v0", "v1", "u0v0", "u1v0", "u0v1", "u1v1", "centre-row", "centre-column"];

/// Sets that every solid has: all nodes, and those on the faces of its block.
pub(crate) const OF_SOLIDS: [&str; 7] = ["all", "x0", "x1", "y0", "y1", "z0", "z1"];

/// Sets of a solid whose nodes fill a surface: those of every solid, where faces are what of the surface lies in the planes of the box round it, and
/// the nodes that bear a part of the surface.
pub(crate) const OF_FILLED: [&str; 8] = ["all", "x0", "x1", "y0", "y1", "z0", "z1", "surface"];

/// Sets that every rigid body has: the body itself, at its centre of mass.
pub(crate) const OF_RIGID_BODIES: [&str; 1] = ["all"];

/// Sets that every fluid has.
pub(crate) const OF_FLUIDS: [&str; 1] = ["all"];

/// Sets that walls have: all of them and, of a basin, its sides.
pub(crate) const OF_WALLS: [&str; 7] = OF_SOLIDS;

/// Built-in sets that are edges: particles in a row, each with a tributary length.
pub(crate) const EDGES: [&str; 4] = ["u0", "u1", "v0", "v1"];

/// Picks particles; exactly one key beside `of` is given: a region of space, in the un-turned frame, or other sets.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Region {
    /// The body whose particles, or places of whose walls, are picked; may be left out where there is one, or where other sets say so.
    pub of: Option<String>,
    /// The one particle nearest to this point \[L\].
    pub nearest: Option<[f64; 3]>,
    /// All particles within a distance of a point.
    pub near: Option<Near>,
    /// All particles in a box, its faces included.
    #[serde(rename = "box")]
    pub inside: Option<Box3>,
    /// All particles on a plane.
    pub plane: Option<OnPlane>,
    /// All nodes of a solid within a depth of a face of its block, or of the box round the surface that they fill.
    pub layer: Option<Layer>,
    /// Names of sets: all particles that lie in at least one of them.
    pub union: Option<Vec<String>>,
    /// Names of sets: all particles that lie in every one of them.
    pub intersection: Option<Vec<String>>,
    /// Names of sets: all particles of the first that lie in none of the others.
    pub difference: Option<Vec<String>>,
}

/// How a set is made of others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Made {
    /// In at least one.
    Union,
    /// In every one.
    Intersection,
    /// In the first and in no other.
    Difference,
}

impl Made {
    /// Its key.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Union => "union",
            Self::Intersection => "intersection",
            Self::Difference => "difference",
        }
    }

    /// What is made of some sets, in the order of numbers, each once.
    pub(crate) fn members(self, sets: &[Vec<u32>]) -> Vec<u32> {
        let [first, others @ ..] = sets else { return Vec::new() };
        let mut found: BTreeSet<u32> = first.iter().copied().collect();
        for other in others {
            let other: BTreeSet<u32> = other.iter().copied().collect();
            match self {
                Self::Union => found.extend(other),
                Self::Intersection => found.retain(|a| other.contains(a)),
                Self::Difference => found.retain(|a| !other.contains(a)),
            }
        }
        found.into_iter().collect()
    }
}

impl Region {
    /// How it is made of other sets, and their names; none of a region of space.
    pub(crate) fn made(&self) -> Option<(Made, &[String])> {
        let known = [
            (Made::Union, &self.union),
            (Made::Intersection, &self.intersection),
            (Made::Difference, &self.difference),
        ];
        known.into_iter().find_map(|(made, names)| Some((made, names.as_deref()?)))
    }

    /// Names of the sets that it is made of.
    pub(super) fn names_mut(&mut self) -> impl Iterator<Item = &mut String> {
        [&mut self.union, &mut self.intersection, &mut self.difference].into_iter().flatten().flatten()
    }
}

/// A ball.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Near {
    /// Its centre \[L\].
    pub point: [f64; 3],
    /// Greatest distance from the centre \[L\].
    pub distance: Positive,
}

/// A layer under a face of a block.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Layer {
    /// The face, one of `x0`, `x1`, `y0`, `y1`, `z0`, `z1`.
    pub face: String,
    /// Its depth from the face \[L\].
    pub depth: Positive,
}

/// Axis-parallel box.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Box3 {
    /// Least coordinates \[L\].
    pub min: [f64; 3],
    /// Greatest coordinates \[L\].
    pub max: [f64; 3],
}

/// Plane.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OnPlane {
    /// A point of the plane \[L\].
    pub point: [f64; 3],
    /// Its normal; the length does not matter.
    pub normal: [f64; 3],
    /// Greatest distance from the plane \[L\]; a thousandth of the spacing without.
    pub within: Option<Positive>,
}
