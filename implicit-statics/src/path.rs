//! What a path of equilibria is: its points, its critical points, what was passed, and where it can be continued.

use crate::{Breach, Converged, Effort, EquilibriumError, Increment, Inertia};

/// Where a path starts: the present state of the system at a level.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Start {
    /// Level of the present state \[–\].
    pub level: f64,
    /// The increment that led here: gives arc length its direction and first radius, steps of load and displacement the
    /// bend of their path.
    pub heading: Option<Increment>,
    /// Stiffness that each unknown first had on the path, its unit in the factor \[F/L, F L\]; none where a path begins.
    pub stiffness: Option<Vec<f64>>,
}

/// A converged point of a path.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Number, 0 at the start.
    pub step: usize,
    /// Level, iterations, residuals and inertia.
    pub converged: Converged,
    /// Step size that led here: level, functional or arc length.
    pub size: f64,
    /// Trials that failed before.
    pub restarts: usize,
    /// Directions in which the equilibrium is unstable under the control: negative pivots; where a displacement is
    /// given by a force along it, less the one that it holds.
    pub unstable: usize,
    /// What was factorised and solved since the point before, for trials that failed and critical points on the way too.
    pub effort: Effort,
}

impl Point {
    /// Load level \[–\].
    pub fn level(&self) -> f64 {
        self.converged.level
    }

    /// Inertia of the tangent.
    pub fn inertia(&self) -> Inertia {
        self.converged.inertia
    }
}

/// Why a path ended well.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// The bound of the control was met.
    Reached,
    /// The observer stopped it.
    Stopped,
    /// The allowed number of steps was made.
    Steps,
}

/// A path as far as it went; the system stands at its last converged point.
#[derive(Debug, Clone)]
pub struct Path {
    /// Converged points, the start first.
    pub points: Vec<Point>,
    /// Critical points located, in order.
    pub critical: Vec<CriticalPoint>,
    /// What was passed without being located.
    pub passages: Vec<Passage>,
    /// What broke on the way, set by set.
    pub breaches: Vec<Breach>,
    /// Whence it can be continued.
    pub restart: Start,
    /// How it ended.
    pub end: Result<End, EquilibriumError>,
}

impl Path {
    /// Nothing yet.
    pub(crate) fn new(start: &Start) -> Self {
        Self {
            points: Vec::new(),
            critical: Vec::new(),
            passages: Vec::new(),
            breaches: Vec::new(),
            restart: start.clone(),
            end: Ok(End::Steps),
        }
    }

    /// What its points after the first took: what the first needs, a path that goes on has at hand or makes anew.
    pub fn effort(&self) -> Effort {
        let mut sum = Effort::default();
        self.points.iter().skip(1).for_each(|point| sum.add(&point.effort));
        sum
    }
}

/// What kind a critical point is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CriticalKind {
    /// The level is stationary: `∂external/∂λ · mode ≠ 0` \[wriggers1990\].
    Limit,
    /// Another branch crosses: the load does no work in the mode.
    Bifurcation,
}

/// A point where the tangent is singular.
#[derive(Debug, Clone, PartialEq)]
pub struct CriticalPoint {
    /// The path's step in which it lies.
    pub step: usize,
    /// Load level, interpolated to where the eigenvalue vanishes \[–\].
    pub level: f64,
    /// Limit point or bifurcation.
    pub kind: CriticalKind,
    /// `|p·φ| / (‖p‖ ‖φ‖)` (0 where p vanishes) with norms scaled by the diagonal stiffness: 0 … 1, the same in any unit.
    pub participation: f64,
    /// Whether the path went over to the branch that leaves here.
    pub left: bool,
    /// Critical mode φ, its largest entry 1.
    pub mode: Vec<f64>,
    /// Negative pivots before and after.
    pub negative: (usize, usize),
    /// State at the near end of the last bracket, for [`crate::Equilibrium::restore`].
    pub state: Vec<f64>,
    /// Level of that state \[–\].
    pub state_level: f64,
}

/// A part of a path over which something critical was passed that no [`CriticalPoint`] tells of.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage {
    /// The path's step.
    pub step: usize,
    /// Levels at its ends \[–\].
    pub levels: (f64, f64),
    /// Negative pivots at its ends.
    pub negative: (usize, usize),
    /// What was passed.
    pub what: Passed,
}

/// What a [`Passage`] went over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Passed {
    /// Critical points that were bracketed but not located: the number of negative pivots changes.
    Pivots,
    /// The branch of the first end turns back at about this level; the other end lies on another.
    Turn(f64),
    /// Small steps end by this share of the way beside the state found, of a system that remembers its steps.
    Steps(f64),
    /// The branch of the first end goes on to another state; the second lies on another branch.
    Branch,
    /// The step is far from its tangents, and the branch of its first end could not be followed: the other end may lie
    /// on another.
    Unproved,
}
