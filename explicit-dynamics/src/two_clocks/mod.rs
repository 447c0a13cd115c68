//! A fluid and the structures in it, each at a clock of its own.

mod coupled;
mod march;
mod state;

use crate::interface::{BoundaryDriven, Wetted};
use crate::record::Balance;
use coupled::Coupled;

/// A fluid and the structures in it, marched as one system: a step of the fluid is one or more steps of each structure.
///
/// Numbers of particles run through the fluid, then through the structures in their order.
pub struct TwoClocks<F, S: ?Sized> {
    fluid: F,
    structures: Vec<Coupled<S>>,
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
    pub fn new(mut fluid: F, structures: Vec<Box<S>>) -> Self {
        let structures: Vec<_> = structures.into_iter().map(Coupled::new).collect();
        for (number, structure) in structures.iter().enumerate() {
            let (place, velocities) = structure.start();
            fluid.set_boundary(number, place, velocities);
        }
        Self {
            fluid,
            structures,
            order: Order::default(),
            impedance: true,
            centred: true,
            counts: Counts::default(),
        }
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
        self.structures.iter().map(|structure| &*structure.body)
    }

    /// The structures, to be changed.
    pub fn structures_mut(&mut self) -> impl ExactSizeIterator<Item = &mut S> {
        self.structures.iter_mut().map(|structure| &mut *structure.body)
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

    /// What the clocks did so far.
    pub fn counts(&self) -> Counts {
        self.counts
    }
}
