//! What is attached to the particles of a shell: lumped masses, edges tied to other sheets.

use sph_shell::Tie;

use super::build::Builder;
use super::cells::CellSets;
use crate::bodies::sets::Sets;
use crate::scene::ShellTie;
use crate::scene::error::SceneError;

impl Builder<'_> {
    /// Lumped masses, shared equally by the particles of their sets.
    pub(super) fn masses(&self, sets: &Sets) -> Result<Vec<(u32, f64)>, SceneError> {
        let mut all = Vec::new();
        for (i, lumped) in self.scene.shell.masses.iter().enumerate() {
            let path = self.scene.body_scope().path(&format!("masses[{i}].on"));
            let particles = sets.at(self.scene, &path, &lumped.on)?;
            let share = lumped.mass.get() / particles.len() as f64;
            all.extend(particles.iter().map(|&a| (a, share)));
        }
        Ok(all)
    }

    /// Edges and the cells that they hang on.
    pub(super) fn ties(&self, sets: &Sets, cells: &CellSets<'_>) -> Result<Vec<Tie>, SceneError> {
        let tie = |(i, ShellTie { edge, to }): (usize, &ShellTie)| {
            let own = self.scene.body_scope().below(&format!("ties[{i}]"));
            let edge = sets.at(self.scene, &own.path("edge"), edge)?.to_vec();
            Ok(Tie { edge, host: cells.at(&own.path("to"), to)? })
        };
        self.scene.shell.ties.iter().enumerate().map(tie).collect()
    }
}
