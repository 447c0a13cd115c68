//! same-bits: a scene on 1, 2 and 4 threads, and twice on one; every number of its curve has to have the same bits.

use std::time::Instant;

use coque::{Curve, Silent};

use crate::Outcome;
use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::{CELL, STRONG_12};
use crate::support::scenes;
use crate::support::studies::{ENERGY, figure, in_time, model};
use crate::{JudgeError, Metric};

const OFF: &str = "numbers with other bits";

pub fn case() -> Case {
    Case {
        name: "same-bits",
        title: "The panel on 1, 2 and 4 threads and once more: the same bits",
        about: "The crown moves by 30 mm in a hundredth of a second, without damping; of the curve every number is compared bit \
                for bit with that of one thread. 529 particles are more than one chunk of work.",
        citation: "reference: the run on one thread",
        variants: ENERGY.into_iter().chain([STRONG_12]).map(variant).collect(),
        each,
        headline: Some(Headline::new(OFF, 0.0)),
        ..Case::default()
    }
}

fn variant(method: &str) -> Variant {
    let panel = Variant::new(method, scenes::PANEL, "cylinder", [23, 23]);
    let panel = in_time(panel.set("supports[3].amplitude", "{ ramp = 0.01 }"), 0.002, 0.0001);
    let quick = method == CELL;
    let study = Variant::study(method, "23×23", move || run(&panel));
    if quick { study.quick() } else { study }
}

fn run(panel: &Variant) -> Result<Outcome, String> {
    let started = Instant::now();
    let mut curves = Vec::new();
    let mut last = None;
    for threads in [1, 1, 2, 4] {
        let run = model(panel, threads)?.run(&mut Silent);
        curves.push(run.curve.clone());
        last = Some(run);
    }
    let other = curves[1..].iter().map(|curve| different(&curves[0], curve)).sum::<usize>();
    let moved = curves[0].column("w_crown").and_then(|w| w.last().copied()).unwrap_or(0.0);
    let figures = [(OFF, "-", other as f64), ("crown", "mm", moved)];
    let outcome = Outcome::from(last.ok_or("no run")?).showing(&figures);
    Ok(Outcome { wall_seconds: started.elapsed().as_secs_f64(), ..outcome })
}

fn different(one: &Curve, other: &Curve) -> usize {
    let bits = |curve: &Curve| curve.rows.iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
    let (one, other) = (bits(one), bits(other));
    one.iter().zip(&other).filter(|(a, b)| a != b).count() + one.len().abs_diff(other.len())
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let reason = "equal bit for bit across 1, 2, 4 threads and across two runs";
    Ok(vec![
        figure(run, OFF, "-")?.within(0.0, reason),
        figure(run, "crown", "mm")?.shown("it moves: bits of a body at rest would be equal by themselves"),
    ])
}
