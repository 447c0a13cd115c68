//! Joints of the rigid bodies among several, in a fluid or without one: from the scene's words to constraints on the march of them.

use std::any::Any;

use explicit_dynamics::{Bracing, Dynamics, OutOfBounds, OutOfRange, Step, Work};
use rigid_body::{Joint, JointKind, Joints, RigidBody};
use sph_core::Vec3;

use super::parts::{Marched, MarchedPart};
use crate::scene::{BodyScene, JointScene, Scene};

/// A body that is marched beside others and may be a rigid one.
pub(in crate::bodies) trait MayBeRigid: 'static {
    /// The body, by its type.
    fn any(&self) -> &dyn Any;

    /// The same, to be changed.
    fn any_mut(&mut self) -> &mut dyn Any;
}

impl MayBeRigid for dyn MarchedPart {
    fn any(&self) -> &dyn Any {
        self
    }

    fn any_mut(&mut self) -> &mut dyn Any {
        self
    }
}

/// Joints, by the numbers of the rigid bodies among all.
pub(in crate::bodies) struct JointedBodies {
    joints: Joints,
    /// Names of the rigid bodies, in their order, and by joint which of them it is on and to.
    names: Vec<String>,
    ends: Vec<[Option<usize>; 2]>,
}

impl JointedBodies {
    /// The joints of a scene whose bodies stand at rest; none without any.
    pub fn find<S: MayBeRigid + ?Sized>(scene: &Scene, bodies: &[Box<S>]) -> Option<Self> {
        if scene.joints.is_empty() {
            return None;
        }
        let rigid = scene.bodies.iter().filter(|(_, body)| matches!(body, BodyScene::Rigid(_)));
        let names: Vec<String> = rigid.map(|(name, _)| name.clone()).collect();
        let number = |name: &String| names.iter().position(|own| own == name);
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
        let ends = joints.iter().map(|joint| [Some(joint.on), joint.to]).collect();
        let bodies: Vec<&RigidBody> = bodies.iter().filter_map(|body| body.any().downcast_ref()).collect();
        Some(Self { joints: Joints::new(&bodies, &joints), names, ends })
    }

    /// A line for the summary.
    pub fn line(scene: &Scene) -> Option<String> {
        let count = scene.joints.len();
        (count > 0).then(|| format!("joints of rigid bodies: {count}, exact constraints in every step"))
    }

    /// Force on a body \[F\] and its moment about the origin \[F L\] of a joint, by its number, or of all.
    pub fn exerted(&self, body: &str, joint: Option<usize>) -> [Vec3; 2] {
        let mut sum = [Vec3::zeros(); 2];
        for (number, ends) in self.ends.iter().enumerate() {
            if joint.is_some_and(|joint| joint != number) {
                continue;
            }
            let own = self.joints.of_joint(number);
            for (end, sign) in ends.iter().zip([1.0, -1.0]) {
                if end.is_some_and(|end| self.names[end] == body) {
                    sum.iter_mut().zip(&own).for_each(|(sum, own)| *sum += own * sign);
                }
            }
        }
        sum
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
        self.joints.brace(&mut rigid_of(system.systems_mut()), step);
        let mut work = system.kick(step);
        self.settled(system.systems_mut(), step, &mut work);
        work
    }

    fn settled<S: MayBeRigid + ?Sized>(&self, bodies: &mut [Box<S>], step: &Step, work: &mut Work) {
        let bodies: Vec<&RigidBody> = bodies.iter().filter_map(|body| body.any().downcast_ref()).collect();
        self.joints.settle(&bodies, step, work);
    }
}

impl<S: MayBeRigid + ?Sized> Bracing<S> for JointedBodies {
    fn brace(&mut self, bodies: &mut [Box<S>], step: &Step) {
        self.joints.brace(&mut rigid_of(bodies), step);
    }

    fn settle(&self, bodies: &mut [Box<S>], step: &Step, work: &mut Work) {
        self.settled(bodies, step, work);
    }

    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        self.held()
    }
}

/// The rigid bodies among all.
fn rigid_of<S: MayBeRigid + ?Sized>(bodies: &mut [Box<S>]) -> Vec<&mut RigidBody> {
    bodies.iter_mut().filter_map(|body| body.any_mut().downcast_mut()).collect()
}
