//! Forces that whoever leads a march exerts on the particles of a system, by a function.

use crate::step::Instant;

/// A function of the instant, of all positions \[L\] and of all velocities \[L/T\], those of half a step before, that fills in a force
/// on each particle \[F\]. In quasi-static runs times say nothing, and levels say how far the run has come.
pub type Exert = Box<dyn FnMut(Instant, &[[f64; 3]], &[[f64; 3]], &mut [[f64; 3]]) + Send + Sync>;

/// Such a function, with room for what it is given and for what it fills in.
pub struct Push {
    exert: Exert,
    positions: Vec<[f64; 3]>,
    velocities: Vec<[f64; 3]>,
    forces: Vec<[f64; 3]>,
}

impl Push {
    /// Of a function on so many particles.
    pub fn new(particles: usize, exert: Exert) -> Self {
        let room = || vec![[0.0; 3]; particles];
        Self { exert, positions: room(), velocities: room(), forces: room() }
    }

    /// The forces at an instant, on particles of which each has this position and velocity.
    pub fn forces(&mut self, at: Instant, of: impl Fn(usize) -> [[f64; 3]; 2]) -> &[[f64; 3]] {
        let Self { exert, positions, velocities, forces } = self;
        let rooms = positions.iter_mut().zip(&mut *velocities).enumerate();
        rooms.for_each(|(particle, (position, velocity))| [*position, *velocity] = of(particle));
        exert(at, positions, velocities, forces);
        forces
    }

    /// Bytes of its room.
    pub fn bytes(&self) -> usize {
        3 * size_of::<[f64; 3]>() * self.forces.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_function_sees_each_particle_and_its_forces_stay_until_it_changes_them() {
        let spring: Exert = Box::new(|at, x, v, f| {
            if at.time < 2.0 {
                (0..x.len()).for_each(|a| f[a] = [0, 1, 2].map(|k| -2.0 * x[a][k] - v[a][k]));
            }
        });
        let mut push = Push::new(2, spring);
        let of = |a: usize| [[a as f64, 1.0, 0.0], [0.0, 0.0, 3.0]];
        let at = |time| Instant { time, level: 1.0 };
        assert_eq!(push.forces(at(1.0), of), [[0.0, -2.0, -3.0], [-2.0, -2.0, -3.0]]);
        assert_eq!(push.forces(at(2.0), |_| [[7.0; 3]; 2])[1], [-2.0, -2.0, -3.0]);
    }
}
