//! pinched-cylinder-large: the cylinder between diaphragms pinched until its wall buckles inward.

use benchmarks_ref::fe_shell::cases::pinched_cylinder_large as elements;

use super::dial::{ELEMENTS, STATIC};
use super::path::Compared;
use crate::case::{Case, Headline, Published, Run, Variant};
use crate::measure::largest;
use crate::measured::Measured;
use crate::{JudgeError, Metric};

pub const SCENE: &str = include_str!("../../../scenes/pinched-cylinder-large.toml");
const TABLE: &str = "sze_pinched_cylinder_diaphragm";
const COLUMNS: [&str; 2] = ["minus_W_A", "U_B"];
/// Load up to which bricks confirm the table, in parts of 12000, and the displacement there.
const CONFIRMED: (f64, f64) = (0.15, 36.208);
const NAME: &str = "distance from the table to 0.15";
const UNIT: &str = "% of the largest";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "pinched-cylinder-large",
        title: "Pinched cylinder between diaphragms, large displacements",
        about: "Displacements under a force and a quarter round from it against the table of Sze et al., up to 0.15 of the full \
                load, in percent of the displacement there (36.2, with a radius of 100). Beyond, the table is a single \
                transcription that bricks confirm in shape only.",
        citation: "Sze, Liu and Lo 2004, section 3.6",
        variants: variants(),
        each,
        together: |_| Ok(Vec::new()),
        headline: Some(Headline { metric: NAME, floor: 0.1, published }),
        figures: |_| Ok(Vec::new()),
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    // 38×25 makes nearly square cells of as many particles as 31×31, whose are 1.6 : 1.
    for [u, v] in [[21, 21], [31, 31], [38, 25], [33, 33]] {
        let particles = Variant::new(STATIC, SCENE, "cylinder", [u, v]);
        let nodes = Variant::elements(ELEMENTS, [u, v], move || elements([v - 1, u - 1], 40.0, 40));
        let quick = |variant: Variant| if u == 21 { variant.quick() } else { variant };
        variants.extend([quick(particles), quick(nodes)]);
    }
    variants
}

/// The largest distance of each displacement from the confirmed part of the table, in percent of the largest there.
pub fn errors(run: &Run) -> Result<Vec<Option<f64>>, JudgeError> {
    let mut errors = Vec::new();
    for column in COLUMNS {
        let compared = Compared { table: TABLE, known: ["P/Pmax", column], found: ["load", column] };
        errors.push(compared.largest(run, CONFIRMED.0, None)?.map(|error| 100.0 * error / CONFIRMED.1));
    }
    Ok(errors)
}

/// Distances from the table \[% of the largest displacement\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[("21×21", 12.0), ("31×31", 4.4), ("38×25", 1.1), ("33×33", 3.3)]),
    (ELEMENTS, &[("21×21", 5.5), ("31×31", 0.66), ("38×25", 2.1), ("33×33", 0.24)]),
]);

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let errors = errors(run)?;
    let reason = "the wall buckles, and what buckles shows every error of a coarse lattice enlarged";
    let measured = MEASURED.of(run)?;
    let judged = |name: &str, error| Metric::error(name, error, UNIT).near(measured, reason);
    let named = COLUMNS.iter().zip(&errors).map(|(name, error)| judged(name, *error));
    Ok(std::iter::once(judged(NAME, largest(errors.iter().copied()))).chain(named).collect())
}

fn published() -> Result<Vec<Published>, JudgeError> {
    Ok(vec![Published { source: "Sze et al. 2004, S4R 48×48", error: None }])
}
