//! Checks of the analysis that need no particles.

use super::base::check_base;
use super::harmonic::check_harmonic;
use super::spectrum::{check_noise, check_spectrum};
use crate::scene::analysis::{Analysis, Damping, Explicit};
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::levels::Levels;
use crate::scene::problem::BodyScene;
use crate::scene::shell::formulation::Formulation;
use crate::scene::statics::{ArcLength, Branches, Linear, LinearSolver, Relaxation, Static, Stop};
use crate::scene::tools::ToolScene;

/// Every level is a ramp and a hold; more than this is a mistake.
const MOST_LEVELS: u64 = 100_000;
/// Rows of a curve that still fit in memory and on a plot.
const MOST_RECORDS: f64 = 1e7;

/// Refuses numbers out of bounds and what does not go with the analysis.
pub(super) fn check_analysis(scene: &BodyInScene<'_>) -> Verdict {
    match &scene.analysis {
        Analysis::Explicit(explicit) => check_explicit(scene, explicit)?,
        Analysis::Linear(wanted) => check_linear(scene, wanted)?,
        Analysis::Static(Static { levels, one_solve, .. }) => {
            check_levels(scene, "analysis.static.levels", levels)?;
            check_one_solve(scene, *one_solve)?;
        }
        Analysis::ArcLength(path) => check_arc_length(scene, path)?,
        Analysis::Relaxation(Relaxation { levels, .. }) => {
            check_levels(scene, "analysis.relaxation.levels", levels)?;
        }
        Analysis::Harmonic(wanted) => check_harmonic(scene, wanted)?,
        Analysis::ResponseSpectrum(wanted) => check_spectrum(scene, wanted)?,
        Analysis::RandomVibration(wanted) => check_noise(scene, wanted)?,
        Analysis::Heat(wanted) => {
            if let Some(run) = &wanted.transient {
                let at = "analysis.heat.transient";
                scene.scope().sized(&format!("{at}.start"), run.start.unwrap_or_default())?;
                check_records(scene, at, [run.duration.get(), run.record_every.get()])?;
            }
        }
        Analysis::Modal(_) | Analysis::Buckling(_) => {}
    }
    let kind = scene.analysis.kind();
    if kind.wants_tangent {
        check_tangent(scene)?;
    }
    // Of several bodies one that is driven is enough.
    if kind.wants_driver && !scene.together { check_driver(scene) } else { Ok(()) }
}

fn check_linear(scene: &BodyInScene<'_>, Linear { solver, iterations, .. }: &Linear) -> Verdict {
    let at = "analysis.linear.iterations";
    if let (LinearSolver::Direct, Some(iterations)) = (solver, iterations) {
        let bound = "left out where the solver is \"direct\": a factor does not iterate";
        let repair = "leave it out, or add solver = \"conjugate-gradients\"";
        return Err(scene.scope().value(at, iterations, bound, repair));
    }
    check_solver(scene, *solver)
}

/// What breaks does so in states of balance.
fn check_one_solve(scene: &BodyInScene<'_>, one_solve: bool) -> Verdict {
    if !(one_solve && has_fracture(scene)) {
        return Ok(());
    }
    let bound = "false where bonds break (`fracture`): they do so in states of balance, which one solve a step does not find";
    let fault = scene.scope().fault("analysis.static.one_solve", "true", bound, "remove it, or `fracture`");
    Err(SceneError::Choice(fault))
}

/// What breaks has its limit met by steps along one branch.
fn check_branches(scene: &BodyInScene<'_>, branches: Branches) -> Verdict {
    let given = match branches {
        Branches::Primary => return Ok(()),
        Branches::Stable => "\"stable\"",
        Branches::StableReversed => "\"stable-reversed\"",
    };
    if !has_fracture(scene) {
        return Ok(());
    }
    let bound = "\"primary\" where bonds break (`fracture`): the first step on a branch does not end where the first bond breaks";
    let fault = scene.scope().fault("analysis.arc-length.branches", given, bound, "remove it, or `fracture`");
    Err(SceneError::Choice(fault))
}

fn has_fracture(scene: &BodyInScene<'_>) -> bool {
    let breaks = |body: &BodyScene| matches!(body, BodyScene::Solid(solid) if solid.fracture.is_some());
    breaks(scene.body)
}

/// Coarser unknowns are built on rigid motions, which only shells tell.
fn check_solver(scene: &BodyInScene<'_>, solver: LinearSolver) -> Verdict {
    if solver == LinearSolver::Direct || matches!(scene.body, BodyScene::Shell(_)) {
        return Ok(());
    }
    let (at, given) = ("analysis.linear.solver", "\"conjugate-gradients\"");
    let bound = "\"direct\" where the body is no shell";
    Err(SceneError::Choice(scene.scope().fault(at, given, bound, "leave it out")))
}

fn check_explicit(scene: &BodyInScene<'_>, explicit: &Explicit) -> Verdict {
    let s = &scene.scope();
    let known = ["quasi-static", "transient"];
    let mut given = Vec::new();
    given.extend(explicit.quasi_static.as_ref().map(|_| known[0]));
    given.extend(explicit.transient.as_ref().map(|_| known[1]));
    s.exactly_one("analysis.explicit", "table", &given, &known)?;
    if let Some(path) = &explicit.quasi_static {
        let at = |key: &str| format!("analysis.explicit.quasi-static.{key}");
        check_levels(scene, &at("levels"), &path.levels)?;
        if has_strong_form(scene) && path.stability == Some(true) {
            let repair = "use [formulation.stress-point] or [formulation.nodal], or leave `stability` out";
            let bound = "one with an energy, and so a tangent, to look at stability";
            let fault = scene.body_scope().fault(
                "formulation.strong-form",
                "a formulation without energy",
                bound,
                repair,
            );
            return Err(SceneError::Choice(fault));
        }
        if let Damping::Ratio(ratio) = path.damping {
            s.positive(&at("damping.ratio"), ratio)?;
        }
    }
    if let Some(run) = &explicit.transient {
        if let Some(base) = &run.base {
            check_base(scene, base, run.duration.get())?;
        }
        let times = [run.duration.get(), run.record_every.get()];
        check_records(scene, "analysis.explicit.transient", times)?;
    }
    Ok(())
}

/// Refuses rows that are none, or more than any curve has.
fn check_records(scene: &BodyInScene<'_>, at: &str, [duration, every]: [f64; 2]) -> Verdict {
    if every > duration || duration / every > MOST_RECORDS {
        let bound = format!("at most the duration, and at least its {MOST_RECORDS:e}th part");
        let repair = "a hundredth of the duration gives a smooth curve";
        return Err(scene.scope().value(&format!("{at}.record_every"), every, &bound, repair));
    }
    Ok(())
}

/// Whether levels may fall as well: where what a body went through is left when it is let go.
fn may_fall(scene: &BodyInScene<'_>) -> bool {
    let yields = scene.as_shell().is_some_and(|shell| shell.yields())
        || scene.as_solid().is_some_and(|solid| solid.material.yields());
    matches!(scene.analysis, Analysis::Static(_)) && yields
}

fn check_levels(scene: &BodyInScene<'_>, at: &str, levels: &Levels) -> Verdict {
    let s = &scene.scope();
    match levels {
        Levels::Equal(count) if (1..=MOST_LEVELS).contains(count) => Ok(()),
        Levels::Equal(count) => Err(s.value(at, count, &format!("from 1 to {MOST_LEVELS}"), "10 is usual")),
        Levels::List(list) if list.is_empty() => {
            Err(s.value(at, "empty", "a list of at least one level", "levels = [1.0] goes to the full load"))
        }
        Levels::List(list) => {
            let mut last = 0.0;
            for (i, &level) in list.iter().enumerate() {
                let path = format!("{at}[{i}]");
                s.sized(&path, level)?;
                let falls = level < last && level >= 0.0 && may_fall(scene);
                if level <= last && !falls {
                    let (bound, repair) = match may_fall(scene) {
                        true => (
                            format!("zero or positive, and other than the level {last} before it"),
                            "what yields may be let go, to level 0",
                        ),
                        false => (
                            format!("greater than the level {last} before it"),
                            "sort the levels; they start above 0",
                        ),
                    };
                    return Err(s.value(&path, level, &bound, repair));
                }
                last = level;
            }
            Ok(())
        }
    }
}

fn check_arc_length(scene: &BodyInScene<'_>, path: &ArcLength) -> Verdict {
    let s = &scene.scope();
    let at = |key: &str| format!("analysis.arc-length.{key}");
    let known = ["until", "stop"];
    let mut given = Vec::new();
    given.extend(path.until.map(|_| known[0]));
    given.extend(path.stop.as_ref().map(|_| known[1]));
    s.exactly_one("analysis.arc-length", "end of the path", &given, &known)?;
    if let Some(Stop { column, above }) = &path.stop {
        let own = scene.curve.iter().map(|probe| probe.name.as_str());
        let known: Vec<&str> = scene.analysis.columns().chain(own).collect();
        s.word(&at("stop.column"), column, &known)?;
        s.sized(&at("stop.above"), *above)?;
    }
    check_branches(scene, path.branches)
}

/// Whether the body is a shell by the published equations, which have no energy.
fn has_strong_form(scene: &BodyInScene<'_>) -> bool {
    scene.as_shell().is_some_and(|shell| matches!(shell.formulation, Formulation::StrongForm(_)))
}

fn check_tangent(scene: &BodyInScene<'_>) -> Verdict {
    if !has_strong_form(scene) {
        return Ok(());
    }
    let bound = format!("one with an energy, and so a tangent, in {}", scene.analysis.kind().name);
    let repair = "use [formulation.stress-point] or [formulation.nodal], or [analysis.explicit]";
    let path = "formulation.strong-form";
    Err(SceneError::Choice(scene.body_scope().fault(path, "a formulation without energy", &bound, repair)))
}

/// One load level drives the analysis: loads, prescribed motions, or both.
pub(super) fn check_driver(scene: &BodyInScene<'_>) -> Verdict {
    if scene.stress_drives() {
        return Ok(());
    }
    let (s, what) = (&scene.scope(), scene.analysis.kind().name);
    let supports = scene.supports.iter().filter(|support| !support.preload);
    let motions = || supports.clone().filter_map(|support| Some((support, support.motion()?)));
    if scene.body.tools().iter().any(ToolScene::is_driven_by_level) {
        return Ok(());
    }
    if scene.loads.iter().any(|load| !load.preload) || motions().any(|(_, (_, by))| by != 0.0) {
        return Ok(());
    }
    let Some((support, (word, by))) = motions().next() else {
        let repair = "add a load, or a support with `moved`";
        let fault = s.fault("loads", "nothing", &format!("something that drives {what}"), repair);
        return Err(SceneError::Choice(fault));
    };
    let bound = format!("other than zero: it drives {what}");
    let repair = "hold a direction by `symmetry`, `diaphragm` or `hinged`";
    Err(s.value(&support.at(&format!("{word}.by")), by, &bound, repair))
}
