//! Temperatures in balance: one row of the curve.

use crate::bodies::ConductingBody;
use crate::run::Run;
use crate::run::outcome::{Ended, Failure};

use super::linear::INTERRUPTED;

/// Finds the temperatures and reads the curve's one row: the heat that enters by each way, then the columns of the scene.
pub(super) fn steady(body: &mut dyn ConductingBody, run: &mut Run<'_>) -> Ended {
    if run.tell(0.0, 0, 0.0, 0.0).is_break() {
        return INTERRUPTED;
    }
    let mut row = match body.settle() {
        Err(cause) => return Ended::Diverged(Failure::Heat(cause)),
        Ok(found) => {
            let (heat, iterations) = (&found.balance, found.iterations);
            run.record.newton_iterations = iterations as u64;
            vec![iterations as f64, heat.supplied, heat.held, heat.film, heat.radiated]
        }
    };
    run.record.steps = 1;
    run.read_probes(&mut row, body);
    run.push(row);
    // A frame that cannot be written has its own failure.
    let _ = run.keep_shape(body, 0.0, 1.0);
    Ended::Done
}
