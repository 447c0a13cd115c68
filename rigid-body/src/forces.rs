//! Forces on a body and their derivatives, and what of a motion supports leave.

use explicit_dynamics::Instant;
use nalgebra::{Matrix3, Matrix6, SymmetricEigen, Vector6};
use sph_core::Vec3;

use crate::body::RigidBody;
use crate::conditions::{RotationHold, Wrench};

impl RigidBody {
    /// Forces of springs and loads, and of what others exert, in the present state; the energy of springs \[F L\].
    pub(crate) fn evaluate_at(&mut self, at: Instant) -> f64 {
        let axes = self.motion.turn.axes();
        let (exerted, lever) = self.exerted;
        let (mut internal, mut external, mut lever) = (Wrench::default(), exerted, lever);
        self.energy = 0.0;
        if let Some(surface) = &self.wetted {
            let (pushed, own) = surface.push(&self.moving());
            external = external + pushed;
            lever += own;
        }
        for spring in &self.springs {
            let arm = axes * self.arms[spring.particle as usize];
            let moved = self.motion.pole + arm - self.rest[spring.particle as usize];
            let stretch = spring.direction.dot(&moved);
            let force = spring.direction * (spring.stiffness * stretch);
            internal.add(&force, &arm);
            lever -= force * arm.transpose();
            self.energy += 0.5 * spring.stiffness * stretch * stretch;
        }
        for load in &self.loads {
            let factor = at.level * load.amplitude.value(at.time);
            for &(particle, force) in &load.forces {
                let (force, arm) = (force * factor, axes * self.arms[particle as usize]);
                external.add(&force, &arm);
                lever += force * arm.transpose();
            }
            external.moment += load.couple * factor;
            external.force += load.acceleration * (self.mass * factor);
        }
        (self.internal, self.external, self.lever) = (internal, external, lever);
        self.energy
    }

    /// Forgets what others exert.
    pub(crate) fn release_exerted(&mut self) {
        self.exerted = Default::default();
    }

    /// Adds forces that others exert on particles.
    pub(crate) fn add_exerted(&mut self, particles: &[u32], forces: &[[f64; 3]]) {
        let axes = self.motion.turn.axes();
        let (wrench, lever) = &mut self.exerted;
        for (&particle, &force) in particles.iter().zip(forces) {
            let (force, arm) = (Vec3::from(force), axes * self.arms[particle as usize]);
            wrench.add(&force, &arm);
            *lever += force * arm.transpose();
        }
    }

    /// `∂(internal − external)` over displacements and turns along the axes of space, symmetric, for the forces last evaluated.
    pub(crate) fn stiffness(&self) -> Matrix6<f64> {
        let axes = self.motion.turn.axes();
        let mut all = Matrix6::zeros();
        for spring in &self.springs {
            let moment = (axes * self.arms[spring.particle as usize]).cross(&spring.direction);
            let way = stacked(&spring.direction, &moment);
            all += way * way.transpose() * spring.stiffness;
        }
        let turning = Matrix3::identity() * self.lever.trace() - (self.lever + self.lever.transpose()) * 0.5;
        let mut block = all.fixed_view_mut::<3, 3>(3, 3);
        block += turning;
        all
    }

    /// Axes of the turns that are free, in space: the principal ones, or the one that is left.
    pub(crate) fn free_axes(&self) -> Vec<Vec3> {
        match self.hold.rotation {
            RotationHold::Free => {
                let axes = self.motion.turn.axes();
                (0..3).map(|k| axes.column(k).into()).collect()
            }
            RotationHold::About(axis) => vec![axis],
            RotationHold::Fixed => Vec::new(),
        }
    }

    /// Moment of inertia about an axis \[M L²\].
    pub(crate) fn moment_about(&self, axis: &Vec3) -> f64 {
        axis.dot(&self.inertia_times(axis))
    }

    /// A moment of momentum as supports leave it: that of the spin that is free.
    pub(crate) fn resisted(&self, momentum: &Vec3) -> Vec3 {
        match self.hold.rotation {
            RotationHold::Free => *momentum,
            RotationHold::About(axis) => {
                self.inertia_times(&(axis * (axis.dot(momentum) / self.moment_about(&axis))))
            }
            RotationHold::Fixed => Vec3::zeros(),
        }
    }

    /// Masses that move with some particles at least, `Σ μ |ẋ|² ≤ 2T` for every motion \[M\].
    ///
    /// A force at an arm a meets the mass m_e, `1/m_e = 1/m + max_n (a × n)·J⁻¹ (a × n)`: the mass of one particle alone. Several share what
    /// there is in this proportion, `μ = m_e/λ` with the greatest eigenvalue λ of `Σ m_e BᵀB` over the mass of the body, `ẋ = B q̇`.
    pub(crate) fn masses_with(&self, particles: &[u32]) -> Vec<f64> {
        let arms: Vec<Vec3> = particles.iter().map(|&a| self.arms[a as usize]).collect();
        self.masses_at(&arms)
    }

    /// The same of places with these arms in principal axes \[L\].
    pub(crate) fn masses_at(&self, arms: &[Vec3]) -> Vec<f64> {
        let effective = |arm: &Vec3| {
            // (a × n)·J⁻¹ (a × n) = n·(ĀᵀJ⁻¹Ā) n, Ā the cross product with a.
            let cross = arm.cross_matrix();
            let turning = cross.transpose() * Matrix3::from_diagonal(&self.moments.map(f64::recip)) * cross;
            (1.0 / self.mass + SymmetricEigen::new(turning).eigenvalues.max()).recip()
        };
        let all: Vec<f64> = arms.iter().map(effective).collect();
        let (root, roots) = (self.mass.sqrt().recip(), self.moments.map(|moment| moment.sqrt().recip()));
        let mut sum = Matrix6::zeros();
        for (arm, mass) in arms.iter().zip(&all) {
            for axis in [Vec3::x(), Vec3::y(), Vec3::z()] {
                let row = stacked(&(axis * root), &arm.cross(&axis).component_mul(&roots));
                sum += row * row.transpose() * *mass;
            }
        }
        let most = SymmetricEigen::new(sum).eigenvalues.max();
        all.into_iter().map(|mass| mass / most).collect()
    }
}

/// Six numbers, those of space before those of turns.
pub(crate) fn stacked(place: &Vec3, turn: &Vec3) -> Vector6<f64> {
    Vector6::new(place.x, place.y, place.z, turn.x, turn.y, turn.z)
}
