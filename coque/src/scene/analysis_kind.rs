//! What each analysis is and does, a row each: read by the checks, the catalogue and the run.

use super::analysis::Analysis;
use super::statics::{Linear, LinearSolver};

/// One kind of analysis.
#[derive(Debug, PartialEq, Eq)]
pub struct AnalysisKind {
    /// Its keys under `analysis`.
    pub word: &'static str,
    /// Its name in sentences.
    pub name: &'static str,
    /// Columns that every curve of it has; see [`Analysis::columns`].
    pub columns: &'static [&'static str],
    /// Whether answers are modes, not states: nothing is measured on them.
    pub gives_modes: bool,
    /// Whether it goes on from a checkpoint.
    pub resumes: bool,
    /// Whether time passes: conditions have a course in time, bodies a velocity at the start. Else a load level counts.
    pub passes_time: bool,
    /// Whether rigid motions may be free of supports.
    pub floats: bool,
    /// Whether something must drive it: a load, or a prescribed motion.
    pub wants_driver: bool,
    /// Whether the one motion that drives it, if it is that of one particle, becomes a force whose size is sought.
    pub seeks_force: bool,
    /// Whether it needs a tangent, which a formulation without energy does not have.
    pub wants_tangent: bool,
    /// Whether it goes on from a preload.
    pub preloads: bool,
    /// Which contacts go with it.
    pub contacts: Contacts,
}

/// Contacts that go with an analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contacts {
    /// None: nothing opens or closes in it.
    None,
    /// Of a shell alone, as a preload leaves them: what touches is a spring, what is apart stays apart.
    Frozen,
    /// Of a shell alone, smooth ones.
    Smooth,
    /// All.
    All,
}

/// Columns of marches.
const MARCHED: &[&str] = &["time", "level", "kinetic", "internal", "external", "dissipated"];
/// Columns of equilibria found by a tangent.
const BALANCED: &[&str] = &["level", "internal", "iterations", "negative_pivots"];

/// Columns of states that one solve each led to: forces left out of balance over the load, and remaining displacement over displacement.
const ONE_SOLVE: &[&str] =
    &["level", "internal", "iterations", "negative_pivots", "unbalanced", "remaining_displacement"];

/// Columns of steady vibration: mean energies, and energies of a cycle.
const SWINGING: &[&str] =
    &["frequency", "circular_frequency", "internal", "kinetic", "external", "dissipated"];

/// Columns of answers to response spectra: the number of the base, zero of all together.
const BASES: &[&str] = &["base"];

/// Columns of densities by frequency.
const NOISY: &[&str] = &["frequency", "circular_frequency"];

/// Columns of temperatures in balance: heat that enters by each way.
const HEATED: &[&str] = &["iterations", "supplied", "held", "film", "radiated"];

/// Columns of temperatures in time: heat that has entered by each way, what is stored, the sum of the estimates of steps.
const HEATED_IN_TIME: &[&str] =
    &["time", "supplied_heat", "held_heat", "film_heat", "radiated_heat", "stored_heat", "step_error"];

/// What most analyses without time are.
const LEVELLED: AnalysisKind = AnalysisKind {
    word: "",
    name: "",
    columns: BALANCED,
    gives_modes: false,
    resumes: false,
    passes_time: false,
    floats: false,
    wants_driver: true,
    seeks_force: true,
    wants_tangent: true,
    preloads: false,
    contacts: Contacts::None,
};

/// What marches are.
const MARCH: AnalysisKind = AnalysisKind {
    columns: MARCHED,
    resumes: true,
    wants_driver: false,
    seeks_force: false,
    wants_tangent: false,
    contacts: Contacts::All,
    ..LEVELLED
};

/// All analyses.
pub const ANALYSES: [AnalysisKind; 12] = [
    AnalysisKind { word: "explicit.quasi-static", name: "a quasi-static run", ..MARCH },
    AnalysisKind {
        word: "explicit.transient",
        name: "a transient run",
        passes_time: true,
        floats: true,
        ..MARCH
    },
    AnalysisKind { word: "linear", name: "a linear analysis", ..LEVELLED },
    AnalysisKind {
        word: "static",
        name: "a static analysis",
        resumes: true,
        preloads: true,
        contacts: Contacts::All,
        ..LEVELLED
    },
    AnalysisKind {
        word: "arc-length",
        name: "an arc-length analysis",
        preloads: true,
        contacts: Contacts::Smooth,
        ..LEVELLED
    },
    AnalysisKind {
        word: "relaxation",
        name: "a relaxation",
        columns: &["level", "internal", "iterations"],
        resumes: true,
        seeks_force: false,
        contacts: Contacts::Smooth,
        ..LEVELLED
    },
    AnalysisKind {
        word: "modal",
        name: "a modal analysis",
        columns: &["mode", "circular_frequency", "frequency", "residual"],
        gives_modes: true,
        contacts: Contacts::Frozen,
        floats: true,
        wants_driver: false,
        seeks_force: false,
        preloads: true,
        ..LEVELLED
    },
    AnalysisKind {
        word: "harmonic",
        name: "a harmonic analysis",
        columns: SWINGING,
        floats: true,
        wants_driver: false,
        seeks_force: false,
        preloads: true,
        ..LEVELLED
    },
    AnalysisKind {
        word: "response-spectrum",
        name: "an analysis by response spectra",
        columns: BASES,
        wants_driver: false,
        seeks_force: false,
        preloads: true,
        ..LEVELLED
    },
    AnalysisKind {
        word: "random-vibration",
        name: "an analysis of random vibration",
        columns: NOISY,
        wants_driver: false,
        seeks_force: false,
        preloads: true,
        ..LEVELLED
    },
    AnalysisKind {
        word: "buckling",
        name: "a buckling analysis",
        columns: &["mode", "level", "residual"],
        gives_modes: true,
        contacts: Contacts::Frozen,
        preloads: true,
        ..LEVELLED
    },
    AnalysisKind {
        word: "heat",
        name: "a heat analysis",
        columns: HEATED,
        floats: true,
        wants_driver: false,
        seeks_force: false,
        wants_tangent: false,
        ..LEVELLED
    },
];

/// A static analysis that does not iterate: its conditions are as given, no force is sought.
const WITHOUT_ITERATIONS: AnalysisKind = AnalysisKind {
    word: "static",
    name: "a static analysis of one solve a step",
    columns: ONE_SOLVE,
    resumes: true,
    seeks_force: false,
    preloads: true,
    ..LEVELLED
};

/// Temperatures in time.
const HEAT_IN_TIME: AnalysisKind = AnalysisKind {
    word: "heat",
    name: "a heat analysis in time",
    columns: HEATED_IN_TIME,
    passes_time: true,
    floats: true,
    wants_driver: false,
    seeks_force: false,
    wants_tangent: false,
    ..LEVELLED
};

impl Analysis {
    /// The kind of the analysis.
    pub fn kind(&self) -> &'static AnalysisKind {
        let [
            quasi_static,
            transient,
            linear,
            levels,
            arc_length,
            relaxation,
            modal,
            harmonic,
            spectrum,
            random,
            buckling,
            heat,
        ] = &ANALYSES;
        match self {
            Self::Explicit(explicit) if explicit.quasi_static.is_some() => quasi_static,
            Self::Explicit(_) => transient,
            Self::Linear(_) => linear,
            Self::Static(wanted) if wanted.one_solve => &WITHOUT_ITERATIONS,
            Self::Static(_) => levels,
            Self::ArcLength(_) => arc_length,
            Self::Relaxation(_) => relaxation,
            Self::Modal(_) => modal,
            Self::Harmonic(_) => harmonic,
            Self::ResponseSpectrum(_) => spectrum,
            Self::RandomVibration(_) => random,
            Self::Buckling(_) => buckling,
            Self::Heat(wanted) if wanted.transient.is_some() => &HEAT_IN_TIME,
            Self::Heat(_) => heat,
        }
    }

    /// Columns that every curve of it has: those of its kind, without pivots where nothing is factorised.
    pub fn columns<'a>(&self) -> impl Iterator<Item = &'a str> + use<'a> {
        let factorised =
            !matches!(self, Self::Linear(Linear { solver: LinearSolver::ConjugateGradients, .. }));
        self.kind().columns.iter().copied().filter(move |&name| factorised || name != "negative_pivots")
    }

    /// Whether bodies move in time by it, not along a load path.
    pub fn moves_in_time(&self) -> bool {
        self.kind().passes_time && !matches!(self, Self::Heat(_))
    }

    /// Whether it finds vibrations of a size, steady ones or the greatest of them.
    pub fn swings(&self) -> bool {
        matches!(self, Self::Harmonic(_) | Self::ResponseSpectrum(_) | Self::RandomVibration(_))
    }

    /// Whether bases shake it one by one, or not at all.
    pub(crate) fn is_shaken_by_bases(&self) -> bool {
        matches!(self, Self::ResponseSpectrum(_) | Self::RandomVibration(_))
    }

    /// Key of the analysis in a scene.
    pub fn word(&self) -> &'static str {
        let word = self.kind().word;
        word.split_once('.').map_or(word, |(first, _)| first)
    }
}
