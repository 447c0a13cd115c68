//! The kick of a group, of a rigid body with the impulse by which supports hold or move its reference point.
//!
//! Force and torque kick the centre and the spin; then comes the impulse P along the held directions n_i at the reference point `p = c + r`:
//!
//! ```text
//! v += Σ P_i n_i/m,   ω += J⁻¹ (r × Σ P_i n_i)     such that     n_i·(p after the drift) = n_i·(p₀ + c(t))
//! ```
//!
//! The place is held, not its rate (SHAKE, \[ryckaert1977\]): what is held never drifts away, the rule stays that of central differences,
//! symmetric in time and without secular error of the energy, and a body whose centre is elsewhere swings about its hinge as it should. Where
//! rotations are held, J⁻¹ is that of the rotations left. The equations for P are solved by rounds with the matrix at the beginning of the
//! step, each of which gains a factor of `Δt ω`.

use explicit_dynamics::{Step, Work};
use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::conditions::case::LoadCase;
use crate::conditions::supports::{Constraint, DirectorHold};
use crate::junction::body::{Power, RigidBody};
use crate::junction::group::{Group, director, place};
use crate::junction::rotation::turned;
use crate::packs::Row;

/// Rounds for the impulse: each gains two digits and more.
const ROUNDS: usize = 10;

/// The kick of one group: force and torque `f`, of which `external` by loads, on the motion `[v, ω]` it has.
pub(super) struct Kick<'a> {
    pub group: &'a Group,
    pub state: &'a [Row],
    pub f: Row,
    pub external: Row,
    pub old: Row,
    pub step: &'a Step,
}

impl Kick<'_> {
    /// `[v, ω]` after the kick, by the rule of every particle; kinetic energy and external work are added to `work`.
    pub(super) fn new_motion(&self, constraint: Option<&Constraint>, work: &mut Work) -> Row {
        let Self { group, f, external, old, step, .. } = self;
        if let Some(body) = &group.body {
            return self.of_body(body, constraint, work);
        }
        let (kick, decay) = (step.kick, step.decay());
        let mass = |k: usize| if k < 3 { group.mass } else { group.inertia };
        let mut new: Row = std::array::from_fn(|k| decay.kicked(old[k], kick / mass(k) * f[k]));
        let mut prescribed = [false; 2];
        if let Some(constraint) = constraint {
            (new, prescribed) = held(constraint, new, step);
        }
        let mean: Row = std::array::from_fn(|k| 0.5 * (old[k] + new[k]));
        for k in 0..6 {
            work.kinetic += 0.5 * mass(k) * mean[k] * mean[k];
            work.external += kick * external[k] * mean[k];
            let change = new[k] - old[k];
            work.change += 0.5 * mass(k) * change * change;
            work.resisted += kick * (external[k] - f[k]) * change;
            if prescribed[k / 3] || kick == 0.0 {
                work.external += step.support_impulse(mass(k), [old[k], new[k]], f[k]) * mean[k];
            }
        }
        new
    }

    /// `[v, ω]` of a body after the kick; kinetic energy and external work are added to `work`.
    fn of_body(&self, body: &RigidBody, constraint: Option<&Constraint>, work: &mut Work) -> Row {
        let Self { group, state, f, external, old, step } = self;
        let (kick, decay, triad) = (step.kick, step.decay(), group.triad(state));
        let hold = constraint.map_or(DirectorHold::Free, |held| held.director);
        // What a torque does to the spin.
        let turning = |torque: Vec3| match hold {
            DirectorHold::Free => body.marching.power(&triad, Power::Inverse, &torque),
            DirectorHold::InPlane(n) => n * (n.dot(&torque) / body.marching.about(&triad, &n)),
            DirectorHold::Fixed => Vec3::zeros(),
        };
        let pushed = turning(director(f));
        let push = |k: usize| kick * if k < 3 { f[k] / group.mass } else { pushed[k - 3] };
        let mut new: Row = std::array::from_fn(|k| decay.kicked(old[k], push(k)));
        if let Some(constraint) = constraint {
            let spin = constraint.spin(step).unwrap_or_else(|| constraint.free_spin(director(&new)));
            new[3..].copy_from_slice(spin.as_slice());
            if !constraint.held.basis().is_empty() {
                new = self.guided(body, constraint, &triad, new, turning);
            }
        }
        let mean: Row = std::array::from_fn(|k| 0.5 * (old[k] + new[k]));
        let (v, spin) = (place(&mean), director(&mean));
        work.kinetic += 0.5 * (group.mass * v.norm_squared() + body.marching.about(&triad, &spin));
        work.external += kick * (0..6).map(|k| external[k] * mean[k]).sum::<f64>();
        let change: Row = std::array::from_fn(|k| new[k] - old[k]);
        let turned = body.marching.about(&triad, &director(&change));
        work.change += 0.5 * (group.mass * place(&change).norm_squared() + turned);
        work.resisted += kick * (0..6).map(|k| (external[k] - f[k]) * change[k]).sum::<f64>();
        if kick == 0.0 || constraint.is_some_and(|constraint| constraint.prescribed().is_some()) {
            // What the balance of the body lacks, its supports exert.
            let change: Row = std::array::from_fn(|k| new[k] - old[k] + kick * step.damping * mean[k]);
            let impulse = place(&change) * group.mass - place(f) * kick;
            let turning = body.marching.power(&triad, Power::One, &director(&change)) - director(f) * kick;
            work.external += impulse.dot(&v) + turning.dot(&spin);
        }
        new
    }

    /// A motion with the impulse that brings the reference point where supports have it after the drift.
    fn guided(
        &self,
        body: &RigidBody,
        constraint: &Constraint,
        triad: &Matrix3<f64>,
        motion: Row,
        turning: impl Fn(Vec3) -> Vec3,
    ) -> Row {
        let Self { group, state, step, .. } = self;
        let (dt, arm, held) = (step.drift(), body.arm(triad), constraint.held.basis());
        let target = constraint.reference_at(step.to, LoadCase::Loading);
        // Velocity of the reference point for impulses along the held directions; what is not held is left as it is.
        let mut matrix = Matrix3::identity();
        for (j, n) in held.iter().enumerate() {
            let v = n / group.mass + turning(arm.cross(n)).cross(&arm);
            (0..held.len()).for_each(|i| matrix[(i, j)] = held[i].dot(&v));
        }
        let Some(inverse) = matrix.try_inverse() else { return motion };
        let (mut v, mut spin) = (place(&motion), director(&motion));
        let start = group.pole(state);
        for _ in 0..ROUNDS {
            let theta = match constraint.director {
                DirectorHold::Free => body.free_turn(triad, &spin, dt).0,
                _ => spin * dt,
            };
            let missing = (target - start - v * dt - body.arm(&turned(triad, &theta))) / dt;
            let lack = Vec3::from_fn(|i, _| held.get(i).map_or(0.0, |n| n.dot(&missing)));
            let sizes = inverse * lack;
            let impulse = held.iter().zip(sizes.iter()).map(|(n, size)| n * *size).sum::<Vec3>();
            let before = (v, spin);
            v += impulse / group.mass;
            spin += turning(arm.cross(&impulse));
            if (v, spin) == before {
                break;
            }
        }
        [v.x, v.y, v.z, spin.x, spin.y, spin.z]
    }
}

/// A motion without what supports hold and with what they prescribe; whether they prescribe velocity and spin.
fn held(constraint: &Constraint, new: Row, step: &Step) -> (Row, [bool; 2]) {
    let mut v = constraint.held.free_part([new[0], new[1], new[2]]);
    let moved = constraint.velocity(step);
    if let Some(moved) = moved {
        (0..3).for_each(|k| v[k] += moved[k]);
    }
    let turned = constraint.spin(step);
    let w = turned.unwrap_or_else(|| constraint.free_spin(director(&new)));
    ([v[0], v[1], v[2], w.x, w.y, w.z], [moved.is_some(), turned.is_some()])
}
