//! A column of the curve, measured on a set of particles of a body.

use sph_core::Vec3;

use super::body::Body;
use super::invariants::{Principal, von_mises_in_space};
use super::point_numbers::POINT_NUMBERS;
use super::sampled::Sampled;
use crate::results::curve::Column;
use crate::scene::units::{Quantity, Units};
use crate::scene::{self, Measured, Scene, Take, mean_of};

/// Numbers of a stress.
const OF_STRESS: usize = 6;

/// One column, measured.
#[derive(Clone, Debug)]
pub struct Probe {
    /// Name of the column.
    pub name: String,
    /// What it measures.
    pub of: Measured,
    /// Particles over which it is reduced; of what follows from strains the points at which these are sampled.
    pub particles: Vec<u32>,
    /// Unit vector along which it is measured; zero for numbers without components.
    pub direction: Vec3,
    /// Point about which a moment is taken \[L\].
    pub about: Vec3,
    /// What its values are, for the unit of the column.
    pub quantity: Quantity,
    /// What is taken of the values of the particles.
    pub take: Take,
    /// Factor on the value.
    pub factor: f64,
    /// Unit in which the column is written, to which the factor converts; none where it is that of its quantity.
    pub unit: Option<String>,
    /// Which joint exerts a force or a moment, by its number; of all where none is named.
    pub(crate) joint: Option<usize>,
    /// Where strains are sampled, of what follows from them.
    pub(crate) sampled: Option<Sampled>,
    /// For a rotation: last director and angle so far \[rad\] of each particle.
    pub(crate) turns: Vec<(Vec3, f64)>,
}

impl Probe {
    /// A column of factor one, the usual of its quantity taken.
    pub fn new(name: &str, of: Measured, particles: Vec<u32>, direction: Vec3) -> Self {
        let (take, quantity, about) = (Take::usual(of), of.quantity(), Vec3::zeros());
        let name = name.into();
        let (unit, joint, sampled, turns) = (None, None, None, Vec::new());
        Self {
            name,
            of,
            particles,
            direction,
            about,
            quantity,
            take,
            factor: 1.0,
            unit,
            joint,
            sampled,
            turns,
        }
    }

    /// A column of a scene.
    pub(crate) fn of_column(
        scene: &Scene,
        column: &scene::Probe,
        particles: Vec<u32>,
        direction: Vec3,
    ) -> Self {
        let unit = scene.unit_of(column);
        let factor = unit.as_ref().map_or(column.factor, |unit| column.factor * unit.factor);
        Self {
            take: column.taken(),
            factor,
            unit: unit.map(|unit| unit.symbol),
            about: column.about.map_or_else(Vec3::zeros, Vec3::from),
            quantity: scene.quantity(column.of),
            joint: column.joint.as_ref().and_then(|name| scene.joint(name)),
            ..Self::new(&column.name, column.of, particles, direction)
        }
    }

    /// Its column, and that of its mean where it has one.
    pub(crate) fn columns(&self, units: &Units) -> impl Iterator<Item = Column> {
        let unit = self.unit.clone().unwrap_or_else(|| units.symbol(self.quantity));
        let column = move |name| Column { name, unit: unit.clone() };
        let mean = self.of.has_mean().then(|| column(mean_of(&self.name)));
        [Some(column(self.name.clone())), mean].into_iter().flatten()
    }

    /// The value now.
    ///
    /// A rotation must be read at least twice a turn, since it is counted on from the last reading.
    pub(crate) fn read(&mut self, body: &dyn Body) -> f64 {
        let values = self.values(body);
        self.taken(&values)
    }

    /// Numbers that go linearly with a small motion: the value now, or, of a largest or least, the values of all particles.
    pub(crate) fn parts(&mut self, body: &dyn Body) -> Vec<f64> {
        if self.sampled.is_some() {
            return body.point_numbers(&self.particles).into_iter().flatten().collect();
        }
        if self.of.is_of_stress() {
            return self.stresses(body).into_iter().flatten().collect();
        }
        match self.take {
            Take::Mean | Take::Sum => vec![self.read(body)],
            Take::Max | Take::Min => self.values(body),
        }
    }

    /// Number of [`Probe::parts`].
    pub(crate) fn part_count(&self) -> usize {
        match self.take {
            _ if self.sampled.is_some() => self.particles.len() * POINT_NUMBERS,
            _ if self.of.is_of_stress() => self.particles.len() * OF_STRESS,
            Take::Mean | Take::Sum => 1,
            Take::Max | Take::Min => self.particles.len(),
        }
    }

    /// The value of which these are the [`Probe::parts`].
    pub(crate) fn of_parts(&self, parts: &[f64]) -> f64 {
        if let Some(sampled) = &self.sampled {
            return self.taken(&sampled.values(parts.as_chunks().0));
        }
        if self.of.is_of_stress() {
            return self.taken(&self.of_stresses(parts.as_chunks().0));
        }
        match self.take {
            Take::Mean | Take::Sum => parts.iter().sum(),
            Take::Max | Take::Min => self.taken(parts),
        }
    }

    /// What is taken of the values of the particles.
    fn taken(&self, values: &[f64]) -> f64 {
        match self.take {
            Take::Mean => self.factor * values.iter().sum::<f64>() / values.len() as f64,
            Take::Sum => self.factor * values.iter().sum::<f64>(),
            Take::Max => self.factor * values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            Take::Min => self.factor * values.iter().copied().fold(f64::INFINITY, f64::min),
        }
    }

    /// The value of each particle now.
    fn values(&mut self, body: &dyn Body) -> Vec<f64> {
        if let Some(sampled) = &self.sampled {
            return sampled.values(&body.point_numbers(&self.particles));
        }
        if self.of.is_of_stress() {
            return self.of_stresses(&self.stresses(body));
        }
        if matches!(self.of, Measured::ContactGap | Measured::GreatestDepth | Measured::TouchingArea) {
            return self.nodal_contact(body);
        }
        if matches!(self.of, Measured::PlasticStrain | Measured::Thickness | Measured::PlasticWork) {
            return self.yielding(body);
        }
        if self.of.is_of_joints() {
            return self.joints_exert(body);
        }
        let followed =
            self.of == Measured::Rotation && !self.particles.iter().all(|&a| body.counts_turns(a as usize));
        if followed {
            self.count_on(body);
        }
        let one = |i: usize| {
            let a = self.particles[i] as usize;
            match self.of {
                Measured::Rotation if followed => self.turns[i].1,
                Measured::Moment
                | Measured::ReactionMoment
                | Measured::ContactMoment
                | Measured::SectionMoment => moment(body, (self.of, a), &self.direction, &self.about),
                of => body.read(of, a, &self.direction),
            }
        };
        (0..self.particles.len()).map(one).collect()
    }

    /// Stresses of the particles, all of one solid.
    fn stresses(&self, body: &dyn Body) -> Vec<[f64; OF_STRESS]> {
        let Some(&first) = self.particles.first() else { return Vec::new() };
        let (of, own) = body.place(first as usize);
        let before = first - own as u32;
        let all = body.stresses(of);
        let one = |&a: &u32| all.get((a - before) as usize).copied().unwrap_or_default();
        self.particles.iter().map(one).collect()
    }

    /// What is taken of stresses `xx, yy, zz, xy, yz, zx`, one by one.
    fn of_stresses(&self, stresses: &[[f64; OF_STRESS]]) -> Vec<f64> {
        let e = self.direction;
        let one = |&stress: &[f64; OF_STRESS]| {
            let [xx, yy, zz, xy, yz, zx] = stress;
            let principal = || Principal::of(stress);
            match self.of {
                Measured::VonMises => von_mises_in_space(stress),
                Measured::MaxPrincipal => principal().stresses[0],
                Measured::MinPrincipal => principal().stresses[2],
                Measured::Tresca => principal().tresca(),
                _ => {
                    let normal = xx * e.x * e.x + yy * e.y * e.y + zz * e.z * e.z;
                    normal + 2.0 * (xy * e.x * e.y + yz * e.y * e.z + zx * e.z * e.x)
                }
            }
        };
        stresses.iter().map(one).collect()
    }

    /// What joints exert on the body of its one particle.
    fn joints_exert(&self, body: &dyn Body) -> Vec<f64> {
        let one = |&a: &u32| {
            let [force, moment] = body.joints_exert(body.place(a as usize).0, self.joint);
            let of = if self.of == Measured::JointForce { force } else { moment - self.about.cross(&force) };
            of.dot(&self.direction)
        };
        self.particles.iter().map(one).collect()
    }

    /// What the particles feel of contact, all of one body.
    fn nodal_contact(&self, body: &dyn Body) -> Vec<f64> {
        let Some(&first) = self.particles.first() else { return Vec::new() };
        let (of, own) = body.place(first as usize);
        let before = first - own as u32;
        let own: Vec<u32> = self.particles.iter().map(|a| a - before).collect();
        if self.of == Measured::ContactGap {
            return body.gaps(of, &own);
        }
        let nodal = body.nodal_contact(of);
        let one = |&a: &u32| match nodal.get(a as usize) {
            Some(nodal) if self.of == Measured::GreatestDepth => nodal.depth,
            Some(nodal) => nodal.area,
            None => 0.0,
        };
        own.iter().map(one).collect()
    }

    /// What the particles have gone through, all of one body that yields.
    fn yielding(&self, body: &dyn Body) -> Vec<f64> {
        let Some(&first) = self.particles.first() else { return Vec::new() };
        let (of, own) = body.place(first as usize);
        let before = first - own as u32;
        let all = body.yielding(of);
        let one = |&a: &u32| all.get((a - before) as usize).map_or(0.0, |own| own.read(self.of));
        self.particles.iter().map(one).collect()
    }

    fn count_on(&mut self, body: &dyn Body) {
        let along = |a: u32, axis: &Vec3| body.read(Measured::Director, a as usize, axis);
        let director = |&a: &u32| Vec3::new(along(a, &Vec3::x()), along(a, &Vec3::y()), along(a, &Vec3::z()));
        let directors = self.particles.iter().map(director);
        if self.turns.is_empty() {
            self.turns = directors.map(|d| (d, 0.0)).collect();
            return;
        }
        for ((last, angle), now) in self.turns.iter_mut().zip(directors) {
            *angle += turn(last, &now, &self.direction);
            *last = now;
        }
    }
}

/// Component of the moment about a point, `M·e − (p × F)·e`, from the moment about the origin.
fn moment(body: &dyn Body, (of, at): (Measured, usize), along: &Vec3, about: &Vec3) -> f64 {
    let force = match of {
        Measured::Moment => Measured::Force,
        Measured::ContactMoment => Measured::ContactForce,
        Measured::SectionMoment => Measured::SectionForce,
        _ => Measured::Reaction,
    };
    let force = [Vec3::x(), Vec3::y(), Vec3::z()].map(|axis| body.read(force, at, &axis));
    body.read(of, at, along) - about.cross(&Vec3::from(force)).dot(along)
}

/// Angle from `a` to `b` about `axis`, from −π to π \[rad\].
fn turn(a: &Vec3, b: &Vec3, axis: &Vec3) -> f64 {
    let across = |v: &Vec3| v - axis * axis.dot(v);
    let (a, b) = (across(a), across(b));
    libm::atan2(axis.dot(&a.cross(&b)), a.dot(&b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turn_has_the_sign_of_the_axis() {
        let (x, y, z) = (Vec3::x(), Vec3::y(), Vec3::z());
        assert!((turn(&x, &y, &z) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        assert!((turn(&x, &y, &-z) + std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        // The part along the axis does not count.
        assert!((turn(&(x + z), &(y - z), &z) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    }
}
