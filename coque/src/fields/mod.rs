//! Fields out: frames of a run, offered while it goes on, and the files that ParaView opens.
//!
//! A run offers a [`Frame`] wherever it has something to show: a settled level, a record in time, a point of a path, a
//! mode. Every N-th goes to a [`FieldSink`]; [`FieldFiles`] is the one that writes. Without a sink nothing is
//! evaluated, and no file is touched by [`crate::Model::run`]. What a frame shows its body writes, through
//! [`mesh_io::FieldWriter`], into whatever the sink hands it.
//!
//! | where is | look in |
//! |---|---|
//! | which frame goes to the sink | `fields/mod.rs` |
//! | the files of a body | `fields/files.rs` |
//! | what a shell shows | `bodies/shell/fields.rs` |
//! | the file format, the list of frames, frames read back | the crate `mesh-io` |

mod files;

use std::io;
use std::ops::ControlFlow;

use explicit_dynamics::Instant;
use mesh_io::{At, FieldError, FieldWriter, Sheet, Values, rows};

pub use files::{FieldFiles, SETS, Written};

use crate::bodies::{Body, FieldRequest, FieldSource, Part, State, StressFields, Task};
use crate::results::picture::together;
use crate::scene::Analysis;
use crate::scene::units::Units;

/// Takes the frames of a run while it goes on.
pub trait FieldSink: Send {
    /// Takes a frame; an error ends the run, and what it found so far is kept.
    ///
    /// # Errors
    /// [`FieldError`] of the sink's own making.
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError>;
}

/// A state that is worth showing.
#[derive(Clone, Copy)]
pub struct Frame<'a> {
    /// The body in this state.
    pub body: &'a dyn Body,
    /// What is asked of its fields, stresses apart.
    pub shown: FieldRequest<'a>,
    /// What a film of the frames runs along, ascending: time \[T\] of a transient run, load level of a quasi-static
    /// or static one, number of the point of a path, number of the mode, number of the load case.
    pub along: f64,
    /// Load level; frequency \[1/T\] of a mode of vibration.
    pub level: f64,
    /// Time \[T\]; zero where there is none.
    pub time: f64,
    /// Name of the load case or combination that it shows, where there are some.
    pub case: Option<&'a str>,
}

impl<'a> Frame<'a> {
    /// A body as it is now, on the way in time or in balance.
    pub(crate) fn present(body: &'a dyn Body, task: &Task, driven: Option<u32>, at: Instant) -> Self {
        let Instant { time, level } = at;
        let marched = matches!(task.analysis, Analysis::Explicit(_));
        let state = if marched { State::Moving } else { State::Balance };
        let shown = FieldRequest {
            state,
            units: task.units,
            stresses: false,
            indicator: false,
            contact: task.output.fields.is_some_and(|fields| fields.contact),
            of_stresses: StressFields::asked(&task.output),
            driven,
            forces: None,
        };
        let along = if task.analysis.kind().passes_time { time } else { level };
        Self { body, shown, along, level, time, case: None }
    }

    /// Works out what the frame shows, once for all its parts.
    pub fn evaluate(&self, stresses: bool) -> FrameFields<'a> {
        let fields = self.body.fields(&FieldRequest { stresses, ..self.shown });
        FrameFields { along: self.along, level: self.level, time: self.time, fields }
    }

    /// The same for one of the bodies that the body is made of ([`Body::bodies`]).
    pub fn evaluate_one(&self, body: usize, stresses: bool) -> FrameFields<'a> {
        let fields = self.body.fields_of(body, &FieldRequest { stresses, ..self.shown });
        FrameFields { along: self.along, level: self.level, time: self.time, fields }
    }

    /// The frame in memory: its surface, as [`FieldFiles`] writes it, of several bodies all together.
    ///
    /// # Errors
    /// [`FieldError`] for a body that writes its fields out of their order; none is known.
    pub fn sheet(&self, stresses: bool) -> Result<Sheet, FieldError> {
        let drawn = |fields: FrameFields<'_>| {
            let mut sheet = Sheet::default();
            let written = fields.write(Part::Surface, &mut sheet);
            written.map_err(|error| FieldError { path: "the frame".into(), reason: error.to_string() })?;
            Ok(sheet)
        };
        match self.body.bodies().len() {
            0 => drawn(self.evaluate(stresses)),
            bodies => {
                let sheets = (0..bodies).map(|body| drawn(self.evaluate_one(body, stresses)));
                sheets.collect::<Result<_, _>>().map(together)
            }
        }
    }
}

/// What a frame shows, ready to be written.
pub struct FrameFields<'a> {
    along: f64,
    level: f64,
    time: f64,
    fields: Box<dyn FieldSource + 'a>,
}

impl FrameFields<'_> {
    /// Writes a part, with the place of the frame in front of it.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write(&self, part: Part, to: &mut dyn FieldWriter) -> io::Result<()> {
        for (name, value) in [("TimeValue", self.along), ("level", self.level), ("time", self.time)] {
            to.numbers(At::Frame, name, "-", &[], Values::Double(&rows(1, |_| [value])))?;
        }
        self.fields.write(part, to)
    }
}

/// Counts the frames that a run offers and hands on every N-th.
pub(crate) struct Frames<'a> {
    sink: &'a mut dyn FieldSink,
    every: u64,
    state: State,
    along: Along,
    driven: Option<u32>,
    units: Units,
    /// Whether frames show where the lattice is too coarse.
    indicator: bool,
    /// Whether frames show what particles feel of contact.
    contact: bool,
    /// What else of stresses they show.
    of_stresses: StressFields,
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
    pub(crate) fn new(
        sink: &'a mut dyn FieldSink,
        task: &Task,
        driven: Option<u32>,
        indicator: bool,
    ) -> Self {
        let (state, along) = match &task.analysis {
            Analysis::Explicit(explicit) if explicit.quasi_static.is_some() => (State::Moving, Along::Level),
            Analysis::Explicit(_) => (State::Moving, Along::Time),
            Analysis::Linear(_) => (State::Linear, Along::Level),
            Analysis::Static(_) | Analysis::Relaxation(_) => (State::Balance, Along::Level),
            Analysis::ArcLength(_) => (State::Balance, Along::Number(0)),
            Analysis::Harmonic(_) => (State::Mode, Along::Level),
            Analysis::ResponseSpectrum(_) | Analysis::RandomVibration(_) => {
                (State::Greatest, Along::Number(1))
            }
            Analysis::Modal(_) | Analysis::Buckling(_) => (State::Mode, Along::Number(1)),
            Analysis::Heat(wanted) if wanted.transient.is_some() => (State::Mode, Along::Time),
            Analysis::Heat(_) => (State::Mode, Along::Level),
        };
        let every = task.output.fields.map_or(1, |fields| fields.every).max(1);
        let units = task.units;
        let contact = task.output.fields.is_some_and(|fields| fields.contact);
        let of_stresses = StressFields::asked(&task.output);
        let (offered, taken, failure) = (0, 0, None);
        Self {
            sink,
            every,
            state,
            along,
            driven,
            units,
            indicator,
            contact,
            of_stresses,
            offered,
            taken,
            failure,
        }
    }

    /// Hands a frame on if its turn has come; `Break` if the sink cannot go on.
    pub(crate) fn offer(&mut self, body: &dyn Body, time: f64, level: f64) -> ControlFlow<()> {
        self.offer_with(body, [time, level], None, None)
    }

    /// The same for a linear answer, to a load case by its number and name where there are some. A frame that could not be taken is reported by the
    /// failure.
    pub(crate) fn offer_linear(&mut self, body: &dyn Body, forces: &[f64], case: Option<(f64, &str)>) {
        let _ = self.offer_with(body, [0.0, 1.0], Some(forces), case);
    }

    fn offer_with(
        &mut self,
        body: &dyn Body,
        [time, level]: [f64; 2],
        forces: Option<&[f64]>,
        case: Option<(f64, &str)>,
    ) -> ControlFlow<()> {
        let number = self.offered;
        let wanted = self.failure.is_none() && number.is_multiple_of(self.every);
        self.offered += 1;
        if wanted {
            let along = match (case, self.along) {
                (Some((case, _)), _) => case,
                (None, Along::Time) => time,
                (None, Along::Level) => level,
                (None, Along::Number(first)) => (first + number) as f64,
            };
            let Self { state, driven, units, indicator, contact, of_stresses, .. } = *self;
            let stresses = false;
            let shown =
                FieldRequest { state, units, stresses, indicator, contact, of_stresses, driven, forces };
            let frame = Frame { body, shown, along, level, time, case: case.map(|(_, name)| name) };
            match self.sink.frame(&frame) {
                Ok(()) => self.taken += 1,
                Err(error) => self.failure = Some(error),
            }
        }
        if self.failure.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
