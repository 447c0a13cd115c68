//! Checks of the preload: which conditions, bodies and analyses it goes with.

use super::Checked;
use crate::scene::analysis::Analysis;
use crate::scene::error::SceneError;
use crate::scene::problem::Scene;
use crate::scene::statics::Prebuckling;

impl Scene {
    /// Whether anything is applied before the analysis.
    pub(crate) fn has_preload(&self) -> bool {
        let stressed = self.as_shell().is_some_and(|shell| !shell.initial_stress.is_empty());
        let applied =
            self.loads.iter().any(|load| load.preload) || self.supports.iter().any(|support| support.preload);
        applied || stressed && self.analysis.kind().preloads && !self.stress_drives()
    }

    /// Refuses a preload where nothing could apply or hold it.
    pub(super) fn check_preload(&self) -> Checked {
        let s = &self.scope();
        let refuse = |path: &str, bound: &str, repair: &str| {
            Err(SceneError::Choice(s.fault(path, "a preload", bound, repair)))
        };
        for (i, support) in self.supports.iter().enumerate().filter(|(_, support)| support.preload) {
            if support.motion().is_none() {
                let repair = "remove it: what stands still needs none";
                return refuse(
                    &format!("supports[{i}].preload"),
                    "`moved`, `rotated` or `turned` beside it",
                    repair,
                );
            }
        }
        let loads = self.loads.iter().position(|load| load.preload).map(|i| format!("loads[{i}].preload"));
        let motions = || self.supports.iter().position(|support| support.preload);
        let Some(path) = loads.or_else(|| motions().map(|i| format!("supports[{i}].preload"))) else {
            return Ok(());
        };
        if self.as_shell().is_none() {
            let bound = format!("none on a {}", self.body().word());
            return refuse(&path, &bound, "remove it: only shells are preloaded");
        }
        let kind = self.analysis.kind();
        if !kind.preloads {
            let repair = match kind.passes_time {
                true => "remove it, and let an `amplitude` bring the load up and hold it",
                false => {
                    "use [analysis.static], [analysis.arc-length], [analysis.modal] or [analysis.buckling]"
                }
            };
            return refuse(&path, &format!("none in {}", kind.name), repair);
        }
        match &self.analysis {
            Analysis::Buckling(wanted) if wanted.prebuckling == Prebuckling::Stress => {
                let bound = "\"rotations\" from a state with stresses of its own";
                let repair =
                    "leave it out: the stresses of the load alone are computed from an unloaded shell";
                Err(s.value("analysis.buckling.prebuckling", "\"stress\" beside a preload", bound, repair))
            }
            _ => Ok(()),
        }
    }
}
