//! What structures resisted beyond the forces of the fluid goes back to the particles beside their points.
//!
//! ```text
//! Δv_f = −J W_pf / (m Σ_f W_pf)      J: impulse on a point p, W_pf over the particles that see it
//! ```
//!
//! So momentum is kept, and a wave that would have carried the impulse away within the step has gone as far as the kernel
//! reaches. What it does to the kinetic energy is work of the boundary.
//!
//! Of those who march a fluid together each gives to the particles that he moves: he knows all beside the points that these see.

use peers::Exact;
use sph_core::Vec3;

use crate::books::put;
use crate::cells::NOWHERE;
use crate::fluid::Fluid;
use crate::sorted::Sorted;
use crate::state::State;

/// What impulses do to the particles that one moves.
struct Given {
    /// Work over the mass of a particle.
    work: Exact,
    /// Greatest speed \[L/T\].
    fastest: f64,
}

impl Fluid {
    /// Gives the opposite of impulses on the points of a structure \[F T; F T/L in a plane\] to the particles beside
    /// them, where these were when the forces were found. An impulse on a point beside no fluid is dropped: there is no
    /// force either.
    pub(crate) fn return_impulses(&mut self, structure: usize, impulses: &[[f64; 3]]) {
        // Everyone has the same, and none has anything to say then.
        if impulses.iter().all(|impulse| *impulse == [0.0; 3]) {
            return;
        }
        self.settle();
        let mut given = Given { work: Exact::new(), fastest: self.fastest };
        for (point, impulse) in self.boundary.structure(structure).zip(impulses) {
            let slot = self.boundary.sorted.slots[point];
            if *impulse != [0.0; 3] && slot != NOWHERE {
                self.return_impulse(point, slot as usize, Vec3::from(*impulse), &mut given);
            }
        }
        let [work] = self.share.add([given.work]);
        self.ledger.external += self.mass * work;
        [self.fastest] = self.share.greatest([given.fastest]);
        self.bring_velocities();
    }

    fn return_impulse(&mut self, point: usize, slot: usize, impulse: Vec3, given: &mut Given) {
        let Self { dimensions, mass, momentum, boundary, grid, sorted, present, share, .. } = self;
        let impulse = if *dimensions == 2 { Vec3::new(impulse.x, impulse.y, 0.0) } else { impulse };
        let Sorted { starts, order, rows, faces, .. } = sorted;
        let near = grid.beside(boundary.sorted.cell(slot) as u32, starts);
        let at = boundary.points[point];
        let hidden = boundary.sorted.hidden_faces(slot, faces);
        let seen = |near: usize| hidden.faces == 0 || hidden.of[near] & hidden.faces == 0;
        let beside =
            || near.filled().iter().flat_map(|&(from, to)| from as usize..to as usize).filter(|&k| seen(k));
        let State { positions, velocities, .. } = present;
        let weight = |particle: usize| momentum.kernel.value((positions[particle] - at).norm());
        let sum: f64 = beside().map(|k| weight(order[k] as usize)).sum();
        if sum == 0.0 {
            return;
        }
        let gain = -impulse / (*mass * sum);
        let moves = share.moves();
        for (slot, particle) in beside().map(|k| (k, order[k] as usize)) {
            let weight = weight(particle);
            if weight == 0.0 || moves.get(particle).is_some_and(|moves| !moves) {
                continue;
            }
            let (old, change) = (velocities[particle], gain * weight);
            let new = old + change;
            velocities[particle] = new;
            rows[slot].set_velocity(new.into());
            put(&mut given.work, change.dot(&(old + change * 0.5)));
            given.fastest = given.fastest.max(new.norm());
        }
    }
}
