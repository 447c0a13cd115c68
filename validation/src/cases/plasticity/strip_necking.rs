//! strip-necking: a strip pulled past its greatest force.
//!
//! ```text
//!  ▐━━━━━━━━━▶ u        force F(h) = b t σ e⁻ʰ,   h = σ/E + α,   σ = K (e₀ + α)ⁿ
//! ```

use libm::{exp, log, pow};

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/strip-necking.toml");
const OFF: &str = "greatest error of the force";
const THINNING: &str = "greatest error of the thickness";
const YOUNG: f64 = 2e5;
const POISSON: f64 = 0.3;
/// K \[F/L²\], e₀, n.
const SWIFT: [f64; 3] = [500.0, 1e-4, 0.2];
/// Width and thickness at rest \[L\].
const SIZE: [f64; 2] = [0.5, 0.01];

/// Errors \[%\].
const FORCE: Measured = Measured(&[(STATIC, &[("8 by 4 cells", 5.7e-8)])]);
const THICKNESS: Measured = Measured(&[(STATIC, &[("8 by 4 cells", 8.6e-9)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "strip-necking",
        title: "A strip pulled past its greatest force",
        about: "Yield stress K (e₀ + α)ⁿ, n = .2, to a logarithmic strain of one half: force and thickness at every level against the closed form with its \
                elastic part. The force is greatest at the strain n − e₀, but for σ/E.",
        citation: "uniaxial stress in closed form; Considère",
        variants: vec![Variant::scene(STATIC, SCENE, "8 by 4 cells").quick_if(true)],
        each,
        headline: Some(Headline::new(OFF, 1e-6)),
        ..Case::default()
    }
}

/// True stress and plastic strain at a logarithmic strain, by halving.
fn stress(strain: f64) -> [f64; 2] {
    let [factor, offset, exponent] = SWIFT;
    let (mut low, mut high) = (0.0, strain);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        let beyond = factor * pow(offset + middle, exponent) / YOUNG + middle > strain;
        if beyond {
            high = middle;
        } else {
            low = middle;
        }
    }
    [YOUNG * (strain - low), low]
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (stretch, force) = (run.column("stretch")?, run.column("F")?);
    let mut worst = [0.0_f64; 2];
    for ((stretch, force), t) in stretch.into_iter().zip(force).zip(run.column("t")?).skip(1) {
        let strain = log(stretch);
        let [stress, plastic] = stress(strain);
        let exact = stress * exp(-strain) * SIZE[0] * SIZE[1];
        let thickness = SIZE[1] * exp(-0.5 * plastic - POISSON * stress / YOUNG);
        worst[0] = worst[0].max(100.0 * (force / exact - 1.0).abs());
        worst[1] = worst[1].max(100.0 * (t / thickness - 1.0).abs());
    }
    let [off, thinning] = worst.map(|worst| run.done().then_some(worst));
    Ok(vec![
        Metric::error(OFF, off, "%").near(FORCE.of(run)?, "Newton's method stops at 1e-9 of the force"),
        Metric::error(THINNING, thinning, "%").near(THICKNESS.of(run)?, "the same"),
    ])
}
