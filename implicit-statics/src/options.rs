//! Options: Newton's method, paths and their control, critical points, dynamic relaxation.

use crate::error::require;
use crate::{Equilibrium, EquilibriumError};

/// How Newton iterates.
#[derive(Debug, Clone, PartialEq)]
pub struct NewtonOptions {
    /// Bound of ‖external − internal‖ relative to the largest of ‖external‖, ‖∂external/∂λ Δλ‖ (where no tool
    /// moves) and the internal forces of the states found so far; default 1e-9.
    ///
    /// Where rounding of the forces exceeds it (a thin shell is stiff against stretching, its load small), a
    /// residual that no longer falls while corrections are below 1e-8 of the way counts as converged.
    pub tolerance: f64,
    /// Iterations allowed; default 15.
    pub iterations: usize,
    /// Whether load-controlled steps that overshoot are shortened; default true.
    pub line_search: bool,
    /// Share of the residual before below which an iterate goes on with the factor at hand, where the system keeps factors
    /// ([`Equilibrium::keeps_factor`]); 0 gives every iterate its own. Default 0.03.
    pub keep: f64,
    /// Whether the tangent of each balance is factorised for its inertia, by which paths see critical points; else the inertia
    /// is that of the last factor, of an iterate near it, and zero where none was made. Default true.
    pub inertia: bool,
}

impl Default for NewtonOptions {
    fn default() -> Self {
        Self { tolerance: 1e-9, iterations: 15, line_search: true, keep: 0.03, inertia: true }
    }
}

/// What drives a path.
#[derive(Debug, Clone, PartialEq)]
pub enum Control {
    /// The level goes to `until` in steps of `step`; ends at the first limit point.
    Load {
        /// First change of level \[–\].
        step: f64,
        /// Last level, met exactly \[–\].
        until: f64,
    },
    /// The functional `c·Δq` of the increments goes to `until`; passes limit points, not turning points of `c·q`.
    Displacement {
        /// The unknowns and their weights `c`.
        functional: Vec<(usize, f64)>,
        /// First change of the functional \[its unit\].
        step: f64,
        /// Total change of the functional from the start, with its sign, met exactly \[its unit\].
        until: f64,
    },
    /// The spherical arc length; passes limit points and turning points \[crisfield1981\].
    ArcLength {
        /// Change of level of a linear first step; its sign is the first direction, its size the first radius.
        first: f64,
        /// The path ends when the level leaves this range; the bound that is crossed is met exactly \[–\].
        range: (f64, f64),
    },
}

/// How a path is followed.
#[derive(Debug, Clone, PartialEq)]
pub struct PathOptions {
    /// What drives the path.
    pub control: Control,
    /// How every step is corrected.
    pub newton: NewtonOptions,
    /// Steps grow or shrink by √(target/iterations), between halves and doubles; default 5.
    pub target_iterations: usize,
    /// Largest step in units of the first; default 10.
    pub largest: f64,
    /// Least step in units of the first, below which the path has failed; default 1e-6.
    pub smallest: f64,
    /// Steps allowed; default 1000.
    pub steps: usize,
    /// What the level counts in the arc length against the linear response to it at the start; default 1.
    pub load_share: f64,
    /// Whether steps are watched for what is critical: whether and how critical points are located where the number of
    /// negative pivots changes, and steps checked for having left their branch; default not.
    pub critical: Option<CriticalOptions>,
}

impl PathOptions {
    /// Defaults for a control.
    pub fn new(control: Control) -> Self {
        Self {
            control,
            newton: NewtonOptions::default(),
            target_iterations: 5,
            largest: 10.0,
            smallest: 1e-6,
            steps: 1000,
            load_share: 1.0,
            critical: None,
        }
    }

    pub(crate) fn check<E: Equilibrium + ?Sized>(&self, system: &E) -> Result<(), EquilibriumError> {
        let unknowns = system.unknowns();
        let first = match &self.control {
            Control::Load { step, .. } => *step,
            Control::Displacement { functional, step, .. } => {
                for &(unknown, _) in functional {
                    let inside = unknown < unknowns;
                    require(inside, "controlled unknown", unknown as f64, "below the number of unknowns")?;
                }
                *step
            }
            Control::ArcLength { first, range } => {
                require(range.0 < range.1, "range of levels, its upper bound", range.1, "above the lower")?;
                *first
            }
        };
        require(first != 0.0 && first.is_finite(), "first step", first, "finite and not zero")?;
        require(self.target_iterations > 0, "target iterations", 0.0, "one at least")?;
        require(self.largest >= 1.0, "largest step", self.largest, "one first step at least")?;
        require(
            self.smallest > 0.0 && self.smallest <= 1.0,
            "smallest step",
            self.smallest,
            "above 0 and at most one first step",
        )?;
        require(self.load_share >= 0.0, "load share", self.load_share, "not negative")
    }
}

/// Which branch a path takes where it bifurcates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case")
)]
pub enum Branches {
    /// The one it is on: a perfect body stays flat or straight beyond its critical load.
    #[default]
    Primary,
    /// Where a stable path loses its stability in one mode, the branch that leaves it along the mode, whose first greatest entry, each
    /// times the root of its mass, is positive: the body buckles without an imperfection. Limit points are passed, and unstable paths
    /// stay on their branch.
    Stable,
    /// The same branch to the other side, against the mode.
    StableReversed,
}

/// How critical points are located, and what is done there.
#[derive(Debug, Clone, PartialEq)]
pub struct CriticalOptions {
    /// Width of the last bracket in units of the step that crossed; default 1e-6.
    pub tolerance: f64,
    /// Participation of the load in the mode above which the point is a limit point; default 1e-4.
    pub participation: f64,
    /// Which branch is taken at bifurcations, by arcs alone: load and displacement go where they are prescribed; default
    /// [`Branches::Primary`].
    pub branches: Branches,
}

impl CriticalOptions {
    /// As they are on a path under a control: one that is only looked at stays on its branch, and so do steps of load and
    /// displacement.
    pub(crate) fn within(&self, control: &Control, kept: bool) -> Self {
        let free = kept && matches!(control, Control::ArcLength { .. });
        let branches = if free { self.branches } else { Branches::Primary };
        Self { branches, ..self.clone() }
    }
}

impl Default for CriticalOptions {
    fn default() -> Self {
        Self { tolerance: 1e-6, participation: 1e-4, branches: Branches::Primary }
    }
}

/// What takes the energy out of a fictitious motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case"),
    schemars(rename = "RelaxationDamping")
)]
pub enum Damping {
    /// The motion is stopped whenever its kinetic energy passes a peak.
    #[default]
    Kinetic,
    /// Mass-proportional, near critical for the lowest frequency that the motion shows, which Rayleigh's quotient finds.
    Rayleigh,
}

/// How equilibrium is relaxed.
#[derive(Debug, Clone, PartialEq)]
pub struct RelaxationOptions {
    /// Bound of ‖external − internal‖ relative to the larger of ‖external‖ and the forces that bring prescribed values
    /// about; default 1e-6.
    pub tolerance: f64,
    /// Residual that is small enough whatever acts, of two bounds the greater counts: where next to nothing acts the relative one asks
    /// for digits that forces do not have; default none, 0 \[F\].
    pub force: f64,
    /// Iterations allowed; default 100 000.
    pub iterations: usize,
    /// What takes the energy out; default kinetic.
    pub damping: Damping,
    /// Λ, masses over the least that Gerschgorin's bound allows; default 1.1.
    pub safety: f64,
    /// Iterations within which held values that move go from level to level; default 200.
    pub ramp: usize,
}

impl Default for RelaxationOptions {
    fn default() -> Self {
        Self {
            tolerance: 1e-6,
            force: 0.0,
            iterations: 100_000,
            damping: Damping::Kinetic,
            safety: 1.1,
            ramp: 200,
        }
    }
}
