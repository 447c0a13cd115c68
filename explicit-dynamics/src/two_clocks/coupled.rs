//! A structure at a clock of its own, between two instants of a fluid.

use super::course::{Course, SLIVER};
use crate::error::MarchError;
use crate::interface::{BoundaryLoad, BoundaryState, Wetted};
use crate::record::Balance;
use crate::stable_step::StableStep;
use crate::step::{Step, Work};

/// The clock of a structure.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct OwnClock {
    /// Stable step \[T\].
    pub stable: f64,
    /// Steps done.
    pub steps: u64,
    /// Steps after which the stable step is estimated anew.
    pub next_estimate: u64,
    /// The last step \[T\]; zero before the first.
    pub last: f64,
    /// Steps within the last one of the fluid, the most that any of its steps asked for; where one of them had to be shorter there were more.
    pub count: u64,
    /// Span of all of them \[T\]; zero before the first.
    pub whole: f64,
}

/// A structure with its clock, what the fluid receives of it, and its ledger.
pub(super) struct Coupled {
    pub clock: OwnClock,
    /// Mean velocities of its points over the last step of the fluid \[L/T\].
    pub velocities: Vec<[f64; 3]>,
    /// Velocities with which the fluid saw them when it found the forces \[L/T\].
    pub seen: Vec<[f64; 3]>,
    /// Impulses that its points had from loads, less those that the fluid had with opposite sign \[F T; F T/L in a
    /// plane problem\].
    pub ahead: Vec<[f64; 3]>,
    /// Impulses with which its points resisted, until the fluid has them \[F T; F T/L in a plane problem\].
    resisted: Vec<[f64; 3]>,
    /// Work done since the last kick was counted \[F L\].
    pub pending: Work,
    /// Its energies; those counted are up to the instant in the middle of the last kick until the drift behind it.
    pub energy: Balance,
    /// The other half of what that kick did.
    behind: Work,
    /// The step that it may take next \[T\].
    pub most: f64,
    from: BoundaryState,
    to: BoundaryState,
    load: Vec<[f64; 3]>,
}

impl OwnClock {
    /// Steps of a structure within one of the fluid: never fewer than before. The step of a fluid wavers; where it wavers
    /// about a whole number of stable steps, the steps of the structure would change by half or a third time and again, and
    /// central differences keep energy for equal steps only: with step h the energy of a mode is that of its amplitude times
    /// `1 − (ωh/2)²`, so that each change multiplies it by up to a few, and the fast modes grow in silence.
    pub fn count(&self, step: &Step) -> u64 {
        ((step.drift() / self.stable - SLIVER).ceil() as u64).max(self.count).max(1)
    }
}

impl Coupled {
    pub fn new<S: Wetted + ?Sized>(body: &S) -> Self {
        let mut velocities = Vec::new();
        body.boundary_velocities(&mut velocities);
        let mut to = BoundaryState::default();
        body.boundary(&mut to);
        Self {
            clock: OwnClock::default(),
            seen: velocities.clone(),
            ahead: vec![[0.0; 3]; velocities.len()],
            resisted: vec![[0.0; 3]; velocities.len()],
            load: vec![[0.0; 3]; velocities.len()],
            velocities,
            pending: Work::default(),
            energy: Balance::default(),
            behind: Work::default(),
            most: f64::INFINITY,
            from: BoundaryState::default(),
            to,
        }
    }

    /// Where its boundary starts, and with which velocities.
    pub fn start(&self) -> (&BoundaryState, &[[f64; 3]]) {
        (&self.to, &self.velocities)
    }

    /// Whether its stable step has lapsed.
    pub fn lapsed(&self) -> bool {
        self.clock.steps >= self.clock.next_estimate
    }

    /// Finds the stable step.
    ///
    /// # Errors
    /// [`MarchError::NoStableStep`].
    pub fn estimate<S: Wetted + ?Sized>(&mut self, body: &mut S, safety: f64) -> Result<(), MarchError> {
        let StableStep { dt, holds } = body.stable_step(safety)?;
        self.clock.stable = dt;
        self.clock.next_estimate = self.clock.steps.saturating_add(holds);
        Ok(())
    }

    /// Puts the forces of the fluid on the points. If they shall be `centred`, they lead by half the difference of the
    /// two steps, T = MΔt_s and Δt_s, as the structure's velocities then lead those of the fluid; what it had beyond that
    /// lead is taken back:
    ///
    /// ```text
    /// load = F + (½(T − Δt_s) F − J)/T      J impulse by which it is ahead
    /// ```
    ///
    /// So its impulse over a run is that of the fluid, but for J.
    pub fn load<S: Wetted + ?Sized>(
        &mut self,
        body: &mut S,
        forces: &[[f64; 3]],
        impedance: f64,
        centred: bool,
    ) {
        let OwnClock { last, count, whole, .. } = self.clock;
        let (lead, rate) =
            if centred && whole > 0.0 { (0.5 * (whole - last), 1.0 / whole) } else { (0.0, 0.0) };
        for ((load, force), ahead) in self.load.iter_mut().zip(forces).zip(&self.ahead) {
            *load = std::array::from_fn(|k| force[k] + rate * (lead * force[k] - ahead[k]));
        }
        // One step has the velocity that the fluid saw.
        let impedance = if count == 1 && whole == last { 0.0 } else { impedance };
        let Self { load, seen, .. } = self;
        body.apply_load(&BoundaryLoad { forces: load, found: forces, seen, impedance });
    }

    /// Counts the impulses of a kick of the fluid, which had these forces with opposite sign.
    pub fn kicked(&mut self, forces: &[[f64; 3]], span: f64) {
        push(&mut self.ahead, forces, -span);
    }

    /// Hands over the impulses with which its points resisted over the step.
    pub fn hand_back(&mut self, to: impl FnOnce(&[[f64; 3]])) {
        to(&self.resisted);
        self.resisted.fill([0.0; 3]);
    }

    /// Impulse by which it is ahead of the fluid \[F T; F T/L in a plane problem\].
    pub fn impulse_ahead(&self) -> [f64; 3] {
        let all = self.ahead.iter().chain(&self.resisted);
        all.fold([0.0; 3], |sum, impulse| std::array::from_fn(|k| sum[k] + impulse[k]))
    }

    /// Counts the impulses of a kick of its own that is about to come.
    fn push<S: Wetted + ?Sized>(&mut self, body: &S, span: f64) {
        push(&mut self.ahead, &self.load, span);
        body.impedance_impulses(span, &mut self.resisted);
    }

    /// The kick of its first step within one of the fluid; returns what has been done since the last of these. A kick
    /// of no span, before a `shown` instant, shows the energies, and counts what supports do at once.
    pub fn kick<S: Wetted + ?Sized>(&mut self, body: &mut S, step: &Step, shown: bool) -> Work {
        if !shown {
            self.push(body, step.kick);
        }
        let work = body.kick(&Step { kick: if shown { 0.0 } else { step.kick }, ..*step });
        self.energy.kinetic = work.kinetic;
        if shown {
            self.energy.external += work.external;
            return work;
        }
        let half = Work { external: 0.5 * work.external, dissipated: 0.5 * work.dissipated, ..work };
        self.behind = half;
        self.book(half);
        self.pending.external += half.external;
        self.pending.dissipated += half.dissipated;
        Work { change: work.change, resisted: work.resisted, ..self.settle(work.kinetic) }
    }

    /// Takes note of where its boundary stands before a step of the fluid.
    pub fn depart<S: Wetted + ?Sized>(&mut self, body: &S) {
        body.boundary(&mut self.from);
    }

    /// The drift behind [`Coupled::kick`].
    pub fn drift<S: Wetted + ?Sized>(&mut self, body: &mut S, step: &Step) {
        body.drift(step);
        let Work { external, dissipated, .. } = std::mem::take(&mut self.behind);
        self.energy.external += external;
        self.energy.dissipated += dissipated;
        self.done(step);
    }

    /// A step of its own; `first` of one of the fluid, at whose start energies are counted.
    pub fn advance<S: Wetted + ?Sized>(&mut self, body: &mut S, step: &Step, first: bool) {
        self.push(body, step.kick);
        let work = body.advance(step);
        self.kicked_off(work, first);
        self.done(step);
    }

    /// The kick of such a step, behind which [`Coupled::drift`] comes; its forces are evaluated.
    pub fn kick_off<S: Wetted + ?Sized>(&mut self, body: &mut S, step: &Step, first: bool) {
        self.push(body, step.kick);
        let work = body.kick(step);
        self.kicked_off(work, first);
    }

    fn kicked_off(&mut self, work: Work, first: bool) {
        if first {
            self.energy.kinetic = work.kinetic;
        }
        self.book(work);
    }

    /// Ends a step of the fluid, after these of its own.
    pub fn arrive<S: Wetted + ?Sized>(&mut self, body: &S, whole: &Step, course: &Course) {
        self.clock.count = course.planned();
        self.clock.whole = course.span(self.clock.last);
        body.boundary(&mut self.to);
        let rate = 1.0 / whole.drift();
        let places = self.from.points.iter().zip(&self.to.points);
        for (velocity, (from, to)) in self.velocities.iter_mut().zip(places) {
            *velocity = std::array::from_fn(|k| rate * (to[k] - from[k]));
        }
    }

    /// What was done since the ledger was last settled, with the kinetic energy of an instant.
    pub fn settle(&mut self, kinetic: f64) -> Work {
        Work { kinetic, ..std::mem::take(&mut self.pending) }
    }

    /// Where its boundary stands after a step, and the mean velocities over it, with which the fluid sees it from now
    /// on.
    pub fn arrived(&mut self) -> (&BoundaryState, &[[f64; 3]]) {
        self.seen.copy_from_slice(&self.velocities);
        (&self.to, &self.seen)
    }

    /// Where its points would be after `dt` with the velocities of the step before, with which the fluid sees it from
    /// now on.
    pub fn expected<S: Wetted + ?Sized>(&mut self, body: &S, dt: f64) -> (&BoundaryState, &[[f64; 3]]) {
        self.seen.copy_from_slice(&self.velocities);
        body.boundary(&mut self.to);
        for (point, velocity) in self.to.points.iter_mut().zip(&self.seen) {
            (0..3).for_each(|k| point[k] += dt * velocity[k]);
        }
        (&self.to, &self.seen)
    }

    /// The point that moved fastest over the last step, and its speed \[L/T\]; not a number counts as fastest.
    pub fn fastest(&self) -> (usize, f64) {
        let square = |v: &[f64; 3]| {
            let square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
            if square.is_nan() { f64::INFINITY } else { square }
        };
        let greater = |best: (usize, f64), next: (usize, f64)| if next.1 > best.1 { next } else { best };
        let (point, square) = self.velocities.iter().map(square).enumerate().fold((0, 0.0), greater);
        (point, square.sqrt())
    }

    fn book(&mut self, work: Work) {
        self.pending.external += work.external;
        self.pending.dissipated += work.dissipated;
        self.energy.external += work.external;
        self.energy.dissipated += work.dissipated;
    }

    fn done(&mut self, step: &Step) {
        self.clock.last = step.drift();
        self.clock.steps += 1;
    }
}

fn push(impulses: &mut [[f64; 3]], forces: &[[f64; 3]], span: f64) {
    for (impulse, force) in impulses.iter_mut().zip(forces) {
        (0..3).for_each(|k| impulse[k] += span * force[k]);
    }
}
