//! The body in mass-scaled coordinates: its tangent applied to a vector, by differences of the internal force.

use explicit_dynamics::{LinearisedDynamics, MassScaled};
use sph_core::Vec3;

use crate::Solid;
use crate::solid::vector;

/// Greatest perturbation in spacings: central differences lose 1e-10 to truncation and about as much to rounding.
const PERTURBATION: f64 = 1e-5;

impl LinearisedDynamics for Solid {
    fn unknowns(&self) -> usize {
        3 * self.rows.len()
    }

    fn apply(&mut self, v: &[f64], out: &mut [f64]) {
        let direction: Vec<Vec3> = (0..self.rows.len()).map(|row| self.scaled(row, at(v, row))).collect();
        let greatest = direction.iter().fold(0.0_f64, |most, u| most.max(u.amax()));
        if greatest == 0.0 {
            return out.fill(0.0);
        }
        let eps = PERTURBATION * self.block.greatest_spacing() / greatest;
        let home = self.rows.clone();
        let mut forces = [vec![Vec3::zeros(); home.len()], vec![Vec3::zeros(); home.len()]];
        for (sign, force) in [1.0, -1.0].into_iter().zip(&mut forces) {
            for (row, (old, u)) in self.rows.iter_mut().zip(home.iter().zip(&direction)) {
                (0..3).for_each(|k| row[k] = old[k] + sign * eps * u[k]);
            }
            self.evaluate_internal(false);
            force.iter_mut().zip(&self.internal).for_each(|(force, row)| *force = vector(row));
        }
        self.rows = home;
        for row in 0..self.rows.len() {
            let change = (forces[0][row] - forces[1][row]) / (2.0 * eps);
            let scaled = self.scaled(row, change);
            out[3 * row..3 * row + 3].copy_from_slice(scaled.as_slice());
        }
    }
}

impl MassScaled for Solid {
    fn out_of_balance(&self, out: &mut [f64]) {
        for (row, out) in out.chunks_exact_mut(3).enumerate() {
            let external = self.external.get(row).copied().unwrap_or_default();
            let scaled = self.scaled(row, external - vector(&self.internal[row]));
            out.copy_from_slice(scaled.as_slice());
        }
    }

    fn rates(&self, out: &mut [f64]) {
        for (row, out) in out.chunks_exact_mut(3).enumerate() {
            let scaled = vector(&self.rates[row]) * self.masses[row].sqrt();
            out.copy_from_slice(scaled.as_slice());
        }
    }

    fn displaced(&self) -> f64 {
        let square =
            |row: usize| self.masses[row] * (vector(&self.rows[row]) - self.rest[row]).norm_squared();
        (0..self.rows.len()).map(square).sum::<f64>().sqrt()
    }
}

impl Solid {
    /// `M^{-½} v` of a row, without what supports hold.
    fn scaled(&self, row: usize, v: Vec3) -> Vec3 {
        self.free_part(row, v) / self.masses[row].sqrt()
    }
}

/// The part of a long vector that belongs to a row.
fn at(v: &[f64], row: usize) -> Vec3 {
    Vec3::new(v[3 * row], v[3 * row + 1], v[3 * row + 2])
}
