//! fold-pressed: a flat strip folded between two smooth plates.
//!
//! ```text
//!    ▓▓▓▓▓▓▓▓▓▓▓▓▓   ↓ P
//!    ━━━━━━━━━━╮
//!              │   h
//!    ━━━━━━━━━━╯
//!    ▓▓▓▓▓▓▓▓▓▓▓▓▓
//! ```

use benchmarks_ref::on_flats::fold;

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/fold-pressed.toml");
const OFF: &str = "greatest error of the force";
/// B times the width of the strip \[N m²\].
const BENDING: f64 = 1.2e6 * 0.025 * 0.025 * 0.025 / 12.0 * 0.1;

/// Errors \[% of the force\].
const MEASURED: Measured = Measured(&[(STATIC, &[("60 cells", 0.14), ("120 cells", 0.32)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "fold-pressed",
        title: "A strip folded between plates, t/h = 1/40 to 1/20",
        about: "Half of a flat strip: its nose is turned by a right angle and brought half way to the other plate, then the plates close in to half of \
                their distance. The leg bears on the line where it lifts off and nowhere else. Thickness counts twice: h is the distance of \
                the plates less t.",
        citation: "elastica closed form, after Matthewson, Kurkjian and Gulati 1986",
        variants: vec![strip(60), strip(120)],
        each,
        headline: Some(Headline::new(OFF, 0.05)),
        ..Case::default()
    }
}

fn strip(cells: usize) -> Variant {
    Variant::scene(STATIC, SCENE, format!("{cells} cells"))
        .set("geometry.plate.particles", format!("[{}, 3]", cells + 1))
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let exact = |level: f64| BENDING * fold(1.0 - 0.5 * level);
    let found = run.column("level")?.into_iter().zip(run.column("P")?);
    let errors = found.map(|(level, force)| 100.0 * (force / exact(level) - 1.0).abs());
    let worst = errors.reduce(f64::max).filter(|_| run.done());
    let reason = "the line of contact stands between vertices; stretch and shear of the order of (t/h)², .25 % at the end";
    Ok(vec![Metric::error(OFF, worst, "%").near(MEASURED.of(run)?, reason)])
}
