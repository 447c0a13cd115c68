//! Kick and drift: forces with the velocities of half a step before, rates of density in the middle of the step.
//!
//! ```text
//! v^{n+½} = v^{n−½} + κ a(rⁿ, v^{n−½}, ρⁿ)
//! ρ^{n+1} = ρⁿ + Δt D(rⁿ + ½Δt u, v^{n+½}, ρⁿ),    r^{n+1} = rⁿ + Δt u,   u = v^{n+½}, or the mean of XSPH
//! ```
//!
//! Boundaries end a step where the march puts them, and stand half a step of their mean velocities behind in its middle.

use explicit_dynamics::{Bounds, Dynamics, Instant, MarchError, OutOfBounds, StableStep, Step, Work};
use parallel::reduced;
use peers::Exact;
use sph_core::Vec3;

use crate::books::by_cells;
use crate::fluid::{CELL, Fluid, StepBounds};
use crate::formulation::{Scheme, WallRule};
use crate::ledger::Sums;
use crate::pair::Row;
use crate::sharing::moving;
use crate::sorted::Sorted;

impl Dynamics for Fluid {
    fn evaluate(&mut self, _: Instant) -> f64 {
        self.refresh();
        let Self { threads, mass, liquid, grid, sorted, share, .. } = self;
        let adds = |cell: usize| share.adds(grid, cell);
        let Sorted { starts, rows, order, left, .. } = sorted;
        let energy = |_, row: &mut Row| [liquid.compression(row.density())];
        let [sum] = share.add(by_cells(*threads, starts, left, &mut rows[..order.len()], &adds, &energy));
        *mass * sum
    }

    fn kick(&mut self, step: &Step) -> Work {
        self.kicked(step, true)
    }

    fn drift(&mut self, step: &Step) {
        let dt = step.drift();
        self.settle_for(step.to.time, dt);
        self.boundary.move_walls(step.to.time, dt);
        self.advance_openings(step.to.time, dt);
        match self.formulation.scheme {
            Scheme::KickDriftKick => self.drift_once(dt),
            Scheme::PredictorCorrector => self.predict_and_correct(dt, step.damping),
        }
        self.boundary.advance = 0.0;
        self.fresh = false;
    }

    fn advance(&mut self, step: &Step) -> Work {
        self.refresh();
        let work = self.kicked(step, false);
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

/// Sums over the particles of a kick.
#[derive(Clone, Copy, Debug, Default)]
struct Kicked {
    /// Of squares of the means of old and new velocities.
    square: f64,
    /// Of their products with gravity, and of the power that a current gives.
    weight: f64,
    /// Of what friction takes of a unit of mass in a unit of time.
    friction: f64,
    /// Of squares of changes of velocities.
    change: f64,
    /// Of what all forces but gravity resisted them with, over a kick and a mass.
    resisted: f64,
}

impl Fluid {
    /// A kick, and its work; `recorded` what only records need of it.
    fn kicked(&mut self, step: &Step, recorded: bool) -> Work {
        let Kicked { square, weight, friction, change, resisted } = self.kick_velocities(step, recorded);
        let kinetic = 0.5 * self.mass * square;
        let mut work = Work { kinetic, ..Work::default() };
        if step.kick > 0.0 {
            if self.formulation.scheme == Scheme::KickDriftKick {
                let friction = step.kick * self.mass * friction;
                self.ledger.viscous += friction;
                work.dissipated += friction + 2.0 * step.damping * step.kick * kinetic;
                work.external += step.kick * self.mass * weight;
                work.change = 0.5 * self.mass * change;
                work.resisted = step.kick * self.mass * resisted;
            }
            work.external += std::mem::take(&mut self.ledger.external);
            work.dissipated += std::mem::take(&mut self.ledger.dissipated);
        }
        work
    }

    /// Forces of the present state, unless they are there.
    pub(super) fn refresh(&mut self) {
        if self.fresh {
            return;
        }
        self.settle();
        self.go_round();
        self.exchange();
        self.sort(0.0, 0.0);
        self.fill(0.0, 0.0, true);
        self.find_sides();
        self.press_boundaries();
        self.sweep_forces();
        if !self.boundary.points.is_empty() {
            let (sums, time) = self.boundary.work_after(self.share.owns());
            let [pressing, moving] = self.share.add(sums);
            self.ledger.external += self.mass * pressing + time * moving;
        }
        self.fresh = true;
    }

    /// New velocities; of a predictor and corrector none. Their greatest is kept after a kick that takes time.
    fn kick_velocities(&mut self, step: &Step, recorded: bool) -> Kicked {
        self.refresh();
        let kicks = self.formulation.scheme == Scheme::KickDriftKick;
        let kick = if kicks { step.kick } else { 0.0 };
        let decay = Step { kick, ..*step }.decay();
        let kicked = |row: &mut Row, acceleration: &[f64; 3]| {
            let old = row.velocity();
            let new = std::array::from_fn(|k| decay.kicked(old[k], kick * acceleration[k]));
            row.set_velocity(new);
            [old, new].map(Vec3::from)
        };
        let Self { threads, accelerations, powers, grid, sorted, boundary, gravity, share, .. } = self;
        let Sorted { starts, rows, left, .. } = sorted;
        let rows = &mut rows[..accelerations.len()];
        let adds = |cell: usize| share.adds(grid, cell);
        let mut rubbed = Exact::new();
        if kicks {
            boundary.rub(&mut rubbed);
        }
        let plain = |slot: usize, row: &mut Row| {
            let [old, new] = kicked(row, &accelerations[slot]);
            let mean = (old + new) * 0.5;
            [mean.norm_squared(), gravity.dot(&mean), powers[slot]]
        };
        let work = if recorded {
            let numbers = |slot: usize, row: &mut Row| {
                let before = Vec3::from(row.velocity());
                let [square, weight, power] = plain(slot, row);
                let change = Vec3::from(row.velocity()) - before;
                let resisted = (*gravity - Vec3::from(accelerations[slot])).dot(&change);
                [square, weight, power, change.norm_squared(), resisted]
            };
            let [square, weight, mut friction, change, resisted] =
                by_cells(*threads, starts, left, rows, &adds, &numbers);
            friction.merge(&rubbed);
            let [square, weight, friction, change, resisted] =
                share.add([square, weight, friction, change, resisted]);
            Kicked { square, weight, friction, change, resisted }
        } else {
            let [square, weight, mut friction] = by_cells(*threads, starts, left, rows, &adds, &plain);
            friction.merge(&rubbed);
            let [square, weight, friction] = share.add([square, weight, friction]);
            Kicked { square, weight, friction, ..Kicked::default() }
        };
        let (calmed, driven) = (self.calm(kick), self.drive(kick));
        self.keep_velocities(step.kick > 0.0);
        Kicked { friction: work.friction + calmed, weight: work.weight + driven, ..work }
    }

    /// Takes motion out of waves in a damping zone, `v ← v (1 − ½βκ)/(1 + ½βκ)`; the power that this takes a unit of mass, of all \[L²/T³\].
    fn calm(&mut self, kick: f64) -> f64 {
        let Some(beach) = self.beach else { return 0.0 };
        let Self { threads, accelerations, grid, sorted, share, .. } = self;
        let Sorted { starts, rows, left, .. } = sorted;
        let adds = |cell: usize| share.adds(grid, cell);
        let numbers = |_: usize, row: &mut Row| {
            let rate = beach.rate(row.at());
            let (old, left) = (row.velocity(), (1.0 - 0.5 * rate * kick) / (1.0 + 0.5 * rate * kick));
            row.set_velocity(old.map(|v| v * left));
            let mean = Vec3::from(old) * (0.5 * (1.0 + left));
            [rate * mean.norm_squared()]
        };
        let [sum] =
            share.add(by_cells(*threads, starts, left, &mut rows[..accelerations.len()], &adds, &numbers));
        sum
    }

    /// Hands the velocities of rows back to their particles, and those of particles that others move to their rows; keeps the greatest if
    /// asked to.
    fn keep_velocities(&mut self, keeps: bool) {
        let Self { threads, present, sorted, sums, share, openings, fastest, .. } = self;
        let (slots, rows, moves) = (&sorted.slots, &sorted.rows, moving(share, openings));
        reduced(*threads, &mut present.velocities[..], sums, |first, velocities: &mut [Vec3]| {
            let mut fastest: f64 = 0.0;
            for (i, (velocity, &slot)) in (first..).zip(velocities.iter_mut().zip(&slots[first..])) {
                if moves.get(i).is_none_or(|moves| *moves) {
                    *velocity = rows[slot as usize].velocity().into();
                    fastest = fastest.max(velocity.norm_squared());
                }
            }
            Sums { fastest, ..Sums::default() }
        });
        let [square] = share.greatest([Sums::total(sums).fastest]);
        if keeps {
            *fastest = square.sqrt();
        }
        self.bring_velocities();
    }

    /// Power that friction takes a unit of mass, of all, by the last forces \[L²/T³\].
    pub(super) fn friction(&mut self) -> f64 {
        let Self { threads, powers, grid, sorted, boundary, share, .. } = self;
        let adds = |cell: usize| share.adds(grid, cell);
        let mut sums = by_cells(*threads, &sorted.starts, &sorted.left, powers, &adds, &|_, power| [*power]);
        boundary.rub(&mut sums[0]);
        let [sum] = share.add(sums);
        sum
    }

    fn drift_once(&mut self, dt: f64) {
        self.sweep_drags();
        // Cells are a little wider than the kernel reaches; whoever went further is sorted anew, from before its way.
        let way = 0.5 * dt * self.fastest;
        let spare = (CELL - 1.0) * 2.0 * self.momentum.kernel.h;
        let resort = way + way.max(self.boundary.advance) > spare;
        if resort {
            self.sort(0.5 * dt, 0.5 * dt);
        }
        if resort {
            self.fill(0.5 * dt, 0.5 * dt, true);
            self.find_sides();
        } else {
            self.carry_on(0.5 * dt, 0.5 * dt);
        }
        self.sweep_rates();
        self.record_rates(dt);
        self.advance_boundary_densities(dt);
        self.advance_places(dt, resort);
    }

    /// Records what the rates take and give in a step: by diffusion of density, and of the pressure and motion of boundaries.
    fn record_rates(&mut self, dt: f64) {
        let diffuses = self.formulation.density_diffusion != 0.0;
        if !diffuses && self.boundary.points.is_empty() {
            return;
        }
        let Self { threads, liquid, rates, grid, sorted, boundary, share, .. } = self;
        let mut sums = [const { Exact::new() }; 3];
        if diffuses {
            let numbers = |slot: usize, &mut [rate, exchange]: &mut [f64; 2]| {
                let row = &sorted.rows[slot];
                let shares = row.p_over_rho2() + liquid.p_over_rho2(row.density() + dt * (rate + exchange));
                [-0.5 * dt * exchange * shares]
            };
            let Sorted { starts, left, .. } = &*sorted;
            [sums[0]] = by_cells(*threads, starts, left, rates, &|cell| share.adds(grid, cell), &numbers);
        }
        [sums[1], sums[2]] = boundary.work_before(dt, share.owns());
        let [loss, pressing, moving] = share.add(sums);
        let Self { mass, ledger, .. } = self;
        ledger.diffusion += *mass * loss;
        ledger.dissipated += *mass * loss;
        ledger.external += *mass * pressing + 0.5 * dt * moving;
    }

    /// New densities and places from the rates; `resorted` since drags were found.
    fn advance_places(&mut self, dt: f64, resorted: bool) {
        let Self { threads, liquid, present, rates, drags, sorted, sums, share, openings, .. } = self;
        let (slots, velocities, moves) = (&sorted.slots, &present.velocities, moving(share, openings));
        let dragged = if resorted { &sorted.before } else { slots };
        let lists = (&mut present.positions[..], &mut present.densities[..]);
        reduced(*threads, lists, sums, |first, (positions, densities): (&mut [Vec3], &mut [f64])| {
            let mut sums = Sums::default();
            for (i, (position, density)) in (first..).zip(positions.iter_mut().zip(densities)) {
                if moves.get(i).is_none_or(|moves| *moves) {
                    let [rate, exchange] = rates[slots[i] as usize];
                    sums.densify(liquid, density, dt * (rate + exchange));
                }
                let drag = drags.get(dragged[i] as usize).map_or_else(Vec3::zeros, |drag| Vec3::from(*drag));
                *position += (velocities[i] + drag) * dt;
            }
            sums
        });
        self.ledger.density_error = self.ledger.density_error.max(Sums::total(sums).error);
        share.bring_numbers(&mut present.densities);
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
