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
//! | least and greatest over load cases | `fields/envelope.rs` |
//! | what a shell shows | `bodies/shell/fields.rs` |
//! | the file format, the list of frames, frames read back | the crate `mesh-io` |

mod envelope;
mod files;

use std::io;
use std::ops::ControlFlow;

use explicit_dynamics::Instant;
use mesh_io::{At, FieldError, FieldWriter, Sheet, Values, rows};

pub use envelope::{Extreme, FieldEnvelope};
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
    /// What it shows in place of the fields of the body: an extreme of them over load cases.
    pub envelope: Option<(&'a FieldEnvelope, Extreme)>,
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
        Self { body, shown, along, level, time, case: None, envelope: None }
    }

    /// Works out what the frame shows, once for all its parts.
    pub fn evaluate(&self, stresses: bool) -> FrameFields<'a> {
        let fields = match self.envelope {
            Some((envelope, extreme)) => envelope.of_body(0, extreme),
            None => self.body.fields(&FieldRequest { stresses, ..self.shown }),
        };
        FrameFields { along: self.along, level: self.level, time: self.time, fields }
    }

    /// The same for one of the bodies that the body is made of ([`Body::bodies`]).
    pub fn evaluate_one(&self, body: usize, stresses: bool) -> FrameFields<'a> {
        let fields = match self.envelope {
            Some((envelope, extreme)) => envelope.of_body(body, extreme),
            None => self.body.fields_of(body, &FieldRequest { stresses, ..self.shown }),
        };
        FrameFields { along: self.along, level: self.level, time: self.time, fields }
    }

    /// The frame in memory: its surface, as [`FieldFiles`] writes it, of several bodies all together.
    ///
    /// # Errors
    /// [`FieldError`] for a body that writes its fields out of their order; none is known.
    pub fn sheet(&self, stresses: bool) -> Result<Sheet, FieldError> {
        self.sheets(stresses)
            .map(|mut sheets| if sheets.len() == 1 { sheets.remove(0) } else { together(sheets) })
    }

    /// The same of each body by itself.
    fn sheets(&self, stresses: bool) -> Result<Vec<Sheet>, FieldError> {
        let drawn = |fields: FrameFields<'_>| {
            let mut sheet = Sheet::default();
            let written = fields.write(Part::Surface, &mut sheet);
            written.map_err(|error| FieldError { path: "the frame".into(), reason: error.to_string() })?;
            Ok(sheet)
        };
        match self.body.bodies().len() {
            0 => Ok(vec![drawn(self.evaluate(stresses))?]),
            bodies => (0..bodies).map(|body| drawn(self.evaluate_one(body, stresses))).collect(),
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
    /// Least and greatest over load cases, where they are wanted; and whether stresses are in them.
    envelope: Option<FieldEnvelope>,
    stresses: bool,
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
        let wanted = task.output.fields;
        let envelope = wanted.is_some_and(|fields| fields.envelope).then(FieldEnvelope::default);
        let stresses = wanted.is_some_and(|fields| fields.stresses);
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
            envelope,
            stresses,
            offered,
            taken,
            failure,
        }
    }

    /// Hands a frame on if its turn has come; `Break` if the sink cannot go on.
    pub(crate) fn offer(&mut self, body: &dyn Body, time: f64, level: f64) -> ControlFlow<()> {
        self.offer_with(body, [time, level], None, None)
    }

    /// The same for a linear answer, to a load case where there are some. A frame that could not be taken is reported by the failure.
    pub(crate) fn offer_linear(&mut self, body: &dyn Body, forces: &[f64], case: Option<CaseShown<'_>>) {
        let _ = self.offer_with(body, [0.0, 1.0], Some(forces), case);
    }

    /// Hands on what was least and greatest over load cases, where that is wanted, behind so many of them.
    pub(crate) fn offer_envelope(&mut self, body: &dyn Body, cases: usize) {
        let Some(envelope) = self.envelope.take() else { return };
        for (k, extreme) in Extreme::ALL.into_iter().enumerate() {
            let shown = self.shown(None);
            let along = (cases + 1 + k) as f64;
            let (case, envelope) = (Some(extreme.word()), Some((&envelope, extreme)));
            self.offered += 1;
            self.hand_on(&Frame { body, shown, along, level: 1.0, time: 0.0, case, envelope });
        }
    }

    /// What is asked of the fields of a frame.
    fn shown<'b>(&self, forces: Option<&'b [f64]>) -> FieldRequest<'b> {
        let Self { state, driven, units, indicator, contact, of_stresses, .. } = *self;
        FieldRequest { state, units, stresses: false, indicator, contact, of_stresses, driven, forces }
    }

    fn hand_on(&mut self, frame: &Frame<'_>) {
        if self.failure.is_none() {
            match self.sink.frame(frame) {
                Ok(()) => self.taken += 1,
                Err(error) => self.failure = Some(error),
            }
        }
    }

    fn offer_with(
        &mut self,
        body: &dyn Body,
        [time, level]: [f64; 2],
        forces: Option<&[f64]>,
        case: Option<CaseShown<'_>>,
    ) -> ControlFlow<()> {
        let number = self.offered;
        let wanted = number.is_multiple_of(self.every);
        self.offered += 1;
        let along = match (&case, self.along) {
            (Some(case), _) => case.number,
            (None, Along::Time) => time,
            (None, Along::Level) => level,
            (None, Along::Number(first)) => (first + number) as f64,
        };
        let (shown, name) = (self.shown(forces), case.as_ref().map(|case| case.name));
        let frame = Frame { body, shown, along, level, time, case: name, envelope: None };
        if let (Some(envelope), true) = (&mut self.envelope, case.is_some_and(|case| case.counts)) {
            match frame.sheets(self.stresses) {
                Ok(sheets) => envelope.take(along, sheets),
                Err(error) => self.failure = Some(error),
            }
        }
        if wanted {
            self.hand_on(&frame);
        }
        if self.failure.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// A load case or combination that a frame shows.
pub(crate) struct CaseShown<'a> {
    /// Its number, from 1.
    pub number: f64,
    /// Its name.
    pub name: &'a str,
    /// Whether it counts in envelopes.
    pub counts: bool,
}
