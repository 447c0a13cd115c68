//! The step of some particles: gather forces, kick, hold what is held, book the work, drift.

use std::ops::Range;

use explicit_dynamics::{Decay, Step, Work};
use shell_kinematics::{LANES, Pack3, parallel_transport};

use crate::conditions::prescribed_at::Prescribed;
use crate::conditions::supports::Constraint;
use crate::gather::Gather;
use crate::packs::Row;
use crate::registers::{Baseline, Fours, Groups, Registers, columns, four_of};

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

/// What the step of some particles reads; the lanes from `count` on count for nothing.
#[derive(Clone, Copy)]
struct Group<'a, const P: usize> {
    /// Number of the first.
    a: usize,
    count: usize,
    rows: &'a [[Row; LANES]; P],
    rates: &'a [[Row; LANES]; P],
    external: &'a [[Row; LANES]; P],
    masses: &'a [[f64; LANES]; P],
    inertias: &'a [[f64; LANES]; P],
    held: &'a [[u32; LANES]; P],
}

/// The internal forces on the particles from number `a` on.
struct Internal<'a> {
    direct: &'a [Row],
    slots: Option<Slots<'a>>,
    a: usize,
}

impl Groups for Internal<'_> {
    #[inline(always)]
    fn sums<R: Fours>(&self, registers: R, group: usize) -> [[R::Numbers; 2]; LANES] {
        let a = self.a + group * LANES;
        let mut sums = [[registers.splat(0.0); 2]; LANES];
        if !self.direct.is_empty() {
            let [i, j, k, l] = four_of(self.direct, a);
            sums = [registers.halves(&i), registers.halves(&j), registers.halves(&k), registers.halves(&l)];
        }
        if let Some(Slots { rows, lists, first }) = self.slots {
            sums = lists.add(registers, (a - first) / LANES, rows, sums);
        }
        sums
    }
}

/// Four particles that no load touches.
const UNLOADED: [Row; LANES] = [[0.0; 6]; LANES];

impl Update<'_> {
    /// Kicks the particles of `range`, which `rates` holds, by their forces, and with `DRIFT` moves them from their rows
    /// in `state` into `next`. Chunks of `work` count from particle `first` on.
    #[inline(always)]
    pub fn run<const DRIFT: bool, const P: usize, R: Registers<P>>(
        &self,
        registers: R,
        range: Range<usize>,
        first: usize,
        rows: Rows<'_>,
        slots: Option<Slots<'_>>,
        work: &mut [Work],
    ) {
        if self.external.is_empty() {
            self.groups::<DRIFT, false, P, R>(registers, range, first, rows, slots, work);
        } else {
            self.groups::<DRIFT, true, P, R>(registers, range, first, rows, slots, work);
        }
    }

    /// Four where a chunk of work would not begin with several, several as far as they go, four, and what is left.
    #[inline(always)]
    fn groups<const DRIFT: bool, const LOADED: bool, const P: usize, R: Registers<P>>(
        &self,
        registers: R,
        range: Range<usize>,
        first: usize,
        mut rows: Rows<'_>,
        slots: Option<Slots<'_>>,
        work: &mut [Work],
    ) {
        let mut a = range.start;
        if P > 1 {
            let before = (P - (a - first) / LANES % P) % P * LANES;
            let fours = a..(a + before).min(range.end);
            (a, rows) =
                self.whole::<DRIFT, LOADED, 1, _>(registers.single(), fours, first, rows, slots, work);
            (a, rows) = self.whole::<DRIFT, LOADED, P, _>(registers, a..range.end, first, rows, slots, work);
        }
        (a, rows) =
            self.whole::<DRIFT, LOADED, 1, _>(registers.single(), a..range.end, first, rows, slots, work);
        if a < range.end {
            let Rows { state, next, rates } = rows;
            self.rest::<DRIFT, LOADED>(
                a,
                state,
                rates,
                next,
                slots,
                &mut work[(a - first) / parallel::CHUNK],
            );
        }
    }

    /// The whole groups of a range; returns where they end, and the rows from there on.
    #[inline(always)]
    fn whole<'a, const DRIFT: bool, const LOADED: bool, const P: usize, R: Registers<P>>(
        &self,
        registers: R,
        range: Range<usize>,
        first: usize,
        Rows { state, next, rates }: Rows<'a>,
        slots: Option<Slots<'_>>,
        work: &mut [Work],
    ) -> (usize, Rows<'a>) {
        let (rates, rest_rates) = rates.split_at_mut(range.len() / (P * LANES) * (P * LANES));
        let (next, rest_next) = next.split_at_mut(if DRIFT { rates.len() } else { 0 });
        let range = range.start..range.start + rates.len();
        let rates = rates.as_chunks_mut::<LANES>().0.as_chunks_mut::<P>().0;
        let next = next.as_chunks_mut::<LANES>().0.as_chunks_mut::<P>().0;
        let rows = state[range.clone()].as_chunks::<LANES>().0.as_chunks::<P>().0;
        let masses = self.masses[range.clone()].as_chunks::<LANES>().0.as_chunks::<P>().0;
        let inertias = self.inertias[range.clone()].as_chunks::<LANES>().0.as_chunks::<P>().0;
        let held = self.constraint_of[range.clone()].as_chunks::<LANES>().0.as_chunks::<P>().0;
        let groups = rows.iter().zip(rates).zip(masses).zip(inertias).zip(held).enumerate();
        for (i, ((((rows, rates), masses), inertias), held)) in groups {
            let a = range.start + P * LANES * i;
            let mut external = [UNLOADED; P];
            if LOADED {
                for part in 0..P {
                    external[part] = four_of(self.external, a + part * LANES);
                }
            }
            let group =
                Group { a, count: P * LANES, rows, rates, external: &external, masses, inertias, held };
            let tally = &mut work[(a - first) / parallel::CHUNK];
            let [places, kicked] = self.group::<DRIFT, LOADED, P, R>(registers, group, slots, tally);
            if DRIFT {
                next[i] = places;
            }
            *rates = kicked;
        }
        (range.end, Rows { state, next: rest_next, rates: rest_rates })
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
        let group = Group {
            a,
            count: rates.len(),
            rows: &[four_of(state, a)],
            rates: &[four_of(rates, 0)],
            external: &[if LOADED { four_of(self.external, a) } else { UNLOADED }],
            masses: &[four_of(self.masses, a)],
            inertias: &[four_of(self.inertias, a)],
            held: &[four_of(self.constraint_of, a)],
        };
        let [[places], [kicked]] = self.group::<DRIFT, LOADED, 1, _>(Baseline, group, slots, work);
        if DRIFT {
            next.copy_from_slice(&places[..next.len()]);
        }
        rates.copy_from_slice(&kicked[..rates.len()]);
    }

    /// `v ← [v(1 − ½cκ) + κ f/m]/(1 + ½cκ)` of some particles, and with `DRIFT` their motion; returns their new rows and
    /// rates.
    ///
    /// Kinetic energy and external work are added to `work`, particle by particle; what damping takes is `2cκ` times the
    /// former.
    #[inline(always)]
    fn group<const DRIFT: bool, const LOADED: bool, const P: usize, R: Registers<P>>(
        &self,
        registers: R,
        group: Group<'_, P>,
        slots: Option<Slots<'_>>,
        work: &mut Work,
    ) -> [[[Row; LANES]; P]; 2] {
        let Group { a, count, rows, rates, held, .. } = group;
        let kick = self.step.kick;
        let Decay { before, after } = self.decay;
        let mut f = registers.gathered(Internal { direct: self.direct, slots, a });
        let mut external = [registers.splat(0.0); 6];
        if LOADED {
            external = columns(registers, group.external);
        }
        for k in 0..6 {
            f[k] = external[k] - f[k];
        }
        let (row, old) = (columns(registers, rows), columns(registers, rates));
        let (m, inertia) = (registers.read(group.masses), registers.read(group.inertias));
        let kicked = registers.splat(kick);
        let (to_v, to_w) = (kicked / m, kicked / inertia);
        // The director feels the part of its force across itself.
        let along = f[3] * row[3] + f[4] * row[4] + f[5] * row[5];
        let mut new = old;
        for k in 0..3 {
            new[k] = (old[k] * before + to_v * f[k]) * after;
            new[3 + k] = (old[3 + k] * before + to_w * (f[3 + k] - along * row[3 + k])) * after;
        }
        let mut prescribed = [[false; LANES]; P];
        if *held != [[0; LANES]; P] {
            let mut moved = registers.rows(new);
            for part in 0..P {
                prescribed[part] = self.hold_four(&held[part], &rows[part], &mut moved[part]);
            }
            new = columns(registers, &moved);
        }
        let mut mean = new;
        for k in 0..6 {
            mean[k] = (old[k] + new[k]) * 0.5;
        }
        let square = mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2];
        let turning = mean[3] * mean[3] + mean[4] * mean[4] + mean[5] * mean[5];
        let kinetic = registers.store((m * square + inertia * turning) * 0.5);
        // What the energy at this instant has too much is asked for where it is recorded, between a kick and a drift.
        let [mut changes, mut resisted] = [[[0.0; LANES]; P]; 2];
        if !DRIFT {
            let zero = registers.splat(0.0);
            let [mut moved, mut turned, mut along] = [zero; 3];
            for k in 0..3 {
                let [v, w] = [new[k] - old[k], new[3 + k] - old[3 + k]];
                moved += v * v;
                turned += w * w;
                along = along + (external[k] - f[k]) * v + (external[3 + k] - f[3 + k]) * w;
            }
            changes = registers.store((m * moved + inertia * turned) * 0.5);
            resisted = registers.store(kicked * along);
        }
        let mut done = mean;
        if LOADED {
            for k in 0..6 {
                done[k] = kicked * external[k] * mean[k];
            }
        }
        let done = registers.rows(done);
        for lane in 0..count {
            work.kinetic += kinetic.as_flattened()[lane];
            if !DRIFT {
                work.change += changes.as_flattened()[lane];
                work.resisted += resisted.as_flattened()[lane];
            }
            if LOADED {
                for k in 0..6 {
                    work.external += done.as_flattened()[lane][k];
                }
            }
            if prescribed.as_flattened()[lane] {
                let [f, old, new] = [registers.rows(f), registers.rows(old), registers.rows(new)];
                let [f, old, new] = [&f, &old, &new].map(|rows| rows.as_flattened()[lane]);
                let row = rows.as_flattened()[lane];
                work.external = self.with_reported_work(a + lane, work.external, row, f, [old, new]);
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
