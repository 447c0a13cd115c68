//! plate-branches: the second event of the plate beyond buckling, by arc length: flat, along the branches that leave its bifurcations, and
//! bent at rest, through the turning point of its shortening to three half-waves.

use benchmarks_ref::fe_shell::cases::plate_path;
use coque::Shape;

use super::plate_post_buckling::{BENT, CRITICAL, FLAT_STIFFNESS, points};
use super::plate_stability::{FULL, PLATE};
use crate::figures::{
    Axis, BLACK, BLUE, Chart, Figure, GREY, Line, Mark, ORANGE, Series, Shapes, Sheet, VERMILION, shade,
};
use crate::judge::{Case, Headline, Measured, Run, Runs, Variant};
use crate::methods::{ELEMENTS, SHEETS};
use crate::support::path;
use crate::{JudgeError, Metric};

/// Names of the runs.
const FLAT: &str = "10 mm flat";
const PULLED: &str = "10 mm flat, pulled";
const CLAMPED: &str = "10 mm flat, ends clamped";
const DEFLECTED: &str = "10 mm bent";
const FLAT_ELEMENTS: &str = "31×21 flat";
const DEFLECTED_ELEMENTS: &str = "31×21 bent";
/// Shortening \[mm\] up to which the flat plate is compared, short of its turning point; and the bent one, on three half-waves.
const BEFORE: f64 = 0.33;
const BEYOND: f64 = 0.6;
/// Critical force with the ends clamped by the closed form \[kN\].
const CLAMPED_CRITICAL: f64 = 8.935;
/// Force of the flat plate pulled by 1.2 mm with its sides held, `E A ε/(1 − ν²)` \[kN\].
const PULL: f64 = 123.89;
/// Stiffness kept at the bifurcation over that of the flat plate, `1/(1 + 2 (a² + νb²)²/((1 − ν²)(a⁴ + 3b⁴)))`, a = 1/300, b = 1/200.
const KEPT: f64 = 0.7037;
/// Shortening \[mm\] and force \[kN\] in parts of which distances are counted: about those of the turning point.
const SCALE: (f64, f64) = (0.36, 23.0);
const NAME: &str = "distance from finite elements";

/// The scene, its references, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "plate-branches",
        title: "Thin plate beyond buckling by arc length: second bifurcation, turning point, three half-waves",
        about: "The plate of plate-post-buckling without its deflection at rest leaves its bifurcations along their modes: knee and \
                stiffness beyond it against closed forms, the path against finite elements. With ends hinged no second bifurcation \
                lies on the path, but a turning point of the shortening; with ends clamped a second bifurcation, from which an unstable \
                branch of two half-waves leaves. Bent at rest, the path leads through the turning point to three half-waves. \
                Published: events at 9.6, 35.2 and 39.6 kN, 40 % of the stiffness before the last and 30 % after it; of other \
                supports, which cannot be repeated from what is published.",
        citation: "von Kármán's plate equations to the second order; the finite-element shell of this project",
        variants: variants(),
        headline: Some(Headline::new(NAME, 0.1)),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let elements = |name: &str, deflection: f64, first: f64, until: f64| {
        Variant::elements(ELEMENTS, [31, 21], move || plate_path(10, deflection, first, until)).named(name)
    };
    let sheets = |name: &str, deflection: f64, path: &str| {
        Variant::scene(SHEETS, PLATE, name)
            .set("bodies.plate.solid.imperfection.amplitude", deflection)
            .set("analysis.arc-length", format!("{{ {path} }}"))
    };
    // The path of the flat plate ends at its first unstable state, that with ends clamped where the centre comes back to the plane.
    let unstable = "stop = { column = \"negative_pivots\", above = 0.5 }";
    let down = "{ name = \"down\", of = \"displacement\", on = \"middle\", direction = [0.0, 0.0, -1.0] }";
    let turns = "[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]";
    vec![
        elements(FLAT_ELEMENTS, 0.0, 0.0036, BEFORE),
        elements(DEFLECTED_ELEMENTS, BENT, 0.006, BEYOND).full_if(true),
        sheets(FLAT, 0.0, &format!("radius = 0.003, branches = \"stable\", {unstable}"))
            .judged(|run, runs| Ok([knee(run)?, beside_elements(run, runs, FLAT_ELEMENTS)?].concat())),
        sheets(
            CLAMPED,
            0.0,
            "radius = 0.003, branches = \"stable\", stop = { column = \"down\", above = 0.0 }",
        )
        .set("supports[0].held.director", turns)
        .set("supports[1].held.director", turns)
        .set("curve[+]", down)
        .full_if(true)
        .judged(|run, _| second(run)),
        Variant::scene(SHEETS, PLATE, PULLED)
            .set("bodies.plate.solid.imperfection.amplitude", 0.0)
            .set("supports[2].moved.direction", "[1.0, 0.0, 0.0]")
            .static_levels(&[1.0])
            .judged(|run, _| {
                let force = run.last("P")?.map(|force| 1e-3 * force.abs());
                let reason =
                    "a quarter of the strain, since bonds turn and lengthen; published 119.9 kN, 3.2 % off";
                Ok(vec![
                    Metric::compared("force when pulled", force, "kN", PULL).within(0.003 * PULL, reason),
                ])
            }),
        sheets(DEFLECTED, BENT, &format!("radius = 0.005, until = {}", BEYOND / FULL))
            .judged(|run, runs| Ok([beside_elements(run, runs, DEFLECTED_ELEMENTS)?, three(run)?].concat())),
    ]
}

/// Shortenings of critical points of a kind \[mm\], in the order of the path.
fn critical(run: &Run, kind: &str) -> Vec<f64> {
    let of_kind = run.outcome.critical.iter().filter(|point| point.kind == kind);
    of_kind.map(|point| FULL * point.level).collect()
}

/// Shortening \[mm\] and force \[kN\] at the first bifurcation, on the straight line of the flat plate.
fn first(run: &Run, points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let shortening = critical(run, "bifurcation, branch taken").first().copied()?;
    let &(u, force) = points.get(1)?;
    Some((shortening, force / u * shortening))
}

fn knee(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let points = points(run)?;
    let at = first(run, &points);
    let beyond = at.and_then(|at| points.iter().find(|point| point.1 > 1.05 * at.1));
    let kept = at.zip(beyond).map(|(at, to)| (to.1 - at.1) / (to.0 - at.0) / FLAT_STIFFNESS);
    let turning = critical(run, "limit point").first().copied();
    let top = points.iter().map(|point| point.1 / CRITICAL).reduce(f64::max);
    Ok(vec![
        Metric::compared("force at the first bifurcation", at.map(|at| at.1), "kN", CRITICAL)
            .near(0.1, "ten millimetres of spacing; a quarter of it at half of that"),
        Metric::compared("stiffness kept beyond it", kept, "-", KEPT)
            .near(0.2, "the spacing, and a secant for a tangent"),
        Metric::error("shortening at its turning point", turning, "mm")
            .shown("the plate, whose end is moved, leaves one half-wave there by a jump"),
        Metric::error("greatest force before it over critical", top, "-")
            .shown("published, of other supports: 3.67 and 4.1 times the knee for two events"),
    ])
}

/// The second bifurcation of the plate with ends clamped.
fn second(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let points = points(run)?;
    let at = first(run, &points).map(|at| at.1);
    let second = critical(run, "bifurcation, branch taken").get(1).copied();
    Ok(vec![
        Metric::compared("force at the first bifurcation", at, "kN", CLAMPED_CRITICAL)
            .near(0.19, "ten millimetres of spacing; a quarter of it at half of that"),
        Metric::error("shortening at the second", second, "mm")
            .shown("published, of other supports: 35.2 kN, 3.67 times the first"),
        Metric::error("negative pivots on its branch", run.last("negative_pivots")?, "-")
            .shown("the branch falls and is not stable: the plate jumps"),
    ])
}

/// Distances from finite elements.
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[(SHEETS, &[(FLAT, 1.4), (DEFLECTED, 1.1)])]);

fn beside_elements(run: &Run, runs: &Runs, name: &str) -> Result<Vec<Metric>, JudgeError> {
    let Some(elements) = runs.get(ELEMENTS, name)? else { return Ok(Vec::new()) };
    let off = path::distance(&points(run)?, &points(elements)?, SCALE).filter(|_| run.done());
    let reason =
        "one plate by two methods at one spacing; pieces between the points of the path are straight";
    Ok(vec![Metric::error(NAME, off, "% of .36 mm, 23 kN").near(MEASURED.of(run)?, reason)])
}

/// What is left of the stiffness with three half-waves.
fn three(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let points = points(run)?;
    let [.., a, b] = points[..] else { return Ok(Vec::new()) };
    let kept = (b.1 - a.1) / (b.0 - a.0) / FLAT_STIFFNESS;
    Ok(vec![
        Metric::error("stiffness kept with three half-waves", Some(kept).filter(|_| run.done()), "-")
            .shown("published .3, of other supports"),
    ])
}

/// Number of points before the shortening first falls.
fn turned(points: &[(f64, f64)]) -> usize {
    points.windows(2).position(|pair| pair[1].0 < pair[0].0).map_or(points.len(), |row| row + 1)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let (mut force, mut centre) = (Vec::new(), Vec::new());
    // Elements count deflections from the flat plane.
    let shown = [
        (ELEMENTS, FLAT_ELEMENTS, "w_centre", 0.0, GREY),
        (ELEMENTS, DEFLECTED_ELEMENTS, "w_centre", BENT, BLACK),
        (SHEETS, FLAT, "centre", 0.0, VERMILION),
        (SHEETS, DEFLECTED, "centre", 0.0, BLUE),
        (SHEETS, CLAMPED, "centre", 0.0, ORANGE),
    ];
    for (method, name, column, at_rest, colour) in shown {
        let Some(run) = runs.get(method, name)? else { continue };
        let (own, label) = (points(run)?, format!("{method} {name}"));
        let deflections = run.column(column)?.into_iter().map(|w| w - at_rest);
        let ways = own.iter().map(|point| point.1).zip(deflections).collect();
        let series = |points| match method {
            ELEMENTS => Series::line(&label, points, colour, Line::Solid),
            _ => Series::both(&label, points, colour, Mark::Circle),
        };
        force.push(series(own));
        centre.push(series(ways));
    }
    let mut figures = vec![
        Figure::Chart(Chart {
            title: "Force against shortening (paper, figure 3)".into(),
            caption: "The knee is a bifurcation. Where the shortening turns back, and at the second bifurcation of the plate with ends \
                      clamped, a plate whose end is moved jumps; the bent one lands on the rising branch of three half-waves."
                .into(),
            x: Axis::linear("shortening [mm]"),
            y: Axis::linear("force [kN]"),
            series: force,
        }),
        Figure::Chart(Chart {
            title: "Deflection of the centre against force (paper, figure 4)".into(),
            caption: "Zero up to the knee, one half-wave beyond it; on the way to three the centre goes to the other side."
                .into(),
            x: Axis::linear("force [kN]"),
            y: Axis::linear("deflection of the centre [mm]"),
            series: centre,
        }),
    ];
    if let Some(run) = runs.get(SHEETS, DEFLECTED)? {
        let points = points(run)?;
        let last = points.len().saturating_sub(1);
        let above = |force: f64| points.iter().position(|point| point.1 > force * CRITICAL).unwrap_or(last);
        let stages = [
            (above(1.3), "beyond the knee"),
            (above(2.5), "2.5 times the critical force"),
            (turned(&points), "beyond the turning point"),
            (last, "at the end"),
        ];
        let caption =
            "Hinged, bent at rest. Deflections 15 times enlarged; the darker, the farther along the path.";
        figures.push(waves(run, &stages, "Waves of the plate along its path (paper, figure 5)", caption));
    }
    if let Some(run) = runs.get(SHEETS, CLAMPED)? {
        let points = points(run)?;
        let stages = [
            (turned(&points).saturating_sub(1), "just off the second bifurcation"),
            (points.len().saturating_sub(1), "on the branch that leaves it"),
        ];
        let caption = "Flat at rest, ends clamped. Deflections 15 times enlarged.";
        figures.push(waves(run, &stages, "From one half-wave to two, a state that is not stable", caption));
    }
    if let Some(run) = runs.get(SHEETS, PULLED)? {
        let title = "Displacements of the flat plate in tension (paper, figure 1)";
        let caption = "Displacements 50 times enlarged: a uniform stretch between sides that are held.";
        figures.push(strained(run, run.outcome.shapes.last(), ("pulled", 50.0), title, caption));
    }
    if let Some(run) = runs.get(SHEETS, FLAT)? {
        let knee = critical(run, "bifurcation, branch taken").first().map_or(0.0, |u| u / FULL);
        let flat = run.outcome.shapes.iter().take_while(|shape| shape.level < knee).last();
        let title = "Displacements of the flat plate before it buckles (paper, figure 2)";
        let caption = "Displacements 200 times enlarged: a uniform shortening between sides that are held.";
        figures.push(strained(run, flat, ("shortened", 200.0), title, caption));
    }
    Ok(figures)
}

/// The plate at some points of its path, one behind the other.
fn waves(run: &Run, stages: &[(usize, &str)], title: &str, caption: &str) -> Figure {
    let mut sheets = Vec::new();
    for (number, &(row, words)) in stages.iter().enumerate() {
        let shape = run.outcome.shapes.get(row);
        sheets.extend(shape.map(|shape| {
            Sheet::new(words, &run.outcome.faces, shape, shade(number as f64 / stages.len() as f64))
                .stretched(2, 15.0)
                .shifted(1, 260.0 * number as f64)
        }));
    }
    let (title, caption) = (title.into(), caption.into());
    Figure::Shapes(Shapes { title, caption, view: (-70.0, 35.0), sheets })
}

/// The flat plate at rest and in a shape, its displacements so many times enlarged.
fn strained(
    run: &Run,
    shape: Option<&Shape>,
    (words, enlarged): (&str, f64),
    title: &str,
    caption: &str,
) -> Figure {
    let mut sheets = Vec::new();
    if let (Some(rest), Some(shape)) = (run.outcome.shapes.first(), shape) {
        let mut moved = Sheet::new(words, &run.outcome.faces, shape, BLUE);
        for (point, rest) in moved.points.iter_mut().zip(&rest.positions) {
            (0..3).for_each(|axis| point[axis] = rest[axis] + enlarged * (point[axis] - rest[axis]));
        }
        // Seen from above, the one on top is drawn last.
        sheets = vec![Sheet::new("at rest", &run.outcome.faces, rest, BLACK), moved.shifted(2, 1.0)];
    }
    let (title, caption) = (title.into(), caption.into());
    Figure::Shapes(Shapes { title, caption, view: (-90.0, 90.0), sheets })
}
