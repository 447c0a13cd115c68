//! Initial stresses: from a scene to cells, and whether anything is left to find.

use sph_shell::{Shell, StaticShell};

use super::balance::unbalanced;
use super::build::Builder;
use super::cells::CellSets;
use crate::scene::error::SceneError;
use crate::scene::{Analysis, InitialStress};

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
