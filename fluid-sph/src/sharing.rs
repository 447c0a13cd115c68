//! A fluid that several march together: what they are refused, how all is dealt out and brought back.

use peers::Peers;
use sph_core::Vec3;

use crate::cells::Grid;
use crate::error::FluidError;
use crate::fluid::{CELL, Fluid};
use crate::formulation::{Scheme, WallRule};
use crate::openings::Openings;
use crate::share::Share;
use crate::share::deal::{All, Deal, FARTHEST};
use crate::sorted::Sorted;
use crate::state::State;

/// By particle that is known: whether it is moved here; empty where all are. Others who march the fluid move some, and what has gone out through
/// openings does not move.
pub(crate) fn moving<'a>(share: &'a Share, openings: &'a Option<Box<Openings>>) -> &'a [bool] {
    openings.as_deref().map_or_else(|| share.moves(), |openings| &openings.here)
}

impl Fluid {
    /// Marches it with others, each of whom has built the same fluid: this one moves its part of the particles. All that a march
    /// returns is that of the whole, with the bits of one who marches it alone; what is read of the fluid is right after
    /// [`Fluid::bring`]. All of them call the methods that march it, its bounds among them, in the same order, and give it the same
    /// states. Structures in it are whole with each of them, who all march them: forces on their points are right with everyone.
    ///
    /// # Errors
    /// [`FluidError::NotShared`]: predictor and corrector, walls with a density of their own, periodic sides, openings.
    pub fn share(&mut self, peers: Box<dyn Peers>) -> Result<(), FluidError> {
        let refusals = [
            (
                self.formulation.scheme == Scheme::PredictorCorrector,
                "a fluid marched by predictor and corrector",
            ),
            (self.formulation.walls == WallRule::Dynamic, "a fluid between walls of the published method"),
            (self.periodic.is_some(), "a fluid with periodic sides"),
            (self.openings.is_some(), "a fluid with openings"),
        ];
        if let Some((_, what)) = refusals.iter().find(|(refused, _)| *refused) {
            return Err(FluidError::NotShared(what));
        }
        let whole = self.shown().clone();
        let deal = self.dealer(&whole, false);
        self.share = Share::new(peers, whole, deal);
        self.take_up_deal();
        Ok(())
    }

    /// Brings the state of all particles and forces on all walls to everyone who marches it. All of them call it.
    pub fn bring(&mut self) {
        self.settle();
        self.bring_all();
    }

    fn bring_all(&mut self) {
        let Self { present, boundary, ledger, share, .. } = self;
        let [error] = share.greatest([ledger.density_error]);
        ledger.density_error = error;
        let Some(shared) = share.shared_mut() else { return };
        let mut whole = std::mem::take(&mut shared.whole);
        let known = |particle: usize| shared.deal.known.partition_point(|&known| (known as usize) < particle);
        let row = |particle: usize| present.row(known(particle));
        shared.gather(&shared.deal.particles, row, |particle, row| whole.put(particle, row));
        let (forces, densities, own) = (&boundary.forces, &boundary.densities, &boundary.ledger);
        let row = |point: usize| {
            let [x, y, z] = forces[point];
            [x, y, z, densities[point], own.shares[point], own.owed[point]]
        };
        let mut rows = vec![[0.0; 6]; forces.len()];
        shared.gather(&shared.deal.points, row, |point, row| rows[point] = row);
        for (point, [x, y, z, density, share, owed]) in rows.into_iter().enumerate() {
            (boundary.forces[point], boundary.densities[point]) = ([x, y, z], density);
            (boundary.ledger.shares[point], boundary.ledger.owed[point]) = (share, owed);
        }
        shared.whole = whole;
    }

    /// Brings velocities of particles that others move, to their rows too, and those of copies.
    pub(crate) fn bring_velocities(&mut self) {
        let Self { present, sorted, share, copies, .. } = self;
        let Sorted { slots, rows, .. } = sorted;
        copies.each(present.velocities.len(), slots, |copy, own| {
            let velocity = rows[own].velocity();
            rows[copy].set_velocity(velocity);
        });
        share.bring_vectors(&mut present.velocities, |known| known);
        for (known, _) in share.moves().iter().enumerate().filter(|(_, moves)| !**moves) {
            rows[slots[known] as usize].set_velocity(present.velocities[known].into());
        }
    }

    /// Numbers of the particles that this one moves, ascending: all, unless others march it too. They change as the fluid flows.
    pub fn own_particles(&self) -> impl Iterator<Item = usize> {
        let moves = moving(&self.share, &self.openings);
        let own = (0..self.present.densities.len()).filter(|&i| moves.get(i).is_none_or(|moves| *moves));
        own.map(|i| self.share.number(i))
    }

    /// Velocities of those, in the same order, as they are now \[L/T\].
    pub fn own_velocities(&self) -> impl Iterator<Item = &Vec3> {
        let moves = moving(&self.share, &self.openings);
        let all = self.present.velocities.iter().enumerate();
        all.filter(|(i, _)| moves.get(*i).is_none_or(|moves| *moves)).map(|(_, velocity)| velocity)
    }

    /// All particles, as they were brought last.
    pub(crate) fn shown(&self) -> &State {
        self.share.shared().map_or(&self.present, |shared| &shared.whole)
    }

    /// Gets ready for a drift that takes so long and ends at a time \[T\]: deals all out anew if need be, and puts structures where they
    /// are to be.
    pub(crate) fn settle_for(&mut self, end: f64, dt: f64) {
        if self.share.shared().is_none() {
            return;
        }
        let boundary = self.boundary.way_to(end).max(self.boundary.way_put_off(self.dimensions, dt));
        // The mean velocities of XSPH are no greater than the greatest but for what weights do not sum to one.
        self.deal_if_due([1.1 * dt * self.fastest, boundary]);
        self.boundary.settle(self.dimensions);
    }

    /// Puts structures where they are to be, if no drift did so.
    pub(crate) fn settle(&mut self) {
        if self.share.shared().is_some() {
            self.deal_if_due([0.0, self.boundary.way_put_off(self.dimensions, 0.0)]);
            self.boundary.settle(self.dimensions);
        }
    }

    /// Deals all out anew, where everything stood when forces were found, if the present deal does not last for ways to come \[L\] of
    /// particles and of points of the boundary: where they may go farther from where they were dealt out than is allowed for. Where one
    /// step is as much, or cells do not hold all, everyone knows all.
    fn deal_if_due(&mut self, ways: [f64; 2]) {
        let Some(shared) = self.share.shared() else { return };
        let gone = [shared.gone[0] + ways[0], shared.gone[1] + ways[1]];
        let allowed = FARTHEST * self.momentum.kernel.reach();
        let far = |ways: [f64; 2]| !ways.iter().all(|&way| way <= allowed);
        let spread = !shared.deal.everything && self.grid.may_be_cut_off(self.rest.len());
        let due = far(gone) || spread;
        if due {
            self.bring_all();
            self.deal_out(far(ways));
            // Slots and sides as the last forces had them, by the numbers of who is known now.
            self.sort(0.0, 0.0);
            self.fill(0.0, 0.0, true);
            self.find_sides();
        }
        if let Some(shared) = self.share.shared_mut() {
            shared.gone = if due { ways } else { gone };
        }
    }

    /// Deals all particles out anew, who are known to everyone at this moment; all of them to everyone if one step takes them too far.
    pub(crate) fn deal_out(&mut self, too_far: bool) {
        let Some(shared) = self.share.shared_mut() else { return };
        let whole = std::mem::take(&mut shared.whole);
        let deal = self.dealer(&whole, too_far);
        if let Some(shared) = self.share.shared_mut() {
            shared.take_up(deal);
            shared.whole = whole;
        }
        self.take_up_deal();
    }

    /// How all is dealt out to a rank of so many.
    fn dealer(&self, whole: &State, too_far: bool) -> impl FnOnce(usize, usize) -> Deal + use<> {
        let width = CELL * self.momentum.kernel.reach();
        let grid = Grid::around(self.dimensions, whole.positions.iter().copied(), width);
        let everything = too_far || grid.may_be_cut_off(whole.positions.len());
        let (dimensions, positions) = (self.dimensions, whole.positions.clone());
        let (points, wet) = (self.boundary.points.clone(), self.boundary.wet());
        move |rank, count| {
            let all = All { dimensions, grid, positions: &positions, points: &points, wet, everything };
            Deal::new(&all, rank, count)
        }
    }

    /// Keeps of the whole who is known.
    fn take_up_deal(&mut self) {
        let Some(shared) = self.share.shared() else { return };
        self.present = shared.whole.of(&shared.deal.known);
        let count = self.present.densities.len();
        self.accelerations.resize(count, [0.0; 3]);
        self.powers.resize(count, 0.0);
        self.rates.resize(count, [0.0; 2]);
        self.drags.resize(if self.formulation.xsph == 0.0 { 0 } else { count }, [0.0; 3]);
        self.sorted.slots.clear();
        self.sorted.slots.resize(count, 0);
        self.fresh = false;
    }
}
