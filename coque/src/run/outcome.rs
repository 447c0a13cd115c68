//! What a run leaves behind, and how it ended.

use std::fmt;

use explicit_dynamics::MarchError;
use heat_conduction::ConductionError;
use implicit_statics::EquilibriumError;
use mesh_io::FieldError;
use sph_core::Cell;

use super::summary::Summary;
use crate::bodies::Shape;

use crate::results::curve::Curve;

/// What a run leaves behind.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// One row per record.
    pub curve: Curve,
    /// What it was and what it cost.
    pub summary: Summary,
    /// How it ended.
    pub ended: Ended,
    /// Deformed shapes: the start and every settled level of a quasi-static or static run, every point of a path,
    /// a linear answer and every mode scaled to a tenth of the extent, else the last record.
    pub shapes: Vec<Shape>,
    /// Positions and directors at the start and at every level of a static run whose numbers are to have errors, six numbers a particle.
    pub(crate) states: Vec<Vec<f64>>,
    /// Cells between the particles, for pictures.
    pub cells: Vec<Cell>,
}

/// How a run ended.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Ended {
    /// It reached its end.
    #[default]
    Done,
    /// It did not; curve and shapes hold what came before.
    Diverged(Failure),
    /// It was ended from outside; curve and shapes hold what came before.
    Interrupted {
        /// Time \[T\]; zero without time.
        time: f64,
        /// Load level.
        level: f64,
    },
}

impl fmt::Display for Ended {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Done => f.write_str("done"),
            Self::Diverged(failure) => failure.fmt(f),
            Self::Interrupted { time, level } if *time > 0.0 => {
                write!(f, "interrupted at time {time:.6e}, level {level:.6}")
            }
            Self::Interrupted { level, .. } => write!(f, "interrupted at level {level:.6}"),
        }
    }
}

/// Why a run did not reach its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Failure {
    /// The march in time failed.
    #[error(transparent)]
    March(#[from] MarchError),
    /// A balance was not found.
    #[error("no balance after {points} points, the last at level {level}: {cause}{}{}", causes(.cause), forces(.unit))]
    Balance {
        /// Points found.
        points: u64,
        /// Level of the last one, as in the curve.
        level: f64,
        /// What happened.
        cause: EquilibriumError,
        /// Unit of the load levels that the cause names, where they are forces.
        unit: Option<String>,
    },
    /// The preload was not reached.
    #[error("the preload found no balance after {points} points, the last at {level} of it: {cause}{}", causes(.cause))]
    Preload {
        /// Points found.
        points: u64,
        /// Part of the preload at the last one.
        level: f64,
        /// What happened.
        cause: EquilibriumError,
    },
    /// A path was still under way.
    #[error("the path is still under way after {steps} steps, at level {level}; {repair}")]
    Steps {
        /// Steps made.
        steps: usize,
        /// Level of the last point.
        level: f64,
        /// What to do about it.
        repair: &'static str,
    },
    /// The body could not be built under a load case.
    #[error("the body cannot be built under `{name}`: {cause}")]
    Case {
        /// The case or combination.
        name: String,
        /// What the builder says.
        cause: String,
    },
    /// The body was made ready for another analysis.
    #[error("{analysis} needs {wanted}")]
    Kind {
        /// The analysis.
        analysis: &'static str,
        /// What it needs.
        wanted: &'static str,
    },
    /// Temperatures were not found.
    #[error(transparent)]
    Heat(#[from] ConductionError),
    /// A frame of fields could not be written.
    #[error(transparent)]
    Fields(#[from] FieldError),
}

impl Failure {
    /// Whether the scene asked for what cannot be done, or the disk has no room: nothing diverged.
    pub fn is_input(&self) -> bool {
        match self {
            Self::Fields(_) | Self::Case { .. } | Self::March(MarchError::Option { .. }) => true,
            Self::Balance { cause, .. } | Self::Preload { cause, .. } => {
                matches!(cause, EquilibriumError::Option { .. })
            }
            _ => false,
        }
    }
}

/// Says what a load level is where it is a force.
fn forces(unit: &Option<String>) -> String {
    match unit.as_deref() {
        None => String::new(),
        Some("-") => "; load levels there are forces".into(),
        Some(unit) => format!("; load levels there are forces in {unit}"),
    }
}

/// The causes behind an error, in brackets.
fn causes(error: &EquilibriumError) -> String {
    let first = std::error::Error::source(error);
    std::iter::successors(first, |cause| cause.source()).map(|cause| format!(" ({cause})")).collect()
}
