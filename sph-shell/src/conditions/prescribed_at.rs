//! What the supports of a particle or of a rigid body prescribe: over a step, and by level.

use explicit_dynamics::{Instant, Step};
use sph_core::{HeldDirections, Vec3};

use crate::conditions::case::LoadCase;
use crate::conditions::prescribed::{Motion, Rotation};
use crate::conditions::supports::Constraint;
use crate::packs::Row;

impl Constraint {
    /// Spin of the prescribed rotation over a step \[1/T\].
    pub(crate) fn spin(&self, step: &Step) -> Option<Vec3> {
        Some(self.rotation.as_ref()?.spin(step.from, step.to))
    }

    /// Mean velocity of the prescribed motion over a step \[L/T\].
    pub(crate) fn velocity(&self, step: &Step) -> Option<[f64; 3]> {
        Some(self.motion.as_ref()?.velocity(&self.rest.0, step.from, step.to))
    }

    /// Where the position at rest is to be, at an instant of the case that is under way \[L\].
    pub(crate) fn reference_at(&self, at: Instant, under_way: LoadCase) -> Vec3 {
        let rest = self.rest.0;
        self.motion.as_ref().map_or(rest, |motion| rest + motion.at(&rest, at, under_way))
    }

    /// A vector at rest as the prescribed rotation turns it, if there is one.
    pub(crate) fn turned(&self, rest: &Vec3, at: Instant, under_way: LoadCase) -> Option<Vec3> {
        Some(self.rotation.as_ref()?.at(rest, at, under_way))
    }

    /// Rate of the director `d` under the prescribed rotation over a step \[1/T\].
    #[inline]
    pub(crate) fn director_rate(&self, d: [f64; 3], step: &Step) -> Option<[f64; 3]> {
        let rotation = self.rotation.as_ref()?;
        Some(rotation.rate(&self.rest.1, &d.into(), step.from, step.to))
    }

    /// Whether part of what it prescribes belongs to the preload.
    pub(crate) fn has_preload(&self) -> bool {
        self.motion.as_ref().is_some_and(|motion| motion.preload.is_some())
            || self.rotation.as_ref().is_some_and(|rotation| rotation.case == LoadCase::Preload)
    }

    /// What is prescribed by level, if anything is.
    pub(crate) fn prescribed(&self) -> Option<Prescribed<'_>> {
        let (motion, rotation) = (self.motion.as_deref(), self.rotation.as_deref());
        (motion.is_some() || rotation.is_some()).then_some(Prescribed {
            rest: self.rest,
            motion,
            rotation,
            held: &self.held,
        })
    }
}

/// What is prescribed on one particle, without time: its share of a load level.
pub(crate) struct Prescribed<'a> {
    /// Position and director at rest.
    pub rest: (Vec3, Vec3),
    pub motion: Option<&'a Motion>,
    pub rotation: Option<&'a Rotation>,
    /// Directions in which the position is held.
    pub held: &'a HeldDirections,
}

impl Prescribed<'_> {
    /// Puts the held components where a level has them.
    pub fn put(&self, level: f64, under_way: LoadCase, row: &mut Row) {
        let at = Instant { time: 0.0, level };
        if let Some(motion) = self.motion {
            let rest = self.rest.0 + motion.at(&self.rest.0, at, under_way);
            self.held.put(&rest, row);
        }
        if let Some(rotation) = self.rotation {
            let d = rotation.at(&self.rest.1, at, under_way);
            row[3..].copy_from_slice(d.as_slice());
        }
    }

    /// Square of the force that brings it about at the director `d`, from `[∂U/∂x, ∂U/∂d]`, turns counted as arcs \[F²\].
    pub fn force(&self, row: &Row, d: &Vec3, arc: f64) -> f64 {
        let part = |first: usize| Vec3::new(row[first], row[first + 1], row[first + 2]);
        let pull = self.pull(&part(0));
        let turn = self.rotation.map_or(0.0, |rotation| rotation.axis.cross(d).dot(&part(3)) / arc);
        pull * pull + turn * turn
    }

    /// The part of a force along the ways of the motion \[F\].
    pub fn pull(&self, force: &Vec3) -> f64 {
        let Some(motion) = self.motion else { return 0.0 };
        let along = motion.parts(&self.rest.0).filter_map(|part| part.try_normalize(0.0));
        along.map(|along| along.dot(force)).reduce(libm::hypot).unwrap_or(0.0)
    }

    /// Derivative of place and rotation with respect to the level of the case that is under way, at a level \[L, rad\].
    pub fn motion_rate(&self, level: f64, under_way: LoadCase) -> [Vec3; 2] {
        let u = self.motion.map_or(Vec3::zeros(), |motion| motion.rate(&self.rest.0, level, under_way));
        let turning = self.rotation.filter(|rotation| rotation.case == under_way);
        let spin = turning.map_or(Vec3::zeros(), |rotation| {
            rotation.axis * (rotation.angle * rotation.amplitude.value(0.0))
        });
        [u, spin]
    }

    /// Derivative of `[x, d]` with respect to the level of the case that is under way, at a level and the director `d` there.
    pub fn rate(&self, level: f64, d: &Vec3, under_way: LoadCase) -> Row {
        let [u, spin] = self.motion_rate(level, under_way);
        let w = spin.cross(d);
        [u.x, u.y, u.z, w.x, w.y, w.z]
    }
}
