//! What is not run by several processes together, and why.

/// What one process runs alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotShared {
    /// Bodies of a kind.
    #[error("bodies of this kind run in one process")]
    Kind,
    /// A part of one, in the words of its model.
    #[error("{0}{key} runs in one process", key = key(.0))]
    Part(&'static str),
}

/// Parts in the words of their models, and the keys of scenes that ask for them.
const KEYS: [(&str, &str); 8] = [
    ("a shell whose strains are not sampled in cells", "formulation"),
    ("a plate of two sheets", "formulation.two-sheets"),
    ("a solid under a pressure that follows", "pressure.follower"),
    ("a solid on which a function exerts forces", "Model::push"),
    ("a shell on which a function exerts forces", "Model::push"),
    ("a fluid marched by predictor and corrector", "formulation.weakly-compressible.method"),
    ("a fluid between walls of the published method", "formulation.weakly-compressible.walls"),
    ("a fluid with periodic sides", "periodic"),
];

/// The keys that ask for a part, in brackets.
fn key(what: &str) -> String {
    let found = KEYS.iter().find(|(known, _)| *known == what);
    found.map_or_else(String::new, |(_, keys)| format!(" ({keys})"))
}

/// A kind of body in words.
fn named(kind: &str) -> String {
    if kind == "several" { "a scene of several bodies".into() } else { format!("a body of the kind {kind}") }
}

/// Why one process has to run a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OneProcess {
    /// Its analysis takes a factor of the tangent.
    #[error(
        "[analysis.{analysis}] runs in one process, but {started} were started together: start one, with as many --threads \
         as there are cores, or go by [analysis.explicit] or [analysis.relaxation]"
    )]
    Timeless {
        /// Its key.
        analysis: &'static str,
        /// Processes.
        started: usize,
    },
    /// Its kind of body is run by one, by this analysis.
    #[error(
        "{} with [analysis.{analysis}] runs in one process, but {started} were started together: start \
         one, with as many --threads as there are cores",
        named(.kind)
    )]
    Kind {
        /// The kind.
        kind: &'static str,
        /// Key of the analysis.
        analysis: &'static str,
        /// Processes.
        started: usize,
    },
    /// A part of its body is run by one.
    #[error(
        "{what}, but {started} were started together: start one, with as many --threads as there are cores"
    )]
    Part {
        /// What is.
        what: NotShared,
        /// Processes.
        started: usize,
    },
    /// The errors of its numbers are asked for.
    #[error(
        "errors are found by runs on other lattices, by one process, but {started} were started together: leave out \
         [error], --error, --accuracy and --chart, or start one"
    )]
    Errors {
        /// Processes.
        started: usize,
    },
}
