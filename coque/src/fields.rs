//! Fields out: frames of a run, offered while it goes on, and the files that ParaView opens.
//!
//! A run offers a [`Frame`] wherever it has something to show: a settled level, a record in time, a point of a path, a
//! mode. Every N-th goes to a [`FieldSink`]; [`FieldFiles`] is the one that writes. Without a sink nothing is
//! evaluated, and no file is touched by [`crate::Model::run`]. What a frame shows is a [`FieldSource`], which writes
//! through [`mesh_io::FieldWriter`] into whatever the sink hands it.
//!
//! | where is | look in |
//! |---|---|
//! | which frame goes to the sink | `fields.rs` |
//! | what a shell shows | `fields/content.rs` |
//! | stresses at the faces, von Mises | `fields/stress.rs` |
//! | the files of a body | `fields/files.rs` |
//! | the file format, the list of frames, frames read back | the crate `mesh-io` |

mod content;
mod files;
mod stress;

use std::io;
use std::ops::ControlFlow;

use mesh_io::{At, FieldError, FieldWriter, Sheet, Values, rows};
use sph_shell::Shell;

pub use content::{LinearForces, ShellFields};
pub use files::FieldFiles;

use crate::scene::{Analysis, Scene};
use crate::units::Units;

/// Takes the frames of a run while it goes on.
pub trait FieldSink: Send {
    /// Takes a frame; an error ends the run, and what it found so far is kept.
    ///
    /// # Errors
    /// [`FieldError`] of the sink's own making.
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError>;
}

/// A body in a state that is worth showing.
pub trait FieldSource: Sync {
    /// Works out what is to be written of the state; of stresses only if they are asked for.
    fn evaluate(&self, state: State, units: Units, stresses: bool) -> Box<dyn Evaluated + '_>;
}

/// The fields of a body, ready to be written.
pub trait Evaluated: Sync {
    /// Writes geometry and fields of a part.
    ///
    /// # Errors
    /// Those of the writer.
    fn write(&self, part: Part, to: &mut dyn FieldWriter) -> io::Result<()>;
}

/// What of a body is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Its particles, and the cells between them: of a shell the mid-surface.
    Surface,
    /// A shell with its thickness.
    Extruded,
}

/// A state that is worth showing.
#[derive(Clone, Copy)]
pub struct Frame<'a> {
    /// The body in this state.
    pub body: &'a dyn FieldSource,
    /// What kind of state it is.
    pub state: State,
    /// What a film of the frames runs along, ascending: time \[T\] of a transient run, load level of a quasi-static
    /// or static one, number of the point of a path, number of the mode.
    pub along: f64,
    /// Load level; frequency \[1/T\] of a mode of vibration.
    pub level: f64,
    /// Time \[T\]; zero where there is none.
    pub time: f64,
    /// Units of the scene, for the names of fields.
    pub units: Units,
}

impl<'a> Frame<'a> {
    /// Works out what the frame shows, once for all its parts.
    pub fn evaluate(&self, stresses: bool) -> FrameFields<'a> {
        let fields = self.body.evaluate(self.state, self.units, stresses);
        FrameFields { along: self.along, level: self.level, fields }
    }

    /// The frame in memory: its surface, as [`FieldFiles`] writes it.
    ///
    /// # Errors
    /// [`FieldError`] for a body that writes its fields out of their order; none is known.
    pub fn sheet(&self, stresses: bool) -> Result<Sheet, FieldError> {
        let mut sheet = Sheet::default();
        let written = self.evaluate(stresses).write(Part::Surface, &mut sheet);
        written.map_err(|error| FieldError { path: "the frame".into(), reason: error.to_string() })?;
        Ok(sheet)
    }
}

/// What a frame shows, ready to be written.
pub struct FrameFields<'a> {
    along: f64,
    level: f64,
    fields: Box<dyn Evaluated + 'a>,
}

impl FrameFields<'_> {
    /// Writes a part, with the place of the frame in front of it.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write(&self, part: Part, to: &mut dyn FieldWriter) -> io::Result<()> {
        for (name, value) in [("TimeValue", self.along), ("level", self.level)] {
            to.numbers(At::Frame, name, "-", &[], Values::Double(&rows(1, |_| [value])))?;
        }
        self.fields.write(part, to)
    }
}

/// Kinds of states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// On the way in time.
    Moving,
    /// An equilibrium found without time.
    Balance,
    /// A linear answer: displacements are its own, directors turned by its rotations, forces those of
    /// [`ShellFields::linear`].
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
    pub(crate) failure: Option<FieldError>,
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
            Analysis::Static(_) => (State::Balance, Along::Level),
            Analysis::ArcLength(_) => (State::Balance, Along::Number(0)),
            Analysis::Modal(_) | Analysis::Buckling(_) => (State::Mode, Along::Number(1)),
        };
        let every = scene.output.fields.map_or(1, |fields| fields.every).max(1);
        let homogeneous = scene.section.homogeneous();
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
            let body = &ShellFields { shell, driven, homogeneous, linear };
            let frame = Frame { body, state, along, level, time, units };
            match self.sink.frame(&frame) {
                Ok(()) => self.taken += 1,
                Err(error) => self.failure = Some(error),
            }
        }
        if self.failure.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
