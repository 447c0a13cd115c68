//! two-span-cases: a slab over two spans under five load cases, answered by one factor.
//!
//! ```text
//!   q ↓↓↓↓↓↓↓↓↓↓↓↓↓↓       R = w₀/f      w₀: deflection of the middle without its support      f: that of a unit force there
//!   ━━━━━━━━━━━━━━━
//!   △      △ R    △
//! ```

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/two-span-cases.toml");
const WORST: &str = "reaction of the middle support, worst of five cases";
const COMBINED: &str = "the same, worst of four combinations";

/// Errors \[%\].
const OF_CASES: Measured = Measured(&[(STATIC, &[("41×5", 0.0625), ("81×5", 0.0156)])]);
const OF_SUMS: Measured = Measured(&[(STATIC, &[("41×5", 0.0577), ("81×5", 0.0144)])]);

/// E I, 5/6 G A and half of the length.
const BENDING: f64 = 20_000.0;
const SHEAR: f64 = 5.0 / 6.0 * 15e6 * 0.2;
const SPAN: f64 = 5.0;

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "two-span-cases",
        title: "A slab over two spans, load cases",
        about: "The force on the middle support under weight, people in either span, sun on one face and a settlement, and under combinations of them times \
                factors: five solves by one factor, four sums.",
        citation: "[timoshenko1921]: a beam that shears, by the deflection of its middle without the support",
        variants: vec![
            Variant::scene(STATIC, SCENE, "41×5").set("geometry.plate.particles", "[41, 5]").quick_if(true),
            Variant::scene(STATIC, SCENE, "81×5"),
        ],
        each,
        headline: Some(Headline::new(WORST, 0.1)),
        ..Case::default()
    }
}

/// Forces of the cases, in the order of the scene: weight, people left and right, sun, settlement.
fn forces() -> [f64; 5] {
    let length = 2.0 * SPAN;
    let unit = length.powi(3) / (48.0 * BENDING) + length / (4.0 * SHEAR);
    let spread = 5.0 * length.powi(4) / (384.0 * BENDING) + length * length / (8.0 * SHEAR);
    let curved = 5e-4 * length * length / 8.0;
    [5.0 * spread, 1.5 * spread, 1.5 * spread, -curved, -0.005].map(|without| without / unit)
}

/// Factors of the combinations.
const FACTORS: [[f64; 5]; 4] = [
    [1.35, 1.5, 1.5, 0.0, 0.0],
    [1.35, 1.5, 0.0, 0.0, 0.0],
    [1.35, 0.0, 1.5, 0.0, 0.0],
    [1.0, 1.0, 1.0, 0.6, 1.0],
];

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let found = run.column("R_middle")?;
    let exact = forces();
    let sums = FACTORS.map(|factors| factors.iter().zip(exact).map(|(f, x)| f * x).sum::<f64>());
    let off = |found: &[f64], exact: &[f64]| {
        let one = |(x, exact): (&f64, &f64)| (x / exact - 1.0).abs();
        let whole = run.done() && found.len() == exact.len();
        whole.then(|| 100.0 * found.iter().zip(exact).map(one).fold(0.0, f64::max))
    };
    let (cases, combined) = found.split_at(exact.len().min(found.len()));
    let reason = "three times the error of the lattice, of second order in its spacing: a quarter of it on twice as many cells";
    Ok(vec![
        Metric::error(WORST, off(cases, &exact), "%").near(OF_CASES.of(run)?, reason),
        Metric::error(COMBINED, off(combined, &sums), "%").near(OF_SUMS.of(run)?, reason),
    ])
}
