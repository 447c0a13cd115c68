//! The step of four particles: gather forces, kick, hold what is held, book the work, drift.

use explicit_dynamics::{Step, Work};
use shell_kinematics::{LANES, Pack3, parallel_transport};

use crate::conditions::supports::Constraint;
use crate::gather::Gather;
use crate::packs::Row;
use crate::registers::Registers;

/// Slots of forces, and where in them the forces on the particles from number `first` on lie.
#[derive(Clone, Copy)]
pub(crate) struct Slots<'a> {
    pub rows: &'a [Row],
    pub lists: &'a Gather,
    pub first: usize,
}

impl Slots<'_> {
    /// Adds what lies in the slots of the four particles from number `a` on.
    #[inline(always)]
    pub fn add(&self, a: usize, sums: &mut [Row; LANES]) {
        self.lists.add((a - self.first) / LANES, self.rows, sums);
    }
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

/// What damping leaves of a velocity: `1 − ½cκ` before the kick, `1/(1 + ½cκ)` after it.
#[derive(Clone, Copy)]
pub(crate) struct Decay {
    before: f64,
    after: f64,
}

impl Decay {
    pub fn of(step: &Step) -> Self {
        let half = 0.5 * step.damping * step.kick;
        Self { before: 1.0 - half, after: 1.0 / (1.0 + half) }
    }
}

impl Update<'_> {
    /// Forces from the slots, kick, and with `DRIFT` the motion, of the particles from number `a` on that `rows` and
    /// `rates` hold: `v ← [v(1 − ½cκ) + κ f/m]/(1 + ½cκ)`. Returns their new rows and rates.
    ///
    /// Of the last particles there may be fewer than four; the lanes beyond repeat the last one and count for nothing.
    /// Kinetic energy and external work are added to `work`, particle by particle; what damping takes is `2cκ` times the
    /// former.
    #[inline(always)]
    pub fn four<const DRIFT: bool, const LOADED: bool, R: Registers>(
        &self,
        registers: R,
        a: usize,
        rows: &[Row],
        rates: &[Row],
        slots: Option<Slots<'_>>,
        work: &mut Work,
    ) -> [[Row; LANES]; 2] {
        let kick = self.step.kick;
        let Decay { before, after } = self.decay;
        let mut internal = [[0.0; 6]; LANES];
        if !self.direct.is_empty() {
            let [i0, i1, i2, i3] = four_of(self.direct, a);
            internal = [*i0, *i1, *i2, *i3];
        }
        if let Some(slots) = slots {
            slots.add(a, &mut internal);
        }
        let internal = registers.columns([&internal[0], &internal[1], &internal[2], &internal[3]]);
        let mut external = [registers.splat(0.0); 6];
        if LOADED {
            external = registers.columns(four_of(self.external, a));
        }
        let (row, old) = (registers.columns(four_of(rows, 0)), registers.columns(four_of(rates, 0)));
        let m = registers.gather(four_of(self.masses, a));
        let inertia = registers.gather(four_of(self.inertias, a));
        let kicked = registers.splat(kick);
        let (to_v, to_w) = (kicked / m, kicked / inertia);
        let mut f = external;
        for k in 0..6 {
            f[k] = external[k] - internal[k];
        }
        // The director feels the part of its force across itself.
        let along = f[3] * row[3] + f[4] * row[4] + f[5] * row[5];
        let mut new = old;
        for k in 0..3 {
            new[k] = (old[k] * before + to_v * f[k]) * after;
            new[3 + k] = (old[3 + k] * before + to_w * (f[3 + k] - along * row[3 + k])) * after;
        }
        let [h0, h1, h2, h3] = four_of(self.constraint_of, a);
        let mut told = [false; LANES];
        if (h0 | h1 | h2 | h3) > 0 {
            let mut moved = registers.rows(new);
            told = self.hold_four([*h0, *h1, *h2, *h3], four_of(rows, 0), &mut moved);
            new = registers.columns([&moved[0], &moved[1], &moved[2], &moved[3]]);
        }
        let mut mean = new;
        for k in 0..6 {
            mean[k] = (old[k] + new[k]) * 0.5;
        }
        let square = mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2];
        let turning = mean[3] * mean[3] + mean[4] * mean[4] + mean[5] * mean[5];
        let kinetic = registers.store((m * square + inertia * turning) * 0.5).lanes();
        let mut done = mean;
        if LOADED {
            for k in 0..6 {
                done[k] = kicked * external[k] * mean[k];
            }
        }
        let done = registers.rows(done);
        for lane in 0..rows.len().min(LANES) {
            work.kinetic += kinetic[lane];
            if LOADED {
                for k in 0..6 {
                    work.external += done[lane][k];
                }
            }
            if told[lane] && kick > 0.0 {
                let [f, old, new] = [registers.rows(f), registers.rows(old), registers.rows(new)];
                let rates = [old[lane], new[lane]];
                work.external = self.with_told_work(a + lane, work.external, rows[lane], f[lane], rates);
            }
        }
        if DRIFT {
            let dt = self.step.drift();
            let (d, w) = parallel_transport([row[3], row[4], row[5]], [new[3], new[4], new[5]], dt);
            let x = Pack3([row[0], row[1], row[2]]) + Pack3([new[0], new[1], new[2]]) * registers.splat(dt);
            let place = [x.0[0], x.0[1], x.0[2], d[0], d[1], d[2]];
            [registers.rows(place), registers.rows([new[0], new[1], new[2], w[0], w[1], w[2]])]
        } else {
            [registers.rows(row), registers.rows(new)]
        }
    }

    /// [`Update::hold`] of those of four particles that a support holds, by the numbers of their constraints.
    ///
    /// Neither this nor the work below is inlined: particles that nothing holds pay one branch.
    #[cold]
    #[inline(never)]
    fn hold_four(&self, held: [u32; LANES], rows: [&Row; LANES], new: &mut [Row; LANES]) -> [bool; LANES] {
        let mut told = [false; LANES];
        for lane in (0..LANES).filter(|&lane| held[lane] > 0) {
            let constraint = &self.constraints[held[lane] as usize - 1];
            (new[lane], told[lane]) = self.hold(constraint, *rows[lane], new[lane]);
        }
        told
    }

    /// Takes out what a support holds and puts in what it prescribes; true if it prescribes anything.
    fn hold(&self, constraint: &Constraint, row: Row, new: Row) -> (Row, bool) {
        let mut v = constraint.free_translation([new[0], new[1], new[2]]);
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

    /// External work with that of the support of particle `a` on what it prescribes: its force is what the particle's balance
    /// lacks, from the force `f` on the particle and its rates before and after the kick.
    #[cold]
    #[inline(never)]
    fn with_told_work(&self, a: usize, external: f64, row: Row, f: Row, [old, new]: [Row; 2]) -> f64 {
        let Step { kick, damping, .. } = *self.step;
        let Some(told) = self.constraints[self.constraint_of[a] as usize - 1].told() else { return external };
        let along = f[3] * row[3] + f[4] * row[4] + f[5] * row[5];
        let work = |external: f64, k: usize| {
            let (m, f) =
                if k < 3 { (self.masses[a], f[k]) } else { (self.inertias[a], f[k] - along * row[k]) };
            let mean = 0.5 * (old[k] + new[k]);
            let lack = m * (new[k] - old[k]) / kick - f + m * damping * mean;
            external + kick * lack * mean
        };
        let moved = if told.motion.is_some() { 0..3 } else { 0..0 };
        let rotated = if told.rotation.is_some() { 3..6 } else { 0..0 };
        moved.chain(rotated).fold(external, work)
    }
}

/// Four from number `first` on, or all there are and the last one again.
#[inline(always)]
fn four_of<T>(all: &[T], first: usize) -> [&T; LANES] {
    if let Some([a, b, c, d]) = all[first..].first_chunk() {
        return [a, b, c, d];
    }
    let last = all.len() - 1;
    [&all[first], &all[(first + 1).min(last)], &all[(first + 2).min(last)], &all[(first + 3).min(last)]]
}

/// Writes as many of four rows as there is room for.
#[inline(always)]
pub(crate) fn put(place: &mut [Row], rows: &[Row; LANES]) {
    if let Some(four) = place.first_chunk_mut() {
        *four = *rows;
    } else {
        place.copy_from_slice(&rows[..place.len()]);
    }
}

/// Row and rate after `dt`: the position moves along its velocity, the director along its great circle.
#[inline(always)]
pub(crate) fn drifted(row: &Row, rate: &Row, dt: f64) -> (Row, Row) {
    let (d, w) = parallel_transport([row[3], row[4], row[5]], [rate[3], rate[4], rate[5]], dt);
    let place = [row[0] + dt * rate[0], row[1] + dt * rate[1], row[2] + dt * rate[2], d[0], d[1], d[2]];
    (place, [rate[0], rate[1], rate[2], w[0], w[1], w[2]])
}
