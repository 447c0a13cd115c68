//! Plies on one another, as a scene says them.

use schemars::JsonSchema;
use serde::Deserialize;

use super::material::Material;
use crate::scene::bounded::{PlyAngle, Positive, Slices};

/// Plies on one another, the middle of all on the mid-surface.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Layered {
    /// Direction whose projection on the surface has the angle zero, in the un-turned frame.
    pub axis: [f64; 3],
    /// From the lowest, against the normal, to the highest.
    pub plies: Vec<Ply>,
}

/// One ply.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ply {
    /// Thickness \[L\].
    pub thickness: Positive,
    /// Angle of the fibre from the axis, positive about the normal \[degrees\].
    pub angle: PlyAngle,
    /// What it is made of: elastic, orthotropic or plastic; left out, as the shell.
    pub material: Option<Material>,
    /// Slices through a ply that yields; six without.
    pub slices: Option<Slices>,
}

impl Ply {
    /// What it is made of, in a shell of a material.
    pub(crate) fn material<'a>(&'a self, shell: &'a Material) -> &'a Material {
        self.material.as_ref().unwrap_or(shell)
    }

    /// Slices through it, where it yields.
    pub fn slices(&self) -> usize {
        self.slices.map_or(6, |slices| slices.get())
    }
}

impl Layered {
    /// Whether a ply has a material of its own.
    pub(crate) fn mixed(&self) -> bool {
        self.plies.iter().any(|ply| ply.material.is_some())
    }

    /// Materials of the plies, from the lowest, in a shell of a material.
    pub(crate) fn materials<'a>(&'a self, shell: &'a Material) -> impl Iterator<Item = &'a Material> {
        self.plies.iter().map(|ply| ply.material(shell))
    }

    /// Mass per volume, the mean over the thickness \[F T²/L⁴\].
    pub(crate) fn density(&self, shell: &Material) -> Option<f64> {
        if !self.mixed() {
            return shell.density();
        }
        let [mut mass, mut thickness] = [0.0; 2];
        for ply in &self.plies {
            mass += ply.material(shell).density()? * ply.thickness.get();
            thickness += ply.thickness.get();
        }
        Some(mass / thickness)
    }
}
