//! Groups of particles that move as one, on one place or as a rigid body: their triad, and how fast it turns.

use nalgebra::{Matrix3, Rotation3, SymmetricEigen, UnitQuaternion};
use sph_core::{Cell, Vec3, rotated};

use crate::conditions::supports::{Constraint, DirectorHold};
use crate::error::ShellError;
use crate::junction::body::RigidBody;
use crate::junction::rotation::{across, triad, turned};
use crate::packs::Row;
use crate::reference::Reference;

/// Least sine of the angle between two directors of a group: about a line along all of them nothing resists.
const LEAST_ANGLE: f64 = 0.01;

/// Particles that turn as one body, on one place unless they have a [`RigidBody`].
#[derive(Clone, Debug)]
pub(crate) struct Group {
    /// The particles, ascending; the first stands for all of them.
    pub particles: Vec<u32>,
    /// Places in `particles` of the two directors that are farthest from parallel: they make the triad.
    pair: [usize; 2],
    /// Principal axes of the rotary inertia of modes in the triad, as columns.
    axes: Matrix3<f64>,
    /// `Σ m_k` \[M\].
    pub mass: f64,
    /// `Σ I_k` of marching \[M L²\].
    pub inertia: f64,
    /// What a rigid body has beside.
    pub body: Option<Box<RigidBody>>,
}

/// All groups of a shell.
#[derive(Clone, Debug, Default)]
pub(crate) struct Junctions {
    pub groups: Vec<Group>,
    /// Number of each particle's group, one up; zero for others. Empty without groups.
    group_of: Vec<u32>,
    /// Velocity and spin of each group while a step is under way \[L/T, 1/T\].
    pub motions: Vec<Row>,
}

impl Junctions {
    /// The groups of a cloud whose particles are free to move, with the masses and rotary inertias of its particles.
    ///
    /// # Errors
    /// [`ShellError::ParallelDirectors`] for a group whose directors all run along one line.
    pub fn new(
        reference: &Reference,
        masses: [&[f64]; 2],
        free: impl Fn(usize) -> bool,
    ) -> Result<Self, ShellError> {
        let joined: Vec<&[u32]> = (reference.cloud.joined.iter().map(Vec::as_slice))
            .filter(|group| group.iter().all(|&a| free(a as usize)))
            .collect();
        if joined.is_empty() {
            return Ok(Self::default());
        }
        let groups = joined.iter().map(|particles| Group::new(particles, reference, masses));
        Ok(Self::of_groups(groups.collect::<Result<Vec<_>, _>>()?, reference.cloud.len()))
    }

    /// Those of some groups among `count` particles.
    pub fn of_groups(groups: Vec<Group>, count: usize) -> Self {
        let mut group_of = vec![0; count];
        for (number, group) in (1..).zip(&groups) {
            group.particles.iter().for_each(|&a| group_of[a as usize] = number);
        }
        Self { motions: vec![[0.0; 6]; groups.len()], groups, group_of }
    }

    pub fn is_empty(&self) -> bool {
        self.groups.is_empty()
    }

    /// The particles of all groups.
    pub fn particles(&self) -> impl Iterator<Item = usize> {
        self.groups.iter().flat_map(|group| &group.particles).map(|&a| a as usize)
    }

    /// Number of the group of a particle, if it belongs to one.
    pub fn number(&self, particle: usize) -> Option<usize> {
        (*self.group_of.get(particle)? as usize).checked_sub(1)
    }

    /// The group of a particle, if it belongs to one.
    pub fn of(&self, particle: usize) -> Option<&Group> {
        self.number(particle).map(|i| &self.groups[i])
    }

    /// The particle that bears the unknowns of a particle: the first of its group, or itself.
    pub fn first(&self, particle: usize) -> usize {
        self.of(particle).map_or(particle, Group::first)
    }

    /// The group of a rigid body, if the particle belongs to one.
    pub fn body_of(&self, particle: usize) -> Option<&Group> {
        self.of(particle).filter(|group| group.body.is_some())
    }

    /// The group of a rigid set by its number.
    pub fn body_numbered(&self, number: usize) -> Option<&Group> {
        let is = |group: &&Group| group.body.as_ref().is_some_and(|body| body.number == number);
        self.groups.iter().find(is)
    }

    /// The rigid body to which all corners of a cell belong.
    pub fn body_around(&self, cell: &Cell) -> Option<usize> {
        let number = |b: u32| self.body_of(b as usize).and(self.number(b as usize));
        let first = number(cell.corners[0])?;
        cell.particles().iter().all(|&b| number(b) == Some(first)).then_some(first)
    }

    /// A row `[f, n]` as the force on the unknowns of a particle: its own, or force and torque of the group it stands for, which
    /// leaves the others of the group nothing.
    pub fn gathered(&self, state: &[Row], a: usize, row: impl Fn(usize) -> Row) -> Row {
        match self.of(a) {
            None => row(a),
            Some(group) if group.first() == a => group.gather(state, row),
            Some(_) => [0.0; 6],
        }
    }

    /// Force and torque of the loads and springs on the rigid body that a particle stands for.
    pub fn body_load(&self, particle: usize) -> Row {
        let group = self.of(particle).filter(|group| group.first() == particle);
        group.and_then(|group| group.body.as_ref()).map_or([0.0; 6], |body| body.external)
    }
}

impl Group {
    fn new(particles: &[u32], reference: &Reference, masses: [&[f64]; 2]) -> Result<Self, ShellError> {
        let director = |k: usize| reference.cloud.frames[particles[k] as usize].n;
        let mut best = ([0, 0], 0.0);
        for i in 0..particles.len() {
            for j in 0..i {
                let sine = director(i).cross(&director(j)).norm();
                if sine > best.1 {
                    best = ([j, i], sine);
                }
            }
        }
        let (pair, sine) = best;
        if sine < LEAST_ANGLE {
            let particle = particles.first().copied().unwrap_or_default();
            return Err(ShellError::ParallelDirectors { particle, sine, bound: LEAST_ANGLE });
        }
        let sum = |of: &[f64]| particles.iter().map(|&a| of[a as usize]).sum();
        let tensor: Matrix3<f64> = (0..particles.len())
            .map(|k| across(&director(k)) * reference.masses[particles[k] as usize])
            .sum();
        let principal = SymmetricEigen::new(tensor).eigenvectors;
        let triad = triad(&director(pair[0]), &director(pair[1]));
        Ok(Self {
            particles: particles.to_vec(),
            pair,
            axes: triad.transpose() * principal,
            mass: sum(masses[0]),
            inertia: sum(masses[1]),
            body: None,
        })
    }

    /// The particles, ascending, of a rigid body of some mass \[M\].
    pub fn of_body(particles: Vec<u32>, mass: f64, body: RigidBody) -> Self {
        let axes = body.modal.axes;
        Self { particles, pair: [0, 0], axes, mass, inertia: 0.0, body: Some(Box::new(body)) }
    }

    /// The particle that stands for all.
    pub fn first(&self) -> usize {
        self.particles[0] as usize
    }

    /// Sum of a moment over its particles.
    pub fn sum_of(&self, of: impl Fn(usize) -> Vec3) -> Vec3 {
        self.particles.iter().map(|&a| of(a as usize)).fold(-Vec3::zeros(), |sum, own| sum + own)
    }

    /// Two vectors that turn with the group, among rows `[x, d]` or their rates: directors, of a body a director and a chord.
    fn vectors(&self, rows: &[Row]) -> [Vec3; 2] {
        let row = |k: usize| &rows[self.particles[k] as usize];
        match &self.body {
            None => self.pair.map(|k| director(row(k))),
            Some(body) => [director(row(body.upright)), place(row(body.far)) - place(row(0))],
        }
    }

    /// The present triad.
    pub fn triad(&self, state: &[Row]) -> Matrix3<f64> {
        let [d, e] = self.vectors(state);
        triad(&d, &e)
    }

    /// The point whose velocity is that of the group: the place of its particles, or the centre of mass of a body.
    pub fn pole(&self, state: &[Row]) -> Vec3 {
        let first = place(&state[self.first()]);
        self.body.as_ref().map_or(first, |body| first - self.triad(state) * body.places[0][0])
    }

    /// The pole of a body; a group on one place has no arms.
    pub fn far_pole(&self, state: &[Row]) -> Option<Vec3> {
        self.body.is_some().then(|| self.pole(state))
    }

    /// Present principal axes of the rotary inertia of modes: they turn with the group.
    pub fn principal_axes(&self, state: &[Row]) -> Matrix3<f64> {
        self.triad(state) * self.axes
    }

    /// The rotation vector from one state to another.
    pub fn rotation_to(&self, here: &[Row], there: &[Row]) -> Vec3 {
        let turned = self.principal_axes(there) * self.principal_axes(here).transpose();
        // By the quaternion: the trace of a matrix loses small angles.
        UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(turned)).scaled_axis()
    }

    /// `Σ m_k (1 − (d_k·e)²)`, over t²/12 the rotary inertia of modes about an axis \[M\].
    pub fn mass_about(&self, axis: &Vec3, state: &[Row], mass: impl Fn(usize) -> f64) -> f64 {
        let part = |&a: &u32| mass(a as usize) * (1.0 - director(&state[a as usize]).dot(axis).powi(2));
        self.particles.iter().map(part).sum()
    }

    /// Sum of rows `[f, n]` of the particles as force and torque about the pole, `[Σ f_k, Σ a_k × f_k + d_k × n_k]`.
    pub fn gather(&self, state: &[Row], row: impl Fn(usize) -> Row) -> Row {
        let pole = self.far_pole(state);
        let mut sum = [0.0; 6];
        for &a in &self.particles {
            let own = row(a as usize);
            let mut torque = director(&state[a as usize]).cross(&director(&own));
            if let Some(pole) = &pole {
                torque += (place(&state[a as usize]) - pole).cross(&place(&own));
            }
            for k in 0..3 {
                sum[k] += own[k];
                sum[3 + k] += torque[k];
            }
        }
        sum
    }

    /// Moment of what the supports of the group bear about the place of its first particle: a body bears it at its pole.
    pub fn about_first(&self, state: &[Row], row: &Row) -> Vec3 {
        let moment = director(row);
        if self.body.is_none() {
            return moment;
        }
        moment + (self.pole(state) - place(&state[self.first()])).cross(&place(row))
    }

    /// Velocity and spin `[v, ω]` from the rates of the particles.
    ///
    /// With `c = d₁ × d₂` the components along d₁, d₂, c follow from `w_k = ω × d_k`:
    /// `ω = [(w₂·c) d₁ − (w₁·c) d₂ + (w₁·d₂) c]/|c|²`.
    pub fn motion(&self, state: &[Row], rates: &[Row]) -> Row {
        let ([d1, d2], [w1, w2]) = (self.vectors(state), self.vectors(rates));
        let c = d1.cross(&d2);
        let spin = (d1 * w2.dot(&c) - d2 * w1.dot(&c) + c * w1.dot(&d2)) / c.norm_squared();
        let mut v = place(&rates[self.first()]);
        if let Some(pole) = self.far_pole(state) {
            v += spin.cross(&(pole - place(&state[self.first()])));
        }
        [v.x, v.y, v.z, spin.x, spin.y, spin.z]
    }

    /// Moves all particles by u and turns them by the rotation vector θ.
    pub fn turn(&self, state: &mut [Row], u: &Vec3, theta: &Vec3) {
        if self.body.is_some() {
            let (pole, triad) = (self.pole(state) + u, turned(&self.triad(state), theta));
            self.placed(&pole, &triad).for_each(|(a, row)| state[a as usize] = row);
            return;
        }
        for &a in &self.particles {
            let row = &mut state[a as usize];
            let d = rotated(&director(row), theta).normalize();
            *row = [row[0] + u.x, row[1] + u.y, row[2] + u.z, d.x, d.y, d.z];
        }
    }

    /// The particles of a body with their rows for a pole and a triad.
    pub fn placed(&self, pole: &Vec3, triad: &Matrix3<f64>) -> impl Iterator<Item = (u32, Row)> {
        let places = self.body.iter().flat_map(|body| &body.places);
        self.particles.iter().zip(places).map(move |(&a, [arm, d])| {
            let (x, d) = (pole + triad * arm, (triad * d).normalize());
            (a, [x.x, x.y, x.z, d.x, d.y, d.z])
        })
    }

    /// Gives all particles the rates of a motion `[v, ω]` of the pole: `v + ω × a_k` and `ω × d_k`.
    pub fn set_rates(&self, state: &[Row], rates: &mut [Row], motion: &Row) {
        let (spin, pole) = (director(motion), self.far_pole(state));
        for &a in &self.particles {
            let row = &state[a as usize];
            let w = spin.cross(&director(row));
            let mut v = place(motion);
            if let Some(pole) = &pole {
                v += spin.cross(&(place(row) - pole));
            }
            rates[a as usize] = [v.x, v.y, v.z, w.x, w.y, w.z];
        }
    }
}

impl Constraint {
    /// What supports leave of the spin of a group: nothing of a fixed one, the part along the normal where directors stay in a
    /// plane.
    pub(crate) fn free_spin(&self, spin: Vec3) -> Vec3 {
        match self.director {
            DirectorHold::Free => spin,
            DirectorHold::Fixed => Vec3::zeros(),
            DirectorHold::InPlane(n) => n * n.dot(&spin),
        }
    }

    /// Whether anything is held or prescribed.
    pub(crate) fn holds(&self) -> bool {
        !self.tied || self.held_degrees_of_freedom() > 0
    }
}

/// The second half of a row, of a director or what is conjugate to it.
pub(crate) fn director(row: &Row) -> Vec3 {
    Vec3::new(row[3], row[4], row[5])
}

/// The first half of a row, of a place or what is conjugate to it.
pub(crate) fn place(row: &Row) -> Vec3 {
    Vec3::new(row[0], row[1], row[2])
}
