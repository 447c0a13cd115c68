//! Answers side by side: the same problem in time, without time, by finite elements, and as published.
//!
//! The error of an explicit run is split: what the same particles have without time is the discretisation, what is
//! left between the two is the dynamics (damping, unfinished rest, the stop criterion).

use crate::JudgeError;
use crate::figures::Numbers;
use crate::format::short;
use crate::judge::measure::frontier;
use crate::judge::{CaseResult, Metric, Record, Run, Solver};
use crate::methods::{CELL, ELEMENTS, RELAXED, STATIC};
use crate::metric_names::DYNAMICS;

/// One answer to a problem.
#[derive(Clone, Debug)]
pub struct Answer<'a> {
    /// The run.
    pub run: &'a Run,
    /// Error, in percent of the reference where there is one, else in the unit of the metric.
    pub error: f64,
    /// Part of an explicit run's error that comes from the dynamics, where a static run tells it.
    pub dynamics: Option<f64>,
}

/// Error and unit of a metric that is compared across solvers: percent of its reference where it has one.
pub fn relative(metric: &Metric) -> (Option<f64>, &str) {
    match metric.reference {
        Some(reference) if metric.unit != "%" => {
            (metric.error.map(|error| 100.0 * error / reference.abs()), "%")
        }
        _ => (metric.error, &metric.unit),
    }
}

/// Every run of a case with an error in its headline, in the order of the case.
pub fn answers(result: &CaseResult) -> Vec<Answer<'_>> {
    let Some(headline) = result.case.headline else { return Vec::new() };
    let pairs = result.runs.iter().zip(&result.records);
    pairs
        .filter_map(|(run, record)| {
            let error = relative(record.metric(headline.metric)?).0?;
            let dynamics = (run.is(CELL)).then(|| dynamics(result, run)).flatten();
            Some(Answer { run, error, dynamics })
        })
        .collect()
}

/// What the static run on the same lattice says about an explicit one.
fn dynamics(result: &CaseResult, run: &Run) -> Option<f64> {
    let twin = result.runs.find(STATIC, &run.variant.grid)?;
    relative(result.records[twin].metric(DYNAMICS)?).0
}

/// The unit in which the answers to a case are compared.
pub fn unit_of_answers(result: &CaseResult) -> String {
    let metric = |record: &Record| {
        result
            .case
            .headline
            .and_then(|headline| record.metric(headline.metric))
            .map(|m| relative(m).1.to_owned())
    };
    result.records.iter().find_map(metric).unwrap_or_default()
}

/// The answers of the default formulation, with and without time, of finite elements, and the published ones.
///
/// # Errors
/// [`JudgeError`] from references.
pub fn side_by_side(result: &CaseResult) -> Result<Option<Numbers>, JudgeError> {
    let Some(headline) = result.case.headline else { return Ok(None) };
    let all = answers(result);
    let mut chosen: Vec<&Answer> = all
        .iter()
        .filter(|a| [CELL, STATIC, RELAXED, ELEMENTS].contains(&a.run.variant.method.as_str()))
        .collect();
    // A table is worth its place where two solvers meet.
    let solvers = |solver: Solver| chosen.iter().any(|a| a.run.outcome.solver == solver);
    if [Solver::Explicit, Solver::Static, Solver::Relaxed, Solver::Elements]
        .into_iter()
        .filter(|&s| solvers(s))
        .count()
        < 2
    {
        return Ok(None);
    }
    chosen.sort_by_key(|a| (a.run.outcome.particles, a.run.outcome.solver));
    let best: Vec<usize> = {
        let points: Vec<_> =
            chosen.iter().map(|a| (a.run.outcome.seconds_per_point(), a.error.max(headline.floor))).collect();
        frontier(&points)
    };
    let mut rows: Vec<Vec<String>> = chosen
        .iter()
        .enumerate()
        .map(|(number, a)| {
            let outcome = &a.run.outcome;
            vec![
                outcome.solver.words().into(),
                a.run.variant.grid.clone(),
                outcome.dof.to_string(),
                outcome.steps.to_string(),
                short(a.error),
                a.dynamics.map(short).unwrap_or_default(),
                format!("{:.3}", outcome.wall_seconds),
                format!("{:.4}", outcome.seconds_per_point()),
                if best.contains(&number) { "●".into() } else { String::new() },
            ]
        })
        .collect();
    for published in (headline.published)()? {
        let error = published.error.map_or_else(|| "the reference".into(), short);
        let mut row = vec![published.source.to_owned(), String::new(), String::new(), String::new(), error];
        row.resize(9, String::new());
        rows.push(row);
    }
    let unit = unit_of_answers(result);
    let head = [
        "answer".into(),
        "grid".into(),
        "unknowns".into(),
        "steps".into(),
        format!("error [{unit}]"),
        format!("of it dynamics [{unit}]"),
        "wall [s]".into(),
        "a point [s]".into(),
        "best".into(),
    ];
    Ok(Some(Numbers {
        title: format!("{}: four answers", result.case.name),
        caption: format!(
            "Error: {}. Particles in time, the same particles and energy without time and relaxed, an independent \
             finite-element shell, and published results. The static error is that of the discretisation; what an explicit run adds is \
             the dynamics. Steps are those of time, points of a path, evaluations of relaxation, iterations of elements. A point is one equilibrium of the curve. ● marks what none beats in both error and cost.",
            headline.metric
        ),
        head: head.into(),
        rows,
    }))
}

/// One row a case: the judged answer of every solver (the worst, where a case has several problems), and published ones.
///
/// # Errors
/// [`JudgeError`] from references.
pub fn overview(results: &[CaseResult]) -> Result<Numbers, JudgeError> {
    let solvers = [(Solver::Explicit, CELL), (Solver::Static, STATIC), (Solver::Elements, ELEMENTS)];
    let mut rows = Vec::new();
    for result in results {
        let Some(headline) = result.case.headline else { continue };
        let all = answers(result);
        let cells = solvers.map(|(solver, method)| {
            let variants = result.runs.iter().map(|run| &run.variant).chain(&result.runs.left_out);
            let any = variants.into_iter().any(|variant| variant.usual);
            let stands = |a: &&Answer| a.run.variant.usual || !any;
            let own =
                || all.iter().filter(|a| a.run.outcome.solver == solver && a.run.variant.method == method);
            let worst = own().filter(stands).max_by(|a, b| a.error.total_cmp(&b.error));
            let worst = worst.or_else(|| own().max_by_key(|a| a.run.outcome.particles));
            worst.map_or_else(String::new, |a| {
                let dynamics = a.dynamics.map(|d| format!(", dynamics {}", short(d))).unwrap_or_default();
                let (grid, point) = (&a.run.variant.grid, a.run.outcome.seconds_per_point());
                format!("{}{dynamics} ({grid}, {point:.3} s)", short(a.error))
            })
        });
        if cells.iter().filter(|cell| !cell.is_empty()).count() < 2 {
            continue;
        }
        let published = (headline.published)()?.into_iter();
        let published: Vec<String> = published
            .map(|p| {
                p.error.map_or_else(|| p.source.to_owned(), |error| format!("{} {}", p.source, short(error)))
            })
            .collect();
        let mut row =
            vec![result.case.name.to_owned(), format!("{} [{}]", headline.metric, unit_of_answers(result))];
        row.extend(cells);
        row.push(published.join("; "));
        rows.push(row);
    }
    let [explicit, still, elements] = solvers.map(|(solver, _)| solver.words().to_owned());
    Ok(Numbers {
        title: "Four answers to each problem".into(),
        caption: "Error (grid, wall time of one point of the curve) of a run of usual fineness; where a case has several problems, \
                  of the worst. Dynamics is what an explicit run adds to the error of the same particles without time. Published \
                  answers without a number are themselves the reference."
            .into(),
        head: vec!["case".into(), "error of".into(), explicit, still, elements, "published".into()],
        rows,
    })
}
