//! Running: all chosen scenes on all cores, one thread a scene, then the verdicts case by case.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use coque::{Model, Rendering, RunOptions, Scene, Silent, TangentCost, render};

use super::asked::{asked, rest, silent};
use super::case::Case;
use super::metric::Metric;
use super::outcome::Outcome;
use super::pictured::{KeptFrames, Pictured, chosen, planes};
use super::record::Record;
use super::variant::{Effort, Problem, Run, Runs, Study, Variant};
use crate::JudgeError;

/// What is run, and how.
#[derive(Clone, Debug)]
pub struct Selection {
    /// Which runs of each case.
    pub set: Effort,
    /// Whether the cases are those that are to break: no picture is drawn of them.
    pub hard: bool,
    /// Only these cases; all if empty.
    pub names: Vec<String>,
    /// Scenes that run at the same time.
    pub jobs: usize,
    /// Whether frames of the pictured runs are kept for pages of their own.
    pub pages: bool,
}

/// A case with its runs and their records, in the same order.
pub struct CaseResult {
    /// The case.
    pub case: Case,
    /// The runs that were chosen.
    pub runs: Runs,
    /// Their records.
    pub records: Vec<Record>,
    /// What its picture is made from, if it has one.
    pub picture: Option<Pictured>,
}

/// Runs what is selected of some cases, and judges it; `tell` is called with one line whenever a run ends.
///
/// # Errors
/// [`JudgeError`] for unknown names, refused scenes, and references that are not there. A missed tolerance is no
/// error: it is in the records.
pub fn judge(
    cases: Vec<Case>,
    selection: &Selection,
    tell: &(dyn Fn(String) + Sync),
) -> Result<Vec<CaseResult>, JudgeError> {
    let chosen_cases = choose(cases, selection)?;
    let mut works = Vec::new();
    for (case, _) in &chosen_cases {
        let first = works.len();
        for variant in &case.variants {
            works.push((case.name, variant, build(case.name, variant)?));
        }
        // The page of the hard cases is their table.
        let sizes: Vec<usize> = works[first..].iter().map(|(_, _, work)| work.particles()).collect();
        let chosen = if selection.hard { None } else { chosen(case, &sizes) };
        if let Some(Work::Particles { pictured, .. }) = chosen.map(|number| &mut works[first + number].2) {
            *pictured = true;
        }
    }
    let mut outcomes = run_all(works, selection, tell)?.into_iter();
    chosen_cases
        .into_iter()
        .map(|(case, left_out)| {
            let of_case = case.variants.iter().cloned().zip(outcomes.by_ref());
            let mut picture = None;
            let chosen = of_case.map(|(variant, (outcome, pictured))| {
                picture = picture.take().or(pictured);
                Run { variant, outcome }
            });
            let runs = Runs { chosen: chosen.collect(), left_out };
            let records = records(&case, &runs)?;
            Ok(CaseResult { case, runs, records, picture })
        })
        .collect()
}

/// The exit code of the program: 1 if any record misses a tolerance.
pub fn exit_code(results: &[CaseResult]) -> u8 {
    u8::from(results.iter().flat_map(|result| &result.records).any(|record| !record.passes()))
}

/// The chosen cases, each with the variants that were not chosen.
pub(crate) fn choose(all: Vec<Case>, selection: &Selection) -> Result<Vec<(Case, Vec<Variant>)>, JudgeError> {
    for name in &selection.names {
        if !all.iter().any(|case| case.name == name) {
            let known = all.iter().map(|case| case.name).collect::<Vec<_>>().join(", ");
            return Err(JudgeError::UnknownCase { name: name.clone(), known });
        }
    }
    let named =
        |case: &Case| selection.names.is_empty() || selection.names.iter().any(|name| case.name == name);
    let split = |mut case: Case| {
        let (chosen, left_out) = case.variants.drain(..).partition(|v| v.effort.belongs_to(selection.set));
        case.variants = chosen;
        (case, left_out)
    };
    let chosen: Vec<_> =
        all.into_iter().filter(named).map(split).filter(|(case, _)| !case.variants.is_empty()).collect();
    if chosen.is_empty() { Err(JudgeError::NothingToRun) } else { Ok(chosen) }
}

/// What a worker does.
enum Work {
    /// Runs a scene.
    Particles {
        /// The scene, built.
        model: Box<Model>,
        /// Axes of its symmetry planes.
        planes: Vec<usize>,
        /// Whether it is the run that the report draws.
        pictured: bool,
    },
    /// Does something else.
    Study(Study),
}

impl Work {
    /// Particles of a scene; none of a study.
    fn particles(&self) -> usize {
        match self {
            Self::Particles { model, .. } => model.description.particles,
            Self::Study(_) => 0,
        }
    }
}

/// What a work leaves behind.
type Left = (Outcome, Option<Pictured>);

fn build(case: &'static str, variant: &Variant) -> Result<Work, JudgeError> {
    let (text, set) = match &variant.source {
        Problem::Scene { text, set } => (*text, set),
        Problem::Study(study) => return Ok(Work::Study(study.clone())),
    };
    let how = Rendering { width: 110, colour: false };
    let origin = format!("scene of {case}");
    Scene::with_overrides(text, &origin, set)
        .and_then(|scene| scene.build(1).map(|model| (planes(&scene, &model), model)))
        .map(|(planes, model)| Work::Particles { model: Box::new(model), planes, pictured: false })
        .map_err(|error| JudgeError::Scene {
            case,
            method: variant.method.clone(),
            text: render(&error, how),
        })
}

/// Workers take the next scene from one queue, the dearest first, so that none is left with a long one at the end.
///
/// What runs alone comes after all others, one by one.
fn run_all(
    works: Vec<(&'static str, &Variant, Work)>,
    &Selection { jobs, pages, .. }: &Selection,
    tell: &(dyn Fn(String) + Sync),
) -> Result<Vec<Left>, JudgeError> {
    let count = works.len();
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&a, &b| rough_cost(&works[b].2).total_cmp(&rough_cost(&works[a].2)));
    let (alone, shared): (Vec<usize>, Vec<usize>) = order.into_iter().partition(|&at| works[at].1.alone);
    let labels: Vec<(&'static str, String)> =
        works.iter().map(|(case, v, _)| (*case, v.method.clone())).collect();
    let grids: Vec<String> = works.iter().map(|(_, v, _)| v.grid.clone()).collect();
    let queue: Vec<Mutex<Option<Work>>> =
        works.into_iter().map(|(_, _, work)| Mutex::new(Some(work))).collect();
    let outcomes: Vec<Mutex<Option<Result<Left, String>>>> = (0..count).map(|_| Mutex::new(None)).collect();
    let ended = AtomicUsize::new(0);
    let in_order = |order: &[usize], jobs: usize| {
        let next = AtomicUsize::new(0);
        std::thread::scope(|scope| {
            for _ in 0..jobs.clamp(1, count) {
                scope.spawn(|| {
                    while let Some(&at) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
                        let outcome = match take(&queue[at]) {
                            Some(Work::Particles { model, pictured: false, .. }) => {
                                Ok((Outcome::from(model.run(&mut Silent)), None))
                            }
                            Some(Work::Particles { model, planes, pictured: true }) => {
                                let (_, method) = &labels[at];
                                let mut kept = KeptFrames::new(pages);
                                run_pictured(*model, &mut kept).map(|outcome| {
                                    (outcome, kept.pictured(format!("{method}, {}", grids[at]), planes))
                                })
                            }
                            Some(Work::Study(study)) => timed(&study).map(|outcome| (outcome, None)),
                            None => continue,
                        };
                        let number = ended.fetch_add(1, Ordering::Relaxed) + 1;
                        let how = match &outcome {
                            Ok((Outcome { failure: Some(failure), .. }, _)) => failure.clone(),
                            Ok((outcome, _)) => {
                                let warnings = outcome.warnings().into_iter().map(|word| format!(", {word}"));
                                format!("{:.1} s{}", outcome.wall_seconds, warnings.collect::<String>())
                            }
                            Err(cause) => cause.clone(),
                        };
                        let (case, method) = &labels[at];
                        tell(format!("[{number}/{count}] {case}: {method} {}: {how}", grids[at]));
                        *outcomes[at].lock().unwrap_or_else(std::sync::PoisonError::into_inner) =
                            Some(outcome);
                    }
                });
            }
        });
    };
    in_order(&shared, jobs);
    in_order(&alone, 1);
    let outcomes = outcomes.iter().filter_map(take).zip(labels);
    outcomes
        .map(|(outcome, (case, method))| outcome.map_err(|cause| JudgeError::Study { case, method, cause }))
        .collect()
}

/// Runs a study; one that does not say how long its analysis took is taken as a whole.
fn timed(study: &Study) -> Result<Outcome, String> {
    let start = Instant::now();
    let mut outcome = study()?;
    if outcome.wall_seconds == 0.0 {
        outcome.wall_seconds = start.elapsed().as_secs_f64();
    }
    Ok(outcome)
}

/// Runs a scene and keeps the frames that the report draws.
fn run_pictured(model: Model, kept: &mut KeptFrames) -> Result<Outcome, String> {
    let options = RunOptions { progress: &mut Silent, checkpoints: None, fields: Some(kept), from: None };
    model.run_with(options).map(Outcome::from).map_err(|error| error.to_string())
}

fn take<T>(cell: &Mutex<Option<T>>) -> Option<T> {
    cell.lock().unwrap_or_else(std::sync::PoisonError::into_inner).take()
}

/// Orders runs by time, not more: particles × points of a stencil × steps, where steps grow as the spacing falls.
fn rough_cost(work: &Work) -> f64 {
    // Finite elements take about as long as an explicit run of this many particles.
    let Work::Particles { model, .. } = work else { return libm::pow(100.0_f64, 1.5) };
    let particles = model.description.particles as f64;
    // A wide stencil takes about five times as long as a cell of four particles.
    let stencil = if matches!(model.description.tangent, TangentCost::Steps(_)) { 1.0 } else { 5.0 };
    libm::pow(particles, 1.5) * stencil
}

fn records(case: &Case, runs: &Runs) -> Result<Vec<Record>, JudgeError> {
    let mut records = Vec::new();
    for run in runs.iter() {
        let metrics = metrics(case, run, runs)?;
        records.push(Record::new(case, &run.variant, &run.outcome, metrics));
    }
    for (number, metric) in (case.together)(runs)? {
        records[number].metrics.push(metric);
    }
    for (run, record) in runs.iter().zip(&mut records) {
        let silent = silent(run, &record.metrics);
        record.metrics.extend(silent);
    }
    Ok(records)
}

/// What a case measures of a run, but for what needs several.
///
/// # Errors
/// [`JudgeError`] of the case.
pub(crate) fn metrics(case: &Case, run: &Run, runs: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let mut metrics = (case.each)(run)?;
    metrics.extend(rest(run));
    metrics.extend(asked(run, runs)?);
    if let Some(judged) = &run.variant.judged {
        metrics.extend(judged(run, runs)?);
    }
    Ok(metrics)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCENE: &str = include_str!("../../../scenes/ring.toml");

    fn case(each: fn(&Run) -> Result<Vec<Metric>, JudgeError>) -> Case {
        let strip = Variant::new("cell", SCENE, "plate", [5, 3]);
        let variants = vec![strip.set("analysis.explicit.quasi-static.levels", "[0.01]").quick()];
        Case { name: "made-up", variants, each, ..Case::default() }
    }

    fn result(case: Case) -> CaseResult {
        let variant = &case.variants[0];
        let work = build(case.name, variant).unwrap();
        let selection =
            Selection { set: Effort::Quick, hard: false, names: Vec::new(), jobs: 1, pages: false };
        let (outcome, _) = run_all(vec![(case.name, variant, work)], &selection, &|_| {}).unwrap().remove(0);
        let runs = Runs { chosen: vec![Run { variant: variant.clone(), outcome }], left_out: Vec::new() };
        let records = records(&case, &runs).unwrap();
        CaseResult { case, runs, records, picture: None }
    }

    #[test]
    fn a_missed_tolerance_gives_exit_code_one() {
        let kept = result(case(|run| {
            let tip = run.at("W_tip", 0.01)?;
            Ok(vec![Metric::error("tip", tip, "cm").within(10.0, "made up")])
        }));
        assert_eq!(exit_code(std::slice::from_ref(&kept)), 0, "{:?}", kept.records);
        let missed = result(case(|run| {
            let tip = run.at("W_tip", 0.01)?;
            Ok(vec![Metric::error("tip", tip, "cm").within(1e-6, "made up")])
        }));
        assert_eq!(exit_code(&[kept, missed]), 1);
    }

    #[test]
    fn a_level_that_was_never_reached_fails() {
        let absent = result(case(|run| {
            let tip = run.at("W_tip", 0.5)?;
            Ok(vec![Metric::error("tip", tip, "cm").within(1e9, "made up")])
        }));
        assert_eq!(exit_code(&[absent]), 1);
    }

    #[test]
    fn an_unknown_column_names_the_known_ones() {
        let run = &result(case(|_| Ok(Vec::new()))).runs.chosen[0];
        let error = run.column("w_tip").unwrap_err().to_string();
        assert!(error.contains("W_tip"), "{error}");
    }

    #[test]
    fn cases_are_chosen_by_name_and_by_what_they_cost() {
        use Effort::{Full, Heavy, Quick, Usual};
        let selection = |set, names: &[&str]| Selection {
            set,
            hard: false,
            names: names.iter().map(ToString::to_string).collect(),
            jobs: 1,
            pages: false,
        };
        let all = || {
            [("made-up", Quick), ("slow", Usual), ("long", Full), ("expensive", Heavy)]
                .map(|(name, effort)| {
                    let mut case = case(|_| Ok(Vec::new()));
                    case.name = name;
                    case.variants[0].effort = effort;
                    case
                })
                .into()
        };
        let chosen = |set, names: &[&str]| {
            choose(all(), &selection(set, names))
                .map(|cases| cases.iter().map(|(case, _)| case.name).collect::<Vec<_>>())
        };
        assert_eq!(chosen(Full, &[]).unwrap(), ["made-up", "slow", "long"]);
        assert_eq!(chosen(Usual, &[]).unwrap(), ["made-up", "slow"]);
        assert_eq!(chosen(Quick, &[]).unwrap(), ["made-up"]);
        assert_eq!(chosen(Heavy, &[]).unwrap(), ["expensive"]);
        assert_eq!(chosen(Full, &["slow"]).unwrap(), ["slow"]);
        assert!(matches!(chosen(Quick, &["slow"]), Err(JudgeError::NothingToRun)));
        let error = chosen(Full, &["fast"]).unwrap_err().to_string();
        assert!(error.contains("made-up, slow, long"), "{error}");
    }
}
