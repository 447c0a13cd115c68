//! A body with what is known of it, before it is made ready for its analysis or put beside others.

use std::collections::BTreeMap;

use super::body::{Description, PrescribedPoint};
use super::contacts_of_scene::ContactsOfScene;
use super::memory::Memory;
use super::model::{Identity, Model, ShapeJudge, Task};
use super::probe::Probe;
use super::ready::Ready;
use crate::Warning;
use crate::scene::Scene;

/// A body as its builder made it.
pub(super) struct BuiltBody<B> {
    /// The body.
    pub body: B,
    /// What it is.
    pub description: Description,
    /// What a run of it alone will need, and what there is.
    pub memory: Memory,
    /// What tells it from another with the same particles.
    pub identity: Identity,
    /// The columns that its scene measures on it.
    pub probes: Vec<Probe>,
    /// The prescribed motion whose force is sought.
    pub driven: Option<PrescribedPoint>,
    /// What is known beforehand to make its numbers wrong.
    pub warnings: Vec<Warning>,
    /// Who looks for warnings in the shapes that it took.
    pub judge: Option<ShapeJudge>,
    /// Its particles by name of their set.
    pub sets: BTreeMap<String, Vec<u32>>,
}

impl<B> BuiltBody<B> {
    /// The same with another body in its place.
    pub fn map<T>(self, body: impl FnOnce(B) -> T) -> BuiltBody<T> {
        let Self { body: own, description, memory, identity, probes, driven, warnings, judge, sets } = self;
        BuiltBody { body: body(own), description, memory, identity, probes, driven, warnings, judge, sets }
    }
}

impl BuiltBody<Ready> {
    /// The body with what its scene asks of it.
    pub fn model(self, scene: &Scene, threads: usize) -> Model {
        let Self { body, description, memory, identity, probes, driven, warnings, judge, sets } = self;
        let (task, threads) = (Task::of(scene), threads.max(1));
        let shown = task.output.fields.is_some();
        let sets = if shown { [(description.kind.to_string(), sets)].into() } else { BTreeMap::new() };
        let barred = None;
        Model {
            task,
            body,
            description,
            memory,
            identity,
            probes,
            driven,
            threads,
            warnings,
            judge,
            contacts: ContactsOfScene::default(),
            sets,
            barred,
            cases: None,
            shaken: None,
            water: None,
            increments: Vec::new(),
            ranks: None,
            surrounding: None,
        }
    }
}
