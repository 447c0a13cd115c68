//! All of two clocks that changes beside their fluid and their structures, as plain numbers.

use crate::interface::{BoundaryDriven, Wetted};
use crate::record::Balance;
use crate::step::Work;
use crate::two_clocks::coupled::{Coupled, OwnClock};
use crate::two_clocks::{Counts, TwoClocks};

/// Numbers of a structure beside its velocities.
const LEDGER: usize = 11;

impl<F: BoundaryDriven, S: Wetted + ?Sized> TwoClocks<F, S> {
    /// All that changes here while it marches, beside the states of the fluid and of the structures: counts, clocks,
    /// counts, velocities of the boundaries, and the impulses that are under way.
    pub fn state(&self) -> Vec<f64> {
        let Counts { substeps, most, shortened } = self.counts;
        let mut numbers = vec![substeps as f64, most as f64, shortened as f64];
        for structure in &self.structures {
            let OwnClock { stable, steps, next_estimate, last, count } = structure.clock;
            let Work { external: owed, dissipated: lost, .. } = structure.pending;
            let Balance { kinetic, internal, external, dissipated } = structure.energy;
            let clock = [stable, steps as f64, next_estimate as f64, last, count as f64];
            let ledger = [owed, lost, kinetic, internal, external, dissipated];
            numbers.extend(clock.into_iter().chain(ledger));
            let Coupled { velocities, seen, ahead, .. } = structure;
            numbers.extend([velocities, seen, ahead].into_iter().flatten().flatten());
        }
        numbers
    }

    /// Takes up what [`TwoClocks::state`] gave, to the same bits; false, and nothing changed, if it is that of other
    /// structures.
    pub fn set_state(&mut self, numbers: &[f64]) -> bool {
        let Some(([substeps, most, shortened], mut rest)) = numbers.split_first_chunk() else { return false };
        let length = |structure: &Coupled<S>| LEDGER + 9 * structure.velocities.len();
        if rest.len() != self.structures.iter().map(length).sum::<usize>() {
            return false;
        }
        let counts = [substeps, most, shortened].map(|&number| number as u64);
        self.counts = Counts { substeps: counts[0], most: counts[1], shortened: counts[2] };
        for structure in &mut self.structures {
            let points = structure.velocities.len();
            let Some((ledger, behind)) = rest.split_first_chunk::<LEDGER>() else { return false };
            let [stable, steps, next, last, count, owed, lost, kinetic, internal, external, dissipated] =
                *ledger;
            let [steps, next_estimate, count] = [steps, next, count].map(|number| number as u64);
            structure.clock = OwnClock { stable, steps, next_estimate, last, count };
            structure.pending = Work { external: owed, dissipated: lost, ..Work::default() };
            structure.energy = Balance { kinetic, internal, external, dissipated };
            let (own, behind) = behind.split_at(9 * points);
            let Coupled { velocities, seen, ahead, .. } = structure;
            let vectors = [velocities, seen, ahead];
            for (vectors, numbers) in vectors.into_iter().zip(own.chunks_exact(3 * points)) {
                take(vectors, numbers);
            }
            rest = behind;
        }
        true
    }
}

fn take(vectors: &mut [[f64; 3]], numbers: &[f64]) {
    for (vector, numbers) in vectors.iter_mut().zip(numbers.chunks_exact(3)) {
        vector.copy_from_slice(numbers);
    }
}
