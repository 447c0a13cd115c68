//! Whether the states that a march settles at are stable: the negative pivots of their tangents.
//!
//! A march finds states of rest, and a perfect column beyond its critical load rests straight. Each negative pivot of
//! the tangent (Sylvester: each negative eigenvalue) is a direction in which the shell would leave such a state at the
//! least disturbance. Directions that a prescribed motion holds are held in the tangent.

use implicit_statics::{Equilibrium, Inertia, SymmetricSolver};
use sph_shell::{Formulation, Reach, Shell, StaticShell};

use crate::results::summary::LevelSummary;
use crate::scene::{Analysis, Formulation as Chosen, Scene};

/// Part of the work that a look may take where nobody asked for it.
const SHARE: f64 = 0.01;
/// Steps in whose time a tangent of cells is assembled and factorised: so many, and so many times the root of the number
/// of freedoms n (a step takes a time that grows as n, a factor on a surface as n^1.5). Measured on lattices of 528 to
/// 32 238 freedoms: 80 to 130 steps.
const STEPS: [f64; 2] = [60.0, 0.5];

/// Looks at the tangents of settled states.
pub(crate) struct Stability {
    wanted: Option<bool>,
    /// Ordered once a run.
    solver: Option<(SymmetricSolver, Vec<f64>)>,
}

impl Stability {
    /// As the scene asks for it; without a word from it, where it costs little.
    pub fn new(wanted: Option<bool>) -> Self {
        Self { wanted, solver: None }
    }

    /// Whether to look at a state after so many steps: those of its level, those of the run if the level is its last.
    pub fn due(&self, shell: &Shell, steps: u64) -> bool {
        match (self.wanted, shell.formulation()) {
            (_, Formulation::StrongForm { .. }) | (Some(false), _) => false,
            (Some(true), _) => true,
            (None, Formulation::StressPoint(Reach::Cell)) => {
                STEPS[0] + STEPS[1] * (shell.freedoms() as f64).sqrt() < SHARE * steps as f64
            }
            // Tangents of wide stencils are dearer; nobody asked.
            (None, _) => false,
        }
    }

    /// The signs of the pivots at a load level; nothing where the tangent cannot be factorised. The motion of the shell
    /// stays as it is, its forces are those of its state.
    pub fn look(&mut self, shell: &mut Shell, level: f64) -> Option<Inertia> {
        let mut system = StaticShell::lent(shell);
        if self.solver.is_none() {
            let pattern = system.pattern();
            let solver = SymmetricSolver::new(system.unknowns(), &pattern).ok()?;
            self.solver = Some((solver, vec![0.0; pattern.len()]));
        }
        let (solver, values) = self.solver.as_mut()?;
        system.tangent(level, values);
        let found = solver.factor(values).ok();
        system.evaluate(level);
        found
    }
}

/// What the summary says of states whose stability was not looked at, if there are any.
pub(crate) fn left_out(scene: &Scene, levels: &[LevelSummary]) -> Option<String> {
    let Analysis::Explicit(explicit) = &scene.analysis else { return None };
    if explicit.quasi_static.is_none() || matches!(scene.shell().formulation, Chosen::StrongForm(_)) {
        return Some("stability of the states: it was not looked at".into());
    }
    let without = levels.iter().filter(|level| level.negative_pivots.is_none()).count();
    let key = "analysis.explicit.quasi-static.stability = true";
    (without > 0).then(|| {
        format!("stability at {without} of {} levels: it was not looked at ({key} does)", levels.len())
    })
}
