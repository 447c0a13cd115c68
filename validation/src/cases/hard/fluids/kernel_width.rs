//! fluid-kernel-width: the column that falls on a dry bed, with smoothing lengths from 1.1 to 2 spacings.

use std::error::Error;

use fluid_sph::{Fluid, Formulation, Parts};

use crate::judge::{Case, Outcome, Run, Runs, Variant};
use crate::support::fluids::{GRAVITY, KICKS, basin, domain, filled, march, water};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

/// Width of the column \[m\], and its height; the basin.
const COLUMN: [f64; 3] = [1.0, 2.0, 0.0];
const BASIN: [f64; 3] = [6.0, 3.0, 0.0];
/// Smoothing lengths over the spacing; the first is what the others are held against.
const WIDTHS: [f64; 5] = [1.55, 1.1, 1.3, 1.8, 2.0];
const HIGH: usize = 24;

const FRONT: &str = "Z at T = 2.5";
const DENSITY_ERROR: &str = "density error";
const BALANCE: &str = "balance";

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

fn variant(width: f64) -> Variant {
    let run = move || fallen(width).map_err(|e| e.to_string());
    Variant::study(KICKS, &grid(width), run).quick().judged(judged)
}

fn grid(width: f64) -> String {
    format!("h/Δx {width}")
}

fn fallen(smoothing: f64) -> Result<Outcome, Box<dyn Error>> {
    let dx = COLUMN[1] / HIGH as f64;
    let formulation = Formulation { smoothing, ..Formulation::default() };
    let sound = 20.0 * (GRAVITY * COLUMN[1]).sqrt();
    let parts = water(2, dx, filled([0.0; 3], COLUMN, 2, dx), sound, formulation);
    let wall = basin(BASIN, 2, dx, &formulation)?;
    let mut fluid = Fluid::new(Parts { walls: vec![wall], domain: Some(domain(BASIN, 2, dx)), ..parts })?;
    let until = 2.5 * (COLUMN[0] / (2.0 * GRAVITY)).sqrt();
    let marched = march(&mut fluid, until, 0.1 * until, |_, _| {});
    let front = fluid.positions().iter().map(|place| place.x).fold(0.0, f64::max) + 0.5 * dx;
    let figures = [
        (FRONT, "-", front / COLUMN[0]),
        (DENSITY_ERROR, "%", 100.0 * fluid.greatest_density_error()),
        (BALANCE, "%", marched.balanced.percent()),
    ];
    Ok(marched.outcome(&mut fluid).showing(&figures))
}

fn judged(run: &Run, runs: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let mut metrics = Vec::new();
    let usual = runs.get(KICKS, &grid(WIDTHS[0]))?.map(|run| run.last(FRONT)).transpose()?.flatten();
    if let Some(usual) = usual {
        let reason = "5 %: 3.9 measured at h = 2 Δx, of a thin front that a wide kernel smears";
        metrics.push(Metric::compared(FRONT, run.last(FRONT)?, "-", usual).within(0.05 * usual, reason));
    }
    metrics.extend([
        figure(run, DENSITY_ERROR, "%")?.within(5.0, "a fluid that is weakly compressible; 0.4 measured"),
        figure(run, BALANCE, "%")?.within(4.0, "1.4 measured at h = 2 Δx"),
    ]);
    Ok(metrics)
}
