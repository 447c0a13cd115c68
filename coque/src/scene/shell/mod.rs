//! The shell of a scene.

pub(crate) mod by_temperature;
pub(crate) mod formulation;
pub(crate) mod geometry;
pub(crate) mod initial_stress;
pub(crate) mod material;
pub(crate) mod mesh;
pub(crate) mod parts;
pub(crate) mod plastic;
pub(crate) mod plies;
pub(crate) mod rubber;
pub(crate) mod section;
pub(crate) mod stiffeners;
pub(crate) mod strength;

use schemars::JsonSchema;
use serde::Deserialize;
use sph_shell::WetFaces;

use formulation::{Formulation, STRETCH_CORRECTED};
use geometry::{Geometry, Orientation, Placed};
use initial_stress::InitialStress;
use material::Material;
use parts::{LumpedMass, RigidBody, ShellPart, ShellTie};
use section::Section;
use stiffeners::StiffenerScene;

use super::imperfection::Imperfection;
use super::tools::ToolScene;
use super::velocity::Velocity;

/// A thin shell: its mid-surface, what it is made of, and the particle method.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShellScene {
    /// Shape of the mid-surface and its particles.
    pub geometry: Geometry,
    /// Rotation of geometry, conditions and probes together.
    pub orientation: Option<Orientation>,
    /// What the shell is made of.
    pub material: Material,
    /// How the material fills the thickness.
    pub section: Section,
    /// Cells with a material, section or height of their own.
    #[serde(default)]
    pub parts: Vec<ShellPart>,
    /// Masses lumped at particles; they count in time, in modes and under gravity on all.
    #[serde(default)]
    pub masses: Vec<LumpedMass>,
    /// Edges that run along another sheet without sharing its particles.
    #[serde(default)]
    pub ties: Vec<ShellTie>,
    /// Bars along lines of particles, such as stringers, frames and rings.
    #[serde(default)]
    pub stiffeners: Vec<StiffenerScene>,
    /// Sets that move as one rigid body each.
    #[serde(default)]
    pub rigid: Vec<RigidBody>,
    /// Rigid tools that it may touch.
    #[serde(default)]
    pub tools: Vec<ToolScene>,
    /// Stresses of cells before anything is strained.
    #[serde(default)]
    pub initial_stress: Vec<InitialStress>,
    /// The particle method; left out, `stress-point`.
    #[serde(default)]
    pub formulation: Formulation,
    /// Where in space the shape stands; left out, where its geometry says. Sets, conditions and probes stay in space.
    pub placed: Option<Placed>,
    /// Deflection of the unstrained body.
    pub imperfection: Option<Imperfection>,
    /// Which of its faces a fluid wets; left out, both.
    pub wet: Option<WetFaces>,
    /// Velocity at the start, in transient runs.
    pub velocity: Option<Velocity>,
}

impl ShellScene {
    /// Name of the strain measure: as the method says, else what the material wants.
    pub fn curvature(&self) -> &str {
        self.formulation.curvature().unwrap_or_else(|| self.measure_of_law().unwrap_or(STRETCH_CORRECTED))
    }

    /// The one strain measure that its law is written in, where it is not that of small strains.
    pub(crate) fn measure_of_law(&self) -> Option<&'static str> {
        self.section.materials(&self.material).into_iter().find_map(Material::curvature)
    }

    /// Whether it yields where no part has a law of its own.
    pub(crate) fn yields_itself(&self) -> bool {
        self.section.materials(&self.material).into_iter().any(Material::yields)
    }

    /// Whether it yields, or one of its parts does.
    pub(crate) fn yields(&self) -> bool {
        self.yields_itself() || (0..self.parts.len()).any(|part| self.in_part(part).yields_itself())
    }

    /// The first of its materials, where no part has one of its own, whose yield stress grows with the rate: its place among the plies, if it is one of theirs.
    pub(crate) fn rated(&self) -> Option<Option<usize>> {
        let rated = |material: &Material| matches!(material, Material::Plastic(own) if own.rate.is_some());
        let Section::Layered(section) = &self.section else { return rated(&self.material).then_some(None) };
        let of_ply = |ply: &plies::Ply| rated(ply.material(&self.material));
        let number = section.plies.iter().position(of_ply)?;
        Some(section.plies[number].material.is_some().then_some(number))
    }

    /// Mass per volume, the mean over the thickness \[F T²/L⁴\], where the scene gives it.
    pub(crate) fn density(&self) -> Option<f64> {
        match &self.section {
            Section::Layered(section) => section.density(&self.material),
            Section::Homogeneous(_) | Section::Stiffness(_) | Section::File(_) => self.material.density(),
        }
    }

    /// Whether a fluid wets both of its faces.
    pub(crate) fn wets_both(&self) -> bool {
        self.wet.unwrap_or_default() == WetFaces::Both
    }

    /// Number of the rigid body that a set is, if it is one.
    pub(crate) fn rigid_body(&self, set: &str) -> Option<usize> {
        self.rigid.iter().position(|body| body.on == set)
    }

    /// Keys of a shell: at the top of a scene they mean a lone shell.
    pub(crate) const WORDS: [&'static str; 15] = [
        "geometry",
        "orientation",
        "material",
        "section",
        "parts",
        "masses",
        "ties",
        "stiffeners",
        "rigid",
        "tools",
        "initial_stress",
        "formulation",
        "velocity",
        "placed",
        "imperfection",
    ];
}
