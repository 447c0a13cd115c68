//! Rigid sets of a shell: where their bodies stand, what holds them, what acts on them.

use nalgebra::Matrix3;
use sph_core::{Cloud, Vec3};
use sph_shell::{Holds, Preloaded, RigidLoad, RigidSet, Support};

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
                mass: body.mass.get(),
                inertia: turn * tensor * turn.transpose(),
                holds: self.holds_of_body(&body.on),
                particles,
            })
        };
        self.scene.shell.rigid.iter().enumerate().map(body).collect()
    }

    /// What each support on a set asks of its body.
    fn holds_of_body(&self, on: &str) -> Vec<Holds> {
        let mut all = Vec::new();
        for support in self.scene.supports.iter().filter(|support| support.on == on) {
            for (_, kind) in support.kinds() {
                let course = support.amplitude.clone().unwrap_or_default();
                let Some(found) = self.support(kind, course) else { continue };
                all.push(if support.preload { Preloaded(found).holds() } else { found.holds() });
            }
        }
        all
    }

    /// A force or a couple about a fixed axis on a rigid set, as a load on its body.
    pub(super) fn load_on_body(&self, kind: &LoadKind, on: &str) -> Option<RigidLoad> {
        let set = self.scene.shell.rigid_body(on)?;
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
}
