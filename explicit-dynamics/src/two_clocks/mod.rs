//! A fluid and the structures in it, each at a clock of its own; what changes beside them, as plain numbers.

mod bracing;
mod coupled;
mod course;
mod march;

pub use bracing::Bracing;

use coupled::{Coupled, OwnClock};
use course::Course;

use crate::clock::Shortened;
use crate::interface::{BoundaryDriven, Wetted};
use crate::record::Balance;
use crate::several::{Interaction, Interactions};
use crate::step::Work;

/// A fluid and the structures in it, marched as one system: a step of the fluid is one or more steps of each structure.
///
/// Numbers of particles run through the fluid, then through the structures in their order. Structures that do something to each other
/// ([`TwoClocks::with_interactions`], [`TwoClocks::with_bracing`]) take the same steps, all of them.
pub struct TwoClocks<F, S: ?Sized> {
    fluid: F,
    structures: Vec<Coupled>,
    bodies: Vec<Box<S>>,
    interactions: Interactions,
    bracing: Option<Box<dyn Bracing<S>>>,
    /// What structures did to each other since it was last counted \[F L\].
    between: Work,
    /// Fraction of the stable steps that is used.
    safety: f64,
    slowed: Shortened,
    /// Who moves first in a step.
    pub order: Order,
    /// Whether the load on a structure changes while its wet faces move within a step, by the pressure of a plane wave.
    pub impedance: bool,
    /// Whether a structure of several steps takes the load of their mean instant, which follows from the last two
    /// loads. One that stays as it was at the start lags by half a step of the fluid, and lets the energy grow.
    pub centred: bool,
    counts: Counts,
}

/// Who moves first in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case"),
    schemars(rename = "CouplingOrder")
)]
pub enum Order {
    /// The structures, under the loads of the start of the step: the fluid follows their velocity over the step.
    #[default]
    StructureFirst,
    /// The fluid, with the velocity of the step before: the published order. The pressure then answers a motion too late, and feeds
    /// energy into light structures, whose periods are a few steps of the fluid.
    FluidFirst,
}

/// What the clocks did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Steps of all structures.
    pub substeps: u64,
    /// Most steps of a structure within one of the fluid.
    pub most: u64,
    /// Steps that were shortened because a boundary moved fast.
    pub shortened: u64,
}

impl<F: BoundaryDriven, S: Wetted + ?Sized> TwoClocks<F, S> {
    /// Puts structures into a fluid that was built with their boundaries, in the same order.
    pub fn new(mut fluid: F, bodies: Vec<Box<S>>) -> Self {
        let structures: Vec<_> = bodies.iter().map(|body| Coupled::new(&**body)).collect();
        for (number, structure) in structures.iter().enumerate() {
            let (place, velocities) = structure.start();
            fluid.set_boundary(number, place, velocities);
        }
        Self {
            fluid,
            structures,
            bodies,
            interactions: Interactions::default(),
            bracing: None,
            between: Work::default(),
            safety: 1.0,
            slowed: Shortened::default(),
            order: Order::default(),
            impedance: true,
            centred: true,
            counts: Counts::default(),
        }
    }

    /// Lets structures act on each other; particles of each interaction ascend.
    #[must_use]
    pub fn with_interactions(mut self, interactions: Vec<Box<dyn Interaction>>) -> Self {
        self.interactions = Interactions::new(interactions);
        self
    }

    /// Holds structures together by exact constraints.
    #[must_use]
    pub fn with_bracing(mut self, bracing: Option<Box<dyn Bracing<S>>>) -> Self {
        self.bracing = bracing;
        self
    }

    /// The constraints between structures.
    pub fn bracing(&self) -> Option<&dyn Bracing<S>> {
        self.bracing.as_deref()
    }

    /// What structures do to each other.
    pub fn interactions(&self) -> &Interactions {
        &self.interactions
    }

    /// Takes up what each interaction kept with a state, after the structures have taken it up; false if it is that of others.
    pub fn take_up(&mut self, kept: &[&[f64]]) -> bool {
        self.interactions.take_up(&self.bodies, kept)
    }

    /// The fluid.
    pub fn fluid(&self) -> &F {
        &self.fluid
    }

    /// The fluid, to be changed.
    pub fn fluid_mut(&mut self) -> &mut F {
        &mut self.fluid
    }

    /// The structures, in their order.
    pub fn structures(&self) -> impl ExactSizeIterator<Item = &S> {
        self.bodies.iter().map(|body| &**body)
    }

    /// The structures, to be changed.
    pub fn structures_mut(&mut self) -> impl ExactSizeIterator<Item = &mut S> {
        self.bodies.iter_mut().map(|body| &mut **body)
    }

    /// Energies of a structure \[F L\], its loads those of the fluid among them: at a record all at its instant; else up to the
    /// last step, the kinetic and the stored one where they were last found. None for a structure there is not.
    pub fn energy(&self, structure: usize) -> Option<Balance> {
        self.structures.get(structure).map(|structure| structure.energy)
    }

    /// Impulse by which a structure is ahead of the fluid \[F T; F T/L in a plane problem\]: its velocities stand half a step
    /// of its own behind its place, those of the fluid half a step of the fluid. Momenta of the fluid and the structures
    /// less this impulse are kept where nothing else acts. None for a structure there is not.
    pub fn impulse_ahead(&self, structure: usize) -> Option<[f64; 3]> {
        self.structures.get(structure).map(Coupled::impulse_ahead)
    }

    /// Steps of structures that were made shorter than their stable ones, because something came.
    pub fn slowed(&self) -> Shortened {
        self.slowed
    }

    /// What the clocks did so far.
    pub fn counts(&self) -> Counts {
        self.counts
    }
}

/// Numbers of a structure beside its velocities.
const LEDGER: usize = 12;

impl<F: BoundaryDriven, S: Wetted + ?Sized> TwoClocks<F, S> {
    /// All that changes here while it marches, beside the states of the fluid and of the structures: counts, clocks,
    /// counts, velocities of the boundaries, and the impulses that are under way.
    pub fn state(&self) -> Vec<f64> {
        let Counts { substeps, most, shortened } = self.counts;
        let mut numbers = vec![substeps as f64, most as f64, shortened as f64];
        let Shortened { steps, least, time } = self.slowed;
        numbers.extend([steps as f64, least, time, self.between.external, self.between.dissipated]);
        for structure in &self.structures {
            let OwnClock { stable, steps, next_estimate, last, count, whole } = structure.clock;
            let Work { external: owed, dissipated: lost, .. } = structure.pending;
            let Balance { kinetic, internal, external, dissipated } = structure.energy;
            let clock = [stable, steps as f64, next_estimate as f64, last, count as f64, whole];
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
        let Some(([substeps, most, shortened, slowed @ ..], mut rest)) = numbers.split_first_chunk::<8>()
        else {
            return false;
        };
        let length = |structure: &Coupled| LEDGER + 9 * structure.velocities.len();
        if rest.len() != self.structures.iter().map(length).sum::<usize>() {
            return false;
        }
        let counts = [substeps, most, shortened].map(|&number| number as u64);
        self.counts = Counts { substeps: counts[0], most: counts[1], shortened: counts[2] };
        let [steps, least, time, external, dissipated] = *slowed;
        self.slowed = Shortened { steps: steps as u64, least, time };
        self.between = Work { external, dissipated, ..Work::default() };
        for structure in &mut self.structures {
            let points = structure.velocities.len();
            let Some((ledger, behind)) = rest.split_first_chunk::<LEDGER>() else { return false };
            let [
                stable,
                steps,
                next,
                last,
                count,
                whole,
                owed,
                lost,
                kinetic,
                internal,
                external,
                dissipated,
            ] = *ledger;
            let [steps, next_estimate, count] = [steps, next, count].map(|number| number as u64);
            structure.clock = OwnClock { stable, steps, next_estimate, last, count, whole };
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
