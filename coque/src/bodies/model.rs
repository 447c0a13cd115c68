//! A body with what is asked of it, ready to run.

use std::collections::BTreeMap;
use std::fmt;

use explicit_dynamics::Exert;
use sph_core::{Cell, Vec3};

use super::body::{Description, PrescribedPoint, Shape};
use super::contacts_of_scene::ContactsOfScene;
use super::in_water::InStillWater;
use super::memory::Memory;
use super::one_process::{NotShared, OneProcess};
use super::probe::Probe;
use super::ready::Ready;
use crate::Warning;
use crate::ranks::Ranks;
use crate::results::curve::Column;
use crate::scene::units::{Quantity, Units};
use crate::scene::{Analysis, CASE, Checked, Output, Scene, phase_of};

/// What is asked of a body, whatever it is made of.
#[derive(Clone, Debug)]
pub struct Task {
    /// One line that names the problem.
    pub title: String,
    /// Units of all numbers.
    pub units: Units,
    /// How to find answers.
    pub analysis: Analysis,
    /// Further results.
    pub output: Output,
}

impl Task {
    /// What a scene asks of its body.
    pub fn of(scene: &Scene) -> Self {
        let Scene { title, units, analysis, output, .. } = scene;
        let units = Units { by_depth: scene.is_by_depth(), ..*units };
        let mut analysis = analysis.clone();
        // What shakes a shell turns with its conditions.
        let turn = scene.as_shell().and_then(|shell| shell.orientation);
        if let Some(turn) = turn {
            for acceleration in analysis.shaken_mut() {
                *acceleration = (turn.rotation() * Vec3::from(*acceleration)).into();
            }
        }
        Self { title: title.clone(), units, analysis, output: output.clone() }
    }
}

/// A body ready to be run, with what its curve measures.
pub struct Model {
    /// What is asked of it.
    pub task: Task,
    /// The body.
    pub body: Ready,
    /// What it is.
    pub description: Description,
    /// What a run will need, and what there is.
    pub memory: Memory,
    /// Particles by name of their set, of each body that has sets, where the scene asks for fields; a body alone in its scene goes by its
    /// kind.
    pub sets: BTreeMap<String, BTreeMap<String, Vec<u32>>>,
    pub(crate) identity: Identity,
    pub(crate) probes: Vec<Probe>,
    /// The prescribed motion whose force is sought, in analyses without time.
    pub(crate) driven: Option<PrescribedPoint>,
    pub(crate) threads: usize,
    pub(crate) warnings: Vec<Warning>,
    pub(crate) judge: Option<ShapeJudge>,
    /// The contacts of its scene by name, and what nothing keeps apart.
    pub(crate) contacts: ContactsOfScene,
    /// Its scene, where the errors of its numbers are asked for.
    pub(crate) barred: Option<Box<Checked>>,
    /// Its scene, where that has load cases.
    pub(crate) cases: Option<Box<Checked>>,
    /// Its scene, where bases shake it one by one.
    pub(crate) shaken: Option<Box<Checked>>,
    /// The still water about it, where its modes are sought in some.
    pub(crate) water: Option<Box<InStillWater>>,
    /// Changes of the state from one level to the next, from which the levels of a static analysis start; none where each starts at the one
    /// before.
    pub(crate) increments: Vec<Vec<f64>>,
    /// Those who run it together; none where one process does.
    pub(crate) ranks: Option<Ranks>,
    /// What its work is done in, on the thread that does it; nothing where none is asked for.
    pub(crate) surrounding: Option<Surrounding>,
}

/// Calls what it is given, once, on the same thread: the place for what a thread needs before it may be called back on.
pub type Surrounding = fn(&mut (dyn FnMut() + Send));

/// Why no function can exert forces on a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoPush {
    /// Its analysis does not march.
    #[error(
        "a function exerts forces in marches only, in analysis.explicit.transient and analysis.explicit.quasi-static, not in {0}; \
         give the scene a load in its place"
    )]
    Timeless(&'static str),
    /// It is of another kind.
    #[error(
        "a function exerts forces on a shell or a solid that is alone in its scene, not on a body of the kind {0}"
    )]
    Body(&'static str),
    /// Several processes run it already.
    #[error("a function exerts forces on what one process runs; give it before the model is shared")]
    Shared,
}

/// Looks for warnings in the shapes that a body of such cells took.
pub(crate) type ShapeJudge = Box<dyn Fn(&[Cell], &[Shape]) -> Vec<Warning> + Send>;

/// What tells a body from another with the same particles.
#[derive(Clone, Debug, Default)]
pub(crate) struct Identity {
    /// The file that its surface was read from.
    pub file: Option<String>,
    /// Checksum of that file.
    pub checksum: Option<u32>,
}

impl Model {
    /// A body that no scene describes, with what its curve measures; it runs on one thread.
    pub fn new(task: Task, body: Ready, description: Description, probes: Vec<Probe>) -> Self {
        Self {
            task,
            body,
            description,
            memory: Memory::default(),
            identity: Identity::default(),
            probes,
            driven: None,
            threads: 1,
            warnings: Vec::new(),
            judge: None,
            contacts: ContactsOfScene::default(),
            barred: None,
            cases: None,
            shaken: None,
            water: None,
            increments: Vec::new(),
            ranks: None,
            surrounding: None,
            sets: BTreeMap::new(),
        }
    }

    /// What is known beforehand to make its numbers wrong, and why.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// Lets a function of the caller exert forces on the particles in every step in time; their work is external. Such a run keeps no
    /// checkpoint: what the function remembers is not its own.
    ///
    /// # Errors
    /// [`NoPush`] of an analysis that does not march, and of bodies other than a shell or a solid alone.
    pub fn push(&mut self, exert: Exert) -> Result<(), NoPush> {
        let kind = self.task.analysis.kind();
        let Ready::Dynamic(body) = &mut self.body else { return Err(NoPush::Timeless(kind.name)) };
        if self.ranks.is_some() {
            return Err(NoPush::Shared);
        }
        body.push(exert).map_err(|_| NoPush::Body(self.description.kind))?;
        self.task.output.checkpoint_every = None;
        self.description.left_out.retain(|line| line != "loads");
        self.description.modelled.push("forces that a function of the caller exerts".into());
        Ok(())
    }

    /// Does its work in such a function, on whichever thread does it: the one that calls, or one of its own pool, once for a run or for
    /// each [`crate::Simulation::advance`].
    pub fn surround(&mut self, surrounding: Surrounding) {
        self.surrounding = Some(surrounding);
    }

    /// Runs it with others, each of whom has built the same model and calls this; the first of them has the results of all.
    ///
    /// # Errors
    /// [`OneProcess`].
    pub fn share(&mut self, ranks: &Ranks) -> Result<(), OneProcess> {
        let (analysis, started) = (self.task.analysis.kind().word, ranks.number());
        if self.barred.is_some() {
            return Err(OneProcess::Errors { started });
        }
        let shared = match (&mut self.body, &self.task.analysis) {
            (Ready::Dynamic(body), _) => body.share(ranks),
            (Ready::Static(body), Analysis::Relaxation(_)) => body.share(ranks),
            _ => return Err(OneProcess::Timeless { analysis, started }),
        };
        let kind = self.description.kind;
        shared.map_err(|what| match what {
            NotShared::Kind => OneProcess::Kind { kind, analysis, started },
            part => OneProcess::Part { what: part, started },
        })?;
        self.ranks = Some(ranks.clone());
        Ok(())
    }

    /// Names of the columns that its scene measures.
    pub fn measured(&self) -> Vec<String> {
        let own = self.probes.iter().flat_map(|probe| probe.columns(&self.task.units));
        own.map(|column| column.name).collect()
    }

    /// The columns of the analysis with their units, and those of the probes.
    ///
    /// `level` is a force where a prescribed motion drives an analysis that finds the load, and the share of that motion
    /// where the level is given.
    pub(crate) fn columns(&self) -> Vec<Column> {
        let Task { analysis, units, .. } = &self.task;
        let force = self.driven.is_some() && !matches!(analysis, Analysis::Static(_) | Analysis::Linear(_));
        let quantity = |name: &str| match name {
            "time" => Quantity::Time,
            "level" if force => Quantity::Force,
            CASE
            | "base"
            | "level"
            | "iterations"
            | "negative_pivots"
            | "mode"
            | "residual"
            | "unbalanced"
            | "remaining_displacement" => Quantity::Ratio,
            "circular_frequency" | "frequency" => Quantity::Rate,
            "step_error" => Quantity::Temperature,
            "supplied" | "held" | "film" | "radiated" => Quantity::HeatFlow,
            _ => Quantity::Energy,
        };
        let unit = |name: &str| units.symbol(quantity(name));
        let kind = analysis.kind();
        let case = self.cases.as_ref().map(|_| CASE);
        let always = case
            .into_iter()
            .chain(analysis.columns())
            .map(|name| Column { name: name.into(), unit: unit(name) });
        let swings = matches!(analysis, Analysis::Harmonic(_));
        let phase = |name: &str| Column { name: phase_of(name), unit: units.symbol(Quantity::Angle) };
        let own = self.probes.iter().filter(|_| !kind.gives_modes);
        let own = own.flat_map(|probe| probe.columns(units).chain(swings.then(|| phase(&probe.name))));
        let time = units.symbol(Quantity::Time);
        let noisy = matches!(analysis, Analysis::RandomVibration(_));
        let own = own.map(|column| if noisy { column.density(&time) } else { column });
        always.chain(own).collect()
    }
}

impl fmt::Debug for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Model").field("description", &self.description).finish_non_exhaustive()
    }
}
