//! Where a march stands between two steps: plain data from which it goes on as if it had never stopped.

use serde::{Deserialize, Serialize};

use crate::clock::Clock;
use crate::damping::KineticDamping;
use crate::error::MarchError;
use crate::rest::Sizes;

/// Where a march stands between two steps, beside the state of its system.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MarchState {
    /// Time, step size, energies counted so far.
    pub clock: Clock,
    /// Where on its way the march is.
    pub stage: Stage,
}

/// Where on its way a march is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Stage {
    /// [`crate::QuasiStatic`].
    QuasiStatic(LevelUnderWay),
    /// [`crate::Transient`].
    Transient {
        /// Number of the last record, from 0.
        record: u64,
        /// Steps after which the stable step is estimated anew.
        next_estimate: u64,
    },
}

/// A load level under way: its ramp, then its hold.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LevelUnderWay {
    /// Number of the level it goes to, or holds at, from 0.
    pub level: usize,
    /// When the ramp to it began \[T\].
    pub start: f64,
    /// Steps done when the ramp began.
    pub first_step: u64,
    /// Sizes of the answers so far.
    pub sizes: Sizes,
    /// The period it goes by: the one given, or the last one found \[T\].
    pub period: f64,
    /// When the motion is checked next, for its period or for rest \[T\].
    pub next_check: f64,
    /// Forces evaluated by checks since the ramp began.
    pub checked: u64,
    /// The hold, once the ramp is over.
    pub hold: Option<Hold>,
}

/// A hold under way: the load stays until the motion has died.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hold {
    /// When it began \[T\].
    pub start: f64,
    /// Checks in a row that found the motion dead.
    pub settled_checks: usize,
    /// Peaks of the kinetic energy.
    pub peaks: KineticDamping,
}

impl MarchState {
    /// Refuses the place of another march.
    pub(crate) fn other(&self) -> MarchError {
        MarchError::OtherMarch(match self.stage {
            Stage::QuasiStatic(LevelUnderWay { level, .. }) => {
                format!("level number {level} of a quasi-static march")
            }
            Stage::Transient { record, .. } => format!("record number {record} of a transient march"),
        })
    }
}
