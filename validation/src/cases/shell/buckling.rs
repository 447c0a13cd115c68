//! buckling: a cantilever column and a simply supported plate, their first two critical loads.

use benchmarks_ref::fe_shell::cases::{column_buckling, plate_buckling};

use crate::Metric;
use crate::judge::Measured;
use crate::judge::{Case, Headline, Variant};
use crate::methods::{ELEMENTS, STATIC};

const COLUMN: &str = include_str!("../../../../scenes/column-buckling.toml");
const PLATE: &str = include_str!("../../../../scenes/plate-buckling.toml");
const NAME: &str = "worse of two levels";

/// What is pressed, and its first two critical levels by a closed form.
type Pressed = (&'static str, [f64; 2]);

/// In units of π²EI/4L².
const OF_COLUMN: Pressed = ("column", [1.0, 9.0]);
/// Plate of 300 × 200 × 2 mm in kN (`plate_stability`), two half-waves before one while the sides are free in the plane.
const SIDES_FREE: Pressed = ("plate, sides free", [11.057, 11.959]);
/// The same, one half-wave before two.
const SIDES_HELD: Pressed = ("plate, sides held", [6.863, 9.325]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "buckling",
        title: "Buckling of a column and of a plate",
        about: "First two levels of linearised buckling against closed forms: Euler's column, and the plate of which the \
                sides are free in its plane or held.",
        citation: "Timoshenko and Gere 1961; closed forms in this project's reference file",
        variants: variants(),
        headline: Some(Headline::new(NAME, 0.01)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let across = "[[0, 1, 0], [0, 0, 1]]";
    let plate = || Variant::new(STATIC, PLATE, "plate", [31, 21]).quick();
    let held =
        plate().set("supports[2].held.displacement", across).set("supports[3].held.displacement", across);
    let mut variants = vec![
        pressed(Variant::new(STATIC, COLUMN, "plate", [41, 3]), OF_COLUMN),
        pressed(Variant::elements(ELEMENTS, [41, 2], || column_buckling(40)), OF_COLUMN),
        pressed(plate(), SIDES_FREE),
        pressed(held, SIDES_HELD),
    ];
    for (sides, levels) in [(false, SIDES_FREE), (true, SIDES_HELD)] {
        let coarse = Variant::elements(ELEMENTS, [31, 21], move || plate_buckling(10, sides)).quick();
        let fine = Variant::elements(ELEMENTS, [43, 29], move || plate_buckling(14, sides));
        variants.extend([coarse, fine].map(|variant| pressed(variant, levels)));
    }
    variants
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

/// Judges the first two levels of a run.
fn pressed(variant: Variant, (name, expected): Pressed) -> Variant {
    variant.on(name).judged(move |run, _| {
        let (found, measured) = (run.column("level")?, MEASURED.of(run)?);
        let error =
            |mode: usize| (mode as f64, found.get(mode).map(|level| 100.0 * (level / expected[mode] - 1.0)));
        let reason = "of second order in the spacing over the wave; the closed forms have no shear";
        let judged = |name: &str, modes: &[usize]| {
            Metric::greatest(name, modes.iter().map(|mode| error(*mode)), "%").near(measured, reason)
        };
        Ok(vec![judged(NAME, &[0, 1]), judged("first", &[0]), judged("second", &[1])])
    })
}
