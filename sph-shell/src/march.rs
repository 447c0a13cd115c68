//! The shell as a system of `explicit-dynamics`: forces, kick, drift, the whole step at once, its stable step and bounds.

use explicit_dynamics::{
    Bounds, Dynamics, Instant, MarchError, MassScaled, OutOfBounds, OutOfRange, StableStep, Step, Work,
    lanczos_step,
};
use rayon::prelude::*;

use crate::Shell;
use crate::bounds::Unsound;
use crate::dispatch::widest;
use crate::particle::{Decay, Slots, Update, drifted};
use crate::point::Row;
use crate::shell::PARTICLE_CHUNK;

/// A chunk of particles on its way to a thread, to be kicked and, with `DRIFT`, moved in place.
struct Chunk<'a, 'b, const DRIFT: bool> {
    update: &'b Update<'a>,
    slots: Slots<'a>,
    first: usize,
    state: &'b mut [Row],
    rates: &'b mut [Row],
}

/// State, rates and work of a chunk of particles.
type ChunkRows<'a> = ((&'a mut [Row], &'a mut [Row]), &'a mut Work);

impl<const DRIFT: bool> Chunk<'_, '_, DRIFT> {
    #[inline(always)]
    fn run<const LOADED: bool>(self) -> Work {
        let mut work = Work::default();
        for (i, (row, rate)) in self.state.iter_mut().zip(self.rates).enumerate() {
            let new = self.update.particle::<DRIFT, LOADED>(self.first + i, row, rate, self.slots, &mut work);
            if DRIFT {
                *row = new;
            }
        }
        work
    }
}

impl<const DRIFT: bool> pulp::NullaryFnOnce for Chunk<'_, '_, DRIFT> {
    type Output = Work;

    #[inline(always)]
    fn call(self) -> Work {
        if self.update.external.is_empty() { self.run::<false>() } else { self.run::<true>() }
    }
}

impl Shell {
    /// What the update of particles reads; a macro-free way to borrow parts of the shell while others change.
    pub(crate) fn update_parts<'a>(&'a self, step: &'a Step) -> Update<'a> {
        Update {
            packs: &self.packs,
            direct: &self.direct,
            external: &self.external,
            masses: &self.reference.masses,
            inertias: &self.reference.inertias,
            constraint_of: &self.constraint_of,
            constraints: &self.constraints,
            step,
            decay: Decay::of(step),
        }
    }

    /// Kicks all particles, and moves them with `DRIFT`, from the slots that the sweep over all points filled.
    fn update<const DRIFT: bool>(&mut self, step: &Step) -> Work {
        let mut state = std::mem::take(&mut self.state);
        let mut rates = std::mem::take(&mut self.rates);
        let mut chunk_work = std::mem::take(&mut self.chunk_work);
        let update = self.update_parts(step);
        let slots = Slots { rows: &self.slots, mask: usize::MAX };
        let chunk = |(number, ((state, rates), work)): (usize, ChunkRows<'_>)| {
            let first = number * PARTICLE_CHUNK;
            *work = widest(Chunk::<DRIFT> { update: &update, slots, first, state, rates });
        };
        if self.threads > 1 {
            state
                .par_chunks_mut(PARTICLE_CHUNK)
                .zip(rates.par_chunks_mut(PARTICLE_CHUNK))
                .zip(chunk_work.par_iter_mut())
                .enumerate()
                .for_each(chunk);
        } else {
            state
                .chunks_mut(PARTICLE_CHUNK)
                .zip(rates.chunks_mut(PARTICLE_CHUNK))
                .zip(chunk_work.iter_mut())
                .enumerate()
                .for_each(chunk);
        }
        (self.state, self.rates, self.chunk_work) = (state, rates, chunk_work);
        self.total_work(step)
    }

    /// Adds the work of all chunks, in their order whatever the threads.
    pub(crate) fn total_work(&self, step: &Step) -> Work {
        let sum = self.chunk_work.iter().fold(Work::default(), |sum, part| Work {
            kinetic: sum.kinetic + part.kinetic,
            external: sum.external + part.external,
            dissipated: 0.0,
        });
        Work { dissipated: 2.0 * step.kick * step.damping * sum.kinetic, ..sum }
    }
}

impl Dynamics for Shell {
    fn evaluate(&mut self, at: Instant) -> f64 {
        self.evaluate_internal(true);
        self.evaluate_external(at);
        self.internal_energy
    }

    fn kick(&mut self, step: &Step) -> Work {
        self.update::<false>(step)
    }

    fn drift(&mut self, step: &Step) {
        for (row, rate) in self.state.iter_mut().zip(&mut self.rates) {
            (*row, *rate) = drifted(row, rate, step.drift());
        }
    }

    fn advance(&mut self, step: &Step) -> Work {
        if self.fused.is_some() {
            self.evaluate_external(step.from);
            return self.fused_step(step);
        }
        self.evaluate_internal(false);
        self.evaluate_external(step.from);
        self.update::<true>(step)
    }

    fn stop(&mut self) {
        self.rates.fill([0.0; 6]);
    }

    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        lanczos_step(self, safety)
    }

    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        if bounds == Bounds::Configuration {
            let found = |Unsound { place, what, value, bound }| OutOfRange { place, what, value, bound };
            return self.first_unsound().map_or(Ok(()), |unsound| Err(found(unsound).into()));
        }
        let (particle, speed) = self.fastest();
        let bound = self.reference.sound_speed;
        if speed <= bound { Ok(()) } else { Err(OutOfBounds::Speed { particle, speed, bound }) }
    }

    fn linearised(&mut self) -> Option<&mut dyn MassScaled> {
        Some(self)
    }
}

impl Shell {
    /// The particle with the greatest speed, and that speed \[L/T\]; not a number counts as greatest.
    fn fastest(&self) -> (usize, f64) {
        let speed = |(a, rate): (usize, &Row)| {
            let rotating = rate[3] * rate[3] + rate[4] * rate[4] + rate[5] * rate[5];
            let moving = rate[0] * rate[0] + rate[1] * rate[1] + rate[2] * rate[2];
            let energy = moving + rotating * self.reference.inertias[a] / self.reference.masses[a];
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
}
