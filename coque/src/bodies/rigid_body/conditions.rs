//! Supports, loads, springs, columns and the velocity at the start of a rigid body.

use std::collections::BTreeMap;

use rigid_body::{Load, RigidBody, RotationHold, Spring, Support};
use sph_core::{Frame, Vec3};

use crate::bodies::Probe;
use crate::bodies::rigid::Hold;
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::{Axis, LoadKind, Measured, RigidScene, SupportKind};

type Sets = BTreeMap<String, Vec<u32>>;

/// Members of a set; the checks let no other name through.
fn members<'a>(sets: &'a Sets, name: &str) -> &'a [u32] {
    sets.get(name).map_or(&[], Vec::as_slice)
}

/// What holds and moves the body.
pub(super) fn supports(scene: &BodyInScene<'_>) -> Vec<Support> {
    let axes = || vec![Vec3::x(), Vec3::y(), Vec3::z()];
    let mut all = Vec::new();
    for support in &scene.supports {
        let amplitude = || support.amplitude.clone().unwrap_or_default();
        for (_, kind) in support.kinds() {
            all.extend(match kind {
                SupportKind::Clamped => {
                    Some(Support::Held { displacement: axes(), rotation: RotationHold::Fixed })
                }
                SupportKind::Hinged => {
                    Some(Support::Held { displacement: axes(), rotation: RotationHold::Free })
                }
                SupportKind::Held(held) => {
                    let rotation = held.director.first().map_or(RotationHold::Free, |&normal| {
                        RotationHold::About(Vec3::from(normal).normalize())
                    });
                    let displacement = held.displacement.iter().map(|&v| v.into()).collect();
                    Some(Support::Held { displacement, rotation })
                }
                SupportKind::Moved(moved) => {
                    let (direction, by) = (moved.direction.into(), moved.by);
                    Some(Support::Moved { direction, by, amplitude: amplitude() })
                }
                SupportKind::Rotated(rotated) => {
                    let (axis, by) = (rotated.axis.into(), rotated.by.to_radians());
                    Some(Support::Rotated { axis, by, amplitude: amplitude() })
                }
                // Springs come apart; the checks leave no other.
                _ => None,
            });
        }
    }
    all
}

/// Springs to the ground, whose places share the stiffness equally.
pub(super) fn springs(scene: &BodyInScene<'_>, sets: &Sets) -> Vec<Spring> {
    let mut all = Vec::new();
    for support in &scene.supports {
        let Some(spring) = &support.spring else { continue };
        let Some(direction) = spring.direction else { continue };
        let (direction, places) = (Vec3::from(direction).normalize(), members(sets, support.on));
        let stiffness = spring.stiffness.get() / places.len().max(1) as f64;
        all.extend(places.iter().map(|&particle| Spring { particle, stiffness, direction }));
    }
    all
}

/// The loads.
pub(super) fn loads(scene: &BodyInScene<'_>, sets: &Sets) -> Vec<Load> {
    let mut all = Vec::new();
    for load in &scene.loads {
        let mut own = Load { amplitude: load.amplitude.clone().unwrap_or_default(), ..Load::default() };
        for (_, kind) in load.kinds() {
            match kind {
                LoadKind::Force(force) => {
                    let places = members(sets, load.on);
                    let share = Vec3::from(force.total) / places.len().max(1) as f64;
                    own.forces.extend(places.iter().map(|&particle| (particle, share)));
                }
                LoadKind::Couple(couple) => {
                    if let Axis::Fixed(axis) = couple.axis {
                        own.couple = Vec3::from(axis).normalize() * couple.moment;
                    }
                }
                LoadKind::Gravity(gravity) => own.acceleration = gravity.acceleration.into(),
                // The checks leave no other.
                LoadKind::Pressure(_)
                | LoadKind::Traction(_)
                | LoadKind::Gas(_)
                | LoadKind::Volume(_)
                | LoadKind::Temperature(_) => {}
            }
        }
        all.push(own);
    }
    all
}

/// What supports and springs keep of rigid motions.
pub(super) fn holds(supports: &[Support], springs: &[Spring], centre: &Vec3) -> Vec<Hold> {
    let mut all: Vec<Hold> =
        springs.iter().map(|spring| Hold::Displacement(spring.particle, spring.direction)).collect();
    let axes = [Vec3::x(), Vec3::y(), Vec3::z()];
    for support in supports {
        match support {
            Support::Held { displacement, rotation } => {
                all.extend(displacement.iter().map(|n| Hold::DisplacementAt(*centre, n.normalize())));
                match rotation {
                    RotationHold::Free => {}
                    RotationHold::About(n) => {
                        let frame = Frame::from_normal(*n);
                        all.extend([frame.t1, frame.t2].map(Hold::Turn));
                    }
                    RotationHold::Fixed => all.extend(axes.map(Hold::Turn)),
                }
            }
            Support::Moved { direction, .. } => {
                all.push(Hold::DisplacementAt(*centre, direction.normalize()));
            }
            Support::Rotated { .. } => all.extend(axes.map(Hold::Turn)),
        }
    }
    all
}

/// The columns of the curve; forces and losses of contact on all of the body are those on its vertices.
pub(super) fn probes(scene: &BodyInScene<'_>, sets: &Sets, vertices: u32) -> Vec<Probe> {
    let probe = |column: &OnSet<'_, crate::scene::Probe>| {
        let of_contact = matches!(
            column.of,
            Measured::ContactForce | Measured::ContactMoment | Measured::FrictionLoss | Measured::GlueForce
        );
        let linked = column.of == Measured::LinkForce;
        let whole = (of_contact || linked) && column.on == "all";
        let places = if whole {
            (0..vertices + u32::from(linked)).collect()
        } else {
            members(sets, column.on).to_vec()
        };
        let direction = column.direction.map_or_else(Vec3::zeros, |v| Vec3::from(v).normalize());
        Probe::of_column(scene.scene, column, places, direction)
    };
    scene.curve.iter().map(probe).collect()
}

/// Gives the body the velocity of the scene, `v + ω × (c − p)` at its centre c; what is held stays at rest.
pub(super) fn set_out(rigid: &RigidScene, body: &mut RigidBody) {
    let Some(velocity) = &rigid.velocity else { return };
    let linear = Vec3::from(velocity.linear.unwrap_or_default());
    let (spin, point) = velocity.spin.map_or_else(Default::default, |spin| {
        (Vec3::from(spin.axis).normalize() * spin.rate, Vec3::from(spin.point))
    });
    let about: Vec3 = body.position(body.centre() as usize) - point;
    body.set_out(&(linear + spin.cross(&about)), &spin);
}
