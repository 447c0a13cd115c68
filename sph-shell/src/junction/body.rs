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
//! The pole is the centre of mass, so that v and ω do not meet in the kinetic energy; where supports hold places, it is the reference
//! point that they hold. The drift is a free motion by the midpoint rule: it keeps moment of momentum to round-off. The inertia of
//! directors is that of particles restricted to the body: a constraint shortens no stable step.

use explicit_dynamics::Amplitude;
use nalgebra::{Matrix3, SymmetricEigen};
use sph_core::Vec3;

use crate::conditions::case::LoadCase;
use crate::packs::Row;

/// Rounds of the midpoint rule: each gains a factor of `Δt ω`, and steps turn a body by far less than a hundredth.
const ROUNDS: usize = 8;

/// What a group has as a rigid body.
#[derive(Clone, Debug)]
pub(crate) struct RigidBody {
    /// Arm from the pole and director of each particle, in the triad.
    pub places: Vec<[Vec3; 2]>,
    /// Place in the group of the particle whose chord from the first makes the triad.
    pub far: usize,
    /// Its inertia in the march and in modes.
    pub marching: Inertia,
    pub modal: Inertia,
    /// Loads on the body itself.
    pub loads: Vec<BodyLoad>,
    /// Their force and torque about the pole, as last evaluated.
    pub external: Row,
}

/// A dead force at a point of a body and a couple about an axis fixed in space.
#[derive(Clone, Debug)]
pub(crate) struct BodyLoad {
    pub force: Vec3,
    pub couple: Vec3,
    /// Where the force acts, from the pole, in the triad \[L\].
    pub arm: Vec3,
    pub case: LoadCase,
    pub amplitude: Amplitude,
    /// Its factor when the loads were last evaluated.
    pub scale: f64,
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

    /// Second variation of its loads along the rotation, to be added to that of the particles:
    /// `−½(F rᵀ + r Fᵀ) + (F·r) 1`; a couple about a fixed axis has a skew one alone.
    pub fn load_block(&self, triad: &Matrix3<f64>) -> Matrix3<f64> {
        let part = |load: &BodyLoad| {
            let (r, f) = (triad * load.arm, load.force * load.scale);
            let outer = f * r.transpose();
            Matrix3::identity() * f.dot(&r) - (outer + outer.transpose()) * 0.5
        };
        self.loads.iter().map(part).sum()
    }

    /// Evaluates its loads, each times a factor.
    pub fn evaluate(&mut self, triad: &Matrix3<f64>, scale: impl Fn(&BodyLoad) -> f64) {
        let mut sum = (Vec3::zeros(), Vec3::zeros());
        for load in &mut self.loads {
            load.scale = scale(load);
            let force = load.force * load.scale;
            sum.0 += force;
            sum.1 += (triad * load.arm).cross(&force) + load.couple * load.scale;
        }
        let (f, m) = sum;
        self.external = [f.x, f.y, f.z, m.x, m.y, m.z];
    }
}

/// `exp(θ) Q`, its columns made unit vectors.
pub(crate) fn turned(triad: &Matrix3<f64>, theta: &Vec3) -> Matrix3<f64> {
    let column = |i: usize| super::group::rotated(&triad.column(i).into(), theta).normalize();
    Matrix3::from_columns(&[column(0), column(1), column(2)])
}

/// `|a|² 1 − a aᵀ`.
pub(crate) fn of_arm(a: &Vec3) -> Matrix3<f64> {
    Matrix3::identity() * a.norm_squared() - a * a.transpose()
}
