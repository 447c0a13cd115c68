//! stiffened-plate: a plate with a bar along its middle under compression, against two half plates on a bar.

use benchmarks_ref::stiffened_plate::coefficient;

use crate::Metric;
use crate::judge::{Case, Headline, Variant};
use crate::methods::STATIC;

const SCENE: &str = include_str!("../../../../scenes/stiffened-plate.toml");
const NAME: &str = "buckling level";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    let mut variants = Vec::new();
    for (cells, delta) in [(16, 0.1), (32, 0.1), (32, 0.05), (32, 0.2)] {
        let exact = coefficient(1.0, 5.0, delta);
        let counts = [cells + 1, cells + 1];
        let variant = Variant::new(STATIC, SCENE, "plate", counts).quick().on(&format!("A/bh = {delta}"));
        let variant = variant.set("parameters.delta", delta.to_string());
        variants.push(variant.judged(move |run, _| {
            let found = run.column("level")?.first().map(|level| 100.0 * (level / exact - 1.0));
            // .32 % at most with 32 cells.
            let bound = 3.0 * 0.33 * (32.0 / cells as f64).powi(2);
            let reason = "three times what one curvature a cell leaves of half a wave, of second order, and of shear in plate and bar";
            Ok(vec![Metric::error(NAME, found, "%").within(bound, reason)])
        }));
    }
    Case {
        name: "stiffened-plate",
        title: "Plate with a stiffener, buckling",
        about: "A square plate with a bar along its middle, EI/bD = 5, under even compression along it: the first level.",
        citation: "Timoshenko and Gere 1961, section 9.11; the exact equation of two half plates on a bar",
        variants,
        headline: Some(Headline::new(NAME, 1.0)),
        ..Case::default()
    }
}
