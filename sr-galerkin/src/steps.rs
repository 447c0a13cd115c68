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
    let (mut level, mut parts, mut failures) = (from, 1_u64, 0);
    let mut done = 0;
    while done < parts {
        let next = if done + 1 == parts { to } else { from + (to - from) * (done + 1) as f64 / parts as f64 };
        let before = body.insists;
        match newton.at_level(body, next) {
            Ok(converged) => {
                let step = Step { converged, failures, insisted: before };
                observer(&step, body);
                (level, failures) = (next, 0);
                done += 1;
            }
            Err(error) => {
                failures += 1;
                if body.insists && !before {
                    continue; // once more with the consistent tangent
                }
                if parts >= 1 << HALVINGS {
                    return Err(error);
                }
                (parts, done) = (2 * parts, 2 * done);
            }
        }
    }
    debug_assert!(level == to || parts == 1);
    Ok(())
}
