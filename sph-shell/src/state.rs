//! The motion of the particles: read, set, kept and taken up again.

use sph_core::Vec3;

use crate::Shell;

impl Shell {
    /// Present position of a particle \[L\].
    pub fn position(&self, particle: usize) -> Vec3 {
        self.reference.from_zero(self.place(particle))
    }

    /// Position of a particle at rest \[L\].
    pub fn rest_position(&self, particle: usize) -> Vec3 {
        self.rest_positions()[particle]
    }

    /// Positions of all particles at rest \[L\].
    pub fn rest_positions(&self) -> &[Vec3] {
        if self.reference.given.is_empty() { &self.reference.cloud.positions } else { &self.reference.given }
    }

    /// Present position from the origin \[L\].
    pub(crate) fn place(&self, particle: usize) -> Vec3 {
        let row = &self.state[particle];
        Vec3::new(row[0], row[1], row[2])
    }

    /// Displacement of a particle \[L\].
    pub fn displacement(&self, particle: usize) -> Vec3 {
        self.place(particle) - self.reference.cloud.positions[particle]
    }

    /// Present director of a particle (unit vector).
    pub fn director(&self, particle: usize) -> Vec3 {
        let row = &self.state[particle];
        Vec3::new(row[3], row[4], row[5])
    }

    /// Velocity of a particle, half a step behind its position \[L/T\].
    pub fn velocity(&self, particle: usize) -> Vec3 {
        let row = self.rate(particle);
        Vec3::new(row[0], row[1], row[2])
    }

    /// Rate of a particle's director, in step with [`Shell::velocity`] \[1/T\].
    pub fn director_rate(&self, particle: usize) -> Vec3 {
        let row = self.rate(particle);
        Vec3::new(row[3], row[4], row[5])
    }

    /// Sets the velocity of a particle and the rate of its director; held parts are taken out. Tied particles share the velocity
    /// last set, and turn as their directors' rates say; a rigid body takes the motion of its particles, which must be rigid.
    pub fn set_rate(&mut self, particle: usize, velocity: Vec3, director_rate: Vec3) {
        let d = self.director(particle);
        let tangent = director_rate - d * d.dot(&director_rate);
        let (mut v, mut w) = (velocity.into(), tangent.into());
        let group = self.junctions.of(particle);
        let rigid = group.is_some_and(|group| group.body.is_some());
        if let Some(constraint) = self.constraint(particle).filter(|_| !rigid) {
            (v, w) = (constraint.free_translation(v), constraint.free_rotation(w));
        }
        self.rates[particle] = [v[0], v[1], v[2], w[0], w[1], w[2]];
        for &a in group.iter().filter(|_| !rigid).flat_map(|group| &group.particles) {
            self.rates[a as usize][..3].copy_from_slice(&v);
        }
    }

    /// Puts a particle at a position with a director (made a unit vector); for tests and initial shapes.
    pub fn set_state(&mut self, particle: usize, position: Vec3, director: Vec3) {
        let (d, position) = (director.normalize(), position - self.reference.origin);
        self.state[particle] = [position.x, position.y, position.z, d.x, d.y, d.z];
    }

    /// All that changes while the shell moves, a row a particle: `[x, d]` \[L, –\] and its rates \[L/T, 1/T\].
    pub fn motion(&self) -> [&[[f64; 6]]; 2] {
        [&self.state, &self.rates]
    }

    /// Takes up a motion that [`Shell::motion`] gave, to the same bits; false, and nothing changed, if it is that of
    /// another number of particles.
    pub fn take_up(&mut self, [state, rates]: [&[[f64; 6]]; 2]) -> bool {
        let fits = state.len() == self.len() && rates.len() == self.len();
        if fits {
            self.state.copy_from_slice(state);
            self.rates.copy_from_slice(rates);
        }
        fits
    }
}
