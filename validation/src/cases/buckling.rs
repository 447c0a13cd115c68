//! buckling: a cantilever column and a simply supported plate, their first two critical loads.

use benchmarks_ref::fe_shell::cases::{column_buckling, plate_buckling};

use super::dial::{ELEMENTS, STATIC};
use crate::case::{Case, Headline, Published, Run, Variant};
use crate::measure::largest;
use crate::measured::Measured;
use crate::{JudgeError, Metric};

const COLUMN: &str = include_str!("../../../scenes/column-buckling.toml");
const PLATE: &str = include_str!("../../../scenes/plate-buckling.toml");
const NAME: &str = "worse of two levels";

/// What is pressed, and its first two critical levels by closed forms.
///
/// Column in units of π²EI/4L²; plate 300 × 200 × 2 mm in kN (`plate_stability`), two half-waves before one while the sides
/// are free in the plane, one before two when they are held.
const LEVELS: [(&str, [f64; 2]); 3] =
    [("column", [1.0, 9.0]), ("plate, sides free", [11.057, 11.959]), ("plate, sides held", [6.863, 9.325])];

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "buckling",
        title: "Buckling of a column and of a plate",
        about: "First two levels of linearised buckling against closed forms: Euler's column, and the plate of which the \
                sides are free in its plane or held.",
        citation: "Timoshenko and Gere 1961; closed forms in this project's reference file",
        variants: variants(),
        each,
        together: |_| Ok(Vec::new()),
        headline: Some(Headline { metric: NAME, floor: 0.01, published: || Ok(Vec::<Published>::new()) }),
        figures: |_| Ok(Vec::new()),
    }
}

fn variants() -> Vec<Variant> {
    let [column, free, held] = LEVELS.map(|level| level.0);
    let across = "[[0, 1, 0], [0, 0, 1]]";
    let plate = |counts| Variant::new(STATIC, PLATE, "plate", counts);
    let mut variants = vec![
        Variant::new(STATIC, COLUMN, "plate", [41, 3]).on(column),
        Variant::elements(ELEMENTS, [41, 2], || column_buckling(40)).on(column),
        plate([31, 21]).on(free),
        plate([31, 21])
            .on(held)
            .set("supports[2].held.displacement", across)
            .set("supports[3].held.displacement", across),
    ];
    for (sides, name) in [(false, free), (true, held)] {
        variants.push(Variant::elements(ELEMENTS, [31, 21], move || plate_buckling(10, sides)).on(name));
        variants.push(Variant::elements(ELEMENTS, [43, 29], move || plate_buckling(14, sides)).on(name));
    }
    variants
        .into_iter()
        .map(|variant| if variant.grid.starts_with('4') { variant } else { variant.quick() })
        .collect()
}

/// Errors of the worse of two levels \[%\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[("41×3 column", 0.22), ("31×21 plate, sides free", 0.5), ("31×21 plate, sides held", 0.57)]),
    (ELEMENTS, &[
        ("41×2 column", 0.22), ("31×21 plate, sides free", 0.088), ("43×29 plate, sides free", 0.072),
        ("31×21 plate, sides held", 0.018), ("43×29 plate, sides held", 0.028),
    ]),
]);

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let Some((_, expected)) = LEVELS.iter().find(|(name, _)| run.variant.grid.ends_with(name)) else {
        return Ok(Vec::new());
    };
    let found = run.column("level")?;
    let errors: Vec<_> = expected
        .iter()
        .enumerate()
        .map(|(mode, expected)| found.get(mode).map(|level| 100.0 * (level / expected - 1.0).abs()))
        .collect();
    let reason = "of second order in the spacing over the wave; the closed forms have no shear";
    let measured = MEASURED.of(run)?;
    let judged = |name: &str, error| Metric::error(name, error, "%").near(measured, reason);
    Ok(vec![
        judged(NAME, largest(errors.iter().copied())),
        judged("first", errors[0]),
        judged("second", errors[1]),
    ])
}
