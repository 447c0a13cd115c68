//! What is wetted, and with which points.

use explicit_dynamics::Face;

use crate::error::ShellError;

/// How a shell meets a fluid.
#[derive(Clone, Debug)]
pub struct Wetting {
    /// Spacing of the fluid's particles Δx \[L\]: points are hardly farther apart.
    pub spacing: f64,
    /// Rows of points on each wet face; row k, from 0, lies `(½ + k)Δx` below the face, in the wall or through it.
    pub rows: usize,
    /// Which faces are wet.
    pub faces: WetFaces,
    /// Whether the problem is plane: the shell is then a strip across the plane z = 0, as wide everywhere.
    pub plane: bool,
    /// Particles of free edges, around which the fluid flows. Edges at which the shell goes on, behind a symmetry
    /// plane or in a wall, are none; closed shells have none.
    pub free_edges: Vec<u32>,
}

/// Faces of a shell that a fluid wets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case")
)]
pub enum WetFaces {
    /// Both.
    #[default]
    Both,
    /// The one to which the director points.
    Front,
    /// The other.
    Back,
}

impl Wetting {
    /// Face and distance from the middle surface along the director \[L\] of each row, in a shell of such a thickness.
    pub(crate) fn heights(&self, thickness: f64) -> Vec<(Face, f64)> {
        let row = |k: usize| 0.5 * thickness - (0.5 + k as f64) * self.spacing;
        let face = |face, sign: f64| (0..self.rows).map(move |k| (face, sign * row(k)));
        let (front, back) = (face(Face::Front, 1.0), face(Face::Back, -1.0));
        match self.faces {
            WetFaces::Front => front.collect(),
            WetFaces::Back => back.collect(),
            WetFaces::Both => front.chain(back).collect(),
        }
    }

    /// Points in a row along a length, hardly more than a spacing apart.
    pub(crate) fn count(&self, length: f64) -> usize {
        /// Part of a spacing by which all points of a row together may stretch, rather than take in one more.
        const SLACK: f64 = 0.05;
        (length / self.spacing - SLACK).ceil().max(1.0) as usize
    }

    /// # Errors
    /// [`ShellError`] for a spacing, rows or particles that make no sense.
    pub(crate) fn check(&self, particles: usize) -> Result<(), ShellError> {
        if !(self.spacing > 0.0 && self.spacing.is_finite()) {
            return Err(ShellError::WetSpacing(self.spacing));
        }
        if self.rows == 0 {
            return Err(ShellError::NoRows);
        }
        let beyond = |particle: &&u32| **particle as usize >= particles;
        match self.free_edges.iter().find(beyond) {
            Some(&particle) => {
                Err(ShellError::NoSuchParticle { what: "a free edge in a fluid", particle, count: particles })
            }
            None => Ok(()),
        }
    }
}
