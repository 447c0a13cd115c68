//! The course of an analysis: which one it is, and how far it has come. It has an arm for each analysis.

use std::ops::ControlFlow;

use explicit_dynamics::Instant;

use super::cases::Cases;
use super::harmonic_cases::harmonic_cases;
use super::heat::HeatingInTime;
use super::march::Marching;
use super::one_solve::OneSolveLevels;
use super::path::{Levels, arc_length};
use super::relaxation::RelaxedLevels;
use super::started::StartedLevels;
use super::{harmonic, heat, linear, modes, random_vibration, response_spectrum};
use crate::bodies::{InStillWater, Ready, TangentCost};
use crate::run::Run;
use crate::run::checkpoint::Stage;
use crate::run::outcome::{Ended, Failure};
use crate::scene::{Analysis, ArcLength, Buckling, Checked, Harmonic, Linear, Modal};

/// An analysis under way.
pub(super) enum Course {
    /// In time, a step at once.
    March(Box<Marching>),
    /// A level at once.
    Levels(Box<Levels>),
    StartedLevels(Box<StartedLevels>),
    OneSolve(Box<OneSolveLevels>),
    Relaxation(Box<RelaxedLevels>),
    /// A load case or a combination at once.
    Cases(Box<Cases>),
    /// All at once.
    Linear(Linear),
    ArcLength(ArcLength),
    Modal(Modal),
    /// Modes in still water.
    WetModes(Modal, Box<InStillWater>),
    Harmonic(Harmonic),
    /// The same under load cases, of a scene, on so many threads.
    HarmonicCases(Box<Checked>, usize),
    /// By response spectra or noise: of a scene whose bases shake it one by one, on so many threads.
    Shaken(Box<Checked>, usize),
    /// The same without a scene.
    Unshaken,
    Buckling(Buckling),
    Heat,
    /// A row at once.
    HeatInTime(Box<HeatingInTime>),
}

impl Course {
    /// From the start, or from where an earlier run stood; of a body whose tangent costs so much, and that has so many particles. Levels may be
    /// given increments of the state, from which they start.
    pub fn new(
        analysis: &Analysis,
        body: (TangentCost, usize),
        from: Option<Stage>,
        increments: Vec<Vec<f64>>,
    ) -> Self {
        match analysis {
            Analysis::Explicit(wanted) => Self::March(Box::new(Marching::new(wanted, body, from))),
            Analysis::Static(wanted) if wanted.one_solve => {
                Self::OneSolve(Box::new(OneSolveLevels::new(wanted, from)))
            }
            Analysis::Static(wanted) if !increments.is_empty() => {
                Self::StartedLevels(Box::new(StartedLevels::new(wanted, increments)))
            }
            Analysis::Static(wanted) => Self::Levels(Box::new(Levels::new(wanted, from))),
            Analysis::Relaxation(wanted) => Self::Relaxation(Box::new(RelaxedLevels::new(wanted, from))),
            Analysis::Linear(wanted) => Self::Linear(wanted.clone()),
            Analysis::ArcLength(wanted) => Self::ArcLength(wanted.clone()),
            Analysis::Modal(wanted) => Self::Modal(*wanted),
            Analysis::Harmonic(wanted) => Self::Harmonic(wanted.clone()),
            // A body of no scene has no bases that shake it.
            Analysis::ResponseSpectrum(_) | Analysis::RandomVibration(_) => Self::Unshaken,
            Analysis::Buckling(wanted) => Self::Buckling(*wanted),
            Analysis::Heat(wanted) => match wanted.transient {
                Some(run) => Self::HeatInTime(Box::new(HeatingInTime::new(run))),
                None => Self::Heat,
            },
        }
    }

    /// Does the next part; `Break` with how the run ends, which may be with this part.
    pub fn advance(
        &mut self,
        analysis: &Analysis,
        body: &mut Ready,
        run: &mut Run<'_>,
    ) -> ControlFlow<Ended> {
        match (self, body) {
            (Self::March(march), Ready::Dynamic(body)) => march.advance(body.as_mut(), run),
            (Self::Levels(levels), Ready::Static(body)) => levels.advance(body.as_mut(), run),
            (Self::StartedLevels(levels), Ready::Static(body)) => levels.advance(body.as_mut(), run),
            (Self::OneSolve(levels), Ready::Static(body)) => levels.advance(body.as_mut(), run),
            (Self::Relaxation(levels), Ready::Static(body)) => levels.advance(body.as_mut(), run),
            (Self::Cases(cases), Ready::Static(body)) => cases.advance(body.as_mut(), run),
            (Self::Linear(wanted), Ready::Static(body)) => {
                ControlFlow::Break(linear::linear(wanted, body.as_mut(), run))
            }
            (Self::ArcLength(wanted), Ready::Static(body)) => {
                ControlFlow::Break(arc_length(wanted, body.as_mut(), run))
            }
            (Self::Modal(wanted), Ready::Static(body)) => {
                ControlFlow::Break(modes::modal(wanted.modes.get(), None, body.as_mut(), run))
            }
            (Self::WetModes(wanted, water), Ready::Static(body)) => {
                ControlFlow::Break(modes::modal(wanted.modes.get(), Some(water), body.as_mut(), run))
            }
            (Self::Harmonic(wanted), Ready::Static(body)) => {
                ControlFlow::Break(harmonic::harmonic(wanted, body.as_mut(), run))
            }
            (Self::HarmonicCases(scene, threads), Ready::Static(body)) => {
                let Analysis::Harmonic(wanted) = analysis else { return ControlFlow::Break(Ended::Done) };
                ControlFlow::Break(harmonic_cases((scene, *threads), wanted, body.as_mut(), run))
            }
            (Self::Shaken(scene, threads), Ready::Static(body)) => ControlFlow::Break(match analysis {
                Analysis::ResponseSpectrum(wanted) => {
                    response_spectrum::response_spectrum(scene, wanted, *threads, body.as_mut(), run)
                }
                Analysis::RandomVibration(wanted) => {
                    random_vibration::random_vibration(scene, wanted, *threads, body.as_mut(), run)
                }
                _ => Ended::Done,
            }),
            (Self::Unshaken, Ready::Static(_)) => refused(analysis, "the scene of its body"),
            (Self::Buckling(wanted), Ready::Static(body)) => {
                ControlFlow::Break(modes::buckling(wanted, body.as_mut(), run))
            }
            (Self::Heat, Ready::Heat(body)) => ControlFlow::Break(heat::steady(body.as_mut(), run)),
            (Self::HeatInTime(course), Ready::Heat(body)) => course.advance(body.as_mut(), run),
            (_, Ready::Heat(_)) => refused(analysis, "a body that moves"),
            (Self::Heat | Self::HeatInTime(_), _) => refused(analysis, "a body that conducts heat"),
            (Self::March(_), Ready::Static(_)) => refused(analysis, "a body that is marched"),
            (_, Ready::Dynamic(_)) => refused(analysis, "a body without time"),
        }
    }

    /// Ends it where it stands, as soon as that is between two of its parts.
    pub fn interrupt(&mut self, body: &mut Ready, run: &mut Run<'_>) -> Ended {
        if let (Self::March(march), Ready::Dynamic(body)) = (&mut *self, body) {
            return march.interrupt(body.as_mut(), run);
        }
        let Instant { time, level } = self.stands_at();
        Ended::Interrupted { time, level }
    }

    /// Time \[T\], zero without time, and the load level that was last reached.
    pub fn stands_at(&self) -> Instant {
        let level = match self {
            Self::March(march) => return march.stands_at(),
            Self::HeatInTime(course) => return course.stands_at(),
            Self::Levels(levels) => levels.last(),
            Self::StartedLevels(levels) => levels.last(),
            Self::OneSolve(levels) => levels.last(),
            Self::Relaxation(levels) => levels.last(),
            Self::Cases(_)
            | Self::Linear(_)
            | Self::ArcLength(_)
            | Self::Modal(_)
            | Self::WetModes(..)
            | Self::Harmonic(_)
            | Self::HarmonicCases(..)
            | Self::Shaken(..)
            | Self::Unshaken
            | Self::Buckling(_)
            | Self::Heat => 0.0,
        };
        Instant { time: 0.0, level }
    }
}

fn refused(analysis: &Analysis, wanted: &'static str) -> ControlFlow<Ended> {
    ControlFlow::Break(Ended::Diverged(Failure::Kind { analysis: analysis.kind().name, wanted }))
}
