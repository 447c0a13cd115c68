//! Further results: a plot, frames of fields, checkpoints, errors.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::Positive;
use crate::scene::criterion::Criterion;

/// Further results.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Output {
    /// Columns of the plot `curve.svg`.
    pub plot: Option<Plot>,
    /// Frames for ParaView, in the folder `fields`.
    pub fields: Option<Fields>,
    /// Whether `summary.json` has, of each measured column over a transient run, mean, root mean square, integral, least and greatest with their times.
    #[serde(default)]
    pub over_time: bool,
    /// Longest wall time between checkpoints, from which `coque resume` goes on \[s\]; none are kept without.
    pub checkpoint_every: Option<Positive>,
}

/// Which frames are written, and what stands in them beside the motion of the particles.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fields {
    /// Every N-th settled level, record in time, converged point or mode; the first always.
    #[serde(default = "each")]
    pub every: u64,
    /// Shells with their thickness as well, in files of their own.
    #[serde(default)]
    pub extruded: bool,
    /// The quadrature points of a Galerkin solid as well, in files of their own.
    #[serde(default)]
    pub points: bool,
    /// Strains, resultants and, of homogeneous sections, surface stresses at the sampling points.
    #[serde(default)]
    pub stresses: bool,
    /// What the particles of shells feel of contact: pressure, friction, depth, and whether they stick (1) or slip (2).
    #[serde(default)]
    pub contact: bool,
    /// Principal stresses with their directions, and Tresca's stress: at both faces and the middle of homogeneous shells, at the nodes of solids.
    #[serde(default)]
    pub principal: bool,
    /// Stresses of a shell at its particles, edges among them, from those at the middles of the cells round each: resultants, of homogeneous sections
    /// stresses of both faces, with `principal` principal ones.
    #[serde(default)]
    pub recovered: bool,
    /// Stresses of each ply of a shell in the axes of its fibre, at its lower and its upper face.
    #[serde(default)]
    pub plies: bool,
    /// Reserve factors and failure indices of a shell by a criterion, and the number of the ply of least reserve; with `plies` the reserve factor of each
    /// as well.
    pub reserve: Option<Criterion>,
    /// Of a scene with load cases four frames more, behind those of the cases, with each number of each field over the combinations, else over the cases: the
    /// least, the greatest, the greatest size (of reserve factors the least), and the number of the case that has it.
    #[serde(default)]
    pub envelope: bool,
}

impl Fields {
    /// Whether it wants anything of strains and stresses.
    pub(crate) fn shows_stresses(self) -> bool {
        self.stresses || self.principal || self.recovered || self.plies || self.reserve.is_some()
    }

    /// Every frame, with the motion of the particles alone.
    pub const MOTION: Self = Self {
        every: 1,
        extruded: false,
        points: false,
        stresses: false,
        contact: false,
        principal: false,
        recovered: false,
        plies: false,
        reserve: None,
        envelope: false,
    };
}

/// The error of every number, from runs on coarser lattices, finer where there are none: in `curve.csv` beside each column, as a band in the plot,
/// in `summary.json`.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ErrorBars {
    /// Runs a lattice of half the spacing as well, of a linear answer, of modes and of the last level of a static analysis, which begins at that
    /// of the run: its numbers come with a bar that is hardly larger than their error, and corrected by it.
    #[serde(default)]
    pub sharpen: bool,
    /// What other lattices do not show: one run each, on the coarsest lattice, with that one number of the method changed. What it changes of each
    /// measured number is said beside the bar.
    #[serde(default)]
    pub probes: Vec<ErrorProbe>,
}

/// A number of the method that a run is made with another value of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ErrorProbe {
    /// Half the time step, of a march.
    Step,
    /// A tenth of what may be missing from rest, of a quasi-static march and of a relaxation.
    Rest,
    /// Half the first arc, of a path by arc length.
    Arc,
    /// Twice the records, of a transient march.
    Records,
    /// A horizon of a third more spacings, of bonds.
    Horizon,
    /// Shape functions of a fifth more support, of Galerkin solids.
    Support,
    /// A sound speed 1.41 times as high, of a fluid.
    SoundSpeed,
    /// A smoothing length a tenth larger, of a fluid.
    Smoothing,
}

/// Which column is drawn over which.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Plot {
    /// Column along the horizontal axis.
    pub x: String,
    /// Column along the vertical axis.
    pub y: String,
    /// Whether the horizontal axis goes by powers of ten; values that are not above zero are left out.
    #[serde(default)]
    pub log_x: bool,
    /// The same of the vertical axis.
    #[serde(default)]
    pub log_y: bool,
}

impl ErrorProbe {
    /// Its name in a scene.
    pub fn word(self) -> &'static str {
        match self {
            Self::Step => "step",
            Self::Rest => "rest",
            Self::Arc => "arc",
            Self::Records => "records",
            Self::Horizon => "horizon",
            Self::Support => "support",
            Self::SoundSpeed => "sound-speed",
            Self::Smoothing => "smoothing",
        }
    }
}

fn each() -> u64 {
    1
}
