//! Analyses without time: the linear answer, equilibria at levels, paths by arc length, vibration and buckling modes.

pub use implicit_statics::{Branches, Damping as RelaxationDamping, Prebuckling, Sign as LevelSign};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::combination::Combination;
use super::levels::Levels;
use crate::scene::bounded::{
    GradientIterations, Iterations, Modes, NotNegative, Positive, RelaxationIterations, RelaxedResidual,
    Residual, Steps,
};

/// Equilibria at load levels, by Newton's method.
///
/// A `moved` support makes it displacement control: its particle goes to `by × level`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Static {
    /// Load levels to stop at.
    pub levels: Levels,
    /// Residual over load at which an equilibrium counts as found \[–\].
    #[serde(default = "usual_tolerance")]
    pub tolerance: Residual,
    /// Iterations allowed before the way to a level is cut in halves.
    #[serde(default = "usual_iterations")]
    pub iterations: Iterations,
    /// Makes one linear answer of each level and lets what is out of balance go into the next; how far each is from its equilibrium is reported.
    /// For comparison with incremental schemes that do not iterate. `tolerance` and `iterations` then count for a preload alone.
    #[serde(default)]
    pub one_solve: bool,
}

/// The linear answer of the unloaded shell to the loads, or to the `moved` support, at level one; with load cases (`case` of loads and motions) one
/// to each, by one factor.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Linear {
    /// How the tangent is solved.
    #[serde(default)]
    pub solver: LinearSolver,
    /// Iterations allowed to conjugate gradients; left out, 5000.
    pub iterations: Option<GradientIterations>,
    /// Combinations of load cases, an answer each after those of the cases.
    #[serde(default)]
    pub combinations: Vec<Combination>,
}

/// How a linear answer is solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LinearSolver {
    /// By a factor of the tangent: the fastest as long as it finds room.
    #[default]
    Direct,
    /// Of a shell, by conjugate gradients with multigrid, in half of the memory at 10⁵ particles and less beyond: some twenty iterations
    /// where particles stand no farther apart than the shell is thick, and some sixteen for each thickness beyond.
    ConjugateGradients,
}

/// A path of equilibria past limit and turning points; ends by exactly one of `until` and `stop`.
///
/// With a `moved` support the load is a force along the motion and the level is that force \[F\].
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ArcLength {
    /// Largest level, met exactly.
    pub until: Option<Positive>,
    /// A column of the curve that ends the path.
    pub stop: Option<Stop>,
    /// First step: what a linear answer to this part of the full load (or of `by`) would be \[–\].
    #[serde(default = "usual_radius")]
    pub radius: Positive,
    /// Steps allowed.
    #[serde(default = "usual_steps")]
    pub steps: Steps,
    /// Residual over load at which an equilibrium counts as found \[–\].
    #[serde(default = "usual_tolerance")]
    pub tolerance: Residual,
    /// Iterations allowed before a step is cut in halves.
    #[serde(default = "usual_iterations")]
    pub iterations: Iterations,
    /// Which branch is taken where the path bifurcates.
    #[serde(default)]
    pub branches: Branches,
}

/// Ends a path when a column of its curve exceeds a bound.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stop {
    /// Name of the column.
    pub column: String,
    /// The path ends at the first point above this.
    pub above: f64,
}

/// Equilibria at load levels by dynamic relaxation: a damped motion in a time of its own, without factorisations.
///
/// Masses are those for which a step of one is stable, from the row sums of the tangent.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Relaxation {
    /// Load levels to stop at.
    pub levels: Levels,
    /// Residual over load at which an equilibrium counts as found \[–\].
    #[serde(default = "relaxed")]
    pub tolerance: RelaxedResidual,
    /// Residual that is small enough at any level, whatever the load; of the two bounds the greater counts \[F\].
    #[serde(default)]
    pub force: NotNegative,
    /// How the motion dies.
    #[serde(default)]
    pub damping: RelaxationDamping,
    /// Iterations allowed to a level.
    #[serde(default = "usual_relaxation")]
    pub iterations: RelaxationIterations,
}

/// Modes of free vibration of the unloaded shell, or of the preloaded one; `moved` supports stand still.
///
/// Rigid motions that no support holds are modes too, of frequency zero within rounding.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Modal {
    /// Number of modes, the lowest ones.
    pub modes: Modes,
}

/// Buckling levels, linearised about the unloaded shell, or about the preloaded one: `(K + μ K_g) φ = 0`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Buckling {
    /// Number of modes, those of the levels nearest to zero.
    pub modes: Modes,
    /// On which side of zero the levels lie.
    #[serde(default)]
    pub sign: LevelSign,
    /// What K_g = dK/dλ holds of the state before buckling.
    #[serde(default)]
    pub prebuckling: Prebuckling,
}

impl Static {
    /// Equilibria at these levels, all else as it usually is.
    pub fn at(levels: Levels) -> Self {
        Self { levels, tolerance: usual_tolerance(), iterations: usual_iterations(), one_solve: false }
    }
}

/// As Newton's method has it.
fn usual_tolerance() -> Residual {
    Residual::usual(implicit_statics::NewtonOptions::default().tolerance)
}

/// What a relaxation reaches in sensible time.
fn relaxed() -> RelaxedResidual {
    RelaxedResidual::usual(1e-6)
}

/// Thin shells take some ten thousand.
fn usual_relaxation() -> RelaxationIterations {
    RelaxationIterations::usual(100_000)
}

/// A thin strip that rolls up takes some fifteen an eighth of a turn: its tangent holds the stretch of the last guess.
fn usual_iterations() -> Iterations {
    Iterations::usual(30)
}

/// A twentieth of the load: steps adapt from there on.
fn usual_radius() -> Positive {
    Positive::usual(0.05)
}

fn usual_steps() -> Steps {
    Steps::usual(1000)
}

/// Temperatures of a shell that conducts heat along its mid-surface, in balance: `{}`, or in time. What holds and heats it stands in `[[heat]]`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Heat {
    /// Temperatures in time, from a start; left out, they are those in balance.
    pub transient: Option<HeatInTime>,
}

/// Temperatures in time, by steps that an estimate of their error chooses: halves of `record_every`, halves of those, and so on.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeatInTime {
    /// Temperature of the whole shell at the start; left out, the temperatures in balance under what is given at that time \[Θ\].
    pub start: Option<f64>,
    /// Length of the run \[T\].
    pub duration: Positive,
    /// Time between rows of the curve \[T\].
    pub record_every: Positive,
    /// What a step may be off by at any particle, by its estimate \[Θ\]; the column `step_error` has the sum of all.
    pub tolerance: Positive,
}
