//! The state from which a shell starts: initial stresses, the deflection of its imperfection, its velocity.

use nalgebra::{Rotation3, Unit};
use sph_core::{Cloud, Vec3};
use sph_shell::{Shell, StaticShell};

use crate::bodies::imperfect::{deflection, of_modes};
use crate::bodies::sets::Sets;
use crate::bodies::shell::balance::unbalanced;
use crate::bodies::shell::build::{Builder, assemble};
use crate::bodies::shell::cells::CellSets;
use crate::scene::body_in_scene::{BodyInScene, ShellInScene};
use crate::scene::error::SceneError;
use crate::scene::{Analysis, InitialStress, ShellScene};

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
            let rotation = along_the_arc(&n, &(n + turn));
            cloud.positions[a] += u;
            cloud.frames[a] = cloud.frames[a].rotated(&rotation);
            let edge: Vec3 = rotation * cloud.edge_normals[a];
            cloud.edge_normals[a] = edge;
        }
        Ok(cloud)
    }

    /// Gives particles and directors of its set the velocity of the scene, `v + ω × (x − p)` and `ω × d`; held parts stay at rest.
    pub(super) fn set_out(&self, sets: &Sets, shell: &mut Shell) -> Result<(), SceneError> {
        let Some(velocity) = &self.scene.shell.velocity else { return Ok(()) };
        let linear = self.turned(velocity.linear.unwrap_or_default());
        let (spin, point) = velocity.spin.map_or_else(Default::default, |spin| {
            (self.turned(spin.axis).normalize() * spin.rate, self.turned(spin.point))
        });
        let path = self.scene.body_scope().path("velocity.on");
        for &a in sets.at(self.scene, &path, velocity.on.as_deref().unwrap_or("all"))? {
            let a = a as usize;
            let about: Vec3 = shell.position(a) - point;
            shell.set_rate(a, linear + spin.cross(&about), spin.cross(&shell.director(a)));
        }
        Ok(())
    }
}

/// The turn of a unit normal along the arc to a direction, by sine and cosine: the cosine alone, which rounding takes beyond one, says nothing of small angles.
fn along_the_arc(n: &Vec3, to: &Vec3) -> Rotation3<f64> {
    let axis = n.cross(to);
    let angle = libm::atan2(axis.norm(), n.dot(to));
    Unit::try_new(axis, 0.0).map_or_else(Rotation3::identity, |axis| Rotation3::from_axis_angle(&axis, angle))
}
