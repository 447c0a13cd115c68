//! What keeps the judge from judging; a missed tolerance is not among it.

use benchmarks_ref::ReferenceError;
use thiserror::Error;

/// Why there is no verdict.
#[derive(Debug, Error)]
pub enum JudgeError {
    /// No case has this name.
    #[error("there is no case \"{name}\"; the cases are: {known}")]
    UnknownCase {
        /// What was asked for.
        name: String,
        /// Every case there is.
        known: String,
    },
    /// Quick runs were asked for, but the chosen cases have none.
    #[error("the chosen cases have no quick runs; leave out --quick")]
    NothingToRun,
    /// A scene was refused.
    #[error("case {case}, {method}: the scene was refused\n{text}")]
    Scene {
        /// The case.
        case: &'static str,
        /// The method of the variant.
        method: String,
        /// The refusal, with the line underlined.
        text: String,
    },
    /// A study left no outcome.
    #[error("case {case}, {method}: {cause}")]
    Study {
        /// The case.
        case: &'static str,
        /// The method of the variant.
        method: String,
        /// What happened.
        cause: String,
    },
    /// A case asks for a column that its scene does not record.
    #[error(
        "the curve has no column \"{name}\"; add a [[curve]] of that name to the scene, or use one of: {known}"
    )]
    NoColumn {
        /// What was asked for.
        name: String,
        /// What there is.
        known: String,
    },
    /// No measured error stands for a run.
    #[error(
        "no measured error stands for {method} {grid}: run the case, look at the error, and write it beside the others"
    )]
    NotMeasured {
        /// The method of the variant.
        method: String,
        /// Its grid.
        grid: String,
    },
    /// A run is asked for that the case does not have.
    #[error("the case has no variant {method} {grid}: correct the name where it is asked for")]
    NoVariant {
        /// The method that was asked for.
        method: String,
        /// The grid that was asked for.
        grid: String,
    },
    /// A reference is missing or does not cover the range.
    #[error(transparent)]
    Reference(#[from] ReferenceError),
    /// A chart could not be drawn.
    #[error("cannot draw \"{title}\": {reason}")]
    Chart {
        /// The chart.
        title: String,
        /// What went wrong.
        reason: String,
    },
    /// A file could not be written.
    #[error("cannot write {path}: {reason}")]
    Write {
        /// The file.
        path: String,
        /// What went wrong.
        reason: String,
    },
}
