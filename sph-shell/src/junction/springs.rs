//! What springs exert on rigid sets as a whole.
//!
//! The rotation of a body from rest as a quaternion (w, v), its twist about the axis e with `a = e·v`, `s = w² + a²`:
//!
//! ```text
//! φ = 2 atan2(a, w)      g = [w² e + w v × e + a v]/s,  δφ = g·θ      h = −w v + a (w e + v × e)
//! torque −k φ g          second variation along θ: k (g·θ)² − k φ (g·θ)(h·θ)/s
//! ```
//!
//! For a rotation about e alone g = e. The angle is that of less than half a turn. A spring between two reference points exerts a force on
//! each, which is counted with the loads on the body: their second variation is that of a dead force.

use implicit_statics::BlockPattern;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector6};
use sph_core::Vec3;

use crate::conditions::body::Block;
use crate::conditions::springs::BodySpring;
use crate::error::ShellError;
use crate::junction::group::{Group, Junctions};
use crate::packs::Row;
use crate::reference::Reference;

/// The twist of a body about an axis.
struct Twist {
    angle: f64,
    gradient: Vec3,
    /// h/s.
    change: Vec3,
}

impl Twist {
    fn of(rotation: &Matrix3<f64>, axis: &Vec3) -> Self {
        let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(*rotation));
        let (mut w, mut v) = (turn.w, turn.imag());
        if w < 0.0 {
            (w, v) = (-w, -v);
        }
        let a = axis.dot(&v);
        let square = w * w + a * a;
        let aside = axis * w + v.cross(axis);
        Self {
            angle: 2.0 * libm::atan2(a, w),
            gradient: (aside * w + v * a) / square,
            change: (aside * a - v * w) / square,
        }
    }
}

/// Springs of rigid sets, and the state in which they are looked at.
pub(crate) struct BodySprings<'a> {
    pub springs: &'a [BodySpring],
    pub junctions: &'a Junctions,
    pub reference: &'a Reference,
    pub state: &'a [Row],
}

impl Junctions {
    /// Refuses springs on bodies that are none, and stiffnesses that are none.
    ///
    /// # Errors
    /// [`ShellError::SpringOfBody`] for the first of them.
    pub fn check_springs(&self, springs: &[BodySpring]) -> Result<(), ShellError> {
        for spring in springs {
            let missing = spring.bodies().into_iter().find(|number| self.body_numbered(*number).is_none());
            let alike = matches!(spring, BodySpring::Between { bodies: [a, b], .. } if a == b);
            let (set, stiffness) = (spring.bodies()[0], spring.stiffness());
            if missing.is_some() || alike || !(stiffness > 0.0 && stiffness.is_finite()) {
                return Err(ShellError::SpringOfBody { set: missing.unwrap_or(set), stiffness });
            }
        }
        Ok(())
    }
}

impl BodySprings<'_> {
    /// Rotation of a body from rest.
    fn rotation_of(&self, group: &Group) -> Matrix3<f64> {
        let rest = group.body.as_ref().map_or_else(Matrix3::identity, |body| body.rest);
        group.triad(self.state) * rest.transpose()
    }

    /// Displacement of the reference point of a body \[L\].
    fn way_of_reference(&self, group: &Group) -> Vec3 {
        let Some(body) = &group.body else { return Vec3::zeros() };
        let rest: Vec3 = self.reference.cloud.positions[group.first()] - body.rest * body.places[0][0];
        group.pole(self.state) + body.arm(&group.triad(self.state)) - rest - body.rest * body.reference
    }

    /// What springs exert on a body by its number: force at the reference point and couple \[F, F L\].
    pub fn on_body(&self, number: usize) -> [Vec3; 2] {
        let mut sum = [Vec3::zeros(); 2];
        for spring in self.springs {
            match spring {
                BodySpring::Turning { body, stiffness, axis } if *body == number => {
                    let Some(group) = self.junctions.body_numbered(*body) else { continue };
                    let twist = Twist::of(&self.rotation_of(group), axis);
                    sum[1] -= twist.gradient * (stiffness * twist.angle);
                }
                BodySpring::Between { bodies, stiffness, direction } if bodies.contains(&number) => {
                    let ways = bodies.map(|b| {
                        self.junctions
                            .body_numbered(b)
                            .map_or(Vec3::zeros(), |group| self.way_of_reference(group))
                    });
                    let pull = stiffness * direction.dot(&(ways[1] - ways[0]));
                    sum[0] += direction * if bodies[0] == number { pull } else { -pull };
                }
                _ => {}
            }
        }
        sum
    }

    /// The same as a row about the pole of the body that a particle stands for, in the present state.
    pub fn row(&self, particle: usize) -> Row {
        let Some(group) = self.junctions.body_of(particle).filter(|group| group.first() == particle) else {
            return [0.0; 6];
        };
        let Some(body) = group.body.as_ref().filter(|_| !self.springs.is_empty()) else {
            return [0.0; 6];
        };
        let [force, couple] = self.on_body(body.number);
        let moment = body.arm(&group.triad(self.state)).cross(&force) + couple;
        [force.x, force.y, force.z, moment.x, moment.y, moment.z]
    }

    /// Pairs of first particles that share a block.
    pub fn pairs(&self) -> Vec<[u32; 2]> {
        let first = |number: usize| self.junctions.body_numbered(number).map(|group| group.first() as u32);
        let pair = |spring: &BodySpring| match spring {
            BodySpring::Between { bodies: [a, b], .. } => Some([first(*a)?, first(*b)?]),
            BodySpring::Turning { .. } => None,
        };
        self.springs.iter().filter_map(pair).collect()
    }

    /// Adds the stiffness of these springs to the blocks of first particles, over the unknowns of bodies.
    pub fn add_blocks(&self, pattern: &BlockPattern, blocks: &mut [Block]) {
        let mut add = |a: u32, b: u32, value: &dyn Fn(usize, usize) -> f64| {
            let Some(number) = pattern.find(a, b) else { return };
            (0..6).for_each(|i| (0..6).for_each(|j| blocks[number][i][j] += value(i, j)));
        };
        for spring in self.springs {
            match spring {
                BodySpring::Turning { body, stiffness, axis } => {
                    let Some(group) = self.junctions.body_numbered(*body) else { continue };
                    let Twist { angle, gradient, change } = Twist::of(&self.rotation_of(group), axis);
                    let mixed = gradient * change.transpose();
                    let over = (gradient * gradient.transpose()
                        - (mixed + mixed.transpose()) * (0.5 * angle))
                        * *stiffness;
                    let first = group.first() as u32;
                    add(first, first, &|i, j| if i < 3 || j < 3 { 0.0 } else { over[(i - 3, j - 3)] });
                }
                BodySpring::Between { bodies, stiffness, direction } => {
                    let row = |number: usize, sign: f64| {
                        let group = self.junctions.body_numbered(number)?;
                        let arm = group.body.as_ref()?.arm(&group.triad(self.state));
                        let n = direction * sign;
                        let moment = arm.cross(&n)
                            - group.lever(self.state).map_or(Vec3::zeros(), |lever| lever.torque(&n));
                        let row = Vector6::from_iterator(n.iter().chain(moment.iter()).copied());
                        Some((group.first() as u32, row))
                    };
                    let (Some(one), Some(two)) = (row(bodies[0], -1.0), row(bodies[1], 1.0)) else {
                        continue;
                    };
                    for (a, r) in [&one, &two] {
                        for (b, q) in [&one, &two].into_iter().filter(|(b, _)| b <= a) {
                            add(*a, *b, &|i, j| stiffness * r[i] * q[j]);
                        }
                    }
                }
            }
        }
    }
}
