//! Kick and drift: forces with the velocities of half a step before, rates of density in the middle of the step.
//!
//! ```text
//! v^{n+½} = v^{n−½} + κ a(rⁿ, v^{n−½}, ρⁿ)
//! ρ^{n+1} = ρⁿ + Δt D(rⁿ + ½Δt u, v^{n+½}, ρⁿ),    r^{n+1} = rⁿ + Δt u,   u = v^{n+½}, or the mean of XSPH
//! ```
//!
//! Boundaries end a step where the march puts them, and stand half a step of their mean velocities behind in its middle.

use explicit_dynamics::{
    Bounds, Dynamics, Instant, MarchError, OutOfBounds, OutOfRange, StableStep, Step, Work,
};
use parallel::reduced;
use sph_core::Vec3;

use crate::fluid::{CELL, Fluid, StepBounds};
use crate::formulation::{Scheme, WallRule};
use crate::ledger::Sums;
use crate::start::outside;

impl Dynamics for Fluid {
    fn evaluate(&mut self, _: Instant) -> f64 {
        self.refresh();
        self.compression()
    }

    fn kick(&mut self, step: &Step) -> Work {
        let sums = self.kick_velocities(step);
        let kinetic = 0.5 * self.mass * sums.square;
        let mut work = Work { kinetic, ..Work::default() };
        if step.kick > 0.0 {
            if self.formulation.scheme == Scheme::KickDriftKick {
                let friction = step.kick * self.mass * self.force_sum.friction;
                self.ledger.viscous += friction;
                work.dissipated += friction + 2.0 * step.damping * step.kick * kinetic;
                work.external += step.kick * self.mass * self.gravity.dot(&sums.velocity);
                work.change = 0.5 * self.mass * sums.change;
                work.resisted = step.kick * self.mass * sums.resisted;
            }
            work.external += std::mem::take(&mut self.ledger.external);
            work.dissipated += std::mem::take(&mut self.ledger.dissipated);
            self.fastest = sums.fastest.sqrt();
        }
        work
    }

    fn drift(&mut self, step: &Step) {
        let dt = step.drift();
        self.boundary.move_walls(step.to.time, dt);
        match self.formulation.scheme {
            Scheme::KickDriftKick => self.drift_once(dt),
            Scheme::PredictorCorrector => self.predict_and_correct(dt, step.damping),
        }
        self.boundary.advance = 0.0;
        self.fresh = false;
    }

    fn advance(&mut self, step: &Step) -> Work {
        self.refresh();
        let work = self.kick(step);
        self.drift(step);
        work
    }

    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        self.find_step(safety)
    }

    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        match bounds {
            Bounds::Motion => self.check_speeds(),
            Bounds::Configuration => self.check_configuration(),
        }
    }

    fn stop(&mut self) {
        self.present.velocities.fill(Default::default());
        self.fresh = false;
    }
}

impl Fluid {
    /// Forces of the present state, unless they are there.
    pub(super) fn refresh(&mut self) {
        if self.fresh {
            return;
        }
        self.sort(0.0, 0.0);
        self.fill(0.0, 0.0, true);
        self.find_sides();
        self.press_boundaries();
        self.sweep_forces();
        self.ledger.external += self.boundary.work_after(self.mass);
        self.fresh = true;
    }

    /// New velocities; of a predictor and corrector none. Sums of the means of old and new.
    fn kick_velocities(&mut self, step: &Step) -> Sums {
        let kicks = self.formulation.scheme == Scheme::KickDriftKick;
        let kick = if kicks { step.kick } else { 0.0 };
        let decay = Step { kick, ..*step }.decay();
        let Self { threads, present, accelerations, sorted, sums, gravity, .. } = self;
        let slots = &sorted.slots;
        reduced(*threads, &mut present.velocities[..], sums, |first, velocities: &mut [Vec3]| {
            let mut sums = Sums::default();
            for (velocity, &slot) in velocities.iter_mut().zip(&slots[first..]) {
                let acceleration = Vec3::from(accelerations[slot as usize]);
                let new = velocity.zip_map(&acceleration, |v, a| decay.kicked(v, kick * a));
                let change = new - *velocity;
                sums.change += change.norm_squared();
                sums.resisted += (*gravity - acceleration).dot(&change);
                sums.kick(velocity, new);
            }
            sums
        });
        Sums::total(sums)
    }

    fn drift_once(&mut self, dt: f64) {
        if self.formulation.xsph != 0.0 {
            self.fill(0.0, 0.5 * dt, true);
            self.sweep_drags();
        }
        // Cells are a little wider than the kernel reaches; whoever went further is sorted anew, from before its way.
        let way = 0.5 * dt * self.fastest;
        let spare = (CELL - 1.0) * 2.0 * self.momentum.kernel.h;
        let resort = way + way.max(self.boundary.advance) > spare;
        if resort {
            self.sort(0.5 * dt, 0.5 * dt);
        }
        self.fill(0.5 * dt, 0.5 * dt, resort);
        if resort {
            self.find_sides();
        }
        self.sweep_rates();
        self.ledger.external += self.boundary.work_before(self.mass, dt);
        self.advance_boundary_densities(dt);
        self.advance_places(dt, resort);
    }

    /// New densities and places from the rates; `resorted` since drags were found.
    fn advance_places(&mut self, dt: f64, resorted: bool) {
        let Self { threads, liquid, present, rates, drags, sorted, sums, mass, .. } = self;
        let (slots, velocities) = (&sorted.slots, &present.velocities);
        let dragged = if resorted { &sorted.before } else { slots };
        let lists = (&mut present.positions[..], &mut present.densities[..]);
        reduced(*threads, lists, sums, |first, (positions, densities): (&mut [Vec3], &mut [f64])| {
            let mut sums = Sums::default();
            for (i, (position, density)) in (first..).zip(positions.iter_mut().zip(densities)) {
                sums.compress(liquid, density, rates[slots[i] as usize], dt);
                let drag = drags.get(dragged[i] as usize).map_or_else(Vec3::zeros, |drag| Vec3::from(*drag));
                *position += (velocities[i] + drag) * dt;
            }
            sums
        });
        let sums = Sums::total(sums);
        let loss = *mass * sums.loss;
        self.ledger.diffusion += loss;
        self.ledger.dissipated += loss;
        self.ledger.density_error = self.ledger.density_error.max(sums.error);
    }

    /// New densities of boundaries that have their own; never below that of no pressure, for a wall does not pull.
    pub(super) fn advance_boundary_densities(&mut self, dt: f64) {
        if self.formulation.walls == WallRule::Extrapolated {
            return;
        }
        let least = if self.formulation.confined { 0.0 } else { self.liquid.density };
        let boundary = &mut self.boundary;
        for (&point, &[rate, _]) in boundary.sorted.order.iter().zip(&boundary.rates) {
            let density = &mut boundary.densities[point as usize];
            *density = (*density + dt * rate).max(least);
        }
    }

    fn check_speeds(&self) -> Result<(), OutOfBounds> {
        let bound = self.liquid.sound_speed;
        let square = |(particle, v): (usize, &Vec3)| {
            let square = v.norm_squared();
            (particle, if square.is_nan() { f64::INFINITY } else { square })
        };
        let squares = self.present.velocities.iter().enumerate().map(square);
        let (particle, square) =
            squares.fold((0, 0.0), |best, next| if next.1 > best.1 { next } else { best });
        let speed = square.sqrt();
        if speed <= bound { Ok(()) } else { Err(OutOfBounds::Speed { particle, speed, bound }) }
    }

    fn check_configuration(&self) -> Result<(), OutOfBounds> {
        let place = |particle: usize| format!("particle {particle}");
        let ratio = |density: &f64| density / self.liquid.density;
        let dense = |density: &f64| !(0.5..=2.0).contains(&ratio(density));
        if let Some(particle) = self.present.densities.iter().position(dense) {
            let value = ratio(&self.present.densities[particle]);
            let bound = "between 0.5 and 2: raise the speed of sound or refine";
            return Err(OutOfRange {
                place: place(particle),
                what: "density over that at rest",
                value,
                bound,
            }
            .into());
        }
        if let Some(domain) = &self.domain {
            let positions = &self.present.positions;
            let outside = |at: &Vec3| outside(self.dimensions, domain, at);
            if let Some(particle) = positions.iter().position(outside) {
                let [low, high] = domain;
                let beyond =
                    |k: &usize| !(positions[particle][*k] >= low[*k] && positions[particle][*k] <= high[*k]);
                let axis = (0..self.dimensions).find(beyond).unwrap_or(0);
                let what = ["first coordinate", "second coordinate", "third coordinate"][axis];
                let value = positions[particle][axis];
                let bound = "inside the domain: close the walls or enlarge the domain";
                return Err(OutOfRange { place: place(particle), what, value, bound }.into());
            }
        }
        if let Some((value, _)) = self.collapsed() {
            let (place, what) = ("the fluid".to_owned(), "stable step");
            let bound = "at least 1e-4 h/c of a quiet fluid: particles collide or boundaries move too fast";
            return Err(OutOfRange { place, what, value, bound }.into());
        }
        Ok(())
    }
}

/// Part of the step of a quiet column below which a step has collapsed.
pub(super) const COLLAPSED: f64 = 1e-4;

impl Fluid {
    /// The step of the present state, times a safety; its forces are kept for the evaluation to come.
    pub(super) fn find_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        self.refresh();
        let h = self.momentum.kernel.h;
        let quotient = |a: f64, b: f64| if b > 0.0 { a / b } else { f64::INFINITY };
        let force = quotient(h, self.force_sum.square.sqrt()).sqrt();
        let sound = h / self.force_sum.signal;
        // Of laminar friction; of the fastest point of a boundary, which is not divided further.
        let friction = quotient(0.125 * h * h, self.formulation.kinematic_viscosity);
        let boundary = quotient(0.25 * h, self.boundary.speed());
        self.bounds = StepBounds { force, sound };
        // A bound that is no number must not vanish in a minimum: the fluid is refused by its bounds then.
        let dt = safety * (self.formulation.courant * force.min(sound)).min(friction).min(boundary);
        let good = dt > 0.0 && dt.is_finite() && !force.is_nan() && !sound.is_nan();
        if good { Ok(StableStep { dt, holds: 1 }) } else { Err(MarchError::NoStableStep(dt)) }
    }

    /// Whether the last step was next to nothing; it and its bound \[T\].
    pub(super) fn collapsed(&self) -> Option<(f64, f64)> {
        let quiet = self.momentum.kernel.h / self.liquid.sound_speed;
        let least = self.bounds.force.min(self.bounds.sound);
        (least > 0.0 && least < COLLAPSED * quiet).then_some((least, COLLAPSED * quiet))
    }
}
