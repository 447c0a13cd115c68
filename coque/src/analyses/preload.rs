//! The preload: what is applied in full before the analysis, by equilibria, and held from then on.

use implicit_statics::{Control, End, NewtonOptions, Point, Start, follow};

use super::breaking::note_breaches;
use super::criticality::{Follows, note};
use super::path::{newton, options, read};
use crate::bodies::StaticBody;
use crate::run::Run;
use crate::run::checkpoint::Stage;
use crate::run::outcome::{Ended, Failure};
use crate::run::record::{PreloadSummary, RunRecord};
use crate::scene::{Analysis, Levels, Static};

const LESS: &str = "the preload needs smaller steps than it can make; apply less of it";

/// Brings the preload up, if there is one, by the steps of a static analysis with one level; its points are no rows of the curve. True if
/// there is one.
///
/// # Errors
/// How the run ends where the preload is not reached.
pub(crate) fn preload(
    analysis: &Analysis,
    system: &mut dyn StaticBody,
    run: &mut Run<'_>,
) -> Result<bool, Box<Ended>> {
    if !system.begin_preload() {
        return Ok(false);
    }
    if run.checkpoints.is_some() {
        run.keep_checkpoint(&Stage::Preload, system);
    }
    let usual = Static::at(Levels::Equal(1));
    let (tolerance, iterations) = match analysis {
        Analysis::Static(wanted) => (wanted.tolerance, wanted.iterations),
        Analysis::ArcLength(wanted) => (wanted.tolerance, wanted.iterations),
        _ => (usual.tolerance, usual.iterations),
    };
    let newton =
        NewtonOptions { line_search: system.opens_and_closes(), ..newton(tolerance.get(), iterations.get()) };
    let options = options(system, Control::Load { step: 1.0, until: 1.0 }, &newton);
    let mut internal = 0.0;
    let path = follow(system, &Start::default(), &options, |point, system| {
        // Every point is read: rotations are counted on from one reading to the next.
        internal = read(run, system, point, point.converged.iterations)[1];
        run.tell(0.0, point.step as u64, 0.0, internal)
    });
    let mut found = RunRecord::default();
    note_breaches(&path.breaches, None, &mut run.record);
    note(&path, Follows::Levels, None, &mut found);
    for mut warning in found.warnings {
        warning.message = format!("in the preload: {}", warning.message);
        run.record.warnings.push(warning);
    }
    let steps = path.points.len().saturating_sub(1) as u64;
    run.record.preload = Some(PreloadSummary {
        points: steps,
        newton_iterations: path.points.iter().map(|point| point.converged.iterations as u64).sum(),
        internal,
        negative_pivots: path.points.last().map_or(0, |point: &Point| point.inertia().negative),
        critical: found.critical,
    });
    let level = path.restart.level;
    match path.end {
        Ok(End::Reached) => {}
        Ok(End::Stopped) => return Err(Box::new(Ended::Interrupted { time: 0.0, level: 0.0 })),
        Ok(End::Steps) => {
            let failure = Failure::Steps { steps: options.steps, level, repair: LESS };
            return Err(Box::new(Ended::Diverged(failure)));
        }
        Err(cause) => {
            return Err(Box::new(Ended::Diverged(Failure::Preload { points: steps, level, cause })));
        }
    }
    if matches!(analysis, Analysis::Modal(_)) || analysis.swings() {
        run.warn_of_skew_loads(system.skew_load_share());
    }
    system.end_preload();
    // Axes of the unknowns that were carried along are dropped, as a run that goes on from here has none.
    let state = system.save();
    system.restore(&state);
    Ok(true)
}
