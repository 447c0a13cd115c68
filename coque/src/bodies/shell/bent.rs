//! A shell with the deflection of its imperfection.

use nalgebra::Rotation3;
use sph_core::{Cloud, Vec3};
use sph_shell::StaticShell;

use super::build::{Builder, assemble};
use crate::bodies::imperfect::{deflection, of_modes};
use crate::scene::ShellScene;
use crate::scene::body_in_scene::{BodyInScene, ShellInScene};
use crate::scene::error::SceneError;

impl Builder<'_> {
    /// The particles where the imperfection puts them, frames and normals of edges turned with the directors of its mode; areas and
    /// lengths stay, which bending leaves alone in the first order.
    pub(crate) fn bent(&self, mut cloud: Cloud, threads: usize) -> Result<Cloud, SceneError> {
        let Some(imperfection) = self.scene.shell.imperfection else { return Ok(cloud) };
        let modes = of_modes(self.scene.scene);
        let view = BodyInScene::new(&modes, self.scene.name, self.scene.body)?;
        let perfect = ShellScene { imperfection: None, ..self.scene.shell.clone() };
        let built = assemble(&ShellInScene::new(&view, &perfect), threads, None)?;
        let mut system = StaticShell::new(built.shell);
        let read = |system: &StaticShell| {
            let shell = system.shell();
            let all = 0..shell.rest_positions().len();
            [all.clone().map(|a| shell.position(a)).collect(), all.map(|a| shell.director(a)).collect()]
        };
        let found = deflection(self.scene, &imperfection, &mut system, read, |v| self.turn_back(v))?;
        for (a, (u, turn)) in found.displacements.iter().zip(&found.turns).enumerate() {
            let n = cloud.frames[a].n;
            // Along the arc to the director, which turns about n × δ.
            let rotation = Rotation3::rotation_between(&n, &(n + turn)).unwrap_or_else(Rotation3::identity);
            cloud.positions[a] += u;
            cloud.frames[a] = cloud.frames[a].rotated(&rotation);
            let edge: Vec3 = rotation * cloud.edge_normals[a];
            cloud.edge_normals[a] = edge;
        }
        Ok(cloud)
    }
}
