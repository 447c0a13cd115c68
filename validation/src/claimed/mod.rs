//! Claimed against true error: the bars that `coque run --error` gives, held against references that are not our own.
//!
//! Every scene of the cases runs on its own lattice and on those beside it, studies that know their number of cells on others as far apart; the
//! numbers that a case compares with a reference are found on each by the case itself, and their bars by the rule of `coque::accuracy`. Cases are split by a hash of their names: the rule was chosen on one half, and
//! is judged on the other.

mod dots;
mod judged;

pub use dots::{Dot, Half};
pub use judged::{Share, judged, page, table};

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use coque::accuracy::{Companions, OF_FLUIDS, OF_OTHERS, order_of};
use coque::{Checked, Scene, Silent};

use crate::judge::{Case, Lattices, Outcome, Problem, Run, Runs, Selection, Variant, choose, metrics};
use crate::{JudgeError, Metric};

/// Runs of a case on one lattice after the other, the scene's own first; none where a scene has no other lattice.
struct OnLattices {
    variant: Variant,
    /// The greatest order that is believed.
    most: f64,
    spacings: Vec<f64>,
    outcomes: Vec<Outcome>,
}

/// What runs on several lattices.
#[derive(Clone)]
enum Source {
    Scene(Box<Checked>),
    Study(Lattices),
}

impl Source {
    /// The greatest order that is believed of its answers.
    fn order(&self) -> f64 {
        match self {
            Self::Scene(scene) => order_of(scene),
            Self::Study(study) if study.marched => OF_FLUIDS,
            Self::Study(_) => OF_OTHERS,
        }
    }

    /// The same on the next coarser lattice.
    fn coarser(self) -> Result<Self, String> {
        match self {
            Self::Scene(scene) => {
                let Companions { lattices, .. } = scene.companions(1)?;
                let first = lattices.into_iter().find(|lattice| lattice.spacing > 1.0);
                let scene = first.ok_or("no coarser lattice")?.scene;
                Ok(Self::Scene(Box::new(scene)))
            }
            Self::Study(study) => {
                let coarser = study.others()?.into_iter().find(|cells| *cells < study.cells);
                let cells = coarser.ok_or("no coarser lattice")?;
                Ok(Self::Study(Lattices { cells, ..study }))
            }
        }
    }
}

/// Runs what is selected of the cases on all lattices, or all from so many `coarser` ones on; a dot for each number that is compared with a reference.
///
/// # Errors
/// [`JudgeError`] for unknown names and refused scenes.
pub fn claimed(
    cases: Vec<Case>,
    selection: &Selection,
    coarser: usize,
    tell: &(dyn Fn(String) + Sync),
) -> Result<Vec<Dot>, JudgeError> {
    let cases = choose(cases, selection)?;
    let mut sources = Vec::new();
    for (number, (case, _)) in cases.iter().enumerate() {
        for variant in &case.variants {
            let source = match (&variant.source, &variant.lattices) {
                (Problem::Scene { text, set }, _) => {
                    // Scenes with the surfaces of their cases are built by these.
                    let scene = Scene::with_overrides(text, case.name, set);
                    scene.ok().map(|scene| Source::Scene(Box::new(scene)))
                }
                (Problem::Study(_), lattices) => lattices.clone().map(Source::Study),
            };
            sources.extend(source.map(|source| (number, variant.clone(), source)));
        }
    }
    let (next, ended, count) = (AtomicUsize::new(0), AtomicUsize::new(0), sources.len());
    let found: Mutex<Vec<(usize, usize, OnLattices)>> = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..selection.jobs.clamp(1, count.max(1)) {
            scope.spawn(|| {
                while let Some((number, variant, source)) = sources.get(next.fetch_add(1, Ordering::Relaxed))
                {
                    let at = ended.fetch_add(1, Ordering::Relaxed) + 1;
                    let ran = on_lattices(variant, source.clone(), coarser);
                    let how = match &ran {
                        Ok(ran) => format!("{} lattices", ran.outcomes.len()),
                        Err(why) => format!("no bar: {why}"),
                    };
                    tell(format!(
                        "[{at}/{count}] {}: {} {}: {how}",
                        cases[*number].0.name, variant.method, variant.grid
                    ));
                    if let Ok(ran) = ran {
                        let mut found = found.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
                        found.push((*number, at, ran));
                    }
                }
            });
        }
    });
    let mut found = found.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    found.sort_by_key(|(number, _, ran)| (*number, ran.variant.method.clone(), ran.variant.grid.clone()));
    let mut dots = Vec::new();
    for (number, (case, left_out)) in cases.iter().enumerate() {
        let own: Vec<&OnLattices> =
            found.iter().filter(|(of, _, _)| *of == number).map(|(_, _, ran)| ran).collect();
        for ran in &own {
            let on = |lattice: usize| of_lattice(case, left_out, &own, ran, lattice);
            let metrics: Vec<Vec<Metric>> = (0..ran.outcomes.len()).map(on).collect();
            dots.extend(dots::of(case, ran, &metrics));
        }
    }
    Ok(dots)
}

/// What a case finds of a run on one of its lattices, beside the others on theirs; nothing where it cannot.
fn of_lattice(
    case: &Case,
    left_out: &[Variant],
    own: &[&OnLattices],
    ran: &OnLattices,
    lattice: usize,
) -> Vec<Metric> {
    let of = |other: &&OnLattices| {
        let outcome = other.outcomes[lattice.min(other.outcomes.len() - 1)].clone();
        Run { variant: other.variant.clone(), outcome }
    };
    let runs = Runs { chosen: own.iter().map(of).collect(), left_out: left_out.to_vec() };
    let run = Run { variant: ran.variant.clone(), outcome: ran.outcomes[lattice].clone() };
    metrics(case, &run, &runs).unwrap_or_default()
}

/// What is run on its own lattice and those beside it, or on the first of these and those beside that, and so on.
fn on_lattices(variant: &Variant, source: Source, coarser: usize) -> Result<OnLattices, String> {
    let source = (0..coarser).try_fold(source, |source, _| source.coarser())?;
    let (mut spacings, mut outcomes) = (vec![1.0], Vec::new());
    // What is refused or ends early on another lattice leaves its numbers without an answer.
    let mut keep = |spacing: f64, outcome: Result<Outcome, String>| {
        if let Ok(outcome) = outcome {
            spacings.push(spacing);
            outcomes.push(outcome);
        }
    };
    let own = match &source {
        Source::Scene(scene) => {
            let Companions { lattices, .. } = scene.companions(1)?;
            let own = run(scene)?;
            lattices.iter().for_each(|companion| keep(companion.spacing, run(&companion.scene)));
            own
        }
        Source::Study(study) => {
            let others = study.others()?;
            let own = (study.run)(study.cells)?;
            let spacing = |cells: usize| study.cells as f64 / cells as f64;
            others.into_iter().for_each(|cells| keep(spacing(cells), (study.run)(cells)));
            own
        }
    };
    outcomes.insert(0, own);
    Ok(OnLattices { variant: variant.clone(), most: source.order(), spacings, outcomes })
}

/// Runs a scene.
fn run(scene: &Checked) -> Result<Outcome, String> {
    let model = scene.build(1).map_err(|error| error.to_string())?;
    Ok(Outcome::from(model.run(&mut Silent)))
}
