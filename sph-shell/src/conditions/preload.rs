//! Load cases: a preload that is applied first and then held, and the loads of the analysis that goes on from there.
//!
//! A static shell is under one case at a time, and the level counts that one:
//!
//! | under way | preloads and preloaded motions | all others |
//! |---|---|---|
//! | [`LoadCase::Preload`] | level | 0 |
//! | [`LoadCase::Loading`], the usual | 1 | level |
//!
//! Follower preloads keep their stiffness in the tangent; the load rate is that of the case under way alone. Without a preload
//! the second row is all there is.

use crate::conditions::loads::{Block, Body, Load};
use crate::conditions::prescribed::{Motion, Rotation};
use crate::conditions::supports::{Holds, Support};
use crate::error::ShellError;
use crate::reference::Reference;

/// To which load case a load or a prescribed motion belongs, and which of them is under way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LoadCase {
    /// Applied first, in full, and held from then on.
    Preload,
    /// What the level of the analysis counts.
    #[default]
    Loading,
}

impl LoadCase {
    /// Factor of what belongs to this case at a level of the case that is under way \[–\].
    pub(crate) fn factor(self, under_way: Self, level: f64) -> f64 {
        match (self, under_way) {
            (Self::Preload, Self::Loading) => 1.0,
            (Self::Loading, Self::Preload) => 0.0,
            _ => level,
        }
    }
}

/// A load or a support whose motion belongs to the preload.
pub struct Preloaded<T>(pub T);

impl Load for Preloaded<Box<dyn Load>> {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        self.0.add(scale, body, forces);
    }

    fn stiffness(&self, scale: f64, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
        self.0.stiffness(scale, body, put);
    }

    fn check(&self, reference: &Reference) -> Result<(), ShellError> {
        self.0.check(reference)
    }

    fn case(&self) -> LoadCase {
        LoadCase::Preload
    }
}

impl Support for Preloaded<Box<dyn Support>> {
    fn holds(&self) -> Holds {
        let holds = self.0.holds();
        let motion = holds.motion.map(Motion::preloaded);
        let rotation = holds.rotation.map(|rotation| Rotation { case: LoadCase::Preload, ..rotation });
        Holds { motion, rotation, ..holds }
    }
}
