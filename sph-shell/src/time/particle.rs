//! One particle's step: gather forces, kick, hold what is held, book the work, drift.

use explicit_dynamics::{Step, Work};
use shell_kinematics::parallel_transport;

use crate::conditions::supports::Constraint;
use crate::packs::{Packs, Row};

/// Slots of forces; a ring that holds only the slots in use is addressed through its mask.
#[derive(Clone, Copy)]
pub(crate) struct Slots<'a> {
    pub rows: &'a [Row],
    pub mask: usize,
}

/// What the update of a particle reads.
#[derive(Clone, Copy)]
pub(crate) struct Update<'a> {
    pub packs: &'a Packs,
    /// Internal forces found particle by particle; empty if there are none.
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

    /// A velocity after the kick `push = κ f/m`.
    pub fn kicked(self, old: f64, push: f64) -> f64 {
        (old * self.before + push) * self.after
    }
}

impl Update<'_> {
    /// Sum of the slots of particle `a`, in ascending order.
    #[inline(always)]
    fn internal(&self, a: usize, slots: Slots<'_>) -> Row {
        let mut sum = if self.direct.is_empty() { [0.0; 6] } else { self.direct[a] };
        if !slots.rows.is_empty() {
            for &slot in self.packs.slots_of(a) {
                let row = &slots.rows[slot as usize & slots.mask];
                for i in 0..6 {
                    sum[i] += row[i];
                }
            }
        }
        sum
    }

    /// `v ← [v(1 − ½cκ) + κ f/m]/(1 + ½cκ)` of particle `a`, and with `DRIFT` its new row.
    ///
    /// Kinetic energy and external work are added to `work`; what damping takes is `2cκ` times the former.
    #[inline(always)]
    pub fn particle<const DRIFT: bool, const LOADED: bool>(
        &self,
        a: usize,
        row: &Row,
        rate: &mut Row,
        slots: Slots<'_>,
        work: &mut Work,
    ) -> Row {
        let kick = self.step.kick;
        let Decay { before, after } = self.decay;
        let internal = self.internal(a, slots);
        let external = if LOADED { self.external[a] } else { [0.0; 6] };
        let (m, inertia) = (self.masses[a], self.inertias[a]);
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
        let number = self.constraint_of[a] as usize;
        let mut told = false;
        if number > 0 {
            (new, told) = self.hold(&self.constraints[number - 1], *row, new);
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
        if told && kick > 0.0 {
            work.external = self.with_told_work(a, work.external, *row, f, [old, new]);
        }
        if DRIFT {
            let (place, carried) = drifted(row, &new, self.step.drift());
            *rate = carried;
            place
        } else {
            *rate = new;
            *row
        }
    }

    /// Takes out what a support holds and puts in what it prescribes; true if it prescribes anything.
    ///
    /// Neither this nor the work below is inlined: particles that nothing holds pay one branch.
    #[cold]
    #[inline(never)]
    fn hold(&self, constraint: &Constraint, row: Row, new: Row) -> (Row, bool) {
        if constraint.tied {
            return ([0.0; 6], false); // its group moves it
        }
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

/// Row and rate after `dt`: the position moves along its velocity, the director along its great circle.
#[inline(always)]
pub(crate) fn drifted(row: &Row, rate: &Row, dt: f64) -> (Row, Row) {
    let (d, w) = parallel_transport([row[3], row[4], row[5]], [rate[3], rate[4], rate[5]], dt);
    let place = [row[0] + dt * rate[0], row[1] + dt * rate[1], row[2] + dt * rate[2], d[0], d[1], d[2]];
    (place, [rate[0], rate[1], rate[2], w[0], w[1], w[2]])
}
