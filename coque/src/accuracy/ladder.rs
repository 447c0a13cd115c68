//! Runs of a scene on ever finer lattices, within a time.

use std::ops::ControlFlow;
use std::time::Instant;

use super::Asked;
use super::answers::{Answer, Step, answers};
use super::convergence::Convergence;
use super::refined::{Refined, coarsest, finer};
use crate::Warning;
use crate::run::progress::{Progress, ProgressReport};
use crate::scene::error::SceneError;
use crate::scene::{Analysis, Checked};

/// Lattices that a ladder has at least if time allows.
const FEWEST: usize = 4;
/// Growth of the time with the number of particles that is expected before two runs have shown theirs \[–\].
const GROWTH: f64 = 1.4;
/// Runs shorter than this tell nothing of that growth \[s\].
const TIMED: f64 = 5e-3;

/// A run on one lattice.
#[derive(Clone, Debug)]
pub struct Rung {
    /// The lattice in words.
    pub lattice: String,
    /// Spacing over that of the scene as it was given \[–\].
    pub spacing: f64,
    /// Particles or nodes.
    pub particles: usize,
    /// Wall time of building and running it \[s\].
    pub seconds: f64,
    /// Memory, as expected beforehand \[bytes\].
    pub memory: f64,
    /// Estimated error, as a share of the answer \[–\]; none on a lattice that is too coarse to compare.
    pub error: Option<f64>,
    /// What is doubtful about it.
    pub warnings: Vec<Warning>,
    answers: Vec<Answer>,
}

impl Rung {
    /// The run on the lattice that is so many times as fine as the scene's own, however long it takes.
    ///
    /// # Errors
    /// [`SceneError`] of the scene; words for a run that failed.
    pub fn at(scene: &Checked, fineness: f64, threads: usize) -> Result<Self, ClimbError> {
        run(scene, fineness, threads, None)?.ok_or_else(|| ClimbError::Silent("the run was ended".into()))
    }

    /// Greatest distance of its answers from those of another, each over the greatest value of its column there \[–\];
    /// none where they do not answer the same.
    pub fn distance_from(&self, finer: &Self) -> Option<f64> {
        let alike = self.answers_like(finer);
        let steps = self.answers.iter().zip(&finer.answers).map(|(own, other)| own.step_to(other).distance);
        alike.then(|| steps.fold(0.0, f64::max))
    }

    /// How far the last number of a column is from a known one, as a share of that \[–\]; none without the column.
    pub fn off(&self, column: &str, known: f64) -> Option<f64> {
        let answer = self.answers.iter().find(|answer| answer.name == column)?;
        Some((answer.last()? / known - 1.0).abs())
    }

    /// Whether it answers the same columns with as many numbers.
    fn answers_like(&self, other: &Self) -> bool {
        let alike = |(a, b): (&Answer, &Answer)| a.name == b.name && a.len() == b.len();
        self.answers.len() == other.answers.len() && self.answers.iter().zip(&other.answers).all(alike)
    }
}

/// The runs of one method, and what they tell.
#[derive(Clone, Debug, Default)]
pub struct Ladder {
    /// The runs, coarse to fine.
    pub rungs: Vec<Rung>,
    /// Error of the finest by the column that asks most, with the name of that column; none before three runs compare.
    pub finest: Option<(Convergence, String)>,
}

impl Ladder {
    /// Climbs until the accuracy is reached on the finest lattice, the time is over, or `tell` ends it.
    ///
    /// # Errors
    /// [`SceneError`] of the scene on its own lattice or a finer one; words for a run that failed there.
    pub fn climb(
        scene: &Checked,
        asked: &Asked,
        tell: &mut dyn FnMut(&Rung) -> ControlFlow<()>,
    ) -> Result<Self, ClimbError> {
        let Asked { accuracy, within, lattices, threads } = *asked;
        let begun = Instant::now();
        let mut ladder = Self::default();
        let mut fineness = coarsest(scene);
        while ladder.rungs.len() < lattices {
            let left = within.saturating_sub(begun.elapsed());
            let next = ladder.rungs.last().map_or(1.0, |last| fineness * last.spacing);
            if ladder.rungs.len() > 2 && ladder.seconds_at(next) > left.as_secs_f64() {
                break;
            }
            match run(scene, fineness, threads, Some(begun + within)) {
                Ok(Some(rung)) => {
                    // Whole numbers of cells may leave the longest edge as it was.
                    if ladder.rungs.last().is_none_or(|last| rung.spacing < last.spacing) {
                        let flow = tell(&rung);
                        ladder.rungs.push(rung);
                        ladder.estimate();
                        if flow.is_break() {
                            break;
                        }
                    }
                }
                Ok(None) => break,
                // What a lattice coarser than the scene's own cannot do does not matter.
                Err(_) if fineness < 1.0 => ladder.rungs.clear(),
                Err(error) if ladder.rungs.is_empty() => return Err(error),
                Err(_) => break,
            }
            let reached = ladder.finest.as_ref().is_some_and(|(found, _)| found.error <= accuracy);
            if reached && ladder.rungs.len() >= FEWEST {
                break;
            }
            fineness = finer(scene, fineness);
        }
        Ok(ladder)
    }

    /// Time of a run with so many times the cells along an edge \[s\], by the growth of the last two.
    pub fn seconds_at(&self, finer: f64) -> f64 {
        let Some(last) = self.rungs.last() else { return 0.0 };
        let before = self.rungs.iter().rev().nth(1).filter(|rung| rung.seconds > TIMED);
        let growth = before.map_or(2.0 * GROWTH, |before| {
            let growth = libm::log(last.seconds / before.seconds) / libm::log(before.spacing / last.spacing);
            // A time grows at least with the particles of a surface, at most with those of a solid and as many levels.
            growth.clamp(2.0, 6.0)
        });
        last.seconds * libm::pow(finer, growth)
    }

    /// Errors of all runs, from the differences of the last that can be compared.
    fn estimate(&mut self) {
        self.finest = None;
        let Some(last) = self.rungs.last() else { return };
        let first = self.rungs.iter().rposition(|rung| !rung.answers_like(last)).map_or(0, |at| at + 1);
        let (compared, count) = (&self.rungs[first..], self.rungs.len() - first);
        if count < 3 {
            return;
        }
        let found: Vec<Convergence> =
            (0..last.answers.len()).map(|column| careful(compared, column)).collect();
        let errors: Vec<Option<f64>> = compared
            .iter()
            .map(|rung| {
                let of_column = |(column, found): (usize, &Convergence)| {
                    found.error + rung.answers[column].step_to(&last.answers[column]).distance
                };
                found.iter().enumerate().map(of_column).reduce(f64::max)
            })
            .collect();
        let worst = found.iter().zip(&last.answers).max_by(|(a, _), (b, _)| a.error.total_cmp(&b.error));
        self.finest = worst.map(|(found, answer)| (*found, answer.name.clone()));
        for (rung, error) in self.rungs[first..].iter_mut().zip(errors) {
            rung.error = error;
        }
    }
}

/// The more careful of what the last three runs tell of a column and what the three before them do.
fn careful(rungs: &[Rung], column: usize) -> Convergence {
    let of = |rungs: &[Rung]| {
        let spacings = [0, 1, 2].map(|i| rungs[i].spacing);
        let steps: [Step; 2] =
            [0, 1].map(|i| rungs[i].answers[column].step_to(&rungs[i + 1].answers[column]));
        let turned = steps[0].turns_back(&steps[1]);
        Convergence::of(spacings, steps.map(|step| step.distance), turned)
    };
    let count = rungs.len();
    let now = of(&rungs[count - 3..]);
    if count < FEWEST {
        return now;
    }
    let before = of(&rungs[count - 4..count - 1]);
    let finer = rungs[count - 1].spacing / rungs[count - 2].spacing;
    let error = before.error * libm::pow(finer, before.order);
    if error > now.error { Convergence { error, ..before } } else { now }
}

/// Why a ladder has no rung.
#[derive(Debug, thiserror::Error)]
pub enum ClimbError {
    /// The scene was refused.
    #[error(transparent)]
    Refused(#[from] SceneError),
    /// A run gave nothing that can be compared.
    #[error("{0}")]
    Silent(String),
}

/// Builds and runs the scene on a lattice; none if the time was over before it ended.
fn run(
    scene: &Checked,
    fineness: f64,
    threads: usize,
    end: Option<Instant>,
) -> Result<Option<Rung>, ClimbError> {
    let refined = scene.refined(fineness)?;
    let begun = Instant::now();
    let model = refined.scene.build(threads)?;
    let (particles, memory) = (model.describe().particles, model.memory.needed);
    // The force along the one motion that drives a linear answer is what is sought.
    let load = model.driven.is_some() && matches!(scene.analysis, Analysis::Linear(_));
    let mut warnings = model.warnings().to_vec();
    let mut until = Until { end, over: false };
    let outcome = model.run(&mut until);
    let seconds = begun.elapsed().as_secs_f64();
    if until.over {
        return Ok(None);
    }
    let answers = answers(&outcome, &scene.analysis, load).map_err(ClimbError::Silent)?;
    let known = |warning: &Warning| warnings.iter().any(|other| other.kind == warning.kind);
    let met: Vec<Warning> = outcome.summary.record.warnings.iter().filter(|w| !known(w)).cloned().collect();
    warnings.extend(met);
    let Refined { spacing, lattice, .. } = refined;
    Ok(Some(Rung { lattice, spacing, particles, seconds, memory, error: None, warnings, answers }))
}

/// Ends a run when the time is over.
struct Until {
    end: Option<Instant>,
    over: bool,
}

impl Progress for Until {
    fn update(&mut self, _: &ProgressReport) -> ControlFlow<()> {
        self.over |= self.end.is_some_and(|end| Instant::now() > end);
        if self.over { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
