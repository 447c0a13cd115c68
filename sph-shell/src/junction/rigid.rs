//! Sets that are rigid: which groups they become, and what is refused.

use std::ops::Range;

use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::conditions::body::{Block, Body};
use crate::conditions::constraints::Constraints;
use crate::conditions::loads::{Load, LoadOnShare, check_set};
use crate::conditions::supports::{Constraint, Holds};
use crate::error::ShellError;
use crate::junction::body::{Inertia, RigidBody};
use crate::junction::group::{Group, Junctions};
use crate::junction::rotation::{across, of_arm, triad as triad_of};
use crate::material::Material;
use crate::reference::Reference;
use crate::second_moments::of_rigid_cells;
use crate::ties::list::Ties;

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

    fn on_share(&self, _: &Range<usize>, _: &Reference) -> Option<LoadOnShare> {
        Some(LoadOnShare { add: Box::new(|_, _, _| ()), reads: Vec::new() })
    }
}

/// What rigid bodies are made from: the shell, with masses and ties.
pub(crate) struct Bodies<'a> {
    pub reference: &'a Reference,
    pub material: &'a Material,
    pub ties: &'a Ties,
}

impl Bodies<'_> {
    /// The groups of a shell with those of its rigid sets, and what holds these.
    ///
    /// # Errors
    /// [`ShellError`] for sets that are empty, meet each other, stand on one line along a normal, hold a particle that is supported, tied to
    /// a cell, or of a junction only in part; for masses and inertias that are none.
    pub fn join(
        &self,
        mut junctions: Junctions,
        sets: &[RigidSet],
        constraints: &mut Constraints,
    ) -> Result<Junctions, ShellError> {
        if sets.is_empty() {
            return Ok(junctions);
        }
        let (origin, count) = (self.reference.origin, self.reference.cloud.len());
        let from_origin = |set: &RigidSet| {
            let holds = set.holds.iter().cloned().map(|holds| holds.about(&origin)).collect();
            RigidSet { at: set.at - origin, holds, ..set.clone() }
        };
        let sets: Vec<RigidSet> = sets.iter().map(from_origin).collect();
        let mut owner = vec![0_usize; count];
        for (number, set) in sets.iter().enumerate() {
            self.check(number, set, constraints, &mut owner)?;
        }
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
            constraints.hold(&set.particles, constraint);
        }
        Ok(Junctions::of_groups(junctions.groups, count))
    }

    fn check(
        &self,
        number: usize,
        set: &RigidSet,
        constraints: &Constraints,
        owner: &mut [usize],
    ) -> Result<(), ShellError> {
        check_set("a rigid set", set.particles.iter().copied(), self.reference)?;
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
            if constraints.of(a).is_some_and(Constraint::holds) {
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
        let [masses, inertias] = self.ties.moving_masses(self.reference);
        let mass = particles.iter().map(|&a| masses[a as usize]).sum::<f64>() + set.mass;
        let moment: Vec3 = particles.iter().map(|&a| cloud.positions[a as usize] * masses[a as usize]).sum();
        let pole = (moment + set.at * set.mass) / mass;
        let section = self.material.thickness(self.reference).powi(2) / 12.0;
        let turning = |a: usize| {
            let own = self.reference.rotary.get(a).copied();
            own.unwrap_or(self.reference.masses[a] * section)
                + self.ties.turning.get(a).copied().unwrap_or(0.0)
        };
        let own = set.inertia + of_arm(&(set.at - pole)) * set.mass;
        // Cells that are rigid turn by their own extents, and their directors by the thickness: no step in time hangs on those.
        let (missing, scaled) = of_rigid_cells(self.reference, self.material, &particles, &pole);
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
            held: constraint.held.basis().iter().map(|n| n * n.transpose()).sum(),
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
}
