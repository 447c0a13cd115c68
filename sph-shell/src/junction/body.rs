//! A rigid body: what a group has beside its particles when they stand apart.
//!
//! The particles of a set stand at arms `a_k = Q A_k` from a pole p and have directors `d_k = Q D_k`, Q the triad of the group. A body may
//! have mass and inertia of its own. Velocity and inertia are those of the pole:
//!
//! ```text
//! J = Σ m_k (|a_k|² 1 − a_k a_kᵀ) + Σ I_k (1 − d_k d_kᵀ) + J_own + m_own (|r|² 1 − r rᵀ)
//! kick    v += κ F/m,  ω += κ J⁻¹ τ                                   at the present Q
//! drift   p += Δt v;  J(Q½) ω½ = J ω,  Q½ = exp(½Δt ω½) Q;  Q ← exp(Δt ω½) Q,  J ω as before
//! ```
//!
//! The pole is the centre of mass, so that v and ω do not meet in the kinetic energy; supports hold another point, the reference point
//! (`guide.rs`). The drift is a free motion by the midpoint rule: it keeps moment of momentum to round-off. The inertia of
//! directors is that of particles restricted to the body: a constraint shortens no stable step.

use nalgebra::{Matrix3, SymmetricEigen};
use sph_core::Vec3;

use crate::junction::rotation::turned;
use crate::packs::Row;

/// Rounds of the midpoint rule: each gains a factor of `Δt ω`, and steps turn a body by far less than a hundredth.
const ROUNDS: usize = 8;

/// What a group has as a rigid body.
#[derive(Clone, Debug)]
pub(crate) struct RigidBody {
    /// Arm from the pole and director of each particle, in the triad.
    pub places: Vec<[Vec3; 2]>,
    /// Places in the group of the particles whose director, and whose chord from the first, make the triad.
    pub upright: usize,
    pub far: usize,
    /// The triad at rest.
    pub rest: Matrix3<f64>,
    /// Projector on the directions in which supports hold the reference point; zero without.
    pub held: Matrix3<f64>,
    /// Its inertia in the march and in modes.
    pub marching: Inertia,
    pub modal: Inertia,
    /// Number of its set, its own mass \[M\], and its reference point from the pole in the triad \[L\].
    pub number: usize,
    pub mass: f64,
    pub reference: Vec3,
    /// Force and couple of the loads on the body itself at its reference point, as last evaluated; the same as a row about the pole.
    pub load: [Vec3; 2],
    pub external: Row,
}

/// Inertia about the pole: principal axes in the triad, as columns, and moments \[M L²\].
#[derive(Clone, Debug)]
pub(crate) struct Inertia {
    pub axes: Matrix3<f64>,
    moments: Vec3,
}

impl Inertia {
    /// Of a tensor in the triad.
    pub fn new(tensor: Matrix3<f64>) -> Self {
        let eigen = SymmetricEigen::new(tensor);
        Self { axes: eigen.eigenvectors, moments: eigen.eigenvalues }
    }

    /// `J^p w` in space for the present triad.
    pub fn power(&self, triad: &Matrix3<f64>, p: Power, w: &Vec3) -> Vec3 {
        let axes = triad * self.axes;
        let factor = |moment: f64| match p {
            Power::One => moment,
            Power::Inverse => 1.0 / moment,
            Power::Root => moment.sqrt(),
            Power::InverseRoot => 1.0 / moment.sqrt(),
        };
        axes * self.moments.map(factor).component_mul(&axes.tr_mul(w))
    }

    /// `eᵀ J e` for the present triad.
    pub fn about(&self, triad: &Matrix3<f64>, e: &Vec3) -> f64 {
        e.dot(&self.power(triad, Power::One, e))
    }
}

/// A power of the inertia.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Power {
    One,
    Inverse,
    Root,
    InverseRoot,
}

impl RigidBody {
    /// Its reference point from the pole, for the present triad \[L\].
    pub fn arm(&self, triad: &Matrix3<f64>) -> Vec3 {
        triad * self.reference
    }

    /// The rotation vector of a free motion over a step, by the midpoint rule, and the spin at its end.
    pub fn free_turn(&self, triad: &Matrix3<f64>, spin: &Vec3, dt: f64) -> (Vec3, Vec3) {
        let momentum = self.marching.power(triad, Power::One, spin);
        let mut middle = *spin;
        for _ in 0..ROUNDS {
            let half = turned(triad, &(middle * (0.5 * dt)));
            let next = self.marching.power(&half, Power::Inverse, &momentum);
            let settled = next == middle;
            middle = next;
            if settled {
                break;
            }
        }
        let theta = middle * dt;
        (theta, self.marching.power(&turned(triad, &theta), Power::Inverse, &momentum))
    }

    /// Second variation of its loads along the rotation, to be added to that of the particles, r the reference point from the pole:
    /// `−½(F rᵀ + r Fᵀ) + (F·r) 1`; that of a couple about a fixed axis is skew.
    pub fn load_block(&self, triad: &Matrix3<f64>) -> Matrix3<f64> {
        let (r, f) = (self.arm(triad), self.load[0]);
        let outer = f * r.transpose();
        Matrix3::identity() * f.dot(&r) - (outer + outer.transpose()) * 0.5
    }

    /// Takes force and couple at its reference point as its loads.
    pub fn take(&mut self, triad: &Matrix3<f64>, [force, couple]: [Vec3; 2]) {
        let moment = self.arm(triad).cross(&force) + couple;
        self.load = [force, couple];
        self.external = [force.x, force.y, force.z, moment.x, moment.y, moment.z];
    }
}
