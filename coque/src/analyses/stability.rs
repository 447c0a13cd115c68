//! Whether the states that a march settles at are stable: the negative pivots of their tangents.
//!
//! A march finds states of rest, and a perfect column beyond its critical load rests straight. Each negative pivot of
//! the tangent (Sylvester: each negative eigenvalue) is a direction in which the body would leave such a state at the
//! least disturbance. Directions that a prescribed motion holds are held in the tangent.

use implicit_statics::{Inertia, SymmetricSolver};

use crate::bodies::{DynamicBody, TangentCost};
use crate::run::record::LevelSummary;
use crate::scene::Explicit;

/// Part of the work that a look may take where nobody asked for it.
const SHARE: f64 = 0.01;

/// Particles times steps that a look may take in any case: a tenth of a second.
const LITTLE: f64 = 1e6;

/// Steps that a look counts as where nobody knows, for a body of few particles.
const UNKNOWN: f64 = 1000.0;

/// Looks at the tangents of settled states.
pub(crate) struct Stability {
    wanted: Option<bool>,
    tangent: TangentCost,
    particles: f64,
    /// Ordered once a run, and anew where parts that touch have found other partners.
    solver: Option<(SymmetricSolver, Vec<f64>)>,
}

impl Stability {
    /// As the scene asks for it; without a word from it, where it costs little for a body of so many particles.
    pub fn new(wanted: Option<bool>, tangent: TangentCost, particles: usize) -> Self {
        Self { wanted, tangent, particles: particles as f64, solver: None }
    }

    /// Whether to look at a state after so many steps: those of its level, those of the run if the level is its last.
    pub fn due(&self, steps: u64) -> bool {
        match (self.wanted, self.tangent) {
            (_, TangentCost::Without) | (Some(false), _) => false,
            (Some(true), _) => true,
            (None, TangentCost::Steps(cost)) => cost < SHARE * steps as f64 || cost * self.particles < LITTLE,
            (None, TangentCost::Expensive) => UNKNOWN * self.particles < LITTLE,
        }
    }

    /// Whether a state that is not looked at is to be reported: where it could be, and nobody said that it need not.
    pub fn is_reported(&self) -> bool {
        self.wanted.is_none() && self.tangent != TangentCost::Without
    }

    /// The signs of the pivots at a load level; nothing where the tangent cannot be factorised. The motion of the body
    /// stays as it is, its forces are those of its state.
    pub fn look(&mut self, body: &mut dyn DynamicBody, level: f64) -> Option<Inertia> {
        let mut system = body.at_rest()?;
        if system.pattern_changed(level) || self.solver.is_none() {
            let pattern = system.pattern();
            let solver = SymmetricSolver::new(system.unknowns(), &pattern).ok()?;
            self.solver = Some((solver, vec![0.0; pattern.len()]));
        }
        let (solver, values) = self.solver.as_mut()?;
        system.tangent(level, values);
        let found = solver.factor(values).ok();
        system.refresh(level);
        found
    }
}

/// What the summary says of states whose stability was not looked at, if there are any.
pub(crate) fn left_out(explicit: &Explicit, tangent: TangentCost, levels: &[LevelSummary]) -> Option<String> {
    if explicit.quasi_static.is_none() || tangent == TangentCost::Without {
        return Some("stability of the states: it was not looked at".into());
    }
    let without = levels.iter().filter(|level| level.negative_pivots.is_none()).count();
    let key = "analysis.explicit.quasi-static.stability = true";
    (without > 0).then(|| {
        format!("stability at {without} of {} levels: it was not looked at ({key} does)", levels.len())
    })
}
