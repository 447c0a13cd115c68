//! What is attached to the particles of a shell: lumped masses, springs to the ground, edges tied to other sheets.

use sph_core::{Cloud, EndWeights};
use sph_shell::{Spring, Tie};

use super::build::Builder;
use super::cells::CellSets;
use super::imported::Imported;
use crate::bodies::sets::{self, Sets};
use crate::scene::ShellTie;
use crate::scene::error::SceneError;

impl Builder<'_> {
    /// Lumped masses, shared equally by the particles of their sets.
    pub(super) fn masses(&self, sets: &Sets) -> Result<Vec<(u32, f64)>, SceneError> {
        let mut all = Vec::new();
        for (i, lumped) in self.scene.shell().masses.iter().enumerate() {
            let path = self.scene.body_scope().path(&format!("masses[{i}].on"));
            let particles = sets.at(self.scene, &path, &lumped.on)?;
            let share = lumped.mass / particles.len() as f64;
            all.extend(particles.iter().map(|&a| (a, share)));
        }
        Ok(all)
    }

    /// Springs to the ground, shared by the particles of their sets as forces are.
    pub(super) fn springs(
        &self,
        sets: &Sets,
        cloud: &Cloud,
        weights: EndWeights,
        imported: Option<&Imported>,
    ) -> Result<Vec<Spring>, SceneError> {
        let mut all = Vec::new();
        for (i, support) in self.scene.supports.iter().enumerate() {
            let Some(spring) = support.spring else { continue };
            let particles = sets.at(self.scene, &format!("supports[{i}].on"), &support.on)?;
            let edge = match imported {
                None => sets::edge(&support.on, particles, cloud, weights),
                Some(imported) => imported.along(particles),
            };
            let shares = edge.unwrap_or_else(|| sets::places(cloud, particles).map(|a| (a, 1.0)).collect());
            let each = spring.stiffness / shares.iter().map(|share| share.1).sum::<f64>();
            let stiffness = shares.into_iter().map(|(a, share)| (a, each * share)).collect();
            all.push(Spring { stiffness, direction: self.turned(spring.direction) });
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
        self.scene.shell().ties.iter().enumerate().map(tie).collect()
    }
}
