//! The published march: all rates twice a step, with velocities at the places' own instants.
//!
//! ```text
//! x½* = xⁿ + ½Δt R(xⁿ),    x^{n+1} = xⁿ + Δt R(x½*),    x = (ρ, v, r)
//! ```
//!
//! In terms of a march of kicks and drifts the forces at xⁿ are its evaluation, the drift is the whole step, and a kick only
//! hands over what the step before it booked. So records show velocities at their own instant, and mass-proportional damping
//! is explicit.

use sph_core::Vec3;

use crate::fluid::{Fluid, State};

impl Fluid {
    /// A step from present forces; `damping` c \[1/T\].
    pub(super) fn predict_and_correct(&mut self, dt: f64, damping: f64) {
        let mut state = std::mem::take(&mut self.present);
        let mut half = std::mem::take(&mut self.half);
        // Rates at the start: its rows still stand, but boundaries have their velocities of this step.
        self.fill(&state, 0.0, dt);
        self.sweep_rates();
        self.sweep_moves(&state);
        self.predict(&state, &mut half, 0.5 * dt, damping);
        self.boundary.remember_densities();
        self.advance_boundary_densities(0.5 * dt);
        self.moves.clear();
        self.sort(&half, 0.0, 0.5 * dt);
        self.fill(&half, 0.0, 0.5 * dt);
        self.find_sides();
        self.press_boundaries();
        self.sweep_forces();
        self.sweep_rates();
        self.boundary.recall_densities();
        self.advance_boundary_densities(dt);
        self.sweep_moves(&half);
        self.correct(&mut state, &half, dt, damping);
        self.moves.clear();
        (self.present, self.half) = (state, half);
    }

    /// `half = start + dt R(start)`.
    fn predict(&self, start: &State, half: &mut State, dt: f64, damping: f64) {
        let moves = if self.moves.is_empty() { &start.velocities } else { &self.moves };
        half.positions.clear();
        half.positions.extend(start.positions.iter().zip(moves).map(|(r, u)| r + u * dt));
        let slot = |i: usize| self.sorted.slots[i] as usize;
        let acceleration = |i: usize, v: &Vec3| Vec3::from(self.accelerations[slot(i)]) - v * damping;
        half.velocities.clear();
        half.velocities.extend(start.velocities.iter().enumerate().map(|(i, v)| v + acceleration(i, v) * dt));
        let rate = |i: usize| self.rates[slot(i)][0] + self.rates[slot(i)][1];
        half.densities.clear();
        half.densities.extend(start.densities.iter().enumerate().map(|(i, density)| density + rate(i) * dt));
    }

    /// `state += dt R(half)`, and what that did is booked.
    fn correct(&mut self, state: &mut State, half: &State, dt: f64, damping: f64) {
        let Self { liquid, sorted, accelerations, rates, moves, mass, books, .. } = self;
        let moves = if moves.is_empty() { &half.velocities } else { &*moves };
        let share = |density: f64| liquid.pressure(density) / (density * density);
        let (mut velocity, mut square, mut loss) = (Vec3::zeros(), 0.0, 0.0);
        for (i, &slot) in sorted.slots.iter().enumerate() {
            let slot = slot as usize;
            let way = (Vec3::from(accelerations[slot]) - half.velocities[i] * damping) * dt;
            let mean = state.velocities[i] + way * 0.5;
            velocity += mean;
            square += mean.norm_squared();
            state.velocities[i] += way;
            state.positions[i] += moves[i] * dt;
            let [rate, exchange] = rates[slot];
            let (old, new) = (state.densities[i], state.densities[i] + dt * (rate + exchange));
            state.densities[i] = new;
            if exchange != 0.0 {
                loss -= 0.5 * exchange * (share(old) + share(new));
            }
            books.density_error = books.density_error.max((new / liquid.density - 1.0).abs());
        }
        let (loss, friction) = (dt * *mass * loss, dt * *mass * self.felt.friction);
        books.diffusion += loss;
        books.viscous += friction;
        books.dissipated += loss + friction + damping * dt * *mass * square;
        books.external += dt * (*mass * self.gravity.dot(&velocity) + self.boundary.power());
    }
}
