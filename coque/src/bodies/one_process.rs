//! What is not run by several processes together, and why.

/// What one process marches alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotShared {
    /// Bodies of a kind.
    #[error("bodies of this kind are marched by one process")]
    Kind,
    /// A part of one, with what scenes say for it.
    #[error("{0} is marched by one process")]
    Part(&'static str),
}

/// Why one process has to run a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OneProcess {
    /// Its analysis does not march.
    #[error(
        "[analysis.{analysis}] runs in one process, but {started} were started together: start one, with as many --threads \
         as there are cores, or march, by [analysis.explicit]"
    )]
    Timeless {
        /// Its key.
        analysis: &'static str,
        /// Processes.
        started: usize,
    },
    /// A part of its body is marched by one.
    #[error(
        "{what}, but {started} were started together: start one, with as many --threads as there are cores"
    )]
    Body {
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
