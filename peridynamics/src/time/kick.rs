//! Kick and drift in one pass over the rows, by chunks of a fixed size: sums do not depend on threads.

use explicit_dynamics::{Step, Work};
use sph_core::Vec3;

use crate::Solid;
use crate::bonds::network::Row;
use crate::constraint::Constraints;
use crate::solid::vector;

/// What a kick reads.
struct Kick<'a> {
    step: &'a Step,
    masses: &'a [f64],
    internal: &'a [Row],
    external: &'a [Vec3],
    constraints: &'a Constraints,
}

impl Kick<'_> {
    /// Kicks a chunk of rows, and with `DRIFT` moves them.
    fn chunk<const DRIFT: bool>(&self, first: usize, rates: &mut [Row], rows: &mut [Row]) -> Work {
        let Self { step, masses, internal, external, constraints } = *self;
        let (decay, dt) = (step.decay(), step.drift());
        let mut work = Work::default();
        for (i, (rate, place)) in rates.iter_mut().zip(rows).enumerate() {
            let row = first + i;
            let mass = masses[row];
            let external = external.get(row).copied().unwrap_or_default();
            let (force, old) = (external - vector(&internal[row]), vector(rate));
            let mut new = (old * decay.before + force * (step.kick / mass)) * decay.after;
            let mut prescribed = false;
            if let Some(constraint) = constraints.get(row) {
                new = constraint.held.free_part(new.into()).into();
                if constraint.moves() {
                    new += constraint.velocity(step);
                }
                prescribed = constraint.moves() || step.kick == 0.0;
            }
            let mean = 0.5 * (old + new);
            if !DRIFT {
                let change = new - old;
                work.change += 0.5 * mass * change.norm_squared();
                work.resisted += step.kick * (external - force).dot(&change);
            }
            work.kinetic += 0.5 * mass * mean.norm_squared();
            work.external += step.kick * external.dot(&mean);
            if prescribed {
                let impulse = |k: usize| step.support_impulse(mass, [old[k], new[k]], force[k]);
                work.external += Vec3::from_fn(|k, _| impulse(k)).dot(&mean);
            }
            rate[..3].copy_from_slice(new.as_slice());
            if DRIFT {
                (0..3).for_each(|k| place[k] += dt * new[k]);
            }
        }
        work
    }
}

impl Solid {
    /// The kick of own rows, and with `DRIFT` the drift behind it; returns the work of all.
    pub(super) fn pass<const DRIFT: bool>(&mut self, step: &Step) -> Work {
        let Self { rates, rows, masses, internal, external, constraints, works, share, .. } = self;
        let kick = Kick { step, masses, internal, external, constraints };
        let own = share.own(rates.len());
        let lists = (&mut rates[own.clone()], &mut rows[own.clone()]);
        parallel::reduced(share.threads(), lists, works, |first, (rates, rows)| {
            kick.chunk::<DRIFT>(own.start + first, rates, rows)
        });
        let of = |work: &Work| [work.kinetic, work.external, work.change, work.resisted];
        let [kinetic, external, change, resisted] = share.sum(works.iter().map(of));
        let dissipated = 2.0 * step.kick * step.damping * kinetic;
        Work { kinetic, external, dissipated, change, resisted }
    }

    /// The drift of own rows alone.
    pub(super) fn drift_rows(&mut self, dt: f64) {
        let Self { rates, rows, share, .. } = self;
        let own = share.own(rates.len());
        share.sweep(own.start, &mut rows[own], |first, rows: &mut [Row]| {
            for (place, rate) in rows.iter_mut().zip(&rates[first..]) {
                (0..3).for_each(|k| place[k] += dt * rate[k]);
            }
        });
    }
}
