//! Sets that are rigid: which groups they become, what is refused, loads on the body.

use explicit_dynamics::Instant;
use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::Shell;
use crate::conditions::loads::{AppliedLoad, Block, Body, Load, check_set};
use crate::conditions::supports::{Constraint, Holds};
use crate::error::ShellError;
use crate::formulation::{Formulation, Reach};
use crate::junction::body::{Inertia, RigidBody};
use crate::junction::group::{Group, Junctions, director};
use crate::junction::rotation::{across, of_arm, triad as triad_of};
use crate::reference::Reference;

/// Least distance, in units of the spacing, of a particle of a rigid set from the normal at its first one.
const APART: f64 = 1e-3;

/// Particles that move as one rigid body, with what it has of its own.
#[derive(Clone, Debug, Default)]
pub struct RigidSet {
    /// The particles; of sheets that meet, all of a place.
    pub particles: Vec<u32>,
    /// The reference point: there its own mass stands, forces act and supports hold \[L\].
    pub at: Vec3,
    /// Mass beside that of the particles \[M\], zero for a rigid patch of the shell.
    pub mass: f64,
    /// Inertia of that mass about the reference point \[M L²\].
    pub inertia: Matrix3<f64>,
    /// What each support asks: displacements of the reference point, held or prescribed, and rotations of the body; a plane for
    /// directors leaves the rotation about its normal.
    pub holds: Vec<Holds>,
}

/// A load on a rigid body: a dead force at its reference point and a couple about an axis fixed in space.
#[derive(Clone, Copy, Debug)]
pub struct RigidLoad {
    /// Number of the body among the rigid sets.
    pub set: usize,
    /// The force \[F\].
    pub force: Vec3,
    /// The couple \[F L\]; without a potential where the body turns about several axes.
    pub couple: Vec3,
}

/// What supports of a set ask of its body cannot be.
fn opposed(set: usize, fault: ShellError) -> ShellError {
    let what = match fault {
        ShellError::TwoMotions(_) => "two of them move or turn it, with courses of their own; give both one",
        ShellError::HeldDirector { .. } => {
            "one turns it and another holds or turns its rotation; remove one, or let the other hold displacements only"
        }
        _ => "one moves its reference point along a direction that another holds; remove one of them",
    };
    ShellError::RigidOpposed { set, what }
}

impl Load for RigidLoad {
    fn add(&self, _: f64, _: &Body<'_>, _: &mut [[f64; 6]]) {}

    fn stiffness(&self, _: f64, _: &Body<'_>, _: &mut dyn FnMut(u32, u32, &Block)) {}

    fn on_body(&self, number: usize, _: f64) -> Option<[Vec3; 2]> {
        (number == self.set).then_some([self.force, self.couple])
    }

    fn check(&self, _: &Reference) -> Result<(), ShellError> {
        Ok(())
    }
}

impl Shell {
    /// Makes sets rigid, after ties and lumped masses.
    ///
    /// # Errors
    /// [`ShellError`] for sets that are empty, meet each other, stand on one line along a normal, hold a particle that is supported, tied to
    /// a cell, or of a junction only in part; for masses and inertias that are none; where strains are not sampled in cells.
    pub fn rigid(&mut self, sets: &[RigidSet]) -> Result<(), ShellError> {
        if sets.is_empty() {
            return Ok(());
        }
        if !matches!(self.formulation, Formulation::StressPoint(Reach::Cell)) {
            return Err(ShellError::RigidOfWideStencils);
        }
        let origin = self.reference.origin;
        let from_origin = |set: &RigidSet| {
            let holds = set.holds.iter().cloned().map(|holds| holds.about(&origin)).collect();
            RigidSet { at: set.at - origin, holds, ..set.clone() }
        };
        let sets: Vec<RigidSet> = sets.iter().map(from_origin).collect();
        let mut owner = vec![0_usize; self.len()];
        for (set, number) in sets.iter().zip(1..) {
            self.check_rigid(number - 1, set, &mut owner)?;
        }
        let mut junctions = std::mem::take(&mut self.junctions);
        let in_body = |group: &Group| group.particles.iter().any(|&a| owner[a as usize] > 0);
        for group in junctions.groups.iter().filter(|group| in_body(group)) {
            let number = owner[group.first()];
            if let Some(&particle) = group.particles.iter().find(|&&a| owner[a as usize] != number) {
                return Err(ShellError::RigidInPart { particle });
            }
        }
        junctions.groups.retain(|group| !in_body(group));
        for (number, set) in sets.iter().enumerate() {
            let first = set.particles[0] as usize;
            let rest = (set.at, self.reference.cloud.frames[first].n);
            let asked: Vec<(usize, Holds)> = set.holds.iter().cloned().enumerate().collect();
            let joined = Constraint::join(set.particles[0], rest, &asked);
            let mut constraint = joined.map_err(|fault| opposed(number, fault))?;
            constraint.tied = true;
            junctions.groups.push(self.body(number, set, &constraint)?);
            self.constraints.push(constraint);
            let entry = self.constraints.len() as u32;
            set.particles.iter().for_each(|&a| self.constraint_of[a as usize] = entry);
        }
        self.junctions = Junctions::of_groups(junctions.groups, self.len());
        Ok(())
    }

    fn check_rigid(&self, number: usize, set: &RigidSet, owner: &mut [usize]) -> Result<(), ShellError> {
        check_set("a rigid set", set.particles.iter().copied(), &self.reference)?;
        let inertia = set.inertia.symmetric_eigenvalues();
        let sound = set.mass >= 0.0 && set.mass.is_finite() && inertia.min() >= -1e-9 * inertia.max();
        if !sound || inertia.iter().any(|moment| !moment.is_finite()) {
            return Err(ShellError::RigidInertia { set: number, mass: set.mass, least: inertia.min() });
        }
        for &particle in &set.particles {
            let a = particle as usize;
            if std::mem::replace(&mut owner[a], number + 1) != 0 {
                return Err(ShellError::RigidTwice { particle });
            }
            if self.ties.of(a).is_some() {
                return Err(ShellError::RigidHangs { particle });
            }
            if self.constraint(a).is_some_and(Constraint::holds) {
                return Err(ShellError::RigidHeld { particle });
            }
        }
        Ok(())
    }

    /// The group of a set that is held so.
    fn body(&self, number: usize, set: &RigidSet, constraint: &Constraint) -> Result<Group, ShellError> {
        let cloud = &self.reference.cloud;
        let mut particles = set.particles.clone();
        particles.sort_unstable();
        let place = |k: usize| cloud.positions[particles[k] as usize];
        let normal = |k: usize| cloud.frames[particles[k] as usize].n;
        let best = |of: &dyn Fn(usize) -> f64| {
            (0..particles.len()).fold(0, |best, k| if of(k) > of(best) { k } else { best })
        };
        let aside = |upright: usize, far: usize| normal(upright).cross(&(place(far) - place(0))).norm();
        let (mut upright, mut far) = (0, best(&|k| aside(0, k)));
        let narrow = |upright: usize, far: usize| aside(upright, far) <= APART * cloud.spacing();
        if narrow(upright, far) {
            // All along the normal of the first, as an edge that rises from a joint: another's director is taken.
            far = best(&|k| (place(k) - place(0)).norm());
            upright = best(&|k| aside(k, far));
        }
        if narrow(upright, far) {
            return Err(ShellError::RigidOnALine { set: number });
        }
        let [masses, inertias] = self.moving_masses();
        let mass = particles.iter().map(|&a| masses[a as usize]).sum::<f64>() + set.mass;
        let moment: Vec3 = particles.iter().map(|&a| cloud.positions[a as usize] * masses[a as usize]).sum();
        let pole = (moment + set.at * set.mass) / mass;
        let section = self.thickness().powi(2) / 12.0;
        let turning = |a: usize| {
            let own = self.reference.rotary.get(a).copied();
            own.unwrap_or(self.reference.masses[a] * section)
                + self.ties.turning.get(a).copied().unwrap_or(0.0)
        };
        let own = set.inertia + of_arm(&(set.at - pole)) * set.mass;
        // Cells that are rigid turn by their own extents, and their directors by the thickness: no step in time hangs on those.
        let (missing, scaled) = self.of_rigid_cells(&particles, &pole);
        let tensor = |inertia: &dyn Fn(usize) -> f64| -> Matrix3<f64> {
            let part = |&a: &u32| {
                let a = a as usize;
                of_arm(&(cloud.positions[a] - pole)) * masses[a] + across(&cloud.frames[a].n) * inertia(a)
            };
            own + missing + particles.iter().map(part).sum::<Matrix3<f64>>()
        };
        let marching = |a: usize| {
            let share = scaled[particles.partition_point(|&b| (b as usize) < a)];
            share * inertias[a] + (1.0 - share) * turning(a)
        };
        let triad = triad_of(&normal(upright), &(place(far) - place(0)));
        let inverse = triad.transpose();
        let in_triad = |tensor: Matrix3<f64>| Inertia::new(inverse * tensor * triad);
        let body = RigidBody {
            places: particles
                .iter()
                .map(|&a| {
                    [cloud.positions[a as usize] - pole, cloud.frames[a as usize].n].map(|v| inverse * v)
                })
                .collect(),
            upright,
            far,
            rest: triad,
            held: constraint.held().iter().map(|n| n * n.transpose()).sum(),
            marching: in_triad(tensor(&marching)),
            modal: in_triad(tensor(&turning)),
            number,
            mass: set.mass,
            reference: inverse * (set.at - pole),
            load: [Vec3::zeros(); 2],
            external: [0.0; 6],
        };
        Ok(Group::of_body(particles, mass, body))
    }

    /// Number of rigid bodies, and of the particles in them.
    pub fn rigid_bodies(&self) -> [usize; 2] {
        let bodies = || self.junctions.groups.iter().filter(|group| group.body.is_some());
        [bodies().count(), bodies().map(|group| group.particles.len()).sum()]
    }

    /// Evaluates the loads on rigid bodies, each load times a factor, with what springs exert on them where that is wanted.
    pub(crate) fn evaluate_bodies(&mut self, springs: bool, scale: impl Fn(&AppliedLoad) -> f64) {
        for number in 0..self.junctions.groups.len() {
            let group = &self.junctions.groups[number];
            let Some(body) = &group.body else { continue };
            let triad = group.triad(&self.state);
            let mut sum = if springs { self.springs_on_body(body.number) } else { [Vec3::zeros(); 2] };
            for applied in &self.loads {
                let Some(own) = applied.load.on_body(body.number, body.mass) else { continue };
                let factor = scale(applied);
                sum.iter_mut().zip(own).for_each(|(sum, part)| *sum += part * factor);
            }
            if let Some(body) = &mut self.junctions.groups[number].body {
                body.take(&triad, sum);
            }
        }
    }

    /// What a load exerts on all rigid bodies: force and couple, and where the force acts.
    pub(crate) fn on_bodies<'a>(
        &'a self,
        load: &'a dyn Load,
    ) -> impl Iterator<Item = ([Vec3; 2], Vec3)> + 'a {
        self.junctions.groups.iter().filter_map(move |group| {
            let body = group.body.as_ref()?;
            let at = group.pole(&self.state) + body.arm(&group.triad(&self.state));
            Some((load.on_body(body.number, body.mass)?, at))
        })
    }

    /// Couples of the loads on rigid bodies at level one, with the particle that stands for each body \[F L\].
    pub(crate) fn couples_on_bodies(&self) -> Vec<(u32, Vec3)> {
        let at = Instant { time: 0.0, level: 1.0 };
        let couple = |group: &Group| {
            let body = group.body.as_ref()?;
            let own = |applied: &AppliedLoad| {
                Some(applied.load.on_body(body.number, body.mass)?[1] * applied.scale(at, self.case))
            };
            Some((group.first() as u32, self.loads.iter().filter_map(own).sum::<Vec3>()))
        };
        self.junctions
            .groups
            .iter()
            .filter_map(couple)
            .filter(|(_, couple)| *couple != Vec3::zeros())
            .collect()
    }

    /// Force and torque of the loads and springs on the rigid body that a particle stands for.
    pub(crate) fn body_load(&self, particle: usize) -> [f64; 6] {
        let group = self.junctions.of(particle).filter(|group| group.first() == particle);
        group.and_then(|group| group.body.as_ref()).map_or([0.0; 6], |body| body.external)
    }

    /// What the supports of a group bear about the place of its first particle: a body bears it at its pole.
    pub(crate) fn about_first(&self, group: &Group, row: &[f64; 6]) -> Vec3 {
        let moment = director(row);
        if group.body.is_none() {
            return moment;
        }
        moment
            + (group.pole(&self.state) - self.place(group.first())).cross(&Vec3::new(row[0], row[1], row[2]))
    }
}
