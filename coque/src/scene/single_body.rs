//! Several bodies: the scene of each alone, and which body a name of a set means.

use std::collections::BTreeMap;

use super::error::SceneError;
use super::problem::{BodyScene, Scene};
use super::source::suggest;

/// Whose set a name is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Owner {
    /// All of every body.
    Every,
    /// A set of one body, by the names of both.
    Of(String, String),
}

impl Scene {
    /// Whether bodies are built together: a fluid with its walls and the structures in it.
    pub(crate) fn is_together(&self) -> bool {
        self.bodies.len() > 1 || self.fluid().is_some()
    }

    /// Whose set the name at `path` is: `body.set`, `all`, or a declared set that says `of` whom.
    ///
    /// # Errors
    /// [`SceneError::Set`] for a name that names no body.
    pub(crate) fn owner(&self, path: &str, on: &str) -> Result<Owner, SceneError> {
        if let Some((only, _)) = self.bodies.first_key_value().filter(|_| self.bodies.len() == 1) {
            return Ok(Owner::Of(only.clone(), on.into()));
        }
        if on == "all" {
            return Ok(Owner::Every);
        }
        if let Some(of) = self.sets.get(on).and_then(|region| region.of.as_ref()) {
            return Ok(Owner::Of(of.clone(), on.into()));
        }
        match on.split_once('.') {
            Some((body, set)) if self.bodies.contains_key(body) => Ok(Owner::Of(body.into(), set.into())),
            _ => {
                let every = self.bodies.keys().map(|name| format!("{name}.all"));
                let known: Vec<String> = every.chain(self.sets.keys().cloned()).collect();
                let repair = suggest(on, &known.iter().map(String::as_str).collect::<Vec<_>>());
                let bound =
                    "which names no set of any body: a set of one of several bodies is written body.set";
                Err(SceneError::Set(self.source.fault(path, &format!("\"{on}\""), bound, &repair)))
            }
        }
    }

    /// The scene of one of its bodies: its sets, the supports, loads and columns that name it; refusals point at the text of
    /// the whole.
    ///
    /// Columns of what a fluid does to a structure stay out.
    ///
    /// # Errors
    /// [`SceneError::Set`] for a name that names no body.
    pub(crate) fn single_body(&self, name: &str) -> Result<Self, SceneError> {
        let mut alone = self.clone();
        alone.bodies.retain(|known, _| known == name);
        alone.sets.retain(|_, region| region.of.as_ref().is_none_or(|of| of == name));
        alone.coupling = None;
        alone.output.plot = None;
        // Of several bodies the shells have a thickness to be written: that there is one is seen to of them together.
        if let Some(fields) = alone.output.fields.as_mut().filter(|_| self.bodies.len() > 1) {
            fields.extruded = false;
        }
        let structure = matches!(self.bodies.get(name), Some(BodyScene::Shell(_) | BodyScene::Solid(_)));
        let of_itself = |column: usize| !(structure && self.curve[column].of.is_of_contact());
        let mut renumbered = BTreeMap::new();
        // Marks the items of a list that name the body, and takes its name off their sets.
        let mut mark = |list: &str, ons: Vec<&mut String>, wanted: &dyn Fn(usize) -> bool| {
            let mut marked = Vec::with_capacity(ons.len());
            for (i, on) in ons.into_iter().enumerate() {
                let item = format!("{list}[{i}]");
                let mine = match self.owner(&format!("{item}.on"), on)? {
                    Owner::Every => true,
                    Owner::Of(body, set) if body == name => {
                        *on = set;
                        wanted(i)
                    }
                    Owner::Of(..) => false,
                };
                if mine {
                    let number = marked.iter().filter(|&&mine| mine).count();
                    renumbered.insert(format!("{list}[{number}]"), item);
                }
                marked.push(mine);
            }
            Ok(marked)
        };
        let supports = alone.supports.iter_mut().map(|support| &mut support.on).collect();
        let supports = mark("supports", supports, &|_| true)?;
        let loads = mark("loads", alone.loads.iter_mut().map(|load| &mut load.on).collect(), &|_| true)?;
        let columns = alone.curve.iter_mut().map(|column| &mut column.on).collect();
        let columns = mark("curve", columns, &of_itself)?;
        retain(&mut alone.supports, &supports);
        retain(&mut alone.loads, &loads);
        retain(&mut alone.curve, &columns);
        // Both ends of a spring are of one body.
        for to in alone.supports.iter_mut().filter_map(|support| support.spring.as_mut()?.to.as_mut()) {
            if let Some(set) = to.strip_prefix(name).and_then(|rest| rest.strip_prefix('.')) {
                *to = set.into();
            }
        }
        alone.source = self.source.renumbered(renumbered);
        Ok(alone)
    }
}

/// Keeps the items that are marked.
fn retain<T>(items: &mut Vec<T>, kept: &[bool]) {
    let mut kept = kept.iter();
    items.retain(|_| kept.next().copied().unwrap_or(false));
}
