//! fluid-first: the published order, in which the fluid moves before the structure, feeds the structure
//! with energy.

use std::ops::ControlFlow::Continue;

use coque::scene::Measured;
use sph_core::Vec3;

use crate::cases::coupled::column::strip;
use crate::judge::measure::largest;
use crate::judge::{Case, Headline, Run};
use crate::support::watched::watched;
use crate::{JudgeError, Metric};

const SQUARES: &str = "sum of v² of the plate";
const LATE: &str = "kinetic energy of the plate, late over early";
/// End \[s\], and the windows in which energies are compared.
const END: f64 = 0.16;
const EARLY: [f64; 2] = [0.02, 0.06];
const LATE_SPAN: [f64; 2] = [0.12, 0.16];

/// The column on its plate with four ways to exchange loads and velocities.
pub fn case() -> Case {
    Case {
        name: "fluid-first",
        title: "The order of fluid and structure, and what the plate gains by it",
        about: "The column of hydrostatic-column. Where the fluid moves first, its pressure answers a \
                motion of the plate one step too late, which feeds all modes whose period is a few steps \
                of the fluid; where the structure moves first it does not. Asserted is the energy of the \
                plate: a mean of the deflection says nothing.",
        citation: "the order of published couplings of particles",
        variants: [
            ("structure first", "structure-first", true),
            ("structure first, bare", "structure-first", false),
            ("fluid first", "fluid-first", true),
            ("fluid first, bare", "fluid-first", false),
        ]
        .into_iter()
        .map(|(grid, order, impedance)| {
            let coupling = format!("{{ order = \"{order}\", impedance = {impedance} }}");
            let scene = strip(1, 2700.0, END).named(grid).set("coupling", coupling);
            let energy = watched(scene, &[(SQUARES, "m²/s²")], |march| {
                // The strip alone stands out of the plane; its free stations have equal masses.
                let rest = march.body().configuration().rest;
                let plate = (0..rest.len()).filter(|&a| rest[a].z != 0.0);
                let speed = |a| march.body().read(Measured::Velocity, a, &Vec3::y());
                Ok(Continue(vec![plate.map(|a| speed(a) * speed(a)).sum()]))
            });
            energy.judged(move |run, _| judged(grid, run))
        })
        .collect(),
        headline: Some(Headline::new(LATE, 0.1)),
        ..Case::default()
    }
}

fn judged(grid: &str, run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (times, energies) = (run.column("time")?, run.column(SQUARES)?);
    let most = |[from, to]: [f64; 2]| {
        largest(times.iter().zip(&energies).filter(|(t, _)| **t >= from && **t <= to).map(|(_, e)| Some(*e)))
    };
    let growth = most(LATE_SPAN).zip(most(EARLY)).map(|(late, early)| late / early);
    let found = match grid {
        "structure first" => Metric::error(LATE, growth, "-").within(1.0, "nothing feeds the plate"),
        "fluid first, bare" => Metric::at_least(LATE, growth, "-", 10.0)
            .within(0.0, "the published order feeds the plate: an energy that grows without bound"),
        _ => Metric::error(LATE, growth, "-").shown("one remedy of several, beside none and all"),
    };
    Ok(vec![found])
}
