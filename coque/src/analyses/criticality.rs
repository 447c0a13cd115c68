//! What was critical on a path of equilibria: for the summary, and as warnings.

use implicit_statics::{CriticalKind, Passed, Path, SnapEnergy};

use crate::WarningKind;
use crate::run::record::{CriticalSummary, RunRecord, place};

/// A path whose levels are given, or one that goes where the equilibria lead.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Follows {
    Levels,
    Arc,
}

const BY_ARC: &str = "follow the path itself with [analysis.arc-length]";
const SMALLER: &str = "take smaller steps there";

/// What a path calls states that no path of equilibria joins.
const LEFT: &str = "change of branch";

/// Takes over a snap between two levels of a relaxation, if there was one.
pub(crate) fn note_snap(release: &SnapEnergy, (low, high): (f64, f64), found: &mut RunRecord) {
    if !release.snapped() {
        return;
    }
    let message = format!(
        "between {} and {} the body snapped: it set free {:.1} times the energy that stable equilibria between the two can leave \
         over; the state found at {} is an equilibrium, but on another branch; take closer levels there, or {BY_ARC}",
        place(low, None),
        place(high, None),
        release.energy / release.most,
        place(high, None)
    );
    found.warn(WarningKind::PassedCritical, message);
    let (level, between) = (0.5 * (low + high), Some([low, high]));
    found.critical.push(CriticalSummary { kind: LEFT.into(), level, unit: None, between });
}

/// Takes over what was critical on a path; `unit` is that of the force where the level is one.
pub(crate) fn note(path: &Path, follows: Follows, unit: Option<&str>, found: &mut RunRecord) {
    let place = |level: f64| place(level, unit);
    let summary = |kind: &str, level: f64, between: Option<[f64; 2]>| CriticalSummary {
        kind: kind.into(),
        level,
        unit: unit.map(String::from),
        between,
    };
    for critical in &path.critical {
        let kind = match critical.kind {
            CriticalKind::Limit => "limit point",
            CriticalKind::Bifurcation if critical.left => "bifurcation, branch taken",
            CriticalKind::Bifurcation => "bifurcation",
        };
        let first = !found.critical.iter().any(|earlier| earlier.kind == kind);
        let (before, after) = critical.negative;
        if critical.kind == CriticalKind::Bifurcation && after > before && first && !critical.left {
            let message = format!(
                "beyond the bifurcation at {} the equilibria that follow are unstable in {after} of the ways to move: \
                 the shell leaves this path there, and with a slight imperfection it may leave before; `branches = \"stable\"` of \
                 [analysis.arc-length] goes along",
                place(critical.level)
            );
            found.warn(WarningKind::PassedCritical, message);
        }
        found.critical.push(summary(kind, critical.level, None));
    }
    for passage in &path.passages {
        let (low, high) = (passage.levels.0, passage.levels.1);
        let span = format!("between {} and {}", place(low), place(high));
        let between = Some([low, high]);
        let elsewhere =
            format!("the state found at {} is an equilibrium, but on another branch", place(high));
        let (message, kind, level) = match passage.what {
            Passed::Pivots => {
                let (before, after) = passage.negative;
                let message = format!(
                    "{span} the tangent goes from {before} to {after} negative pivots, and the critical points there were not \
                     located; {SMALLER}"
                );
                (message, "critical points, not located", 0.5 * (low + high))
            }
            Passed::Turn(level) => {
                let message = format!(
                    "the branch of equilibria turns back at {}: {elsewhere}, which the shell reaches by a snap; {BY_ARC}",
                    place(level)
                );
                (message, "turning point", level)
            }
            Passed::Steps(share) => {
                let message = format!(
                    "{span} what yields or rubs went by one step; by small ones it ends {:.1} % of the way beside the state found at {}: \
                     take more levels",
                    100.0 * share,
                    place(high)
                );
                found.warn(WarningKind::LargeHistoryStep, message);
                continue;
            }
            Passed::Branch => {
                let message = format!("{span} the branch of equilibria was left: {elsewhere}; {BY_ARC}");
                (message, LEFT, 0.5 * (low + high))
            }
            Passed::Unproved => {
                let message = format!(
                    "{span} the equilibria move farther than their tangents lead, and the branch could not be followed \
                     across: the state found at {} may lie on another; {SMALLER}, or {BY_ARC}",
                    place(high)
                );
                (message, "doubtful step", 0.5 * (low + high))
            }
        };
        found.warn(WarningKind::PassedCritical, message);
        // A limit point that was located is where its branch turns back.
        if !found.critical.iter().any(|critical| critical.level == level) {
            found.critical.push(summary(kind, level, between));
        }
    }
    if follows == Follows::Arc || found.warnings.iter().any(|warning| warning.kind == WarningKind::Unstable) {
        return;
    }
    if let Some(point) = path.points.iter().skip(1).find(|point| point.unstable > 0) {
        let message = format!(
            "from {} on equilibria were found that are unstable in {} of the ways to move: the shell would leave them; column \
             `negative_pivots` tells which",
            place(point.level()),
            point.unstable
        );
        found.warn(WarningKind::Unstable, message);
    }
}
