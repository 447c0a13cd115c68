//! light-structure: plates a tenth, once and ten times as dense as the water that they carry.

use crate::cases::coupled::column::{SOUND, WAY, exact, strip};
use crate::cases::coupled::measure::mean_and_deviation;
use crate::judge::{Case, Headline, Run};
use crate::support::coupled::WATER;
use crate::{JudgeError, Metric};

const MEAN: &str = "mean of the deflection";
const SWING: &str = "standard deviation";
const LEFT: &str = "deviation of the last quarter over the second's";
const NUMBER: &str = "ρ₀c₀Δt over the plate's mass";
/// Densities of the plate over that of water, with spacings a thickness.
const RUNS: [(f64, usize); 4] = [(0.1, 1), (1.0, 1), (10.0, 1), (10.0, 2)];
/// Window in which the plate is watched \[s\].
const LATE: [f64; 2] = [0.2, 0.4];
/// Two quarters of the run \[s\].
const QUARTERS: [[f64; 2]; 2] = [[0.1, 0.2], [0.3, 0.4]];

/// The column on plates of other densities, its weight being that of the water.
pub fn case() -> Case {
    Case {
        name: "light-structure",
        title: "Plates lighter than the water that they carry",
        about: "The column of hydrostatic-column at one spacing a thickness, on plates of other \
                densities. Couplings that take a load and a motion in turn are said to fail where the \
                fluid adds more mass than the structure has. The number that counts is ρ₀c₀Δt/(ρ_s t): \
                how much of its speed a plate loses to sound in one step of the fluid. A plate ten times as \
                dense swings at 142 Hz, and the sound it sends out is .31 m long: six spacings at one a \
                thickness, too few to carry its swing away. With twice and four times as many the same \
                plate is at rest within a tenth of a second.",
        citation: "closed form, as hydrostatic-column",
        variants: RUNS
            .into_iter()
            .map(|(ratio, layers)| {
                strip(layers, ratio * WATER, LATE[1])
                    .named(format!("ρ_s/ρ₀ = {ratio}, {layers} across"))
                    .judged(move |run, _| judged(ratio, layers, run))
            })
            .collect(),
        headline: Some(Headline::new(MEAN, 0.1)),
        ..Case::default()
    }
}

fn judged(ratio: f64, layers: usize, run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (times, ways) = (run.column("time")?, run.column(WAY)?);
    let late = mean_and_deviation(&times, &ways, LATE);
    let [early, last] = QUARTERS.map(|quarter| mean_and_deviation(&times, &ways, quarter));
    let left = early.zip(last).map(|(early, last)| last.1 / early.1);
    let exact = exact(ratio * WATER);
    let steps = run.outcome.steps as f64;
    let number = SOUND * LATE[1] / (steps * ratio * 0.05);
    let swing = Metric::error(SWING, late.map(|found| 100.0 * found.1 / found.0), "% of the mean");
    let left = Metric::error(LEFT, left, "-");
    // At one spacing a thickness the heavy plate still rings: what is judged is that it rings down.
    let rings = ratio > 5.0 && layers == 1;
    let (swing, left) = if rings {
        let slow = "the sound it sends out is six spacings long; see the run at two a thickness";
        (
            swing.shown(slow),
            left.within(0.6, "measured .30; a coupling that feeds the plate keeps it ringing"),
        )
    } else {
        let fed = "a coupling that feeds the plate swings more and more";
        (swing.within(5.0, fed), left.shown("what is left is sound between plate and surface"))
    };
    Ok(vec![
        Metric::compared(MEAN, late.map(|found| found.0), "m", exact)
            .within(0.035 * exact, "measured 1.1 % at one spacing a thickness, three times that"),
        swing,
        left,
        Metric::error(NUMBER, Some(number), "-").shown("no bound was met up to here"),
    ])
}
