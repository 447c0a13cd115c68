//! Fields out: frames of a run, offered while it goes on, and the files that ParaView opens.
//!
//! A run offers a [`Frame`] wherever it has something to show: a settled level, a record in time, a point of a path, a
//! mode. Every N-th goes to a [`FieldSink`]; [`FieldFiles`] is the one that writes. Without a sink nothing is
//! evaluated, and no file is touched by [`crate::Model::run`].
//!
//! | where is | look in |
//! |---|---|
//! | which frame goes to the sink | `fields.rs` |
//! | what stands in a frame | `fields/content.rs` |
//! | stresses at the faces, von Mises | `fields/stress.rs` |
//! | the file format | `fields/vtu.rs` |
//! | frames read back, for pictures | `fields/read.rs` |
//! | whole files only, the list of frames | `fields/files.rs`, `whole.rs` |

mod content;
mod files;
mod read;
mod stress;
mod vtu;

use std::ops::ControlFlow;

use sph_core::Vec3;
use sph_shell::{PointResult, Shell};

pub use files::FieldFiles;
pub use read::{Array, ReadError, Sheet, listed};

use crate::run::Failure;
use crate::scene::units::Units;
use crate::scene::{Analysis, Scene};

/// Takes the frames of a run while it goes on.
pub trait FieldSink: Send {
    /// Takes a frame; an error ends the run, and what it found so far is kept.
    ///
    /// # Errors
    /// [`FieldError`] of the sink's own making.
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError>;
}

/// A frame that a sink could not take.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("cannot write {path}: {reason}; make room or choose another folder, then run again")]
pub struct FieldError {
    /// The file.
    pub path: String,
    /// What the system said.
    pub reason: String,
}

/// A state of the shell that is worth showing.
#[derive(Clone, Copy)]
pub struct Frame<'a> {
    /// The shell in this state; its forces are those of the state, but for a linear answer and a mode.
    pub shell: &'a Shell,
    /// What kind of state it is.
    pub state: State,
    /// What a film of the frames runs along, ascending: time \[T\] of a transient run, load level of a quasi-static
    /// or static one, number of the point of a path, number of the mode.
    pub along: f64,
    /// Load level; frequency \[1/T\] of a mode of vibration.
    pub level: f64,
    /// The particle whose prescribed motion drives an analysis without time: it bears a reaction though no support
    /// holds it.
    pub driven: Option<u32>,
    /// Whether stresses run linearly through the thickness, so that those at the faces follow from the resultants.
    pub homogeneous: bool,
    /// The forces of a linear answer.
    pub linear: Option<&'a LinearForces>,
    /// Units of the scene, for the names of fields.
    pub units: Units,
}

impl Frame<'_> {
    /// Whether there are forces to show: stresses and reactions.
    pub fn has_forces(&self) -> bool {
        match self.state {
            State::Moving | State::Balance => true,
            State::Linear => self.linear.is_some(),
            State::Mode => false,
        }
    }
}

/// What a linear answer holds beside its motion: all of it grows with the load, none of it is that of the moved shell.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinearForces {
    /// Strains and resultants of every sampling point, with its direction at rest.
    pub points: Vec<PointResult>,
    /// Reactions of all particles \[F\].
    pub reactions: Vec<Vec3>,
}

/// Kinds of states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// On the way in time.
    Moving,
    /// An equilibrium found without time.
    Balance,
    /// A linear answer: displacements are its own, directors turned by its rotations, forces those of
    /// [`Frame::linear`].
    Linear,
    /// A mode, scaled for the eye: displacements show its shape, stresses and reactions have no size.
    Mode,
}

/// Counts the frames that a run offers and hands on every N-th.
pub(crate) struct Frames<'a> {
    sink: &'a mut dyn FieldSink,
    every: u64,
    state: State,
    along: Along,
    driven: Option<u32>,
    homogeneous: bool,
    units: Units,
    /// Frames that the run had to show so far.
    pub(crate) offered: u64,
    /// Frames that the sink took.
    pub(crate) taken: u64,
    /// Why the sink took no more.
    pub(crate) failure: Option<Failure>,
}

/// What orders the frames.
#[derive(Clone, Copy)]
enum Along {
    Time,
    Level,
    /// Number of the frame, counted from this.
    Number(u64),
}

impl<'a> Frames<'a> {
    pub(crate) fn new(sink: &'a mut dyn FieldSink, scene: &Scene, driven: Option<u32>) -> Self {
        let (state, along) = match &scene.analysis {
            Analysis::Explicit(explicit) if explicit.quasi_static.is_some() => (State::Moving, Along::Level),
            Analysis::Explicit(_) => (State::Moving, Along::Time),
            Analysis::Linear(_) => (State::Linear, Along::Level),
            Analysis::Static(_) | Analysis::Relaxation(_) => (State::Balance, Along::Level),
            Analysis::ArcLength(_) => (State::Balance, Along::Number(0)),
            Analysis::Modal(_) | Analysis::Buckling(_) => (State::Mode, Along::Number(1)),
        };
        let every = scene.output.fields.map_or(1, |fields| fields.every).max(1);
        let homogeneous = scene.shell().section.homogeneous();
        let units = scene.units;
        Self { sink, every, state, along, driven, homogeneous, units, offered: 0, taken: 0, failure: None }
    }

    /// Hands a frame on if its turn has come; `Break` if the sink cannot go on.
    pub(crate) fn offer(&mut self, shell: &Shell, time: f64, level: f64) -> ControlFlow<()> {
        self.offer_with(shell, time, level, None)
    }

    /// The same for a linear answer, of which there is but one.
    pub(crate) fn offer_linear(&mut self, shell: &Shell, forces: &LinearForces) {
        // Nothing follows: a frame that could not be taken is told by the failure.
        let _ = self.offer_with(shell, 0.0, 1.0, Some(forces));
    }

    fn offer_with(
        &mut self,
        shell: &Shell,
        time: f64,
        level: f64,
        linear: Option<&LinearForces>,
    ) -> ControlFlow<()> {
        let number = self.offered;
        let wanted = self.failure.is_none() && number.is_multiple_of(self.every);
        self.offered += 1;
        if wanted {
            let along = match self.along {
                Along::Time => time,
                Along::Level => level,
                Along::Number(first) => (first + number) as f64,
            };
            let Self { state, driven, homogeneous, units, .. } = *self;
            let frame = Frame { shell, state, along, level, driven, homogeneous, linear, units };
            match self.sink.frame(&frame) {
                Ok(()) => self.taken += 1,
                Err(error) => self.failure = Some(Failure::Fields(error)),
            }
        }
        if self.failure.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
