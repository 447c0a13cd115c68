//! A rigid body: what it is made of, and its state.

use nalgebra::Matrix3;
use sph_core::{Cell, Vec3};

use crate::conditions::{Hold, Load, Spring, Support, Wrench};
use crate::error::RigidError;
use crate::mass::{MassProperties, Outline};
use crate::turn::Turn;
use crate::wet_points::{Moving, Surface, WetPoints};

/// Numbers of a state.
const NUMBERS: usize = 16;

/// What a body is made of.
#[derive(Clone, Debug)]
pub struct Parts {
    /// Its surface.
    pub outline: Outline,
    /// Mass, centre and inertia.
    pub mass: MassProperties,
    /// Its supports.
    pub supports: Vec<Support>,
    /// Its loads.
    pub loads: Vec<Load>,
    /// Its springs to the ground.
    pub springs: Vec<Spring>,
}

/// A body with a surface, a mass and an inertia, that keeps its shape.
///
/// Its particles are the vertices of the surface and, last of them, its centre.
#[derive(Clone, Debug)]
pub struct RigidBody {
    pub(crate) cells: Vec<Cell>,
    /// Particles at rest \[L\].
    pub(crate) rest: Vec<Vec3>,
    /// Their arms from the centre in principal axes \[L\].
    pub(crate) arms: Vec<Vec3>,
    pub(crate) mass: f64,
    /// Principal moments of inertia \[M L²\].
    pub(crate) moments: Vec3,
    /// The turn at rest.
    pub(crate) upright: Turn,
    /// The longest step in time \[T\].
    pub(crate) longest: f64,
    pub(crate) motion: Motion,
    pub(crate) hold: Hold,
    pub(crate) loads: Vec<Load>,
    pub(crate) springs: Vec<Spring>,
    /// What others exert, with `Σ f aᵀ` of it.
    pub(crate) exerted: (Wrench, Matrix3<f64>),
    /// Of springs, as they resist, and of all else, as last evaluated.
    pub(crate) internal: Wrench,
    pub(crate) external: Wrench,
    /// `Σ f aᵀ` of both, as they push.
    pub(crate) lever: Matrix3<f64>,
    pub(crate) energy: f64,
    /// What supports exert.
    pub(crate) borne: Wrench,
    /// What a fluid wets of it.
    pub(crate) wetted: Option<Surface>,
}

/// Where a body is and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Motion {
    /// The centre \[L\].
    pub pole: Vec3,
    pub turn: Turn,
    /// Velocity of the centre \[L/T\].
    pub velocity: Vec3,
    /// Moment of momentum about the centre \[M L²/T\].
    pub spin: Vec3,
    /// Sum of all turns, along fixed axes \[rad\].
    pub turned: Vec3,
}

impl RigidBody {
    /// A body at rest.
    ///
    /// # Errors
    /// [`RigidError`] for an inertia that no body has, supports that contradict each other, and particles that there are not.
    pub fn new(parts: Parts) -> Result<Self, RigidError> {
        let Parts { outline: Outline { vertices, cells }, mass, supports, loads, springs } = parts;
        let (moments, axes) = mass.principal()?;
        let mut rest = vertices;
        rest.push(mass.centre);
        let count = rest.len();
        let known = |what, particle: u32| match (particle as usize) < count {
            true => Ok(()),
            false => Err(RigidError::NoSuchParticle { what, particle, count }),
        };
        loads
            .iter()
            .flat_map(|load| &load.forces)
            .try_for_each(|(particle, _)| known("a load", *particle))?;
        springs.iter().try_for_each(|spring| known("a spring", spring.particle))?;
        let upright = Turn::of_axes(&axes);
        // By the axes that the turn has, so that the body at rest stands where it was.
        let axes = upright.axes();
        let arms = rest.iter().map(|x| axes.tr_mul(&(x - mass.centre))).collect();
        let still = Vec3::zeros();
        Ok(Self {
            cells,
            arms,
            mass: mass.mass,
            moments,
            upright,
            longest: f64::INFINITY,
            motion: Motion { pole: mass.centre, turn: upright, velocity: still, spin: still, turned: still },
            rest,
            hold: Hold::new(&supports)?,
            loads,
            springs,
            exerted: Default::default(),
            internal: Wrench::default(),
            external: Wrench::default(),
            lever: Matrix3::zeros(),
            energy: 0.0,
            borne: Wrench::default(),
            wetted: None,
        })
    }

    /// Sets out with a velocity of the centre \[L/T\] and a spin \[1/T\]; what supports hold stays at rest.
    pub fn set_out(&mut self, velocity: &Vec3, spin: &Vec3) {
        self.motion.velocity = self.hold.free_part(velocity);
        self.motion.spin = self.resisted(&self.inertia_times(spin));
    }

    /// Bounds its steps in time: nothing else does where it neither turns nor hangs on springs \[T\].
    pub fn bound_step(&mut self, longest: f64) {
        self.longest = longest;
    }

    /// Lets a fluid wet it.
    pub fn wet(&mut self, points: &WetPoints) {
        self.wetted = Some(Surface::new(points, &self.rest[self.centre() as usize], &self.upright.axes()));
    }

    /// Number of points that a fluid wets.
    pub fn wet_points(&self) -> usize {
        self.wetted.as_ref().map_or(0, |surface| surface.arms.len())
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.rest.len()
    }

    /// Whether it has no particle: never.
    pub fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// Particles at rest \[L\].
    pub fn rest(&self) -> &[Vec3] {
        &self.rest
    }

    /// Cells of its surface.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// The particle at its centre.
    pub fn centre(&self) -> u32 {
        self.rest.len() as u32 - 1
    }

    /// Mass \[M\].
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Principal moments of inertia about the centre \[M L²\].
    pub fn moments(&self) -> Vec3 {
        self.moments
    }

    /// Position of a particle \[L\].
    pub fn position(&self, particle: usize) -> Vec3 {
        // The centre has no arm: no turn moves it by rounding.
        self.motion.pole + self.motion.turn.axes() * self.arms[particle]
    }

    /// Positions of all particles \[L\].
    pub fn positions(&self) -> Vec<Vec3> {
        let axes = self.motion.turn.axes();
        self.arms.iter().map(|arm| self.motion.pole + axes * arm).collect()
    }

    /// Velocity of a particle \[L/T\].
    pub fn velocity(&self, particle: usize) -> Vec3 {
        let arm = self.motion.turn.axes() * self.arms[particle];
        self.motion.velocity + self.spin().cross(&arm)
    }

    /// Spin ω \[1/T\].
    pub fn spin(&self) -> Vec3 {
        self.spin_of(&self.motion.spin)
    }

    /// Moment of momentum about its centre \[M L²/T\].
    pub fn moment_of_momentum(&self) -> Vec3 {
        self.motion.spin
    }

    /// Sum of all its turns, each along fixed axes: the angle about an axis is its component \[rad\].
    pub fn turned(&self) -> Vec3 {
        self.motion.turned
    }

    /// Force of its supports \[F\] and their moment about the centre \[F L\].
    pub fn reaction(&self) -> [Vec3; 2] {
        [self.borne.force, self.borne.moment]
    }

    /// Degrees of freedom that no support holds.
    pub fn dof(&self) -> usize {
        self.hold.held.free().len() + self.free_axes().len()
    }

    /// What changes while it moves.
    pub fn state(&self) -> Vec<f64> {
        let Motion { pole, turn, velocity, spin, turned } = &self.motion;
        let vectors = [pole, velocity, spin, turned].into_iter().flat_map(|v| [v.x, v.y, v.z]);
        vectors.chain(turn.numbers()).collect()
    }

    /// Takes up what [`RigidBody::state`] gave; false, and nothing done, for other numbers.
    pub fn take_up(&mut self, state: &[f64]) -> bool {
        let Ok(numbers) = <&[f64; NUMBERS]>::try_from(state) else { return false };
        let v = |k: usize| Vec3::new(numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]);
        let turn = Turn::of_numbers([numbers[12], numbers[13], numbers[14], numbers[15]]);
        self.motion = Motion { pole: v(0), velocity: v(1), spin: v(2), turned: v(3), turn };
        true
    }

    /// How it moves.
    pub(crate) fn moving(&self) -> Moving {
        let Motion { turn, velocity, .. } = self.motion;
        Moving { axes: turn.axes(), velocity, spin: self.spin() }
    }

    /// `J w` in space \[M L²\].
    pub(crate) fn inertia_times(&self, w: &Vec3) -> Vec3 {
        let axes = self.motion.turn.axes();
        axes * self.moments.component_mul(&axes.tr_mul(w))
    }

    /// `J⁻¹ L` in space.
    pub(crate) fn spin_of(&self, momentum: &Vec3) -> Vec3 {
        let axes = self.motion.turn.axes();
        axes * axes.tr_mul(momentum).component_div(&self.moments)
    }
}
