//! The shell as a system of `explicit-dynamics`: forces, kick, drift, the whole step at once, its stable step and bounds.

use explicit_dynamics::{
    Bounds, Dynamics, Instant, MarchError, MassScaled, OutOfBounds, OutOfRange, StableStep, Step, Work,
    lanczos_step,
};
use parallel::ByChunk;

use crate::Shell;
use crate::conditions::constraints::Constraints;
use crate::dependents::Dependents;
use crate::dispatch::{Work as Sweeping, widest};
use crate::loading::Loading;
use crate::motion::Moving;
use crate::packs::Row;
use crate::points::bounds::BoundViolation;
use crate::points::sweep::Sweep;
use crate::registers::Registers;
use crate::ties::list::Ties;
use crate::time::evaluation::Evaluation;
use crate::time::particle::{Rows, Slots, Update, drifted};
use crate::time::share::Share;

/// A chunk of particles on its way to a thread, to be kicked and, with `DRIFT`, moved.
struct Chunk<'a, 'b, const DRIFT: bool> {
    update: &'b Update<'a>,
    slots: Option<Slots<'a>>,
    first: usize,
    rows: Rows<'b>,
    work: &'b mut Work,
}

/// Places for new rows, rates and work of a chunk of particles.
type ChunkRows<'a> = ((&'a mut [Row], &'a mut [Row]), ByChunk<'a, Work>);

impl<const DRIFT: bool> Sweeping for Chunk<'_, '_, DRIFT> {
    type Output = ();

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) {
        let Self { update, slots, first, rows, work } = self;
        let range = first..first + rows.rates.len();
        *work = Work::default();
        update.run::<DRIFT, 1, R>(registers, range, first, rows, slots, std::slice::from_mut(work));
    }
}

/// What the update of particles reads of the groups of a shell.
fn update_of<'a>(
    [masses, inertias]: [&'a [f64]; 2],
    constraints: &'a Constraints,
    loading: &'a Loading,
    direct: &'a [Row],
    step: &'a Step,
) -> Update<'a> {
    Update {
        direct,
        external: loading.in_march(),
        masses,
        inertias,
        constraint_of: &constraints.of_particle,
        constraints: &constraints.all,
        step,
        decay: step.decay(),
    }
}

impl Shell {
    /// Kicks all particles, and moves them with `DRIFT`, from the slots that the sweep over all points filled.
    fn update<const DRIFT: bool>(&mut self, step: &Step) -> Work {
        let Self { reference, points, constraints, dependents, loading, motion, evaluation, share, .. } =
            self;
        let internal = |a| evaluation.internal_force(points, a);
        let external = |a| loading.external_force(a);
        let of_groups = dependents.junctions.kick(motion, constraints, internal, external, step, DRIFT);
        let Dependents { junctions, ties } = dependents;
        let update = update_of(ties.moving_masses(reference), constraints, loading, points.direct(), step);
        let Evaluation { slots, chunk_work, threads, .. } = evaluation;
        let (own, chunks) = (share.own(), share.chunks());
        let slots = points.lists().map(|lists| Slots { rows: slots, lists, first: 0 });
        let Moving { state, next, rates } = &mut *motion;
        let chunk = |first: usize, ((next, rates), ByChunk(work)): ChunkRows<'_>| {
            let ([work, ..], rows) = (work, Rows { state, next, rates }) else { return };
            widest(Chunk::<DRIFT> { update: &update, slots, first: own.start + first, rows, work });
        };
        let rows = (&mut next[own.clone()], &mut rates[own.clone()]);
        parallel::chunks(*threads, (rows, ByChunk(&mut chunk_work[chunks])), chunk);
        if DRIFT {
            let others = |a: &usize| share.is_shared() && !own.contains(a);
            for a in junctions.particles().filter(others) {
                next[a] = drifted(&state[a], &[0.0; 6], step.drift()).0;
            }
            std::mem::swap(state, next);
            share.moved();
        }
        junctions.drift(motion, constraints, if DRIFT { step.drift() } else { 0.0 });
        put_ties(ties, share, motion);
        evaluation.total_work(share, step, of_groups, loading.rubbed())
    }

    /// A step by the plan; external forces are already evaluated.
    fn fused_step(&mut self, step: &Step) -> Work {
        let Self {
            reference,
            material,
            points,
            constraints,
            dependents,
            loading,
            motion,
            evaluation,
            share,
            ..
        } = self;
        let Evaluation { plan: Some(plan), chunk_work, .. } = evaluation else { return Work::default() };
        let Moving { state, next, rates } = motion;
        let sweep = Sweep { points, law: material.law(), state, energy: false };
        let moving = dependents.ties.moving_masses(reference);
        let update = update_of(moving, constraints, loading, &[], step);
        let (own, chunks) = (share.own(), share.chunks());
        let rows = Rows { state, next: &mut next[own.clone()], rates: &mut rates[own] };
        plan.advance(&sweep, &update, rows, &mut chunk_work[chunks], |next| share.send(next));
        std::mem::swap(state, next);
        evaluation.total_work(share, step, Work::default(), loading.rubbed())
    }
}

/// Puts what hangs where its hosts are, which may be those of others.
fn put_ties(ties: &Ties, share: &Share, motion: &mut Moving) {
    if !ties.is_empty() {
        share.arrive(&mut motion.state);
        ties.put(&mut motion.state);
    }
}

impl Evaluation {
    /// Adds the work of all chunks, exactly whoever has them, to what is there already; what friction took of the work of tools is dissipated.
    fn total_work(&self, share: &Share, step: &Step, first: Work, rubbed: f64) -> Work {
        let of = |work: &Work| [work.kinetic, work.external, work.change, work.resisted];
        let [kinetic, external, change, resisted] = share.sum(self.chunk_work[share.chunks()].iter().map(of));
        let sum = Work {
            kinetic: first.kinetic + kinetic,
            external: first.external + external,
            dissipated: 0.0,
            change: first.change + change,
            resisted: first.resisted + resisted,
        };
        Work {
            dissipated: 2.0 * step.kick * step.damping * sum.kinetic + rubbed,
            external: sum.external + rubbed,
            ..sum
        }
    }
}

impl Dynamics for Shell {
    fn evaluate(&mut self, at: Instant) -> f64 {
        self.evaluate_internal(true);
        self.evaluate_external(at);
        self.stored_energy()
    }

    fn kick(&mut self, step: &Step) -> Work {
        self.update::<false>(step)
    }

    fn drift(&mut self, step: &Step) {
        let Self { dependents: Dependents { junctions, ties }, constraints, motion, share, .. } = self;
        share.moved();
        junctions.set_aside(motion);
        for (row, rate) in motion.state.iter_mut().zip(&mut motion.rates) {
            (*row, *rate) = drifted(row, rate, step.drift());
        }
        junctions.drift(motion, constraints, step.drift());
        put_ties(ties, share, motion);
        self.commit_in(step.drift());
    }

    fn advance(&mut self, step: &Step) -> Work {
        // Groups and ties gather forces that the fused step does not keep, and stiffeners add to them.
        let alone = self.dependents.is_empty() && self.stiffeners.is_empty();
        if self.evaluation.plan.is_some() && alone {
            self.share.arrive(&mut self.motion.state);
            self.evaluate_external(step.from);
            let work = self.fused_step(step);
            self.commit_in(step.drift());
            return work;
        }
        self.evaluate_internal(false);
        self.evaluate_external(step.from);
        let work = self.update::<true>(step);
        self.commit_in(step.drift());
        work
    }

    fn stop(&mut self) {
        self.motion.rates.fill([0.0; 6]);
    }

    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        lanczos_step(self, safety)
    }

    fn shortened(&mut self, stable: f64, safety: f64) -> f64 {
        let Self { reference, dependents, loading, motion, share, .. } = self;
        let Some(own) = &mut loading.own_contact else { return stable };
        if !own.waits() {
            share.arrive(&mut motion.state);
            share.bring(&mut motion.rates);
        }
        let [masses, _] = dependents.ties.moving_masses(reference);
        own.shortened(stable, safety, [&motion.state, &motion.rates], masses)
    }

    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        if bounds == Bounds::Configuration {
            let found =
                |BoundViolation { place, what, value, bound }| OutOfRange { place, what, value, bound };
            return self.bound_violation().map_or(Ok(()), |violation| Err(found(violation).into()));
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
        let speed = |a: usize| {
            let rate = &self.motion.rates[a];
            let rotating = rate[3] * rate[3] + rate[4] * rate[4] + rate[5] * rate[5];
            let moving = rate[0] * rate[0] + rate[1] * rate[1] + rate[2] * rate[2];
            let energy = moving + rotating * self.reference.inertias[a] / self.reference.masses[a];
            (energy, a)
        };
        let (square, particle) = self.share.greatest(self.share.own().map(speed));
        (particle, square.sqrt())
    }
}

#[cfg(test)]
pub(crate) mod tests;
