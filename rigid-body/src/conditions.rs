//! Supports, loads and springs of a rigid body.

use explicit_dynamics::{Amplitude, Instant};
use sph_core::{HeldDirections, Vec3};

use crate::error::RigidError;

/// Part of a motion along a held direction below which it is rounding.
const ROUNDING: f64 = 1e-9;

/// A support of a body, whose displacements are those of its centre.
#[derive(Clone, Debug)]
pub enum Support {
    /// No displacement along some directions (any length), and turns that are held.
    Held {
        /// The directions.
        displacement: Vec<Vec3>,
        /// What is asked of turns.
        rotation: RotationHold,
    },
    /// A displacement along a direction (any length).
    Moved {
        /// The direction.
        direction: Vec3,
        /// Displacement at level one \[L\].
        by: f64,
        /// Its course in time.
        amplitude: Amplitude,
    },
    /// A turn about an axis (any length) through the centre; no other turn is free.
    Rotated {
        /// The axis.
        axis: Vec3,
        /// Angle at level one \[rad\].
        by: f64,
        /// Its course in time.
        amplitude: Amplitude,
    },
}

/// What is asked of turns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum RotationHold {
    /// Nothing.
    #[default]
    Free,
    /// No turn but about a unit vector.
    About(Vec3),
    /// No turn at all.
    Fixed,
}

/// A load, which grows with the level and its amplitude.
#[derive(Clone, Debug, Default)]
pub struct Load {
    /// Dead forces on particles \[F\].
    pub forces: Vec<(u32, Vec3)>,
    /// A couple about a fixed axis \[F L\].
    pub couple: Vec3,
    /// An acceleration of the mass \[L/T²\].
    pub acceleration: Vec3,
    /// Its course in time.
    pub amplitude: Amplitude,
}

/// A spring from a particle to the ground, `½ k (n·u)²`, n a unit vector fixed in space.
#[derive(Clone, Copy, Debug)]
pub struct Spring {
    /// The particle.
    pub particle: u32,
    /// Stiffness k \[F/L\].
    pub stiffness: f64,
    /// Direction n.
    pub direction: Vec3,
}

/// All that supports ask.
#[derive(Clone, Debug, Default)]
pub(crate) struct Hold {
    pub held: HeldDirections,
    pub rotation: RotationHold,
    motions: Vec<(Vec3, Amplitude)>,
    turning: Option<(Vec3, f64, Amplitude)>,
}

impl Hold {
    /// Joins supports.
    ///
    /// # Errors
    /// [`RigidError::Opposed`].
    pub fn new(supports: &[Support]) -> Result<Self, RigidError> {
        let mut out = Self::default();
        for support in supports {
            if let Support::Held { displacement, rotation } = support {
                displacement.iter().for_each(|direction| out.held.hold(&direction.normalize()));
                out.rotation = joined(out.rotation, *rotation);
            }
        }
        let fixed = out.held;
        for support in supports {
            match support {
                Support::Held { .. } => {}
                Support::Moved { direction, by, amplitude } => {
                    let direction = direction.normalize();
                    if fixed.basis().iter().any(|held| held.dot(&direction).abs() > ROUNDING) {
                        return Err(RigidError::Opposed(
                            "move the body along a direction that another holds",
                        ));
                    }
                    out.held.hold(&direction);
                    out.motions.push((direction * *by, amplitude.clone()));
                }
                Support::Rotated { axis, by, amplitude } => {
                    let axis = axis.normalize();
                    let agrees = match out.rotation {
                        RotationHold::Free => true,
                        RotationHold::About(own) => own.cross(&axis).norm() < ROUNDING,
                        RotationHold::Fixed => false,
                    };
                    if !agrees || out.turning.is_some() {
                        return Err(RigidError::Opposed(
                            "turn the body about an axis about which another holds or turns it",
                        ));
                    }
                    out.turning = Some((axis, *by, amplitude.clone()));
                }
            }
        }
        if out.turning.is_some() {
            out.rotation = RotationHold::Fixed;
        }
        Ok(out)
    }

    /// Whether a motion or a turn is prescribed.
    pub fn moves(&self) -> bool {
        !self.motions.is_empty() || self.turning.is_some()
    }

    /// Prescribed displacement at an instant \[L\].
    pub fn displacement(&self, at: Instant) -> Vec3 {
        let all = self.motions.iter();
        all.map(|(by, amplitude)| by * (at.level * amplitude.value(at.time))).sum()
    }

    /// Prescribed rotation vector at an instant, if one is \[rad\].
    pub fn rotation_at(&self, at: Instant) -> Option<Vec3> {
        let (axis, by, amplitude) = self.turning.as_ref()?;
        Some(axis * (by * at.level * amplitude.value(at.time)))
    }

    /// Takes the held part out of a velocity.
    pub fn free_part(&self, v: &Vec3) -> Vec3 {
        self.held.free_part((*v).into()).into()
    }
}

fn joined(a: RotationHold, b: RotationHold) -> RotationHold {
    match (a, b) {
        (RotationHold::Free, other) | (other, RotationHold::Free) => other,
        (RotationHold::About(m), RotationHold::About(n)) if m.cross(&n).norm() < ROUNDING => a,
        _ => RotationHold::Fixed,
    }
}

/// Force on a body and its moment about the centre.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Wrench {
    pub force: Vec3,
    pub moment: Vec3,
}

impl Wrench {
    /// Adds a force at an arm.
    pub fn add(&mut self, force: &Vec3, arm: &Vec3) {
        self.force += force;
        self.moment += arm.cross(force);
    }
}

impl std::ops::Sub for Wrench {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { force: self.force - other.force, moment: self.moment - other.moment }
    }
}

impl std::ops::Add for Wrench {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { force: self.force + other.force, moment: self.moment + other.moment }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn supports_join_and_what_contradicts_is_refused() {
        let held = |displacement: Vec<Vec3>, rotation| Support::Held { displacement, rotation };
        let moved = |direction| Support::Moved { direction, by: 2.0, amplitude: Amplitude::Constant };
        let rotated_about = |axis| Support::Rotated { axis, by: 0.5, amplitude: Amplitude::Ramp(2.0) };
        let about = RotationHold::About(Vec3::z());
        let hold =
            Hold::new(&[held(vec![Vec3::x()], about), moved(Vec3::y() * 3.0), rotated_about(Vec3::z())])
                .unwrap();
        assert_eq!((hold.held.basis().len(), hold.rotation, hold.moves()), (2, RotationHold::Fixed, true));
        let at = Instant { time: 1.0, level: 1.0 };
        assert_eq!(hold.displacement(at), Vec3::y() * 2.0);
        assert_eq!(hold.rotation_at(at), Some(Vec3::z() * 0.25));
        assert!(Hold::new(&[held(vec![Vec3::new(1.0, 1.0, 0.0)], about), moved(Vec3::y())]).is_err());
        assert!(Hold::new(&[held(vec![], about), rotated_about(Vec3::x())]).is_err());
        assert!(Hold::new(&[rotated_about(Vec3::x()), rotated_about(Vec3::x())]).is_err());
        assert_eq!(joined(about, RotationHold::About(Vec3::x())), RotationHold::Fixed);
    }
}
