//! The scene as a whole.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use mesh_io::surface::Arrays;
use schemars::JsonSchema;
use serde::Deserialize;

use super::analysis::Analysis;
use super::column_unit::ColumnUnit;
use super::contact::ContactScene;
use super::coupling::Coupling;
use super::curve::{Measured, Probe};
use super::fluid::FluidScene;
use super::glue::GlueScene;
use super::heat::HeatScene;
use super::links::LinkScene;
use super::loads::Load;
use super::output::{ErrorBars, Output};
use super::rigid::RigidScene;
use super::rigid_joints::JointScene;
use super::scope::Scope;
use super::sets::Region;
use super::shell::ShellScene;
use super::solid::SolidScene;
use super::source::{BODIES, Source};
use super::supports::Support;
use super::tools::ToolScene;
use super::units::{Quantity, Units};
use super::velocity::Velocity;
use super::walls::WallsScene;

/// A problem: bodies, conditions, analysis, and what to record.
///
/// Dimensions are in the scene's own units.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Scene {
    /// One line that names the problem.
    pub title: String,
    /// The one consistent set of units.
    pub units: Units,
    /// Scene files whose tables are taken where this one has none, paths from its folder; their lists of tables come after its own.
    #[serde(default)]
    pub include: Vec<String>,
    /// Numbers by names of your own. Where a number is expected, a text such as `"2 * ${NAME}"` is an expression of them.
    #[serde(default)]
    pub parameters: BTreeMap<String, f64>,
    /// Texts of files that records name, by those names: what stands here is not looked for on the disk. The copy of a scene beside its results holds
    /// all that it read.
    #[serde(default)]
    pub files: BTreeMap<String, String>,
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
    /// What holds the temperature of a shell and gives it heat, which it conducts.
    #[serde(default)]
    pub heat: Vec<HeatScene>,
    /// Surfaces that may touch.
    #[serde(default)]
    pub contact: Vec<ContactScene>,
    /// Sets of bodies that are glued to the surfaces of others.
    #[serde(default)]
    pub glue: Vec<GlueScene>,
    /// Springs by a table, cables, gaps and dashpots between sets and to the ground.
    #[serde(default)]
    pub links: Vec<LinkScene>,
    /// Hinges, sliders and ball joints of rigid bodies.
    #[serde(default)]
    pub joints: Vec<JointScene>,
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
    /// Whether every number has its error beside it: a run into a folder is followed by runs on other lattices. Sweeps leave it out.
    pub error: Option<ErrorBars>,
    /// Surfaces in memory, by the names under which `geometry.mesh.file` calls them; other names are files.
    #[serde(skip)]
    pub surfaces: BTreeMap<String, Arc<Arrays>>,
    /// Numbers by particle in memory, by the names under which `values` calls them.
    #[serde(skip)]
    pub arrays: BTreeMap<String, Arc<Vec<f64>>>,
    /// Whether it is what another scene is under one of its load cases, which was held against the memory of the machine; no scene writes it.
    #[serde(skip)]
    pub is_load_set: bool,
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
    /// A rigid body with a closed surface.
    Rigid(RigidScene),
}

impl BodyScene {
    /// Key of the kind in a scene.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Shell(_) => "shell",
            Self::Solid(_) => "solid",
            Self::Fluid(_) => "fluid",
            Self::Walls(_) => "walls",
            Self::Rigid(_) => "rigid",
        }
    }

    /// Velocity at the start.
    pub fn velocity(&self) -> Option<&Velocity> {
        match self {
            Self::Shell(shell) => shell.velocity.as_ref(),
            Self::Solid(solid) => solid.velocity.as_ref(),
            Self::Fluid(fluid) => fluid.velocity.as_ref(),
            Self::Walls(_) => None,
            Self::Rigid(rigid) => rigid.velocity.as_ref(),
        }
    }

    /// Rigid tools that it may touch.
    pub fn tools(&self) -> &[ToolScene] {
        match self {
            Self::Shell(shell) => &shell.tools,
            Self::Solid(solid) => &solid.tools,
            Self::Rigid(rigid) => &rigid.tools,
            Self::Fluid(_) | Self::Walls(_) => &[],
        }
    }
}

impl Scene {
    /// The number of the joint of this name.
    pub(crate) fn joint(&self, name: &str) -> Option<usize> {
        self.joints.iter().position(|joint| joint.name.as_deref() == Some(name))
    }

    /// The shell, if the one body is one; of several the first by name.
    pub fn as_shell(&self) -> Option<&ShellScene> {
        if let Some(BodyScene::Shell(shell)) = self.bodies.values().next() { Some(shell) } else { None }
    }

    /// The solid, if the one body is one; of several the first by name.
    pub fn as_solid(&self) -> Option<&SolidScene> {
        if let Some(BodyScene::Solid(solid)) = self.bodies.values().next() { Some(solid) } else { None }
    }

    /// Whether bodies are built together: several, or a fluid with its walls and the structures in it.
    pub(crate) fn is_together(&self) -> bool {
        self.bodies.len() > 1 || self.fluid().is_some()
    }

    /// Whether all bodies lie in a plane and none has a thickness of its own: forces and energies are then those of a unit of depth.
    pub(crate) fn is_by_depth(&self) -> bool {
        self.bodies.values().all(|body| match body {
            BodyScene::Shell(_) | BodyScene::Rigid(_) => false,
            BodyScene::Solid(solid) => {
                let block = solid.geometry.block.as_ref();
                solid.dimensions() == 2 && block.is_some_and(|block| block.thickness.is_none())
            }
            BodyScene::Fluid(fluid) => fluid.dimensions() == 2,
            BodyScene::Walls(_) => true,
        })
    }

    /// What a column measures, by depth where the bodies or the fluid that it is read from are plane.
    pub(crate) fn quantity(&self, of: Measured) -> Quantity {
        let plane = self.fluid().is_some_and(|(_, fluid)| fluid.dimensions() == 2);
        let of_fluid = plane && matches!(of, Measured::Force | Measured::Moment | Measured::Flux);
        let quantity = of.quantity();
        if of_fluid || self.is_by_depth() { quantity.by_depth() } else { quantity }
    }

    /// The unit that a column names; none if it names none that fits.
    pub(crate) fn unit_of(&self, column: &Probe) -> Option<ColumnUnit> {
        let unit = column.unit.as_ref()?;
        if unit == "-" && column.factor != 1.0 {
            return Some(ColumnUnit { symbol: unit.clone(), factor: 1.0 });
        }
        ColumnUnit::named(unit, self.quantity(column.of), &self.units)
    }

    /// The fluid with its name, of whatever other bodies there are.
    pub fn fluid(&self) -> Option<(&str, &FluidScene)> {
        self.bodies.iter().find_map(|(name, body)| match body {
            BodyScene::Fluid(fluid) => Some((name.as_str(), fluid)),
            _ => None,
        })
    }

    /// Bodies that a fluid wets.
    pub(crate) fn structures(&self) -> impl Iterator<Item = (&str, &BodyScene)> {
        let wet = |body: &BodyScene| {
            matches!(body, BodyScene::Shell(_) | BodyScene::Solid(_) | BodyScene::Rigid(_))
        };
        self.bodies.iter().filter(move |(_, body)| wet(body)).map(|(name, body)| (name.as_str(), body))
    }

    /// Takes the name of the one body off the sets that are named with it: `strip.u1` becomes `u1`.
    pub(super) fn drop_body_names(&mut self) {
        let alone = self.bodies.len() == 1 && self.source.has(BODIES);
        let Some(body) = self.bodies.keys().next().filter(|_| alone) else { return };
        let supports = self.supports.iter_mut().flat_map(Support::sets_mut);
        let loads = self.loads.iter_mut().map(|load| &mut load.on);
        let columns = self.curve.iter_mut().map(|column| &mut column.on);
        let links =
            self.links.iter_mut().flat_map(|LinkScene { on, to, .. }| std::iter::once(on).chain(to.as_mut()));
        let heat = self.heat.iter_mut().map(|heat| &mut heat.on);
        let all = supports.chain(loads).chain(columns).chain(links).chain(heat);
        for on in all.filter(|on| !self.sets.contains_key(*on)) {
            if let Some(set) = own_name(body, on) {
                *on = set.into();
            }
        }
        let declared: BTreeSet<String> = self.sets.keys().cloned().collect();
        let made = self.sets.values_mut().flat_map(Region::names_mut);
        for name in made.filter(|name| !declared.contains(*name)) {
            if let Some(set) = own_name(body, name) {
                *name = set.into();
            }
        }
    }

    /// The body whose set a declared set is: as it says, or as the sets say that it is made of; none where nothing says so.
    pub(crate) fn owner_of<'a>(&'a self, region: &'a Region) -> Option<&'a str> {
        if let Some(of) = &region.of {
            return Some(of);
        }
        let body = |name: &'a String| match self.sets.get(name) {
            Some(inner) => self.owner_of(inner),
            None => {
                let (body, _) = name.split_once('.')?;
                self.bodies.contains_key(body).then_some(body)
            }
        };
        region.made()?.1.iter().find_map(body)
    }

    /// Where the keys of the scene stand.
    pub(crate) fn scope(&self) -> Scope<'_> {
        self.source.scope("")
    }
}

/// A name of a set without that of its body; none if it is not named with it.
fn own_name<'a>(body: &str, name: &'a str) -> Option<&'a str> {
    name.strip_prefix(body)?.strip_prefix('.')
}
