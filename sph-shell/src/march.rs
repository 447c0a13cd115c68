//! One particle's step: gather forces, kick, drift; the shell as a system of `explicit-dynamics`.

use explicit_dynamics::{Dynamics, Instant, Step, Work};
use rayon::prelude::*;
use shell_kinematics::parallel_transport;

use crate::Shell;
use crate::dispatch::widest;
use crate::point::Row;
use crate::shell::PARTICLE_CHUNK;

/// What a kick or a drift of one chunk of particles reads.
struct Update<'a> {
    shell: Forces<'a>,
    step: &'a Step,
}

/// The read-only part of a shell during the update.
struct Forces<'a> {
    packs: &'a crate::packs::Packs,
    slots: &'a [Row],
    direct: &'a [Row],
    external: &'a [Row],
    masses: &'a [f64],
    inertias: &'a [f64],
    constraint_of: &'a [u32],
    constraints: &'a [crate::supports::Constraint],
}

impl Forces<'_> {
    #[inline(always)]
    fn internal(&self, a: usize) -> Row {
        let mut sum = if self.direct.is_empty() { [0.0; 6] } else { self.direct[a] };
        if !self.slots.is_empty() {
            for &slot in self.packs.slots_of(a) {
                let row = &self.slots[slot as usize];
                for i in 0..6 {
                    sum[i] += row[i];
                }
            }
        }
        sum
    }
}

impl Update<'_> {
    /// `v ← [v(1 − ½cκ) + κ f/m]/(1 + ½cκ)` for particles from number `first` on, and the drift if `DRIFT`.
    #[inline(always)]
    fn chunk<const DRIFT: bool, const LOADED: bool>(
        &self,
        first: usize,
        state: &mut [Row],
        rates: &mut [Row],
    ) -> Work {
        let Step { kick, damping, .. } = *self.step;
        let (before, after) = (1.0 - 0.5 * damping * kick, 1.0 / (1.0 + 0.5 * damping * kick));
        let drift = self.step.drift();
        let mut work = Work::default();
        for (i, (row, rate)) in state.iter_mut().zip(rates.iter_mut()).enumerate() {
            let a = first + i;
            let internal = self.shell.internal(a);
            let external = if LOADED { self.shell.external[a] } else { [0.0; 6] };
            let (m, inertia) = (self.shell.masses[a], self.shell.inertias[a]);
            let (to_v, to_w) = (kick / m, kick / inertia);
            let mut f = [0.0; 6];
            for k in 0..6 {
                f[k] = external[k] - internal[k];
            }
            // The director feels the part of its force across itself.
            let along = f[3] * row[3] + f[4] * row[4] + f[5] * row[5];
            let old = *rate;
            let mut new = [0.0; 6];
            for k in 0..3 {
                new[k] = (old[k] * before + to_v * f[k]) * after;
                new[3 + k] = (old[3 + k] * before + to_w * (f[3 + k] - along * row[3 + k])) * after;
            }
            let number = self.shell.constraint_of[a] as usize;
            let mut pushed = false;
            if number > 0 {
                let constraint = &self.shell.constraints[number - 1];
                let mut v = constraint.free_translation([new[0], new[1], new[2]]);
                if let Some(motion) = constraint.velocity(self.step.from, self.step.to) {
                    for k in 0..3 {
                        v[k] += motion[k];
                    }
                    pushed = true;
                }
                let w = constraint.free_rotation([new[3], new[4], new[5]]);
                new = [v[0], v[1], v[2], w[0], w[1], w[2]];
            }
            let mut mean = [0.0; 6];
            for k in 0..6 {
                mean[k] = 0.5 * (old[k] + new[k]);
            }
            let square = mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2];
            let turning = mean[3] * mean[3] + mean[4] * mean[4] + mean[5] * mean[5];
            work.kinetic += 0.5 * (m * square + inertia * turning);
            if LOADED {
                for k in 0..6 {
                    work.external += kick * external[k] * mean[k];
                }
            }
            if pushed && kick > 0.0 {
                // The support's force is what the particle's balance lacks; it works on the prescribed motion.
                for k in 0..3 {
                    let lack = m * (new[k] - old[k]) / kick - f[k] + m * damping * mean[k];
                    work.external += kick * lack * mean[k];
                }
            }
            *rate = new;
            if DRIFT {
                drift_row(row, rate, drift);
            }
        }
        work.dissipated = 2.0 * kick * damping * work.kinetic;
        work
    }
}

/// State, rates and work of a chunk of particles.
type Part<'a> = ((&'a mut [Row], &'a mut [Row]), &'a mut Work);

/// A chunk on its way to a thread.
struct Chunk<'a, 'b, const DRIFT: bool> {
    update: &'b Update<'a>,
    first: usize,
    state: &'b mut [Row],
    rates: &'b mut [Row],
}

impl<const DRIFT: bool> pulp::NullaryFnOnce for Chunk<'_, '_, DRIFT> {
    type Output = Work;

    #[inline(always)]
    fn call(self) -> Work {
        let Self { update, first, state, rates } = self;
        if update.shell.external.is_empty() {
            update.chunk::<DRIFT, false>(first, state, rates)
        } else {
            update.chunk::<DRIFT, true>(first, state, rates)
        }
    }
}

/// Moves a position along its velocity and a director along its great circle.
#[inline(always)]
fn drift_row(row: &mut Row, rate: &mut Row, dt: f64) {
    let (d, w) = parallel_transport([row[3], row[4], row[5]], [rate[3], rate[4], rate[5]], dt);
    *row = [row[0] + dt * rate[0], row[1] + dt * rate[1], row[2] + dt * rate[2], d[0], d[1], d[2]];
    *rate = [rate[0], rate[1], rate[2], w[0], w[1], w[2]];
}

impl Shell {
    fn update<const DRIFT: bool>(&mut self, step: &Step) -> Work {
        let update = Update {
            shell: Forces {
                packs: &self.packs,
                slots: &self.slots,
                direct: &self.direct,
                external: &self.external,
                masses: &self.reference.masses,
                inertias: &self.reference.inertias,
                constraint_of: &self.constraint_of,
                constraints: &self.constraints,
            },
            step,
        };
        let chunk = |(number, ((state, rates), work)): (usize, Part<'_>)| {
            *work = widest(Chunk::<DRIFT> { update: &update, first: number * PARTICLE_CHUNK, state, rates });
        };
        if self.threads > 1 {
            self.state
                .par_chunks_mut(PARTICLE_CHUNK)
                .zip(self.rates.par_chunks_mut(PARTICLE_CHUNK))
                .zip(self.chunk_work.par_iter_mut())
                .enumerate()
                .for_each(chunk);
        } else {
            self.state
                .chunks_mut(PARTICLE_CHUNK)
                .zip(self.rates.chunks_mut(PARTICLE_CHUNK))
                .zip(self.chunk_work.iter_mut())
                .enumerate()
                .for_each(chunk);
        }
        // In the order of the chunks, whatever the threads.
        self.chunk_work.iter().fold(Work::default(), |sum, part| Work {
            kinetic: sum.kinetic + part.kinetic,
            external: sum.external + part.external,
            dissipated: sum.dissipated + part.dissipated,
        })
    }
}

impl Dynamics for Shell {
    fn force(&mut self, at: Instant, energy: bool) {
        self.evaluate_internal(energy);
        self.evaluate_external(at);
    }

    fn internal_energy(&self) -> f64 {
        self.internal_energy
    }

    fn kick(&mut self, step: &Step) -> Work {
        self.update::<false>(step)
    }

    fn drift(&mut self, step: &Step) {
        for (row, rate) in self.state.iter_mut().zip(&mut self.rates) {
            drift_row(row, rate, step.drift());
        }
    }

    fn kick_drift(&mut self, step: &Step) -> Work {
        self.update::<true>(step)
    }

    fn stop(&mut self) {
        self.rates.fill([0.0; 6]);
    }

    fn fastest(&self) -> (usize, f64) {
        let speed = |(a, rate): (usize, &Row)| {
            let turning = rate[3] * rate[3] + rate[4] * rate[4] + rate[5] * rate[5];
            let moving = rate[0] * rate[0] + rate[1] * rate[1] + rate[2] * rate[2];
            let energy = moving + turning * self.reference.inertias[a] / self.reference.masses[a];
            (a, if energy.is_nan() { f64::INFINITY } else { energy })
        };
        let (particle, square) = self
            .rates
            .iter()
            .enumerate()
            .map(speed)
            .fold((0, 0.0), |best, x| if x.1 > best.1 { x } else { best });
        (particle, square.sqrt())
    }

    fn speed_bound(&self) -> f64 {
        self.reference.sound_speed
    }
}
