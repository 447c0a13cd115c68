//! The body in mass-scaled coordinates: its tangent applied to a vector.

use explicit_dynamics::{LinearisedDynamics, MassScaled};
use sph_core::Vec3;

use crate::Solid;
use crate::bonds::network::Row;
use crate::solid::vector;

impl LinearisedDynamics for Solid {
    fn unknowns(&self) -> usize {
        3 * self.rows.len()
    }

    fn apply(&mut self, v: &[f64], out: &mut [f64]) {
        let scaled = |row: usize| self.scaled(row, Vec3::new(v[3 * row], v[3 * row + 1], v[3 * row + 2]));
        let mut along: Vec<Row> = (0..self.rows.len()).map(|row| scaled(row).push(0.0).into()).collect();
        self.mechanics.tangent(&mut self.rows, &mut along, &mut self.internal, self.threads);
        for (row, out) in out.chunks_exact_mut(3).enumerate() {
            let scaled = self.scaled(row, vector(&self.internal[row]));
            out.copy_from_slice(scaled.as_slice());
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
