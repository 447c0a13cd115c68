//! Initial stresses: from a scene to cells, whether anything is left to find, and whether a run sets out in balance.

use sph_shell::{Shell, StaticShell};

use super::build::Builder;
use super::cells::CellSets;
use crate::scene::body_in_scene::ShellInScene;
use crate::scene::error::SceneError;
use crate::scene::{Analysis, InitialStress};
use crate::warning::{Warning, WarningKind};

/// Part of the forces of an initial stress up to which it counts as balanced: rounding leaves 1e-14, and to Newton's method
/// the rest would be little else.
const BALANCED: f64 = 1e-7;

/// Whether the supports of a shell leave a part of its initial stress without balance where it stands.
pub(super) fn unbalanced<S: std::ops::DerefMut<Target = Shell>>(system: &mut StaticShell<S>) -> bool {
    system.unbalanced_stress() > BALANCED
}

impl Builder<'_> {
    /// The initial stresses of the scene.
    ///
    /// # Errors
    /// [`SceneError`] for sets without cells.
    pub(super) fn stresses(&self, cells: &CellSets<'_>) -> Result<Vec<sph_shell::InitialStress>, SceneError> {
        let all = &self.scene.shell.initial_stress;
        let stress = |(i, stress): (usize, &InitialStress)| {
            let path = self.scene.body_scope().path(&format!("initial_stress[{i}].on"));
            Ok(sph_shell::InitialStress {
                cells: cells.at(&path, &stress.on)?,
                axis: stress.axis.map(|axis| self.turned(axis)),
                membrane: stress.membrane.unwrap_or_default(),
                bending: stress.bending.unwrap_or_default(),
            })
        };
        all.iter().enumerate().map(stress).collect()
    }

    /// Refuses a path along which an initial stress alone is brought up and nothing would happen.
    ///
    /// # Errors
    /// [`SceneError::Choice`] for such a path.
    pub(super) fn refuse_stress_alone(&self, shell: &mut Shell) -> Result<(), SceneError> {
        if !self.scene.stress_drives() {
            return Ok(());
        }
        let path = matches!(self.scene.analysis, Analysis::Static(_) | Analysis::ArcLength(_));
        if path && !unbalanced(&mut StaticShell::lent(shell)) {
            let bound = "something that drives the analysis: the stress is in balance where the shell stands, and nothing would move";
            let repair = "add a load, or look at it with [analysis.modal] or [analysis.buckling]";
            let fault = self.scene.source.fault("loads", "an initial stress alone", bound, repair);
            return Err(SceneError::Choice(fault));
        }
        Ok(())
    }
}

/// What is doubtful about a march that sets out under initial stress.
pub(super) fn warning_of_start(scene: &ShellInScene<'_>, shell: &mut Shell) -> Option<Warning> {
    if !(shell.is_stressed() && scene.analysis.kind().passes_time) {
        return None;
    }
    let part = StaticShell::lent(shell).unbalanced_stress();
    (part > BALANCED).then(|| {
        let message = format!(
            "at the start {:.1} % of the forces of the initial stress are balanced by nothing, at most {BALANCED:e} of them count as rest: \
             the shell springs from where it is drawn. If it is to set out at rest, find its balance with [analysis.static] and draw \
             that, or let damping take the motion away",
            100.0 * part
        );
        Warning::new(WarningKind::NotAtRest, message)
    })
}
