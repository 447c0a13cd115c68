//! Joints of the rigid bodies among several: from the scene's words to constraints on the march of them.

use std::any::Any;

use explicit_dynamics::{Dynamics, OutOfBounds, OutOfRange, Step, Work};
use rigid_body::{Joint, JointKind, Joints, RigidBody};
use sph_core::Vec3;

use super::parts::{Marched, MarchedPart};
use crate::scene::{BodyScene, JointScene, Scene};

/// Joints, by the numbers of the rigid bodies among all.
pub(super) struct JointedBodies {
    joints: Joints,
}

impl JointedBodies {
    /// The joints of a scene whose bodies stand at rest; none without any.
    pub fn find(scene: &Scene, bodies: &mut [Box<dyn MarchedPart>]) -> Option<Self> {
        if scene.joints.is_empty() {
            return None;
        }
        let rigid = scene.bodies.iter().filter(|(_, body)| matches!(body, BodyScene::Rigid(_)));
        let names: Vec<&String> = rigid.map(|(name, _)| name).collect();
        let number = |name: &String| names.iter().position(|own| *own == name);
        let joint = |own: &JointScene| {
            let axis = own.axis().map(Vec3::from);
            let kind = match (own.hinge.is_some(), own.slider.is_some(), axis) {
                (true, _, Some(axis)) => JointKind::Hinge(axis),
                (_, true, Some(axis)) => JointKind::Slider(axis),
                _ => JointKind::Ball,
            };
            // The checks leave names of rigid bodies.
            let to = match &own.to {
                Some(to) => Some(number(to)?),
                None => None,
            };
            Some(Joint { on: number(&own.on)?, to, at: own.at.into(), kind })
        };
        let joints: Vec<Joint> = scene.joints.iter().filter_map(joint).collect();
        let bodies: Vec<&mut RigidBody> = rigid_of(bodies).collect();
        let bodies: Vec<&RigidBody> = bodies.iter().map(|body| &**body).collect();
        Some(Self { joints: Joints::new(&bodies, &joints) })
    }

    /// A line for the summary.
    pub fn line(scene: &Scene) -> Option<String> {
        let count = scene.joints.len();
        (count > 0).then(|| format!("joints of rigid bodies: {count}, exact constraints in every step"))
    }

    /// Refuses a state that the joints do not hold.
    pub fn held(&self) -> Result<(), OutOfBounds> {
        let Some(missed) = self.joints.missed() else { return Ok(()) };
        Err(OutOfBounds::Range(OutOfRange {
            place: "[[joints]]".into(),
            what: "the gap",
            value: missed,
            bound: "zero: supports of a body, or other joints, say otherwise than one of them",
        }))
    }

    /// The kick of all bodies, whose forces are evaluated, with what the joints exert.
    pub fn kick(&mut self, system: &mut Marched, step: &Step) -> Work {
        let mut bodies: Vec<&mut RigidBody> = rigid_of(system.systems_mut()).collect();
        self.joints.brace(&mut bodies, step);
        let mut work = system.kick(step);
        let bodies: Vec<&mut RigidBody> = rigid_of(system.systems_mut()).collect();
        let bodies: Vec<&RigidBody> = bodies.iter().map(|body| &**body).collect();
        self.joints.settle(&bodies, step, &mut work);
        work
    }
}

/// The rigid bodies among all.
fn rigid_of(bodies: &mut [Box<dyn MarchedPart>]) -> impl Iterator<Item = &mut RigidBody> {
    bodies.iter_mut().filter_map(|body| (body.as_mut() as &mut dyn Any).downcast_mut())
}
