//! The published march: all rates twice a step, with velocities at the places' own instants.
//!
//! ```text
//! x½* = xⁿ + ½Δt R(xⁿ),    x^{n+1} = xⁿ + Δt R(x½*),    x = (ρ, v, r)
//! ```
//!
//! In terms of a march of kicks and drifts the forces at xⁿ are its evaluation, the drift is the whole step, and a kick only
//! hands over what the step before it recorded. So records show velocities at their own instant, and mass-proportional damping
//! is explicit.

use parallel::reduced;
use sph_core::Vec3;

use crate::cells::Grid;
use crate::fluid::{CELL, Fluid};
use crate::ledger::Sums;
use crate::pair::Row;
use crate::state::State;

/// Rates at the start, by the slots that particles had there, and the time to the middle of the step \[T\].
struct Prediction<'a> {
    start: &'a State,
    accelerations: &'a [[f64; 3]],
    rates: &'a [[f64; 2]],
    drags: &'a [[f64; 3]],
    half: f64,
    damping: f64,
}

impl Prediction<'_> {
    fn place(&self, i: usize, slot: usize) -> Vec3 {
        self.start.place(i, self.drags, slot, self.half)
    }

    fn velocity(&self, i: usize, slot: usize) -> Vec3 {
        let v = self.start.velocities[i];
        v + (Vec3::from(self.accelerations[slot]) - v * self.damping) * self.half
    }

    fn density(&self, i: usize, slot: usize) -> f64 {
        let [rate, exchange] = self.rates[slot];
        self.start.densities[i] + (rate + exchange) * self.half
    }
}

impl Fluid {
    /// A step from present forces; `damping` c \[1/T\].
    pub(super) fn predict_and_correct(&mut self, dt: f64, damping: f64) {
        // Rates at the start: its rows still stand, but boundaries have their velocities of this step.
        self.fill(0.0, dt, false);
        self.sweep_rates();
        self.sweep_drags();
        self.boundary.remember_densities();
        self.advance_boundary_densities(0.5 * dt);
        self.predict(0.5 * dt, damping);
        self.find_sides();
        self.press_boundaries();
        self.sweep_forces();
        self.sweep_rates();
        self.boundary.recall_densities();
        self.advance_boundary_densities(dt);
        self.sweep_drags();
        self.correct(dt, damping);
    }

    /// Sorts and fills `start + dt R(start)`, the present state being the start.
    fn predict(&mut self, half: f64, damping: f64) {
        let (far, width) = (self.far(), CELL * self.momentum.kernel.reach());
        let Self { threads, dimensions, liquid, present, accelerations, rates, drags, .. } = self;
        let (start, count) = (&*present, present.positions.len());
        let Self { grid, sorted, boundary, .. } = self;
        let middle = Prediction { start, accelerations, rates, drags, half, damping };
        let slot = |i: usize| sorted.slots[i] as usize;
        *grid = Grid::around(*dimensions, (0..count).map(|i| middle.place(i, slot(i))), width);
        sorted.sort(*threads, grid, count, |i, before| Some(middle.place(i, before[i] as usize).into()));
        sorted.fill(*threads, *dimensions, grid, far, |i, _, before, _| {
            let slot = before[i] as usize;
            let density = middle.density(i, slot);
            Row::new(middle.place(i, slot), density, middle.velocity(i, slot), liquid.p_over_rho2(density))
        });
        boundary.sort(grid, half, &[], None, &[]);
        boundary.fill(*dimensions, grid, far, half);
    }

    /// `state += dt R(half)`, and what that did is recorded.
    fn correct(&mut self, dt: f64, damping: f64) {
        let Self { threads, liquid, present, sorted, accelerations, rates, drags, sums, .. } = self;
        let State { positions, velocities, densities } = present;
        let lists = (&mut positions[..], (&mut velocities[..], &mut densities[..]));
        type Chunk<'a> = (&'a mut [Vec3], (&'a mut [Vec3], &'a mut [f64]));
        reduced(*threads, lists, sums, |first, (positions, (velocities, densities)): Chunk<'_>| {
            let mut sums = Sums::default();
            let each = positions.iter_mut().zip(velocities.iter_mut().zip(densities));
            for ((position, (velocity, density)), &slot) in each.zip(&sorted.slots[first..]) {
                let slot = slot as usize;
                let middle = Vec3::from(sorted.rows[slot].velocity());
                let drag = drags.get(slot).map_or_else(Vec3::zeros, |drag| Vec3::from(*drag));
                let new = *velocity + (Vec3::from(accelerations[slot]) - middle * damping) * dt;
                sums.kick(velocity, new);
                sums.compress(liquid, density, rates[slot], dt);
                *position += (middle + drag) * dt;
            }
            sums
        });
        let sums = Sums::total(sums);
        let friction = self.friction();
        let Self { mass, ledger, .. } = self;
        let (loss, friction) = (*mass * sums.loss, dt * *mass * friction);
        let power = self.gravity.dot(&sums.velocity) + self.boundary.pressing();
        ledger.diffusion += loss;
        ledger.viscous += friction;
        ledger.dissipated += loss + friction + damping * dt * *mass * sums.square;
        ledger.external += dt * (*mass * power + self.boundary.power());
        ledger.density_error = ledger.density_error.max(sums.error);
    }
}
