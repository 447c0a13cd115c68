//! One body of a scene with all that the scene says of it: what checks and builders of a body alone take.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Deref;

use sph_core::Vec3;

use super::analysis::Analysis;
use super::curve::Probe;
use super::error::SceneError;
use super::glued::glued;
use super::imperfection::Imperfection;
use super::joints::joints;
use super::linked::links;
use super::loads::Load;
use super::output::Output;
use super::owner::Owner;
use super::problem::{BodyScene, Scene};
use super::rigid::RigidScene;
use super::scope::Scope;
use super::sets::Region;
use super::shell::ShellScene;
use super::solid::SolidScene;
use super::source::Source;
use super::supports::Support;

/// Gravity on a body \[L/T²\]: the sum of what is said of it.
pub(crate) fn gravity_on(scene: &Scene, name: &str) -> Vec3 {
    let on = |(i, load): (usize, &Load)| match Owner::of(scene, &format!("loads[{i}].on"), &load.on) {
        Ok(Owner::Every) => load.gravity,
        Ok(Owner::Of(body, _)) if body == name => load.gravity,
        _ => None,
    };
    let all = scene.loads.iter().enumerate().filter_map(on);
    all.fold(Vec3::zeros(), |sum, gravity| sum + Vec3::from(gravity.acceleration))
}

/// A support, a load or a column of the scene, as one body sees it.
#[derive(Clone, Debug)]
pub(crate) struct OnSet<'a, T> {
    /// Where it stands in the scene, such as `supports[3]`.
    pub path: String,
    /// Its set, without the name of the body.
    pub on: &'a str,
    item: &'a T,
}

impl<'a, T> OnSet<'a, T> {
    /// The item at a path, on a set of the body.
    pub(crate) fn new(path: String, on: &'a str, item: &'a T) -> Self {
        Self { path, on, item }
    }

    /// Where one of its keys stands.
    pub(crate) fn at(&self, key: &str) -> String {
        format!("{}.{key}", self.path)
    }
}

impl<T> Deref for OnSet<'_, T> {
    type Target = T;

    fn deref(&self) -> &T {
        self.item
    }
}

/// One body with its sets, the supports, loads and columns that name it, and what the scene asks.
#[derive(Clone, Debug)]
pub(crate) struct BodyInScene<'a> {
    pub scene: &'a Scene,
    pub name: &'a str,
    pub body: &'a BodyScene,
    pub analysis: &'a Analysis,
    pub output: &'a Output,
    pub source: &'a Source,
    pub sets: BTreeMap<&'a str, &'a Region>,
    pub supports: Vec<OnSet<'a, Support>>,
    pub loads: Vec<OnSet<'a, Load>>,
    /// Columns that the body answers of itself: what a fluid does to a structure stays out.
    pub curve: Vec<OnSet<'a, Probe>>,
    /// Whether there are other bodies.
    pub together: bool,
    /// Whether it is built together with a fluid, or is one.
    pub in_fluid: bool,
    /// Whether a spring, a link or glue joins it to another body, or a link to the ground.
    pub joined: bool,
    /// Whether a link does.
    pub linked: bool,
    /// Whether glue does.
    pub glued: bool,
}

impl<'a> BodyInScene<'a> {
    /// The body of this name.
    ///
    /// # Errors
    /// [`SceneError::Set`] for a set that names no body.
    pub(crate) fn new(scene: &'a Scene, name: &'a str, body: &'a BodyScene) -> Result<Self, SceneError> {
        let (together, in_fluid) = (scene.is_together(), scene.fluid().is_some());
        let structure =
            in_fluid && matches!(body, BodyScene::Shell(_) | BodyScene::Solid(_) | BodyScene::Rigid(_));
        let joints = joints(scene)?;
        let glued = together && glued(scene)?.iter().any(|glue| glue.is_of(name));
        let linked = links(scene)?.iter().any(|link| link.is_of(name));
        let mut supports = on_body(scene, name, "supports", &scene.supports, |support| &support.on)?;
        supports.retain(|support| joints.iter().all(|joint| joint.path != support.path));
        let sets = scene.sets.iter().map(|(name, region)| (name.as_str(), region));
        let of_it = |region: &Region| scene.owner_of(region).is_none_or(|of| of == name);
        Ok(Self {
            scene,
            name,
            body,
            analysis: &scene.analysis,
            output: &scene.output,
            source: &scene.source,
            sets: sets.filter(|(_, region)| !together || of_it(region)).collect(),
            supports,
            loads: on_body(scene, name, "loads", &scene.loads, |load| &load.on)?,
            curve: on_body(scene, name, "curve", &scene.curve, |column| &column.on)?
                .into_iter()
                .filter(|column| !(structure && column.of.is_of_contact()))
                .collect(),
            together,
            in_fluid,
            linked,
            joined: glued
                || linked
                || joints.iter().any(|joint| joint.ends.iter().any(|(body, _)| *body == name)),
            glued,
        })
    }

    /// The shell, if the body is one.
    pub(crate) fn as_shell(&self) -> Option<&'a ShellScene> {
        if let BodyScene::Shell(shell) = self.body { Some(shell) } else { None }
    }

    /// The solid, if the body is one.
    pub(crate) fn as_solid(&self) -> Option<&'a SolidScene> {
        if let BodyScene::Solid(solid) = self.body { Some(solid) } else { None }
    }

    /// The rigid body, if the body is one.
    pub(crate) fn as_rigid(&self) -> Option<&'a RigidScene> {
        if let BodyScene::Rigid(rigid) = self.body { Some(rigid) } else { None }
    }

    /// Where the keys of the scene stand.
    pub(crate) fn scope(&self) -> Scope<'a> {
        self.source.scope("")
    }

    /// Where the keys of the body stand.
    pub(crate) fn body_scope(&self) -> Scope<'a> {
        self.source.body(self.name, self.body.word())
    }

    /// A name of one of its sets without the name of the body, at the other end of a spring: both ends are of one body.
    pub(crate) fn own_set<'b>(&self, set: &'b str) -> &'b str {
        let rest = set.strip_prefix(self.name).and_then(|rest| rest.strip_prefix('.'));
        rest.filter(|_| self.together).unwrap_or(set)
    }

    /// Names of its sets, and of those that they are made of.
    pub(crate) fn with_operands<'b>(&'b self, names: impl Iterator<Item = &'b str>) -> BTreeSet<&'b str> {
        let mut open: Vec<&str> = names.collect();
        let mut found = BTreeSet::new();
        while let Some(name) = open.pop() {
            let Some((_, sets)) = self.sets.get(name).and_then(|region| region.made()) else {
                found.insert(name);
                continue;
            };
            if found.insert(name) {
                open.extend(sets.iter().map(|set| self.own_set(set)));
            }
        }
        found
    }

    /// The deflection of the body before it is strained.
    pub(crate) fn imperfection(&self) -> Option<Imperfection> {
        match self.body {
            BodyScene::Shell(shell) => shell.imperfection,
            BodyScene::Solid(solid) => solid.imperfection,
            BodyScene::Fluid(_) | BodyScene::Walls(_) | BodyScene::Rigid(_) => None,
        }
    }

    /// Whether something else than its own supports and loads acts on it: other bodies, or links.
    pub(crate) fn is_united(&self) -> bool {
        self.together || !self.scene.links.is_empty()
    }

    /// Number of the support whose motion is all that drives an analysis that seeks the force along it.
    ///
    /// That it acts on one particle is known only after building; on more their displacement is prescribed.
    pub(crate) fn sole_motion(&self) -> Option<usize> {
        let mut motions = (0..self.supports.len()).filter(|&i| self.supports[i].motion().is_some());
        let first = motions.next().filter(|&i| self.supports[i].moved.is_some());
        let alone =
            self.loads.is_empty() && motions.next().is_none() && !self.may_touch() && !self.is_united();
        // All cases share what is free.
        let alone = alone && self.supports.iter().all(|support| support.case.is_none());
        first.filter(|_| alone && self.analysis.kind().seeks_force)
    }

    /// Whether it may touch tools, itself or another body.
    pub(crate) fn may_touch(&self) -> bool {
        match self.body {
            BodyScene::Shell(shell) => !(shell.tools.is_empty() && self.scene.contact.is_empty()),
            BodyScene::Solid(solid) => !(solid.tools.is_empty() && self.scene.contact.is_empty()),
            BodyScene::Rigid(rigid) => !(rigid.tools.is_empty() && self.scene.contact.is_empty()),
            BodyScene::Fluid(_) | BodyScene::Walls(_) => false,
        }
    }

    /// Whether any body of the scene may touch.
    pub(crate) fn any_may_touch(&self) -> bool {
        let tools = |body: &BodyScene| !body.tools().is_empty();
        !self.scene.contact.is_empty() || self.scene.bodies.values().any(tools)
    }

    /// Whether the shell has stresses of its own at the start.
    pub(crate) fn is_stressed(&self) -> bool {
        self.as_shell().is_some_and(|shell| !shell.initial_stress.is_empty())
    }

    /// Whether the level counts an initial stress: nothing else drives an analysis that wants to be driven.
    pub(crate) fn stress_drives(&self) -> bool {
        let kind = self.analysis.kind();
        let alone = self.loads.is_empty() && self.supports.iter().all(|support| support.motion().is_none());
        self.is_stressed() && alone && kind.wants_driver && kind.preloads
    }

    /// Whether anything is applied before the analysis.
    pub(crate) fn has_preload(&self) -> bool {
        let by_tools = self.as_shell().is_some_and(|shell| shell.tools.iter().any(|tool| tool.preload));
        let applied = by_tools
            || self.loads.iter().any(|load| load.preload)
            || self.supports.iter().any(|support| support.preload);
        applied || self.is_stressed() && self.analysis.kind().preloads && !self.stress_drives()
    }
}

/// A shell with all that its scene says of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShellInScene<'a> {
    view: &'a BodyInScene<'a>,
    pub shell: &'a ShellScene,
}

impl<'a> ShellInScene<'a> {
    /// The body, which is this shell.
    pub(crate) fn new(view: &'a BodyInScene<'a>, shell: &'a ShellScene) -> Self {
        Self { view, shell }
    }
}

impl<'a> Deref for ShellInScene<'a> {
    type Target = BodyInScene<'a>;

    fn deref(&self) -> &BodyInScene<'a> {
        self.view
    }
}

/// The items of a list that name a body, or all bodies.
fn on_body<'a, T>(
    scene: &'a Scene,
    name: &str,
    list: &str,
    items: &'a [T],
    set: impl Fn(&'a T) -> &'a String,
) -> Result<Vec<OnSet<'a, T>>, SceneError> {
    let mut found = Vec::with_capacity(items.len());
    for (i, item) in items.iter().enumerate() {
        let (path, on) = (format!("{list}[{i}]"), set(item));
        match Owner::of(scene, &format!("{path}.on"), on)? {
            Owner::Every => found.push(OnSet::new(path, on, item)),
            Owner::Of(body, set) if body == name => found.push(OnSet::new(path, set, item)),
            Owner::Of(..) => {}
        }
    }
    Ok(found)
}
