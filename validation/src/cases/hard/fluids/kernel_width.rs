//! fluid-kernel-width: the column that falls on a dry bed, with smoothing lengths from 1.1 to 2 spacings.

use fluid_sph::Formulation;

use crate::cases::fluid::dam_break::{falling, front};
use crate::judge::{Case, Run, Runs, Variant};
use crate::support::fluids::KICKS;
use crate::{JudgeError, Metric};

/// Smoothing lengths over the spacing; the first is what the others are held against.
const WIDTHS: [f64; 5] = [1.55, 1.1, 1.3, 1.8, 2.0];
const HIGH: usize = 24;

const FRONT: &str = "Z at T = 2.5";

/// The column, and how far its front may depend on the kernel.
pub fn case() -> Case {
    Case {
        name: "fluid-kernel-width",
        title: "A dam break with smoothing lengths from 1.1 to 2 spacings",
        about: "The front at T = t √(2g/L) = 2.5 at 24 particles a height, held against that at h = 1.55 Δx: the answer may not depend \
                on a width that is a choice.",
        citation: "reference: the run at h = 1.55 Δx",
        variants: WIDTHS.map(variant).to_vec(),
        ..Case::default()
    }
}

fn variant(smoothing: f64) -> Variant {
    let formulation = Formulation { smoothing, ..Formulation::default() };
    falling(KICKS, HIGH, &formulation, 2.5).named(grid(smoothing)).quick().judged(judged)
}

fn grid(width: f64) -> String {
    format!("h/Δx {width}")
}

fn reached(run: &Run) -> Result<Option<f64>, JudgeError> {
    Ok(front(run)?.last().map(|last| last.1).filter(|_| run.done()))
}

fn judged(run: &Run, runs: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let mut metrics = Vec::new();
    let usual = runs.get(KICKS, &grid(WIDTHS[0]))?.map(reached).transpose()?.flatten();
    if let Some(usual) = usual {
        let reason = "5 %: 3.9 measured at h = 2 Δx, of a thin front that a wide kernel smears";
        metrics.push(Metric::compared(FRONT, reached(run)?, "-", usual).within(0.05 * usual, reason));
    }
    let denser = run.outcome.fluid.as_ref().map(|fluid| 100.0 * fluid.greatest_density_error);
    metrics.extend([
        Metric::error("density error", denser, "%")
            .within(5.0, "a fluid that is weakly compressible; 0.4 measured"),
        Metric::error("balance", Some(run.outcome.balance), "%").within(4.0, "1.4 measured at h = 2 Δx"),
    ]);
    Ok(metrics)
}
