//! fluid-refused: runs that cannot go well have to end with an error that says when and where.

use std::error::Error;

use fluid_sph::{Fluid, Formulation, Parts};
use sph_core::Vec3;

use crate::judge::{Case, Outcome, Run, Runs, Variant};
use crate::metric_names::KNOWN;
use crate::support::fluids::{CORRECTED, GRAVITY, KICKS, basin, domain, filled, formulation, march, water};
use crate::{JudgeError, Metric};

const COLUMN: [f64; 3] = [0.5, 1.0, 0.0];
const BASIN: [f64; 3] = [2.0, 2.0, 0.0];
const DX: f64 = 0.05;
const TIME: &str = "time of the last record";

/// The runs, and what their errors have to name.
pub fn case() -> Case {
    Case {
        name: "fluid-refused",
        title: "Runs that have to end with an error",
        about: "A speed of sound below that of the flow, gravity a million times too strong, particles that are shot at each other \
                beyond the speed of sound, a basin without a floor: each has to end with an error that names the time and the \
                particle, and none with a number that is none.",
        citation: "reference: the words of the errors",
        variants: variants(),
        ..Case::default()
    }
}

/// What is wrong with a run.
#[derive(Clone, Copy, PartialEq)]
enum Wrong {
    Sound,
    Gravity,
    Shot,
    Floor,
}

fn variants() -> Vec<Variant> {
    let wrongs = [
        (Wrong::Sound, "speed of sound 1 m/s"),
        (Wrong::Gravity, "gravity 10⁷ m/s²"),
        (Wrong::Shot, "halves meet at the speed of sound"),
        (Wrong::Floor, "no floor"),
    ];
    let mut variants = Vec::new();
    for method in [KICKS, CORRECTED] {
        for (wrong, grid) in wrongs {
            let run = move || ended(wrong, formulation(method)).map_err(|e| e.to_string());
            variants.push(Variant::study(method, grid, run).quick().judged(judged));
        }
    }
    variants
}

fn ended(wrong: Wrong, formulation: Formulation) -> Result<Outcome, Box<dyn Error>> {
    let sound = if wrong == Wrong::Sound { 1.0 } else { 20.0 * (GRAVITY * COLUMN[1]).sqrt() };
    let parts = water(2, DX, filled([0.0; 3], COLUMN, 2, DX), sound, formulation);
    let mut wall = basin(BASIN, 2, DX, &formulation)?;
    if wrong == Wrong::Floor {
        wall.points.retain(|place| place.y > 0.0);
    }
    let gravity = if wrong == Wrong::Gravity { Vec3::y() * -1e7 } else { parts.gravity };
    let to_the_middle = |place: &Vec3| Vec3::x() * (1.5 * sound * (0.5 * COLUMN[0] - place.x).signum());
    let velocities = match wrong {
        Wrong::Shot => parts.positions.iter().map(to_the_middle).collect(),
        _ => Vec::new(),
    };
    let domain = Some(domain(BASIN, 2, DX));
    let mut fluid = Fluid::new(Parts { walls: vec![wall], gravity, velocities, domain, ..parts })?;
    let marched = march(&mut fluid, 1.0, 0.01, |_, _| {});
    let finite = fluid.positions().iter().all(|place| place.iter().all(|x| x.is_finite()));
    let figures = [(TIME, "s", marched.until), ("finite", "-", f64::from(u8::from(finite)))];
    Ok(marched.outcome(&mut fluid).showing(&figures))
}

fn judged(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let words = run.outcome.failure.clone().unwrap_or_default();
    let clean = ["time", "particle"].iter().all(|word| words.contains(word)) && !words.contains("NaN");
    let last = run.column(TIME)?.last().copied();
    Ok(vec![
        Metric::compared(KNOWN, Some(f64::from(u8::from(clean))), "-", 1.0)
            .within(0.0, format!("it has to end by an error that names time and particle: {words}")),
        Metric::error(TIME, last, "s").shown("how far the run came before it was stopped"),
    ])
}
