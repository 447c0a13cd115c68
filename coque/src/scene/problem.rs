//! The scene as a whole.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use super::analysis::Analysis;
use super::coupling::Coupling;
use super::curve::Probe;
use super::fluid::FluidScene;
use super::imperfection::Imperfection;
use super::loads::Load;
use super::output::Output;
use super::scope::Scope;
use super::sets::Region;
use super::shell::ShellScene;
use super::solid::SolidScene;
use super::source::{BODIES, Source};
use super::supports::Support;
use super::units::Units;
use super::velocity::Velocity;
use super::walls::WallsScene;

/// A problem: bodies, conditions, analysis, and what to record.
///
/// A `Scene` in hand has passed every check that needs no particles; [`Scene::build`] makes the others.
/// Dimensions are in the scene's own units.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Scene {
    /// One line that names the problem.
    pub title: String,
    /// The one consistent set of units.
    pub units: Units,
    /// Bodies by name, each of one kind: `[bodies.NAME.KIND]`. A lone shell may stand at the top of the scene without them.
    #[serde(default)]
    pub bodies: BTreeMap<String, BodyScene>,
    /// Particle sets by name, beside the built-in ones.
    #[serde(default)]
    pub sets: BTreeMap<String, Region>,
    /// Supports and prescribed motions.
    #[serde(default)]
    pub supports: Vec<Support>,
    /// Loads.
    #[serde(default)]
    pub loads: Vec<Load>,
    /// How to find answers.
    pub analysis: Analysis,
    /// How a fluid and the structures in it take turns.
    pub coupling: Option<Coupling>,
    /// Columns of the curve.
    #[serde(default)]
    pub curve: Vec<Probe>,
    /// Further results.
    #[serde(default)]
    pub output: Output,
    /// The text the scene was read from.
    #[serde(skip, default = "Source::none")]
    pub source: Source,
}

/// A body, of exactly one kind.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum BodyScene {
    /// A thin shell, one layer of particles on its mid-surface.
    Shell(ShellScene),
    /// A solid of nodes joined by bonds, which may break.
    Solid(SolidScene),
    /// A weakly compressible fluid of particles.
    Fluid(FluidScene),
    /// Rigid walls of a fluid.
    Walls(WallsScene),
}

impl BodyScene {
    /// Key of the kind in a scene.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Shell(_) => "shell",
            Self::Solid(_) => "solid",
            Self::Fluid(_) => "fluid",
            Self::Walls(_) => "walls",
        }
    }

    /// Velocity at the start.
    pub fn velocity(&self) -> Option<&Velocity> {
        match self {
            Self::Shell(shell) => shell.velocity.as_ref(),
            Self::Solid(solid) => solid.velocity.as_ref(),
            Self::Fluid(fluid) => fluid.velocity.as_ref(),
            Self::Walls(_) => None,
        }
    }
}

impl Scene {
    /// The one body, by name, of several the first: the checks leave no scene without.
    ///
    /// # Panics
    /// If `bodies` has been emptied since.
    fn named_body(&self) -> (&String, &BodyScene) {
        self.bodies.first_key_value().expect("a checked scene has a body")
    }

    /// The one body; of several the first by name.
    pub fn body(&self) -> &BodyScene {
        self.named_body().1
    }

    /// Name of the body; `shell` where the scene does not give one.
    pub fn body_name(&self) -> &str {
        self.named_body().0
    }

    /// The shell, if the body is one.
    pub fn as_shell(&self) -> Option<&ShellScene> {
        match self.body() {
            BodyScene::Shell(shell) => Some(shell),
            _ => None,
        }
    }

    /// The solid, if the body is one.
    pub fn as_solid(&self) -> Option<&SolidScene> {
        match self.body() {
            BodyScene::Solid(solid) => Some(solid),
            _ => None,
        }
    }

    /// Whether all bodies lie in a plane and none has a thickness of its own: forces and energies are then those of a unit of depth.
    pub(crate) fn is_by_depth(&self) -> bool {
        self.bodies.values().all(|body| match body {
            BodyScene::Shell(_) => false,
            BodyScene::Solid(solid) => {
                let block = solid.geometry.block.as_ref();
                solid.dimensions() == 2 && block.is_some_and(|block| block.thickness.is_none())
            }
            BodyScene::Fluid(fluid) => fluid.dimensions() == 2,
            BodyScene::Walls(_) => true,
        })
    }

    /// The deflection of the one body before it is strained.
    pub(crate) fn imperfection(&self) -> Option<Imperfection> {
        match self.body() {
            BodyScene::Shell(shell) => shell.imperfection,
            BodyScene::Solid(solid) => solid.imperfection,
            BodyScene::Fluid(_) | BodyScene::Walls(_) => None,
        }
    }

    /// The fluid with its name, of whatever other bodies there are.
    pub fn fluid(&self) -> Option<(&str, &FluidScene)> {
        self.bodies.iter().find_map(|(name, body)| match body {
            BodyScene::Fluid(fluid) => Some((name.as_str(), fluid)),
            _ => None,
        })
    }

    /// The shell of a scene that is known to have one.
    ///
    /// # Panics
    /// If the body is of another kind; [`Scene::as_shell`] asks.
    pub fn shell(&self) -> &ShellScene {
        self.as_shell().expect("the body is a shell")
    }

    /// The same, to change it; [`Scene::build`] checks it anew.
    ///
    /// # Panics
    /// If the body is of another kind.
    pub fn shell_mut(&mut self) -> &mut ShellScene {
        match self.bodies.values_mut().next() {
            Some(BodyScene::Shell(shell)) => shell,
            _ => panic!("the body is a shell"),
        }
    }

    /// Number of the support whose motion is all that drives an analysis that seeks the force along it.
    ///
    /// That it acts on one particle is known only after building; on more their displacement is prescribed.
    pub(crate) fn sole_motion(&self) -> Option<usize> {
        let mut motions = (0..self.supports.len()).filter(|&i| self.supports[i].motion().is_some());
        let first = motions.next().filter(|&i| self.supports[i].moved.is_some());
        let alone = self.loads.is_empty() && motions.next().is_none();
        first.filter(|_| alone && self.analysis.kind().seeks_force)
    }

    /// Takes the name of the one body off the sets that are named with it: `strip.u1` becomes `u1`.
    pub(super) fn drop_body_names(&mut self) {
        let alone = self.bodies.len() == 1 && self.source.has(BODIES);
        let Some(body) = self.bodies.keys().next().filter(|_| alone) else { return };
        let supports = self.supports.iter_mut().flat_map(Support::sets_mut);
        let loads = self.loads.iter_mut().map(|load| &mut load.on);
        let columns = self.curve.iter_mut().map(|column| &mut column.on);
        for on in supports.chain(loads).chain(columns).filter(|on| !self.sets.contains_key(*on)) {
            if let Some(set) = on.strip_prefix(body).and_then(|rest| rest.strip_prefix('.')) {
                *on = set.into();
            }
        }
    }

    /// Where the keys of the scene stand.
    pub(crate) fn scope(&self) -> Scope<'_> {
        self.source.scope("")
    }

    /// Where the keys of the body stand.
    pub(crate) fn body_scope(&self) -> Scope<'_> {
        let (name, body) = self.named_body();
        self.source.body(name, body.word())
    }
}
