//! falling-bar: a bar held at one end is let go under its weight; its end falls freely until a wave brings it news of the other.

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::{PAIRWISE, STATE};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("falling-bar.toml");
/// Acceleration \[m/s²\]; length, density and speed of the wave are one.
const GRAVITY: f64 = 1e-4;
const NAMES: [[&str; 2]; 3] = [
    ["tip at t = L/c", "mean at t = L/c"],
    ["tip at t = 1.5 L/c", "mean at t = 1.5 L/c"],
    ["tip at t = 2 L/c", "mean at t = 2 L/c"],
];
const TIMES: [f64; 3] = [1.0, 1.5, 2.0];

/// The bar, its closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "falling-bar",
        title: "A bar let go under its weight: its end falls until a wave tells it to stop",
        about: "A slice between mirrors, in which strain is along the bar alone and waves run at √(M/ρ), M = λ + 2μ. The end falls freely, g t²/2, \
                until the wave from the held end is there; then it is slowed by g (t − L/c)². Displacements of the end and their mean.",
        citation: "closed form: d'Alembert's solution of the wave equation",
        variants: [
            (PAIRWISE, 0.25, "{ bond-based = { plane = \"strain\" } }"),
            (STATE, 0.3, "{ state-based = { plane = \"strain\" } }"),
        ]
        .into_iter()
        .map(|(method, poisson, formulation)| {
            let young = (1.0 + poisson) * (1.0 - 2.0 * poisson) / (1.0 - poisson);
            Variant::scene(method, SCENE, "40×16")
                .set("bodies.bar.solid.formulation", formulation)
                .set("bodies.bar.solid.material.elastic.poisson", poisson)
                .set("bodies.bar.solid.material.elastic.young", young)
                .unsettled()
                .quick()
                .judged(|run, _| judged(run))
        })
        .collect(),
        headline: Some(Headline::new(NAMES[1][0], 0.01)),
        ..Case::default()
    }
}

/// Displacement of the end and mean displacement at a time, up to two lengths over the speed \[m\].
fn exact(time: f64) -> [f64; 2] {
    let late = (time - 1.0).max(0.0);
    // The held end bears ρ c g t until the wave is back: the mean is that of a mass under g − g t.
    [GRAVITY * (0.5 * time * time - late * late), GRAVITY * (0.5 * time * time - time.powi(3) / 6.0)]
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (times, tip, mean) = (run.column("time")?, run.column("u")?, run.column("mean")?);
    let mut metrics = Vec::new();
    for (time, names) in TIMES.into_iter().zip(NAMES) {
        let row = times.iter().position(|known| (known - time).abs() < 1e-9);
        for ((name, exact), (column, measured)) in
            names.into_iter().zip(exact(time)).zip([(&tip, 0.4), (&mean, 0.08)])
        {
            let found = Metric::compared(name, row.map(|row| column[row]), "m", exact);
            metrics.push(found.near(
                measured,
                "the held end stands half a spacing inside, and fronts are as wide as a horizon",
            ));
        }
    }
    Ok(metrics)
}
