//! Load steps as the method prescribes them: a step that fails is made again with the consistent tangent, then halved.

use implicit_statics::{Converged, EquilibriumError, Newton};

use crate::body::Galerkin;

/// Times a step is halved before the path has failed.
const HALVINGS: u32 = 8;

/// A step that was made.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// How it converged.
    pub converged: Converged,
    /// Trials that failed before it, that made again with the consistent tangent among them.
    pub failures: usize,
    /// Whether the consistent tangent was taken after a failure.
    pub insisted: bool,
}

/// Leads a body in equilibrium at level `from` to `to`, in one step or in halves of it.
///
/// # Errors
/// Of the last trial, where eight halvings do not help; the body stands at the last state that balanced.
pub fn lead(
    body: &mut Galerkin,
    newton: &mut Newton,
    (from, to): (f64, f64),
    mut observer: impl FnMut(&Step, &mut Galerkin),
) -> Result<(), EquilibriumError> {
    let (mut parts, mut done, mut failures) = (1_u64, 0, 0);
    while done < parts {
        let share = (done + 1) as f64 / parts as f64;
        let next = if share == 1.0 { to } else { from + (to - from) * share };
        let insisted = body.insists;
        match newton.at_level(body, next) {
            Ok(converged) => {
                observer(&Step { converged, failures, insisted }, body);
                (done, failures) = (done + 1, 0);
            }
            Err(error) => {
                failures += 1;
                let again = body.insists && !insisted; // with the consistent tangent
                if !again && parts == 1 << HALVINGS {
                    return Err(error);
                }
                if !again {
                    (parts, done) = (2 * parts, 2 * done);
                }
            }
        }
    }
    Ok(())
}
