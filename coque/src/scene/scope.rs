//! Where in a scene the keys of one of its parts stand, so that a check serves a body in either form.

use super::error::{Fault, SceneError};
use super::source::{BODIES, Source};

/// A part of a scene: refusals name keys by their path from here, with the path to here before it.
#[derive(Clone, Debug)]
pub(crate) struct Scope<'a> {
    source: &'a Source,
    /// Path to the part, with the dot behind it; empty at the top.
    prefix: String,
}

impl Source {
    /// The part of the scene below a path.
    pub(crate) fn scope(&self, path: &str) -> Scope<'_> {
        let prefix = if path.is_empty() { String::new() } else { format!("{path}.") };
        Scope { source: self, prefix }
    }

    /// The keys of a body: at the top where the scene has the short form.
    pub(crate) fn body(&self, name: &str, kind: &str) -> Scope<'_> {
        match self.has(BODIES) {
            true => self.scope(&format!("{BODIES}.{name}.{kind}")),
            false => self.scope(""),
        }
    }
}

impl Scope<'_> {
    /// A part of this part.
    pub(crate) fn below(&self, path: &str) -> Self {
        Self { source: self.source, prefix: format!("{}{path}.", self.prefix) }
    }

    /// A path from the top of the scene.
    pub(crate) fn path(&self, path: &str) -> String {
        format!("{}{path}", self.prefix)
    }

    /// Everything that a refusal of the value at `path` carries.
    pub(crate) fn fault(&self, path: &str, value: &str, bound: &str, repair: &str) -> Box<Fault> {
        self.source.fault(&self.path(path), value, bound, repair)
    }

    /// Refusal of a value.
    pub(crate) fn value(&self, path: &str, value: impl ToString, bound: &str, repair: &str) -> SceneError {
        self.source.value(&self.path(path), value, bound, repair)
    }
}
