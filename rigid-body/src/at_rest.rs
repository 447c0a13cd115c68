//! A rigid body whose equilibria are sought: six unknowns at most, its motions prescribed by the level.

use explicit_dynamics::Instant;
use implicit_statics::{Equilibrium, Joinable, OutOfBounds};
use nalgebra::Vector6;
use sph_core::Vec3;

use crate::body::RigidBody;
use crate::conditions::{RotationHold, Wrench};
use crate::forces::stacked;

/// A rigid body without time.
#[derive(Clone, Debug)]
pub struct RestingBody {
    body: RigidBody,
}

impl RestingBody {
    /// The body with what is asked of it where no time passes.
    pub fn new(body: RigidBody) -> Self {
        Self { body }
    }

    /// The body in its present state.
    pub fn body(&self) -> &RigidBody {
        &self.body
    }

    /// The same, to put it into another state.
    pub fn body_mut(&mut self) -> &mut RigidBody {
        &mut self.body
    }

    /// Evaluates forces at a level, with what supports bear; the energy of springs \[F L\].
    pub fn evaluate(&mut self, level: f64) -> f64 {
        self.put(level);
        let energy = self.body.evaluate_at(at(level));
        let (body, lacking) = (&self.body, self.body.internal - self.body.external);
        let free = body.free_axes();
        let turning = match body.hold.rotation {
            RotationHold::Free => Vec3::zeros(),
            _ => lacking.moment - free.iter().map(|axis| axis * axis.dot(&lacking.moment)).sum::<Vec3>(),
        };
        let force = lacking.force - body.hold.free_part(&lacking.force);
        self.body.borne = Wrench { force, moment: turning };
        energy
    }

    /// Displacement of a particle along a direction, as weights of the unknowns.
    pub fn functional(&self, particle: u32, along: &Vec3) -> Vec<f64> {
        let arm = self.body.motion.turn.axes() * self.body.arms[particle as usize];
        self.ways().iter().map(|way| way.dot(&stacked(along, &arm.cross(along)))).collect()
    }

    /// Displacement and turn of the body for a unit of each unknown.
    fn ways(&self) -> Vec<Vector6<f64>> {
        let places = self.body.hold.held.free().into_iter().map(|n| stacked(&n, &Vec3::zeros()));
        places.chain(self.body.free_axes().iter().map(|axis| stacked(&Vec3::zeros(), axis))).collect()
    }

    fn project(&self, wrench: &Wrench, out: &mut [f64]) {
        let all = stacked(&wrench.force, &wrench.moment);
        out.iter_mut().zip(self.ways()).for_each(|(out, way)| *out = way.dot(&all));
    }

    /// How fast supports move and turn the body with the level, along fixed axes.
    fn prescribed_rate(&self) -> Vector6<f64> {
        let hold = &self.body.hold;
        stacked(&hold.displacement(at(1.0)), &hold.rotation_at(at(1.0)).unwrap_or_default())
    }
}

impl Equilibrium for RestingBody {
    fn unknowns(&self) -> usize {
        self.body.dof()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        (0..self.unknowns()).flat_map(|row| (0..=row).map(move |column| (row, column))).collect()
    }

    fn internal(&mut self, level: f64, out: &mut [f64]) {
        self.evaluate(level);
        self.project(&self.body.internal, out);
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.evaluate(level);
        self.project(&self.body.external, out);
    }

    /// Loads are proportional to the level; springs are drawn by what supports move.
    fn load_rate(&mut self, level: f64, out: &mut [f64]) {
        self.evaluate(level);
        let pull = self.body.stiffness() * self.prescribed_rate();
        let exerted = self.body.exerted.0;
        self.body.evaluate_at(at(1.0));
        let loads = self.body.external - exerted;
        let [force, moment] = [0, 3].map(|k| Vec3::new(pull[k], pull[k + 1], pull[k + 2]));
        self.project(&(loads - Wrench { force, moment }), out);
    }

    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        self.evaluate(level);
        let (stiffness, ways) = (self.body.stiffness(), self.ways());
        for ((row, column), value) in self.pattern().into_iter().zip(values) {
            *value = ways[row].dot(&(stiffness * ways[column]));
        }
    }

    fn has_moving_supports(&self) -> bool {
        self.body.hold.moves()
    }

    fn driving_force(&self) -> f64 {
        if self.body.hold.moves() { self.body.borne.force.norm() } else { 0.0 }
    }

    fn update(&mut self, increment: &[f64]) {
        let ways = self.ways();
        let all: Vector6<f64> = ways.iter().zip(increment).map(|(way, by)| way * *by).sum();
        let [place, turn] = [0, 3].map(|k| Vec3::new(all[k], all[k + 1], all[k + 2]));
        let motion = &mut self.body.motion;
        motion.pole += place;
        motion.turned += turn;
        motion.turn = motion.turn.turned(&turn);
    }

    /// Principal axes go with the body: numbers along them stay what they are.
    fn transport(&mut self, motion: &mut [f64]) {
        self.update(motion);
    }

    fn save(&self) -> Vec<f64> {
        self.body.state()
    }

    fn restore(&mut self, saved: &[f64]) {
        self.body.take_up(saved);
    }

    fn energy(&mut self) -> f64 {
        self.body.evaluate_at(at(0.0))
    }

    fn masses(&self) -> Vec<f64> {
        let places = self.body.hold.held.free().into_iter().map(|_| self.body.mass);
        places.chain(self.body.free_axes().iter().map(|axis| self.body.moment_about(axis))).collect()
    }

    fn name_unknown(&self, unknown: usize) -> String {
        let (places, axes) = (self.body.hold.held.free(), self.body.free_axes());
        let (what, n) = match places.get(unknown) {
            Some(n) => ("moving along", *n),
            None => ("turning about", axes.get(unknown - places.len()).copied().unwrap_or_default()),
        };
        format!("the body {what} ({:.2}, {:.2}, {:.2})", n.x, n.y, n.z)
    }

    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        Ok(())
    }
}

impl Joinable for RestingBody {
    fn places(&self, particles: &[u32], out: &mut [[f64; 3]]) {
        explicit_dynamics::Joinable::places(&self.body, particles, out);
    }

    fn put(&mut self, level: f64) {
        let Self { body } = self;
        if !body.hold.moves() {
            return;
        }
        let target = body.rest[body.centre() as usize] + body.hold.displacement(at(level));
        let mut place: [f64; 3] = body.motion.pole.into();
        body.hold.held.put(&target, &mut place);
        body.motion.pole = place.into();
        if let Some(theta) = body.hold.rotation_at(at(level)) {
            body.motion.turn = body.upright.turned(&theta);
            body.motion.turned = theta;
        }
    }

    fn release(&mut self) {
        self.body.release_exerted();
    }

    fn exert(&mut self, particles: &[u32], forces: &[[f64; 3]]) {
        self.body.add_exerted(particles, forces);
    }

    fn motion_of(&self, particle: u32) -> Vec<(usize, [f64; 3])> {
        let arm = self.body.motion.turn.axes() * self.body.arms[particle as usize];
        let of = |way: &Vector6<f64>| {
            let [place, turn] = [0, 3].map(|k| Vec3::new(way[k], way[k + 1], way[k + 2]));
            place + turn.cross(&arm)
        };
        self.ways().iter().map(|way| of(way).into()).enumerate().collect()
    }
}

/// A level of an analysis in which no time passes.
fn at(level: f64) -> Instant {
    Instant { time: 0.0, level }
}
