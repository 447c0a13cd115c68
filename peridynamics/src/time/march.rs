//! A peridynamic body as a system of `explicit-dynamics`: forces and breaking, kick, drift, stable step and bounds.

use explicit_dynamics::{
    Bounds, Dynamics, Instant, MarchError, MassScaled, OutOfBounds, StableStep, Step, Work, lanczos_step,
};
use sph_core::Vec3;

use crate::Solid;
use crate::mechanics::Evaluation;
use crate::solid::vector;

impl Dynamics for Solid {
    /// Bonds break once a step, after the forces of this step were found with them.
    fn evaluate(&mut self, at: Instant) -> f64 {
        let wanted = Evaluation { energy: true, watch: true, threads: self.threads };
        self.internal_energy = self.mechanics.evaluate(&mut self.rows, &mut self.internal, wanted);
        self.evaluate_external(at);
        self.internal_energy
    }

    fn kick(&mut self, step: &Step) -> Work {
        self.released += self.mechanics.break_bonds();
        self.pass::<false>(step)
    }

    fn drift(&mut self, step: &Step) {
        let dt = step.drift();
        for (row, rate) in self.rows.iter_mut().zip(&self.rates) {
            for k in 0..3 {
                row[k] += dt * rate[k];
            }
        }
    }

    fn advance(&mut self, step: &Step) -> Work {
        let wanted = Evaluation { energy: false, watch: true, threads: self.threads };
        self.mechanics.evaluate(&mut self.rows, &mut self.internal, wanted);
        self.evaluate_external(step.from);
        self.released += self.mechanics.break_bonds();
        self.pass::<true>(step)
    }

    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        lanczos_step(self, safety)
    }

    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        if bounds == Bounds::Configuration {
            return Ok(());
        }
        let speed = |row: usize| {
            let square = vector(&self.rates[row]).norm_squared();
            if square.is_nan() { f64::INFINITY } else { square }
        };
        let (particle, square) = (0..self.len())
            .map(|node| (node, speed(node)))
            .fold((0, 0.0), |best, next| if next.1 > best.1 { next } else { best });
        let (speed, bound) = (square.sqrt(), self.sound_speed);
        if speed <= bound { Ok(()) } else { Err(OutOfBounds::Speed { particle, speed, bound }) }
    }

    fn stop(&mut self) {
        self.rates.fill([0.0; 4]);
    }

    fn linearised(&mut self) -> Option<&mut dyn MassScaled> {
        Some(self)
    }
}

impl Solid {
    /// The vector without what supports of a row hold.
    pub(crate) fn free_part(&self, row: usize, v: Vec3) -> Vec3 {
        self.constraints.get(row).map_or(v, |constraint| constraint.free_part(v.into()).into())
    }
}
