//! plate-tear: a brittle thin plate that buckles, leaps to three half-waves and tears: found at rest until near the leap, then
//! marched.

use std::error::Error;
use std::time::Instant;

use explicit_dynamics::{Dynamics, Instant as At, Step};
use implicit_statics::{Newton, NewtonOptions};
use peridynamics::{Criterion, Fracture, Parts, Solid, StaticSolid};

use super::thin_plate::{WAY, columns, critical, end_force, opposite, plate};
use crate::figures::{Axis, Chart, Figure, Line, SKY, Series, VERMILION};
use crate::judge::{Case, Headline, Outcome, Run, Runs, Variant};
use crate::methods::SHEETS;
use crate::support::marched::{fracture_energy, in_time, marched};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

/// What a unit area of crack takes \[kN/mm\]: of a brittle plastic rather than of aluminium, so that the plate tears at all.
const ENERGY: f64 = 2e-3;
/// Largest deflection of the mode that the plate has at rest \[mm\].
const BENT: f64 = 0.2;
/// The part of the way made at rest, and its levels.
const AT_REST: (f64, usize) = (0.29, 18);
/// The time in which the rest of the way is made \[ms\]; the plate vibrates once in 5.
const TIME: f64 = 10.0;
const RECORDS: usize = 40;

const LOAD: &str = "P";
const WAY_MADE: &str = "way";
const UPPER: &str = "upper columns hurt";
const LOWER: &str = "lower columns hurt";
const SPENT: &str = "energy of broken bonds";
const BALANCE: &str = "balance";
const SKEW: &str = "asymmetry of damage";

/// The plate, and what is asked of it.
pub fn case() -> Case {
    Case {
        name: "plate-tear",
        title: "Brittle thin plate that buckles and tears",
        about: "The plate is bent at rest by a tenth of its thickness, shortened at rest to .29 of 1.2 mm, and from there on \
                in time: it leaps to three half-waves, and the sheets tear where they bend most. Nothing is published: asked \
                are the balance of energy, damage that is its own mirror image, and the same plate with its sheets exchanged \
                where it is bent to the other side; shown is what energy a finer plate takes.",
        citation: "balance of energy and mirror images; no published figures",
        variants: variants(),
        headline: Some(Headline::new(BALANCE, 0.01)),
        figures,
        ..Case::default()
    }
}

#[derive(Clone, Copy)]
struct Plate {
    spacing: f64,
    /// Deflection at rest \[mm\].
    bent: f64,
}

const PLATES: [Plate; 3] = [
    Plate { spacing: 20.0, bent: BENT },
    Plate { spacing: 20.0, bent: -BENT },
    Plate { spacing: 10.0, bent: BENT },
];

fn variants() -> Vec<Variant> {
    let variant = |plate: Plate| {
        let run = move || plate.run().map_err(|error| error.to_string());
        let variant = Variant::study(SHEETS, &plate.grid(), run);
        // Four times the columns and twice the steps: left to the heavy set.
        let variant = if plate.spacing < 20.0 { variant.heavy() } else { variant };
        variant.judged(move |run, runs| plate.judged(run, runs))
    };
    PLATES.into_iter().map(variant).collect()
}

impl Plate {
    fn grid(&self) -> String {
        format!("{} mm{}", self.spacing, if self.bent < 0.0 { ", bent down" } else { "" })
    }

    /// The plate at rest near its leap.
    fn at_rest(&self) -> Result<StaticSolid, Box<dyn Error>> {
        let block = columns([self.spacing; 2])?;
        let mode = critical(&plate(block.clone(), -WAY))?;
        let mut bent = block;
        for (x, w) in bent.positions.iter_mut().zip(&mode.shape) {
            x.z = self.bent * w;
        }
        let unbreakable = bent.faces[..4].iter().flatten().map(|&(node, _)| node).collect();
        let fracture = Some(Fracture { criterion: Criterion::EnergyByStretch(ENERGY), unbreakable });
        let mut system = StaticSolid::new(Solid::new(Parts { fracture, ..plate(bent, -WAY) })?);
        let mut newton = Newton::new(&system, &NewtonOptions::default())?;
        let (until, levels) = AT_REST;
        for number in 1..=levels {
            newton.at_level(&mut system, until * number as f64 / levels as f64)?;
        }
        Ok(system)
    }

    fn run(&self) -> Result<Outcome, Box<dyn Error>> {
        let started = Instant::now();
        let mut system = self.at_rest()?;
        let solid = system.solid_mut();
        let opposite = opposite(solid.block());
        let dt = solid.stable_step(0.9)?.dt;
        let steps = (TIME / dt).ceil() as usize;
        let (from, _) = AT_REST;
        let at = |step: usize| {
            let part = step as f64 / steps as f64;
            At { time: step as f64 * dt, level: from + (1.0 - from) * part }
        };
        let stored = solid.evaluate(at(0));
        let (mut external, mut dissipated, mut most, mut worst) = (0.0, 0.0, stored, 0.0_f64);
        let mut rows = Vec::new();
        for number in 0..steps {
            let kick = if number == 0 { 0.5 * dt } else { dt };
            let step = Step { from: at(number), to: at(number + 1), kick, damping: 0.0 };
            if number % (steps / RECORDS) != 0 {
                let work = solid.advance(&step);
                external += work.external;
                dissipated += work.dissipated;
                continue;
            }
            let internal = solid.evaluate(step.from);
            let load = end_force(solid).abs();
            let work = solid.kick(&step);
            // The kick's work reaches to the middle of the next step: half of it belongs to this state.
            let until = external + 0.5 * work.external;
            most = f64::max(most, internal + work.kinetic);
            worst = worst.max((stored + until - dissipated - work.kinetic - internal).abs());
            let hurt = |sheet: usize| {
                let of = |node: &usize| solid.damage_of_sheets(*node).is_some_and(|of| of[sheet] > 0.0);
                (0..solid.len()).filter(of).count() as f64
            };
            let apart = |(node, &there): (usize, &usize)| (solid.damage(node) - solid.damage(there)).abs();
            let skew = opposite.iter().enumerate().map(apart).fold(0.0, f64::max);
            let way = WAY * step.from.level;
            let energy = 1e3 * fracture_energy(solid);
            rows.push(vec![
                1e3 * step.from.time,
                way,
                load,
                hurt(0),
                hurt(1),
                energy,
                100.0 * worst / most,
                skew,
            ]);
            solid.drift(&step);
            external += work.external;
            dissipated += work.dissipated;
        }
        let columns = [
            ("time", "µs"),
            (WAY_MADE, "mm"),
            (LOAD, "kN"),
            (UPPER, "-"),
            (LOWER, "-"),
            (SPENT, "N mm"),
            (BALANCE, "%"),
            (SKEW, "-"),
        ];
        Ok(Outcome { curve: in_time(&columns, rows), ..marched(solid, steps as u64, started, &[]) })
    }

    fn judged(&self, run: &Run, runs: &Runs) -> Result<Vec<Metric>, JudgeError> {
        let spent = run.last(SPENT)?;
        let mut metrics = vec![
            figure(run, BALANCE, "%")?.near(0.04, "bonds that break are recorded in the middle of a step"),
            Metric::at_least(UPPER, run.last(UPPER)?, "-", 1.0).within(0.0, "the plate tears"),
            if self.spacing < 20.0 {
                figure(run, SKEW, "-")?.shown("rounding, which a tear of a thousand bonds makes grow")
            } else {
                figure(run, SKEW, "-")?
                    .within(1e-9, "plate, supports and imperfection are their own mirror images")
            },
        ];
        let of = |plate: &Plate, column: &str| -> Result<Option<f64>, JudgeError> {
            runs.get(SHEETS, &plate.grid())?.map_or(Ok(None), |run| run.last(column))
        };
        if self.bent < 0.0 {
            // The upper sheet is summed first in both plates, so that they are apart by rounding, which a tear makes grow.
            let exchanged = "the same plate with its sheets exchanged, by the same columns";
            let rounded = "the same plate with its sheets exchanged; sums in one order of sheets differ by what rounding grows to";
            for (own, column, part, reason) in [
                (UPPER, LOWER, 0.0, exchanged),
                (LOWER, UPPER, 0.0, exchanged),
                (SPENT, SPENT, 2e-3, rounded),
                (LOAD, LOAD, 2e-3, rounded),
            ] {
                if let Some(other) = of(&PLATES[0], column)? {
                    let metric = Metric::compared(format!("{own}, bent up"), run.last(own)?, "-", other);
                    metrics.push(metric.within(part * other, reason));
                }
            }
        }
        if let (true, Some(coarse)) = (self.spacing == 10.0, of(&PLATES[0], SPENT)?) {
            let change = spent.map(|spent| 100.0 * (spent / coarse - 1.0));
            metrics.push(
                Metric::error("change of the energy from 20 mm", change, "%")
                    .shown("two spacings of a plate that shatters"),
            );
        }
        Ok(metrics)
    }
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut series = Vec::new();
    for (plate, colour) in [(PLATES[0], SKY), (PLATES[2], VERMILION)] {
        let Some(run) = runs.get(SHEETS, &plate.grid())? else { continue };
        let points = run.column(WAY_MADE)?.into_iter().zip(run.column(LOAD)?).collect();
        series.push(Series::line(&plate.grid(), points, colour, Line::Solid));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Force against shortening".into(),
        caption: "It falls as the plate leaps, and again as it tears.".into(),
        x: Axis::linear("shortening [mm]"),
        y: Axis::linear("force [kN]"),
        series,
    })])
}
