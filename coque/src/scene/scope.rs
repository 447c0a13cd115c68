//! Where in a scene the keys of one of its parts stand, so that a check serves a body in either form; bounds on its numbers and vectors,
//! each with its repair.

use crate::scene::bounded::{Bound, Bounded, GREATEST, LEAST, NotNegative, OutOfBounds, Positive};
use crate::scene::error::{Fault, SceneError, Verdict};
use crate::scene::source::{BODIES, Source, suggest};

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

    /// Positive, and of a size that arithmetic can hold.
    pub(crate) fn positive(&self, path: &str, x: f64) -> Verdict {
        self.keeps(path, x, Positive::new(x))
    }

    /// Zero, or of a size that arithmetic can hold.
    pub(crate) fn sized(&self, path: &str, x: f64) -> Verdict {
        if x == 0.0 || (LEAST..=GREATEST).contains(&x.abs()) {
            return Ok(());
        }
        let bound = format!("zero or between {LEAST:e} and {GREATEST:e} in size");
        Err(self.value(path, x, &bound, "choose other units if the number is meant"))
    }

    /// Each component of a size that arithmetic can hold.
    pub(crate) fn sized_all(&self, path: &str, v: &[f64]) -> Verdict {
        v.iter().enumerate().try_for_each(|(i, &x)| self.sized(&format!("{path}[{i}]"), x))
    }

    /// Not below zero.
    pub(crate) fn not_negative(&self, path: &str, x: f64) -> Verdict {
        self.keeps(path, x, NotNegative::new(x))
    }

    fn keeps<B: Bound>(&self, path: &str, x: f64, number: Result<Bounded<B>, OutOfBounds>) -> Verdict {
        number.map(drop).map_err(|refused| self.value(path, x, &refused.bound, refused.repair))
    }

    /// Strictly between two numbers.
    pub(crate) fn between(&self, path: &str, x: f64, [low, high]: [f64; 2], repair: &str) -> Verdict {
        if low < x && x < high {
            return Ok(());
        }
        Err(self.value(path, x, &format!("between {low} and {high}, both excluded"), repair))
    }

    /// From one number to another, both included.
    pub(crate) fn within(&self, path: &str, x: f64, [low, high]: [f64; 2], repair: &str) -> Verdict {
        if low <= x && x <= high {
            return Ok(());
        }
        Err(self.value(path, x, &format!("from {low} to {high}"), repair))
    }

    /// A vector with a direction.
    pub(crate) fn direction(&self, path: &str, v: [f64; 3]) -> Verdict {
        self.sized_all(path, &v)?;
        if v != [0.0; 3] {
            return Ok(());
        }
        let repair = "give at least one component other than zero; the length does not matter";
        Err(self.value(path, "[0, 0, 0]", "a vector with a direction", repair))
    }

    /// First and last of a range, in this order.
    pub(crate) fn range(&self, path: &str, [first, last]: [f64; 2], widest: f64) -> Verdict {
        if first < last && last - first < widest {
            return Ok(());
        }
        let bound = format!("[first, last] with first < last, less than {widest} apart");
        let repair = "swap the two numbers, or narrow the range";
        Err(self.value(path, format!("[{first}, {last}]"), &bound, repair))
    }

    /// One of a list of words.
    pub(crate) fn word(&self, path: &str, word: &str, known: &[&str]) -> Verdict {
        if known.contains(&word) {
            return Ok(());
        }
        let repair = suggest(word, known);
        let bound = format!("one of {}", known.join(", "));
        Err(SceneError::UnknownWord(self.fault(path, word, &bound, &repair)))
    }

    /// Exactly one of several alternative keys.
    pub(crate) fn exactly_one(&self, path: &str, what: &str, given: &[&str], known: &[&str]) -> Verdict {
        if given.len() == 1 {
            return Ok(());
        }
        let value = if given.is_empty() { format!("no {what}") } else { given.join(" and ") };
        let bound = format!("exactly one {what}");
        let repair = match given.is_empty() {
            true => format!("add one of {}", known.join(", ")),
            false => format!("keep one of {}", given.join(", ")),
        };
        // Several alternatives: underline the second one.
        let place = given.get(1).map_or(path.to_string(), |word| format!("{path}.{word}"));
        let mut fault = self.fault(&place, &value, &bound, &repair);
        fault.key = self.path(path);
        Err(SceneError::Choice(fault))
    }

    /// As many numbers as there are dimensions, each of a size that arithmetic can hold.
    pub(crate) fn coordinates(&self, path: &str, v: &[f64], dimensions: usize) -> Verdict {
        self.as_many(path, v, dimensions, "geometry.block.lengths")
    }

    /// As many numbers as another list has.
    pub(crate) fn as_many(&self, path: &str, v: &[f64], dimensions: usize, other: &str) -> Verdict {
        if v.len() == dimensions {
            return self.sized_all(path, v);
        }
        let value = format!("a list of {} numbers", v.len());
        let repair = format!("give as many as `{other}` has");
        Err(self.value(path, value, &format!("a list of {dimensions}"), &repair))
    }

    /// A vector without a component across the plane of a plane block.
    pub(crate) fn in_plane(&self, path: &str, v: [f64; 3], plane: bool) -> Verdict {
        if !plane || v[2] == 0.0 {
            return Ok(());
        }
        let repair = "set its third component to zero: nodes of a plane block move in it alone";
        Err(self.value(path, format!("{v:?}"), "in the plane of x and y", repair))
    }
}
