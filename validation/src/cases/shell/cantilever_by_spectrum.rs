//! cantilever-by-spectrum: a cantilever under a response spectrum that is the same at any period, and a deck by the own spectrum of a record.
//!
//! ```text
//!  ▐━━━━━━━━━━━━   mode n: share (2σ/λ)² of the mass, at a height 2/λ² over that of 2σ/λ      V = m S √Σ shares²
//!  ↕ S          w
//! ```

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

use super::deck_in_quake;

const SCENE: &str = include_str!("../../../../scenes/cantilever-shaken.toml");
const WORST: &str = "worst of what the table has";
const MODES: usize = 3;

/// Errors \[%\].
#[rustfmt::skip] // a paragraph a method
const ALL: Measured = Measured(&[
    (STATIC, &[("41×3", 0.0128), ("81×3", 0.00759), ("33×3 of the deck", 0.0047)]),
]);

const YOUNG: f64 = 210e9;
const DENSITY: f64 = 7850.0;
const LENGTH: f64 = 0.5;
const WIDTH: f64 = 0.05;
const THICKNESS: f64 = 0.005;
/// Roots of cos λ cosh λ = −1, and `σ = (sinh λ − sin λ)/(cosh λ + cos λ)`.
const ROOTS: [[f64; 2]; MODES] = [
    [1.875_104_068_7, 0.734_095_513_7],
    [4.694_091_133_0, 1.018_467_318_8],
    [7.854_757_438_2, 0.999_224_496_5],
];

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    let spectrum = "{ response-spectrum = { modes = 4, damping.ratio = 0.05, combination = \"srss\", missing_mass = false, \
                    base = [{ acceleration = [0.0, 0.0, 1.0], by = \"period\", amplitude = { table = [[0.0, 1.0], [1.0, 1.0]] } }] } }";
    let moment = "{ name = \"M\", of = \"reaction-moment\", on = \"u0\", direction = [0.0, 1.0, 0.0] }";
    let on = |grid: &str, along: u32| {
        Variant::scene(STATIC, SCENE, grid)
            .set("geometry.plate.particles", format!("[{along}, 3]"))
            .set("analysis", spectrum)
            .set("output", "{}")
            .set("curve[+]", moment)
            .judged(|run: &Run, _| of_cantilever(run))
    };
    let record = "{ response-spectrum = { modes = 1, damping.rayleigh.mass = 0.624, base = [{ acceleration = [0.0, 0.0, 1.0], by = \"time\", \
                  amplitude = { record = { file = \"synthetic.AT2\", baseline = \"linear\" } } }] } }";
    Case {
        name: "cantilever-by-spectrum",
        title: "A cantilever by response spectra",
        about: "A strip whose clamp is shaken across it by a spectrum that is one at any period, in its three lowest modes across by the root of the sum of squares: way of the end, force and \
                moment at the clamp, by the modes of Euler and Bernoulli. And the deck of `deck-in-quake` by the own spectrum of its record: its greatest way against \
                that of one degree of freedom in time.",
        citation: "[chopra2012]: effective masses and heights of modes; [nigam1969]: the exact recurrence for straight lines between the points of a record",
        variants: vec![
            on("41×3", 41),
            on("81×3", 81),
            Variant::scene(STATIC, deck_in_quake::SCENE, "33×3")
                .on("of the deck")
                .set("geometry.plate.particles", "[33, 3]")
                .set("analysis", record)
                .set("output", "{}")
                .judged(|run: &Run, _| of_deck(run)),
        ],
        headline: Some(Headline::new(WORST, 0.5)),
        ..Case::default()
    }
}

fn of_cantilever(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let mass = DENSITY * WIDTH * THICKNESS * LENGTH;
    let stiffness = YOUNG * WIDTH * THICKNESS.powi(3) / 12.0;
    let root = |of: &dyn Fn([f64; 2]) -> f64| ROOTS.iter().map(|&mode| of(mode).powi(2)).sum::<f64>().sqrt();
    // φ of the mean square one ends at 2.
    let way = |[lambda, sigma]: [f64; 2]| {
        let square = lambda.powi(4) * stiffness / (mass * LENGTH.powi(3));
        2.0 * 2.0 * sigma / lambda / square
    };
    let share = |[lambda, sigma]: [f64; 2]| (2.0 * sigma / lambda).powi(2);
    let moment = |[lambda, sigma]: [f64; 2]| 2.0 * sigma / lambda * 2.0 / (lambda * lambda);
    let exact = [("tip", root(&way)), ("R", mass * root(&share)), ("M", mass * LENGTH * root(&moment))];
    let mut worst = 0.0_f64;
    for (name, value) in exact {
        let found = run.column(name)?.last().copied().unwrap_or_default();
        worst = worst.max((found / value - 1.0).abs());
    }
    judged(run, worst)
}

fn of_deck(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let found = run.column("w_deck")?.last().copied().unwrap_or_default();
    judged(run, (1e-3 * found / deck_in_quake::greatest_way() - 1.0).abs())
}

fn judged(run: &Run, worst: f64) -> Result<Vec<Metric>, JudgeError> {
    let worst = run.done().then_some(100.0 * worst);
    let reason = "three times the error of the lattice, whose stiffness converges with the square of the spacing, and of shear, which beams of Euler and Bernoulli leave out";
    Ok(vec![Metric::error(WORST, worst, "%").near(ALL.of(run)?, reason)])
}
