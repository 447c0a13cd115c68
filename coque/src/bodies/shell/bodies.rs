//! Rigid sets of a shell: where their bodies stand, what holds them, what acts on them.

use nalgebra::Matrix3;
use sph_core::{Cloud, Vec3};
use sph_shell::{DirectorHold, Holds, RigidLoad, RigidSet, Shell};

use super::build::Builder;
use crate::bodies::sets::Sets;
use crate::scene::error::SceneError;
use crate::scene::{Axis, LoadKind, RigidBody};

impl Builder<'_> {
    /// Rigid sets with the supports that name them.
    pub(super) fn rigid(&self, sets: &Sets, cloud: &Cloud) -> Result<Vec<RigidSet>, SceneError> {
        let turn = self.turned_axes();
        let body = |(i, body): (usize, &RigidBody)| {
            let path = self.scene.body_scope().path(&format!("rigid[{i}].on"));
            let particles = sets.at(self.scene, &path, &body.on)?.to_vec();
            let sum: Vec3 = particles.iter().map(|&a| cloud.positions[a as usize]).sum();
            let mean = sum / particles.len() as f64;
            let moment = |axis: usize| body.inertia.as_ref().map_or(0.0, |inertia| inertia.along(axis));
            let [xy, yz, zx] = body.products.unwrap_or_default();
            let tensor = Matrix3::new(moment(0), xy, zx, xy, moment(1), yz, zx, yz, moment(2));
            Ok(RigidSet {
                at: body.at.map_or(mean, |at| self.turned(at)),
                mass: body.mass,
                inertia: turn * tensor * turn.transpose(),
                holds: self.holds_of_body(&body.on),
                particles,
            })
        };
        self.scene.shell().rigid.iter().enumerate().map(body).collect()
    }

    /// What the supports on a set ask of its body, all of them together.
    fn holds_of_body(&self, on: &str) -> Holds {
        let mut all = Holds::default();
        for support in self.scene.supports.iter().filter(|support| support.on == on) {
            for (_, kind) in support.kinds() {
                let Some(found) = self.support(kind, explicit_dynamics::Amplitude::Constant) else {
                    continue;
                };
                let asked = found.holds();
                all.translations.extend(asked.translations);
                all.director = match (all.director, asked.director) {
                    (DirectorHold::Free, other) | (other, DirectorHold::Free) => other,
                    (one, other) if one == other => one,
                    _ => DirectorHold::Fixed,
                };
            }
        }
        all
    }

    /// A force or a couple about a fixed axis on a rigid set, as a load on its body.
    pub(super) fn load_on_body(&self, kind: &LoadKind, on: &str) -> Option<RigidLoad> {
        let set = self.scene.shell().rigid_body(on)?;
        match kind {
            LoadKind::Force(force) => {
                Some(RigidLoad { set, force: self.turned(force.total), couple: Vec3::zeros() })
            }
            LoadKind::Couple(couple) => {
                let Axis::Fixed(axis) = couple.axis else { return None };
                let couple = self.turned(axis).normalize() * couple.moment;
                Some(RigidLoad { set, force: Vec3::zeros(), couple })
            }
            _ => None,
        }
    }

    /// Refuses a body some of whose displacements are held beside its centre of mass, where masses count.
    pub(super) fn refuse_coupled(&self, sets: &[RigidSet], shell: &Shell) -> Result<(), SceneError> {
        let kind = self.scene.analysis.kind();
        let counts = kind.passes_time || matches!(self.scene.analysis, crate::scene::Analysis::Modal(_));
        let Some(i) = Shell::coupled_rigid_set(sets, shell).filter(|_| counts) else { return Ok(()) };
        let path = self.scene.body_scope().path(&format!("rigid[{i}].at"));
        Err(self.scene.model_error(
            &path,
            "one or two displacements of the reference point are held, it may turn, and the centre of mass of the body lies elsewhere: its \
             inertia then couples displacements with rotations, which is not computed; hold all three displacements or the rotations \
             (`clamped`), or put `at` where the mass of set and body has its centre",
        ))
    }
}
