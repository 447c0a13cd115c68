//! plate-stability: the thin plate of the seed paper as two peridynamic sheets: tension, compression, first critical force.
//!
//! | what | classical plate |
//! |---|---|
//! | tension, ends free across | E t b u/a |
//! | tension, ends held across | between that and the next; .5 % below 112.8 by a fine model |
//! | compression, sides held, flat | E t b u/((1 − ν²) a) |
//! | first critical force, sides held, hinged; ends clamped; sides free | 6.863; 8.935; 11.057 kN |

use crate::figures::{Axis, Chart, Figure, GREEN, Line, Mark, Series, VERMILION};
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::methods::SHEETS;
use crate::{JudgeError, Metric};

pub const PLATE: &str = include_str!("../../../../scenes/plate-pd.toml");
const NAME: &str = "force";
/// The shortening at level one \[mm\].
pub const FULL: f64 = 1.2;

/// How the edges are held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Edges {
    /// Ends and sides free across; hinged.
    Free,
    /// Ends held across, sides free; hinged.
    EndsHeld,
    /// Sides held across; hinged.
    SidesHeld,
    /// Sides held across, ends clamped.
    Clamped,
}

/// What is asked: the edges, whether it is the critical force, its value \[kN\], the part it may be off at 10 mm \[%\].
#[rustfmt::skip] // a table
const ASKED: [(&str, Edges, bool, f64, f64); 6] = [
    ("tension, free", Edges::Free, false, 110.40, 0.7),
    ("tension, ends held", Edges::EndsHeld, false, 112.3, 0.7),
    ("compression, sides held", Edges::SidesHeld, false, 123.89, 0.7),
    ("buckling, sides held", Edges::SidesHeld, true, 6.863, 0.7),
    ("buckling, ends clamped", Edges::Clamped, true, 8.935, 0.7),
    ("buckling, sides free", Edges::Free, true, 11.057, 0.5),
];

/// The scene, its references, and how far they may differ.
pub fn case() -> Case {
    Case {
        name: "plate-stability",
        title: "Thin plate 300 × 200 × 2 mm as two peridynamic sheets: tension, compression, buckling",
        about: "Forces at a shortening of 1.2 mm and first critical forces under three sets of supports, against classical \
                plates; half the tolerance at half the spacing. The published 119.9 (tension), 131.9 (compression) and 9.6 kN \
                (buckling) cannot be repeated: see plate-lattice for the lattice that they were published for.",
        citation: "Timoshenko and Gere 1961; the published figures: plate_stability in this project's reference files",
        variants: variants(),
        headline: Some(Headline::new(NAME, 0.1)),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for spacing in [10.0, 5.0, 2.5] {
        for (name, edges, critical, expected, percent) in ASKED {
            let bound = if spacing == 10.0 { percent } else { 0.5 * percent };
            let plate =
                supported(edges).named(grid(name, spacing)).quick_if(spacing == 10.0).full_if(spacing < 5.0);
            let plate = plate.set("bodies.plate.solid.geometry.block.spacing", spacing);
            let plate = if critical {
                plate.set("analysis.buckling.modes", 1)
            } else {
                plate.set("analysis.linear", "{}")
            };
            variants.push(plate.judged(move |run, runs| {
                let force = if critical { critical_force(run, runs, edges, spacing)? } else { force(run)? };
                let metric = Metric::compared(NAME, force, "kN", expected);
                let reason = "the plate converges from its spacing and its horizon of 1.5 spacings; half of it at half the spacing";
                Ok(vec![metric.within(0.01 * bound * expected, reason)])
            }));
        }
    }
    // The force of a clamped plate at the shortening: asked of nothing, it scales the critical level.
    for spacing in [10.0, 5.0, 2.5] {
        let plate = supported(Edges::Clamped).named(grid("compression, ends clamped", spacing));
        let plate =
            plate.set("bodies.plate.solid.geometry.block.spacing", spacing).set("analysis.linear", "{}");
        variants.push(plate.quick_if(spacing == 10.0).full_if(spacing < 5.0).judged(|run, _| {
            Ok(vec![
                Metric::compared(NAME, force(run)?, "kN", 123.89)
                    .shown("as with hinged ends: the plate is flat"),
            ])
        }));
    }
    variants
}

fn grid(name: &str, spacing: f64) -> String {
    format!("{spacing} mm {name}")
}

/// The flat plate with its edges held.
fn supported(edges: Edges) -> Variant {
    let solid = |plate: Variant| plate.set("bodies.plate.solid.imperfection.amplitude", 0.0);
    let plate = solid(Variant::scene(SHEETS, PLATE, ""));
    let (up, across, along) = ("[0, 0, 1]", "[0, 1, 0]", "[1, 0, 0]");
    match edges {
        Edges::SidesHeld => plate,
        Edges::Clamped => plate
            .set("supports[0].held.director", format!("[{along}, {across}]"))
            .set("supports[1].held.director", format!("[{along}, {across}]")),
        Edges::EndsHeld => plate
            .set("supports[0].held.displacement", format!("[{along}, {across}, {up}]"))
            .set("supports[1].held.displacement", format!("[{across}, {up}]"))
            .set("supports[3].held.displacement", format!("[{up}]"))
            .set("supports[4].held.displacement", format!("[{up}]")),
        Edges::Free => plate
            .set("supports[3].held.displacement", format!("[{up}]"))
            .set("supports[4].held.displacement", format!("[{up}]"))
            .set("sets.line", "{ plane = { point = [0.0, 100.0, 0.0], normal = [0.0, 1.0, 0.0] } }")
            .set("supports[+]", format!("{{ on = \"line\", held = {{ displacement = [{across}] }} }}")),
    }
}

/// Force at the shortening \[kN\].
fn force(run: &Run) -> Result<Option<f64>, JudgeError> {
    Ok(run.last("P")?.map(|force| 1e-3 * force.abs()))
}

/// The level is a part of the shortening: the force there is that part of the force of the flat plate.
fn critical_force(run: &Run, runs: &Runs, edges: Edges, spacing: f64) -> Result<Option<f64>, JudgeError> {
    let flat = match edges {
        Edges::Free => "tension, free",
        Edges::EndsHeld => "tension, ends held",
        Edges::SidesHeld => "compression, sides held",
        Edges::Clamped => "compression, ends clamped",
    };
    let level = run.column("level")?.first().copied();
    let flat = runs.get(SHEETS, &grid(flat, spacing))?.map(force).transpose()?.flatten();
    Ok(level.zip(flat).map(|(level, force)| level.abs() * force))
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut series = Vec::new();
    for (name, edges, critical, expected, _) in ASKED {
        let mut points = Vec::new();
        for spacing in [10.0, 5.0, 2.5] {
            let Some(run) = runs.get(SHEETS, &grid(name, spacing))? else { continue };
            let found = if critical { critical_force(run, runs, edges, spacing)? } else { force(run)? };
            points.extend(found.map(|found| (spacing, 100.0 * (found / expected - 1.0))));
        }
        let (colour, mark) = if critical { (VERMILION, Mark::Disc) } else { (GREEN, Mark::Square) };
        series.push(Series::both(name, points, colour, mark));
    }
    series.push(Series::line("classical plate", vec![(2.0, 0.0), (10.0, 0.0)], GREEN, Line::Dashed));
    Ok(vec![Figure::Chart(Chart {
        title: "Error of the forces against the spacing".into(),
        caption:
            "Two sheets with corrected weights; without the correction the errors stay at 6 % at any spacing."
                .into(),
        x: Axis::linear("spacing [mm]"),
        y: Axis::linear("error [%]"),
        series,
    })])
}
