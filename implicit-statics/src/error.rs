//! What can go wrong on the way to an equilibrium, with the repair.

use crate::{Equilibrium, bounds::OutOfBounds};

/// Why a balance was not found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum EquilibriumError {
    /// The list of tangent entries is not a lower triangle with its whole diagonal, each entry once.
    #[error(
        "tangent pattern: entry ({row}, {column}) of {unknowns} unknowns is {what}; list the lower triangle with the whole diagonal, each entry once"
    )]
    Pattern {
        /// Row of the offending entry.
        row: usize,
        /// Its column.
        column: usize,
        /// Size of the system.
        unknowns: usize,
        /// What is wrong with it.
        what: &'static str,
    },
    /// An option or argument is out of its bounds.
    #[error("{name} is {value}, must be {bound}")]
    Option {
        /// Name of the option.
        name: &'static str,
        /// Value given.
        value: f64,
        /// What is allowed.
        bound: &'static str,
    },
    /// A vector handed over has the wrong length.
    #[error("{name} has {length} entries, must have {expected}")]
    Length {
        /// Name of the vector.
        name: &'static str,
        /// Length given.
        length: usize,
        /// Length wanted.
        expected: usize,
    },
    /// A value of the tangent is infinite or not a number.
    #[error("tangent value at ({row}, {column}) is not finite; take a smaller step from a sound state")]
    Tangent {
        /// Row of the entry.
        row: usize,
        /// Its column.
        column: usize,
    },
    /// The tangent has eigenvalues that vanish within rounding.
    #[error(
        "singular tangent: {zero} eigenvalues vanish, the free motion is largest in unknown {unknown} ({share:.3} of its norm); support it"
    )]
    Singular {
        /// How many eigenvalues vanish.
        zero: usize,
        /// Unknown with the largest share in the null direction.
        unknown: usize,
        /// Its share of the norm of the null direction, row-scaled.
        share: f64,
    },
    /// The same with the name that the system gives to the unknown.
    #[error(
        "step {step}, load level {level:.6e}: the structure moves freely, mostly in {name} ({share:.3} of the motion, {zero} free motions in all); support it or leave the critical point with another step"
    )]
    Mechanism {
        /// Step of the path.
        step: usize,
        /// Load level.
        level: f64,
        /// How many motions are free.
        zero: usize,
        /// Name of the unknown that moves most.
        name: String,
        /// Its index.
        unknown: usize,
        /// Its share of the norm of the motion.
        share: f64,
    },
    /// A solve left a residual above its bound: pivoting inside supernodes did not suffice.
    #[error(
        "linear solve left a residual of {residual:.3e} against the bound {bound:.3e}; saddle points are not for this solver: eliminate constraints"
    )]
    Solve {
        /// ‖Kx − b‖.
        residual: f64,
        /// What was allowed.
        bound: f64,
    },
    /// Newton did not converge.
    #[error(
        "step {step}, load level {level:.6e}: residual {residual:.3e} above the bound {bound:.3e} after {iterations} iterations; take a smaller step or allow more iterations"
    )]
    NotConverged {
        /// Step of the path.
        step: usize,
        /// Load level of the last iterate.
        level: f64,
        /// Iterations made.
        iterations: usize,
        /// Last residual norm \[F\].
        residual: f64,
        /// Bound it had to reach \[F\].
        bound: f64,
        /// Residual norms from the first iterate on \[F\].
        residuals: Vec<f64>,
    },
    /// Dynamic relaxation did not bring forces to balance.
    #[error(
        "load level {level:.6e}: residual {residual:.3e} above the bound {bound:.3e} after {iterations} iterations of dynamic relaxation; allow more iterations, take a smaller step of the level, or use Newton's method"
    )]
    NotRelaxed {
        /// Load level sought.
        level: f64,
        /// Iterations made.
        iterations: usize,
        /// Last residual norm \[F\].
        residual: f64,
        /// Bound it had to reach \[F\].
        bound: f64,
    },
    /// Dynamic relaxation led out of what the model covers.
    #[error(
        "load level {level:.6e}: after {iterations} iterations of dynamic relaxation {found}; take a smaller step of the level"
    )]
    Strayed {
        /// Load level sought.
        level: f64,
        /// Iterations made.
        iterations: usize,
        /// What is out of bounds.
        found: OutOfBounds,
    },
    /// Whoever watches ended a dynamic relaxation.
    #[error(
        "load level {level:.6e}: ended after {iterations} iterations of dynamic relaxation, at a residual of {residual:.3e}"
    )]
    Ended {
        /// Load level sought.
        level: f64,
        /// Iterations made.
        iterations: usize,
        /// Residual norm then \[F\].
        residual: f64,
    },
    /// A force is infinite or not a number.
    #[error("step {step}, load level {level:.6e}: the force on {name} is not finite; take a smaller step")]
    Force {
        /// Step of the path.
        step: usize,
        /// Load level.
        level: f64,
        /// Name of the unknown.
        name: String,
    },
    /// The functional of displacement control does not move with the load.
    #[error(
        "step {step}, load level {level:.6e}: the controlled displacement does not answer to the load (rate {rate:.3e}); control another displacement or the arc length"
    )]
    Uncontrolled {
        /// Step of the path.
        step: usize,
        /// Load level.
        level: f64,
        /// c·K⁻¹p.
        rate: f64,
    },
    /// A load-controlled step landed on the falling side of a limit point.
    #[error(
        "step {step}, load level {level:.6e}: the step leapt over a limit point (the response turned by {cosine:.2} in cosine, must stay above 0); go on with displacement or arc-length control"
    )]
    Fold {
        /// Step of the path.
        step: usize,
        /// Load level tried.
        level: f64,
        /// Cosine between the step and the response to the load after it.
        cosine: f64,
    },
    /// Forces balance in a state that the model does not cover.
    #[error(
        "step {step}, load level {level:.6e}: forces balance, but {found}; take a smaller step or less load"
    )]
    OutOfBounds {
        /// Step of the path.
        step: usize,
        /// Load level.
        level: f64,
        /// What is out of bounds.
        found: OutOfBounds,
    },
    /// Repeated halving brought the step below its least size.
    #[error(
        "step {step}, load level {level:.6e}: step size {size:.3e} fell below {smallest:.3e}; the last converged state is kept; try arc-length control, a smaller first step or a looser tolerance"
    )]
    StepTooSmall {
        /// Step of the path.
        step: usize,
        /// Load level of the last converged point.
        level: f64,
        /// Size reached, in the unit of the control.
        size: f64,
        /// Least size allowed.
        smallest: f64,
        /// Why the last trial failed.
        #[source]
        cause: Box<EquilibriumError>,
    },
    /// What broke at its limit leaves no balance behind.
    #[error(
        "step {step}, load level {level:.6e}: no balance was found without what broke there: breaking goes on by itself and the level is the greatest that the body bears, or a part hangs loose, as the cause says; prescribe a motion instead of a load, take a wider horizon, or march in time"
    )]
    GaveWay {
        /// Step of the path.
        step: usize,
        /// Load level.
        level: f64,
        /// How the search for a balance ended.
        #[source]
        cause: Box<EquilibriumError>,
    },
    /// No equilibrium was found on the branch that leaves a bifurcation.
    #[error(
        "step {step}, load level {level:.6e}: no equilibrium was found on the branch that leaves the bifurcation there; take smaller steps, or stay on the path and bend the body a little along the mode"
    )]
    NoBranch {
        /// Step of the path.
        step: usize,
        /// Load level of the bifurcation.
        level: f64,
        /// Why the last trial failed, if it did not end on another branch.
        #[source]
        cause: Option<Box<EquilibriumError>>,
    },
    /// Conjugate gradients did not converge.
    #[error(
        "conjugate gradients left {residual:.3e} of the load's energy norm after {iterations} iterations, must be below {bound:.1e}; allow more iterations, or use the direct solver"
    )]
    NotIterated {
        /// Iterations made.
        iterations: usize,
        /// Residual over load, both in the norm of the preconditioner.
        residual: f64,
        /// Bound it had to reach.
        bound: f64,
    },
    /// A direction without stiffness, or against it, in a solution that needs a positive definite tangent.
    #[error(
        "conjugate gradients found a motion without stiffness ({found}): supports are missing, or the state is not stable; the direct solver names the motion"
    )]
    Indefinite {
        /// Where it was found.
        found: &'static str,
    },
    /// The system does not tell its rigid motions, on which coarser unknowns are built.
    #[error(
        "this system does not tell its rigid motions, which conjugate gradients need; use the direct solver"
    )]
    NoRigidMotions,
    /// A tangent with terms beside its pattern, in a solution that has no place for them.
    #[error(
        "{what} takes tangents of a sparse pattern alone, and what this system encloses couples all that encloses it; {instead}, or take a pressure in place of what is enclosed"
    )]
    BesidePattern {
        /// The solution.
        what: &'static str,
        /// What to do instead.
        instead: &'static str,
    },
    /// Eigenpairs did not converge.
    #[error(
        "{found} of {wanted} eigenpairs converged (error bound {residual:.3e}, must be below {bound:.1e}); ask for fewer modes"
    )]
    Modes {
        /// How many converged.
        found: usize,
        /// How many were sought: those wanted, and those that lie among them.
        wanted: usize,
        /// Worst error bound among them, relative to the eigenvalue.
        residual: f64,
        /// What it must be.
        bound: f64,
    },
    /// The inertia of the tangent contradicts the eigenpairs found.
    #[error(
        "{found} eigenpairs were found where the inertia counts {counted}: the tangent is too ill-conditioned to tell; take a thicker shell or fewer particles"
    )]
    Miscounted {
        /// How many were found.
        found: usize,
        /// How many there are by the signs of the pivots.
        counted: usize,
    },
    /// Whoever watches ended the search.
    #[error("ended after {solves} solves")]
    Stopped {
        /// Solves made.
        solves: usize,
    },
    /// Nothing damps a steady vibration at a natural frequency.
    #[error(
        "the circular frequency {omega:.10e} is a natural one, and nothing damps the vibration, which grows without end; give the damping, or leave this frequency out"
    )]
    Resonance {
        /// Circular frequency \[1/T\].
        omega: f64,
    },
    /// No critical level has the sign asked for.
    #[error(
        "the load stretches the structure: no load level from the present one to {searched:.3e} buckles it{}",
        other.map_or(String::new(), |other| format!("; the nearest of the other sign is {other:.6e}"))
    )]
    Stretched {
        /// How far levels were counted, by inertia.
        searched: f64,
        /// The nearest critical level of the other sign, if there is any.
        other: Option<f64>,
    },
    /// The system cannot tell its stresses from its displacements.
    #[error(
        "this system offers no tangent under given stresses; use the derivative along the whole response"
    )]
    Inseparable,
    /// The state from which buckling is extrapolated is not stable.
    #[error(
        "linearised buckling from load level {level:.6e}: {negative} negative pivots there; start below the first critical load"
    )]
    Unstable {
        /// Load level of the base state.
        level: f64,
        /// Negative pivots of its tangent.
        negative: usize,
    },
    /// The load does not change the tangent.
    #[error(
        "linearised buckling from load level {level:.6e}: the load rate of norm {load:.3e} does not change the tangent (relative change {change:.3e}); check the load"
    )]
    NoPrestress {
        /// Load level of the base state.
        level: f64,
        /// Norm of the load rate \[F\].
        load: f64,
        /// Relative change of the tangent found.
        change: f64,
    },
}

impl EquilibriumError {
    /// Gives a singular tangent the name of its free motion, the step and the level; leaves other errors alone.
    pub fn named<E: Equilibrium + ?Sized>(self, system: &E, step: usize, level: f64) -> Self {
        match self {
            Self::Singular { zero, unknown, share } => {
                Self::Mechanism { step, level, zero, name: system.name_unknown(unknown), unknown, share }
            }
            other => other,
        }
    }
}

/// Bounds check shared by the options.
pub(crate) fn require(
    holds: bool,
    name: &'static str,
    value: f64,
    bound: &'static str,
) -> Result<(), EquilibriumError> {
    if holds { Ok(()) } else { Err(EquilibriumError::Option { name, value, bound }) }
}
