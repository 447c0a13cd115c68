//! The step of four particles: gather forces, kick, hold what is held, book the work, drift.

use std::ops::Range;

use explicit_dynamics::{Decay, Step, Work};
use shell_kinematics::{LANES, Pack3, parallel_transport};

use crate::conditions::prescribed_at::Prescribed;
use crate::conditions::supports::Constraint;
use crate::gather::Gather;
use crate::packs::Row;
use crate::registers::{Baseline, Registers, columns, four_of};

/// Slots of forces, and where in them the forces on the particles from number `first` on lie.
#[derive(Clone, Copy)]
pub(crate) struct Slots<'a> {
    pub rows: &'a [Row],
    pub lists: &'a Gather,
    pub first: usize,
}

/// What the update of a particle reads.
#[derive(Clone, Copy)]
pub(crate) struct Update<'a> {
    /// Internal forces found particle by particle; empty if all lie in slots.
    pub direct: &'a [Row],
    /// External forces; empty without loads.
    pub external: &'a [Row],
    pub masses: &'a [f64],
    pub inertias: &'a [f64],
    pub constraint_of: &'a [u32],
    pub constraints: &'a [Constraint],
    pub step: &'a Step,
    pub decay: Decay,
}

/// The rows of particles: all before the step, and of those that are kicked the place for the new ones and the rates.
pub(crate) struct Rows<'a> {
    pub state: &'a [Row],
    /// Not used where particles do not drift.
    pub next: &'a mut [Row],
    pub rates: &'a mut [Row],
}

/// What the step of four particles reads; the lanes from `count` on count for nothing.
#[derive(Clone, Copy)]
struct Four<'a> {
    /// Number of the first.
    a: usize,
    count: usize,
    rows: &'a [Row; LANES],
    rates: &'a [Row; LANES],
    external: &'a [Row; LANES],
    masses: &'a [f64; LANES],
    inertias: &'a [f64; LANES],
    held: &'a [u32; LANES],
}

/// Four particles that no load touches.
const ZEROS: [Row; LANES] = [[0.0; 6]; LANES];

impl Update<'_> {
    /// Kicks the particles of `range`, which `rates` holds, by their forces, and with `DRIFT` moves them from their rows
    /// in `state` into `next`. Chunks of `work` count from particle `first` on.
    #[inline(always)]
    pub fn run<const DRIFT: bool, R: Registers>(
        &self,
        registers: R,
        range: Range<usize>,
        first: usize,
        rows: Rows<'_>,
        slots: Option<Slots<'_>>,
        work: &mut [Work],
    ) {
        if self.external.is_empty() {
            self.groups::<DRIFT, false, R>(registers, range, first, rows, slots, work);
        } else {
            self.groups::<DRIFT, true, R>(registers, range, first, rows, slots, work);
        }
    }

    #[inline(always)]
    fn groups<const DRIFT: bool, const LOADED: bool, R: Registers>(
        &self,
        registers: R,
        range: Range<usize>,
        first: usize,
        rows: Rows<'_>,
        slots: Option<Slots<'_>>,
        work: &mut [Work],
    ) {
        let Rows { state, next, rates } = rows;
        let (rows, rest) = state[range.clone()].as_chunks::<LANES>();
        let (rates, rest_rates) = rates.as_chunks_mut::<LANES>();
        let (next, rest_next) = next.as_chunks_mut::<LANES>();
        let masses = self.masses[range.clone()].as_chunks::<LANES>().0;
        let inertias = self.inertias[range.clone()].as_chunks::<LANES>().0;
        let held = self.constraint_of[range.clone()].as_chunks::<LANES>().0;
        let groups = rows.iter().zip(rates).zip(masses).zip(inertias).zip(held).enumerate();
        for (i, ((((rows, rates), masses), inertias), held)) in groups {
            let a = range.start + LANES * i;
            let external = if LOADED { &four_of(self.external, a) } else { &ZEROS };
            let four = Four { a, count: LANES, rows, rates, external, masses, inertias, held };
            let tally = &mut work[(a - first) / parallel::CHUNK];
            let [places, kicked] = self.four::<DRIFT, LOADED, R>(registers, four, slots, tally);
            if DRIFT {
                next[i] = places;
            }
            *rates = kicked;
        }
        if !rest.is_empty() {
            let a = range.end - rest.len();
            let tally = &mut work[(a - first) / parallel::CHUNK];
            self.rest::<DRIFT, LOADED>(a, state, rest_rates, rest_next, slots, tally);
        }
    }

    /// The last particles of all, if they are fewer than four: the lanes beyond repeat the last one.
    #[cold]
    #[inline(never)]
    fn rest<const DRIFT: bool, const LOADED: bool>(
        &self,
        a: usize,
        state: &[Row],
        rates: &mut [Row],
        next: &mut [Row],
        slots: Option<Slots<'_>>,
        work: &mut Work,
    ) {
        let four = Four {
            a,
            count: rates.len(),
            rows: &four_of(state, a),
            rates: &four_of(rates, 0),
            external: &if LOADED { four_of(self.external, a) } else { ZEROS },
            masses: &four_of(self.masses, a),
            inertias: &four_of(self.inertias, a),
            held: &four_of(self.constraint_of, a),
        };
        let [places, kicked] = self.four::<DRIFT, LOADED, _>(Baseline, four, slots, work);
        if DRIFT {
            next.copy_from_slice(&places[..next.len()]);
        }
        rates.copy_from_slice(&kicked[..rates.len()]);
    }

    /// `v ← [v(1 − ½cκ) + κ f/m]/(1 + ½cκ)` of four particles, and with `DRIFT` their motion; returns their new rows and
    /// rates.
    ///
    /// Kinetic energy and external work are added to `work`, particle by particle; what damping takes is `2cκ` times the
    /// former.
    #[inline(always)]
    fn four<const DRIFT: bool, const LOADED: bool, R: Registers>(
        &self,
        registers: R,
        four: Four<'_>,
        slots: Option<Slots<'_>>,
        work: &mut Work,
    ) -> [[Row; LANES]; 2] {
        let Four { a, count, rows, rates, held, .. } = four;
        let kick = self.step.kick;
        let Decay { before, after } = self.decay;
        let mut sums = [[registers.splat(0.0); 2]; LANES];
        if !self.direct.is_empty() {
            let [i, j, k, l] = four_of(self.direct, a);
            sums = [registers.halves(&i), registers.halves(&j), registers.halves(&k), registers.halves(&l)];
        }
        if let Some(Slots { rows, lists, first }) = slots {
            sums = lists.add(registers, (a - first) / LANES, rows, sums);
        }
        let mut f = registers.turned(sums);
        let mut external = [registers.splat(0.0); 6];
        if LOADED {
            external = columns(registers, four.external);
        }
        for k in 0..6 {
            f[k] = external[k] - f[k];
        }
        let (row, old) = (columns(registers, rows), columns(registers, rates));
        let (m, inertia) = (registers.four(four.masses), registers.four(four.inertias));
        let kicked = registers.splat(kick);
        let (to_v, to_w) = (kicked / m, kicked / inertia);
        // The director feels the part of its force across itself.
        let along = f[3] * row[3] + f[4] * row[4] + f[5] * row[5];
        let mut new = old;
        for k in 0..3 {
            new[k] = (old[k] * before + to_v * f[k]) * after;
            new[3 + k] = (old[3 + k] * before + to_w * (f[3 + k] - along * row[3 + k])) * after;
        }
        let mut prescribed = [false; LANES];
        if *held != [0; LANES] {
            let mut moved = registers.rows(new);
            prescribed = self.hold_four(held, rows, &mut moved);
            new = columns(registers, &moved);
        }
        let mut mean = new;
        for k in 0..6 {
            mean[k] = (old[k] + new[k]) * 0.5;
        }
        let square = mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2];
        let turning = mean[3] * mean[3] + mean[4] * mean[4] + mean[5] * mean[5];
        let kinetic = registers.store((m * square + inertia * turning) * 0.5).lanes();
        // What the energy at this instant has too much is asked for where it is recorded, between a kick and a drift.
        let [mut changes, mut resisted] = [[0.0; LANES]; 2];
        if !DRIFT {
            let zero = registers.splat(0.0);
            let [mut moved, mut turned, mut along] = [zero; 3];
            for k in 0..3 {
                let [v, w] = [new[k] - old[k], new[3 + k] - old[3 + k]];
                moved += v * v;
                turned += w * w;
                along = along + (external[k] - f[k]) * v + (external[3 + k] - f[3 + k]) * w;
            }
            changes = registers.store((m * moved + inertia * turned) * 0.5).lanes();
            resisted = registers.store(kicked * along).lanes();
        }
        let mut done = mean;
        if LOADED {
            for k in 0..6 {
                done[k] = kicked * external[k] * mean[k];
            }
        }
        let done = registers.rows(done);
        for lane in 0..count {
            work.kinetic += kinetic[lane];
            if !DRIFT {
                work.change += changes[lane];
                work.resisted += resisted[lane];
            }
            if LOADED {
                for k in 0..6 {
                    work.external += done[lane][k];
                }
            }
            if prescribed[lane] {
                let [f, old, new] = [registers.rows(f), registers.rows(old), registers.rows(new)];
                let rates = [old[lane], new[lane]];
                work.external = self.with_reported_work(a + lane, work.external, rows[lane], f[lane], rates);
            }
        }
        if !DRIFT {
            return [*rows, registers.rows(new)];
        }
        let dt = self.step.drift();
        let (d, w) = parallel_transport([row[3], row[4], row[5]], [new[3], new[4], new[5]], dt);
        let x = Pack3([row[0], row[1], row[2]]) + Pack3([new[0], new[1], new[2]]) * registers.splat(dt);
        [
            registers.rows([x.0[0], x.0[1], x.0[2], d[0], d[1], d[2]]),
            registers.rows([new[0], new[1], new[2], w[0], w[1], w[2]]),
        ]
    }

    /// [`Update::hold`] of those of four particles that a support holds, by the numbers of their constraints.
    ///
    /// Neither this nor the work below is inlined: particles that nothing holds pay one branch.
    #[cold]
    #[inline(never)]
    fn hold_four(&self, held: &[u32; LANES], rows: &[Row; LANES], new: &mut [Row; LANES]) -> [bool; LANES] {
        let mut prescribed = [false; LANES];
        for lane in (0..LANES).filter(|&lane| held[lane] > 0) {
            let constraint = &self.constraints[held[lane] as usize - 1];
            (new[lane], prescribed[lane]) = self.hold(constraint, rows[lane], new[lane]);
            prescribed[lane] |= self.step.kick == 0.0;
        }
        prescribed
    }

    /// Takes out what a support holds and puts in what it prescribes; true if it prescribes anything.
    fn hold(&self, constraint: &Constraint, row: Row, new: Row) -> (Row, bool) {
        if constraint.tied {
            return ([0.0; 6], false); // its group moves it
        }
        let mut v = constraint.held.free_part([new[0], new[1], new[2]]);
        let motion = constraint.velocity(self.step);
        if let Some(motion) = motion {
            for k in 0..3 {
                v[k] += motion[k];
            }
        }
        let rotation = constraint.director_rate([row[3], row[4], row[5]], self.step);
        let w = rotation.unwrap_or_else(|| constraint.free_rotation([new[3], new[4], new[5]]));
        ([v[0], v[1], v[2], w[0], w[1], w[2]], motion.is_some() || rotation.is_some())
    }

    /// External work with that of the support of particle `a` on what it prescribes: its impulse is what the particle's balance
    /// lacks, from the force `f` on the particle and its rates before and after the kick. A kick of no span counts what the support
    /// gives and takes at once, held velocities among it.
    #[cold]
    #[inline(never)]
    fn with_reported_work(&self, a: usize, external: f64, row: Row, f: Row, [old, new]: [Row; 2]) -> f64 {
        let prescribed = self.constraints[self.constraint_of[a] as usize - 1].prescribed();
        let tells = |what: fn(&Prescribed<'_>) -> bool| {
            self.step.kick == 0.0 || prescribed.as_ref().is_some_and(what)
        };
        let along = f[3] * row[3] + f[4] * row[4] + f[5] * row[5];
        let work = |external: f64, k: usize| {
            let (m, f) =
                if k < 3 { (self.masses[a], f[k]) } else { (self.inertias[a], f[k] - along * row[k]) };
            let mean = 0.5 * (old[k] + new[k]);
            external + self.step.support_impulse(m, [old[k], new[k]], f) * mean
        };
        let moved = if tells(|prescribed| prescribed.motion.is_some()) { 0..3 } else { 0..0 };
        let rotated = if tells(|prescribed| prescribed.rotation.is_some()) { 3..6 } else { 0..0 };
        moved.chain(rotated).fold(external, work)
    }
}

/// Row and rate after `dt`: the position moves along its velocity, the director along its great circle.
#[inline(always)]
pub(crate) fn drifted(row: &Row, rate: &Row, dt: f64) -> (Row, Row) {
    let (d, w) = parallel_transport([row[3], row[4], row[5]], [rate[3], rate[4], rate[5]], dt);
    let place = [row[0] + dt * rate[0], row[1] + dt * rate[1], row[2] + dt * rate[2], d[0], d[1], d[2]];
    (place, [rate[0], rate[1], rate[2], w[0], w[1], w[2]])
}
