//! The body in mass-scaled coordinates: its tangent applied to a vector.

use explicit_dynamics::{LinearisedDynamics, MassScaled};
use sph_core::Vec3;

use crate::Solid;
use crate::bonds::network::Row;
use crate::solid::vector;

/// Greatest perturbation in spacings: central differences lose 1e-10 to truncation and about as much to rounding.
const PERTURBATION: f64 = 1e-5;

impl LinearisedDynamics for Solid {
    fn unknowns(&self) -> usize {
        3 * self.rows.len()
    }

    fn apply(&mut self, v: &[f64], out: &mut [f64]) {
        let scaled = |row: usize| self.scaled(row, Vec3::new(v[3 * row], v[3 * row + 1], v[3 * row + 2]));
        let mut along: Vec<Row> = (0..self.rows.len()).map(|row| scaled(row).push(0.0).into()).collect();
        if !self.mechanics.tangent(&mut self.rows, &mut along, &mut self.internal, self.threads) {
            self.differences(&along);
        }
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

    /// Central differences of the internal forces along a displacement, in their place.
    fn differences(&mut self, along: &[Row]) {
        let greatest = along.iter().flatten().fold(0.0_f64, |most, u| most.max(u.abs()));
        if greatest == 0.0 {
            return self.internal.fill([0.0; 4]);
        }
        let eps = PERTURBATION * self.block.greatest_spacing() / greatest;
        let home = self.rows.clone();
        let forces = [1.0, -1.0].map(|sign| {
            for (row, (old, u)) in self.rows.iter_mut().zip(home.iter().zip(along)) {
                (0..3).for_each(|k| row[k] = old[k] + sign * eps * u[k]);
            }
            self.evaluate_internal(false);
            self.internal.clone()
        });
        self.rows = home;
        for (change, (up, down)) in self.internal.iter_mut().zip(forces[0].iter().zip(&forces[1])) {
            *change = std::array::from_fn(|k| (up[k] - down[k]) / (2.0 * eps));
        }
    }
}
