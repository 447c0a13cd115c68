//! A shell that several march together.

use std::ops::Range;

use peers::{Cut, Peers};

use crate::Shell;
use crate::conditions::on_share::OnShare;
use crate::error::ShellError;
use crate::gather::Places;
use crate::points::bounds::BoundViolation;
use crate::points::remembering::RememberingPack;
use crate::time::fused::Fused;
use crate::time::share::Share;

impl Shell {
    /// Marches it with others, each of whom has built the same shell: this one moves its share of the particles. All that a march returns is that of
    /// the whole, with the bits of one who marches it alone; what is read of particles is right after [`Shell::bring`]. All of them do the same to it
    /// in the same order, [`Shell::set_state`] and [`Shell::take_up`] too. Contact, volumes, and loads that do not say what they add to a range of
    /// particles ([`crate::Load::on_share`]) are evaluated by everyone for the whole shell, whose places are then brought to all in each step.
    ///
    /// # Errors
    /// [`ShellError::NotShared`]: strains that are not sampled in cells, fluids.
    pub fn share(&mut self, peers: Box<dyn Peers>) -> Result<(), ShellError> {
        let Self { reference, points, dependents, stiffeners, loading, evaluation, .. } = self;
        let refusals = [
            (evaluation.plan.is_none(), "a shell whose strains are not sampled in cells"),
            (loading.wetted.is_some(), "a shell in a fluid"),
        ];
        if let Some((_, what)) = refusals.iter().find(|(refused, _)| *refused) {
            return Err(ShellError::NotShared(what));
        }
        let places = Places::new(&points.packs, &reference.operator);
        let particles = reference.cloud.len();
        let mut packs = vec![Vec::new(); points.packs.points.len()];
        for a in 0..particles {
            places.of(a).iter().for_each(|place| packs[place.0 as usize].push(a as u32));
        }
        let cut = Cut::even(particles, peers.count());
        let own = cut.own(peers.rank());
        let touches = loading.touches();
        let (on_share, mut reads) =
            OnShare::new(&loading.loads, &loading.springs, touches, own.clone(), reference);
        reads.extend(stiffeners.reads(&own));
        let share = Share::new(peers, cut, &packs, [reads, dependents.bound()]);
        let ranges = [share.own(), share.interior()];
        evaluation.plan = Some(Fused::plan(&points.packs, &places, ranges, evaluation.threads));
        if share.is_shared() {
            loading.on_share = Some(Box::new(on_share.beside(share.ghosts().to_vec())));
        }
        self.share = share;
        Ok(())
    }

    /// Brings motion and forces of all particles, and the history of all points, to everyone who marches it. All of them call it.
    pub fn bring(&mut self) {
        let Self { points, loading, motion, share, .. } = self;
        if share.is_shared() {
            share.moved();
            bring_histories(points.sections.histories_mut(), share);
            let [external, of_springs] = loading.rows_mut();
            let rows = [&mut motion.state[..], &mut motion.rates, points.direct_mut(), external, of_springs];
            rows.into_iter().filter(|rows| !rows.is_empty()).for_each(|rows| share.bring(rows));
        }
    }

    /// Brings internal forces of all particles to everyone who seeks an equilibrium of it.
    pub(crate) fn bring_internal(&mut self) {
        if self.share.is_shared() {
            self.share.bring(self.points.direct_mut());
        }
    }

    /// Brings the forces of loads and springs on all particles, likewise.
    pub(crate) fn bring_external(&mut self) {
        if self.share.is_shared() {
            let rows = self.loading.rows_mut();
            rows.into_iter().filter(|rows| !rows.is_empty()).for_each(|rows| self.share.bring(rows));
        }
    }

    /// The particles that this one moves: all, unless others march it too.
    pub fn own_particles(&self) -> Range<usize> {
        self.share.own()
    }

    /// The first sampling point beyond the range of the model.
    pub(crate) fn first_violation(&self) -> Option<BoundViolation> {
        let Self { reference, points, motion, evaluation, share, .. } = self;
        let all = points.packs.points.len();
        let Some(plan) = evaluation.plan.as_ref().filter(|_| share.is_shared()) else {
            return points.first_bound_violation(reference, &motion.state, 0..all);
        };
        let mut state = motion.state.clone();
        share.exchange(&mut state);
        // Numbers that are whole are exact as values; the least is the greatest of their opposites.
        let beyond = |&pack: &usize| {
            share.has(pack) && points.first_bound_violation(reference, &state, pack..pack + 1).is_some()
        };
        let own = plan.packs().find(beyond).map(|pack| (-(pack as f64), pack));
        let (value, pack) = share.greatest(own.into_iter());
        if value == f64::NEG_INFINITY {
            return None;
        }
        share.bring(&mut state);
        points.first_bound_violation(reference, &state, pack..pack + 1)
    }
}

/// Brings histories of packs to everyone from those who look after them; who sweeps a pack has its history already.
fn bring_histories(packs: &mut [RememberingPack], share: &Share) {
    let width = packs.iter().map(RememberingPack::count).max().unwrap_or(0);
    if width == 0 {
        return;
    }
    let mut brought: Vec<Vec<f64>> = vec![Vec::new(); packs.len()];
    let read = |pack: usize, row: &mut [f64]| {
        row.iter_mut().zip(packs[pack].numbers()).for_each(|(row, number)| *row = number);
    };
    share.bring_packs(width, read, |pack, row| brought[pack] = row.to_vec());
    for ((pack, row), touched) in packs.iter_mut().zip(&brought).zip(share.touched()) {
        if !touched && !row.is_empty() {
            pack.take_up(&row[..pack.count()]);
        }
    }
}
