//! touched-modes: frequencies of a cantilever that bears on a flat, and levels of a column that tools grip.
//!
//! ```text
//!  ▐━━━━━━━━━━━━━━━━       →  o━━━━━━━●━━━━━━━o  ←
//!                 ▔▔▔▔                ●
//! ```

use crate::Metric;
use crate::judge::measure::largest;
use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;

const BEAM: &str = include_str!("../../../../scenes/propped-cantilever.toml");
const COLUMN: &str = include_str!("../../../../scenes/column-between-tools.toml");
const NAME: &str = "worst of three";

/// What a scene is of, the column of its answers, and these in closed form.
type Touched = (&'static str, &'static str, [f64; 3]);

/// Circular frequencies of a clamped–propped beam, `β² √(B/ρt)` with β L the roots of `tan βL = tanh βL`, √(B/ρt) = √.1 m²/s.
const OF_BEAM: Touched = ("end on a flat", "circular_frequency", [4.875665, 15.800277, 32.966016]);
/// Levels of a hinged column that is held in its middle, in units of `4 π²B/L²`: halves hinged, halves clamped at the middle (`tan u = u`), two waves.
const OF_COLUMN: Touched = ("middle between tools", "level", [1.0, 2.045748, 4.0]);

/// Errors of the worst of three \[%\].
const MEASURED: Measured = Measured(&[(
    STATIC,
    &[
        ("41×3 end on a flat", 0.15),
        ("81×3 end on a flat", 0.12),
        ("41×3 middle between tools", 1.6),
        ("81×3 middle between tools", 0.3),
    ],
)]);

/// The scenes, their closed forms, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "touched-modes",
        title: "Modes and buckling of touched states",
        about: "A cantilever is pressed onto a flat, a hinged column gripped in its middle by two tools; then contact stays as it is. Three \
                frequencies of the one and three levels of the other against those of beams on props.",
        citation: "Bernoulli's and Euler's beams",
        variants: [OF_BEAM, OF_COLUMN].into_iter().flat_map(grids).collect(),
        headline: Some(Headline::new(NAME, 0.01)),
        ..Case::default()
    }
}

fn grids((name, column, exact): Touched) -> impl Iterator<Item = Variant> {
    let scene = if name == OF_BEAM.0 { BEAM } else { COLUMN };
    [41, 81].into_iter().map(move |along| {
        let variant = Variant::new(STATIC, scene, "plate", [along, 3]).on(name);
        variant.judged(move |run, _| judged(run, column, &exact))
    })
}

fn judged(run: &Run, column: &str, exact: &[f64; 3]) -> Result<Vec<Metric>, crate::JudgeError> {
    let found = run.column(column)?;
    let error = |mode: usize| found.get(mode).map(|own| 100.0 * (own / exact[mode] - 1.0).abs());
    let reason = "of second order in the spacing over the wave; beams have no shear and contact no depth";
    Ok(vec![
        Metric::error(NAME, largest([error(0), error(1), error(2)]), "%").near(MEASURED.of(run)?, reason),
    ])
}
