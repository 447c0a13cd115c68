//! plate-post-buckling: the same plate bent by a tenth of its thickness and shortened far beyond its critical force, by two
//! peridynamic sheets, by the shell of particles, and by finite elements.

use benchmarks_ref::fe_shell::cases::plate_shortened;

use super::plate_stability::{FULL, PLATE};
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, Line, Mark, Series, VERMILION};
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::methods::{ELEMENTS, SHEETS, STATIC};
use crate::support::path::value_at;
use crate::{JudgeError, Metric};

const SHELL: &str = include_str!("../../../../scenes/plate-shortened.toml");
/// Young's modulus \[N/mm²\], Poisson's ratio, lengths and thickness \[mm\], deflection at rest \[mm\].
const YOUNG: f64 = 69000.0;
const POISSON: f64 = 0.33;
const LENGTHS: [f64; 2] = [300.0, 200.0];
const THICKNESS: f64 = 2.0;
pub const BENT: f64 = 0.2;
/// Critical force of the flat plate by the closed form \[kN\].
pub const CRITICAL: f64 = 6.863;
/// Stiffness of the flat plate, E t b/((1 − ν²) a) \[kN/mm\].
pub const FLAT_STIFFNESS: f64 =
    1e-3 * YOUNG * THICKNESS * LENGTHS[1] / ((1.0 - POISSON * POISSON) * LENGTHS[0]);
/// Shortening up to which all three are compared: beyond twice the critical force \[mm\].
const COMPARED: f64 = 0.18;
const STEPS: usize = 18;
const NAME: &str = "distance from finite elements";

/// The scene, its references, and how far they may differ.
pub fn case() -> Case {
    Case {
        name: "plate-post-buckling",
        title: "Thin plate shortened through buckling and a jump of its waves: sheets, shell, finite elements",
        about: "A plate with hinged ends and sides held in its plane is bent at rest by one half-wave of 0.2 mm and shortened. \
                Knee and tangent stiffness of the sheets; the three curves up to twice the critical force; the jump to three \
                half-waves with the centre reversed. Published: 9.6 kN, 35.2 kN and 39.6 kN for the knee and two events, with \
                the same order of shapes; the loads cannot be repeated, their ratios to the first are printed.",
        citation: "von Kármán's plate equations by one term; the finite-element shell of this project; plate_stability",
        variants: variants(),
        headline: Some(Headline::new(NAME, 0.5)),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let near = format!("[{}]", levels(COMPARED, STEPS));
    let far = format!("[{}]", levels(FULL, 120));
    let sheets = |spacing: f64| {
        let plate = Variant::scene(SHEETS, PLATE, format!("{spacing} mm"));
        plate.set("bodies.plate.solid.geometry.block.spacing", spacing)
    };
    let near_of = |spacing: f64| sheets(spacing).set("analysis.static.levels", &near);
    vec![
        shell().set("analysis.static.levels", &near).quick().judged(compared),
        Variant::elements(ELEMENTS, [31, 21], || plate_shortened(10, BENT, COMPARED, STEPS)).quick(),
        near_of(10.0).quick().judged(|run, runs| Ok([knee(run)?, compared(run, runs)?].concat())),
        near_of(5.0).judged(|run, runs| Ok([knee(run)?, compared(run, runs)?].concat())),
        sheets(10.0).on("to the end").set("analysis.static.levels", far).judged(|run, _| jump(run)),
    ]
}

/// Levels of equal shortenings up to one, as parts of that at level one.
fn levels(until: f64, steps: usize) -> String {
    let level = |step: usize| (until / FULL * step as f64 / steps as f64).to_string();
    (1..=steps).map(level).collect::<Vec<_>>().join(", ")
}

/// Shortening \[mm\] and force \[kN\] of a run.
pub fn points(run: &Run) -> Result<Vec<(f64, f64)>, JudgeError> {
    if run.is(SHEETS) {
        let shortening = run.column("level")?.into_iter().map(|level| FULL * level);
        return Ok(shortening.zip(run.column("P")?).map(|(u, force)| (u, 1e-3 * force)).collect());
    }
    Ok(run.column("shortening")?.into_iter().zip(run.column("P")?).collect())
}

/// The force at a shortening \[kN\].
fn force_at(points: &[(f64, f64)], shortening: f64) -> Option<f64> {
    let (u, force): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
    value_at(&u, &force, shortening)
}

fn compared(run: &Run, runs: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let Some(elements) = runs.get(ELEMENTS, "31×21")? else { return Ok(Vec::new()) };
    let (own, theirs) = (points(run)?, points(elements)?);
    let worst = theirs
        .iter()
        .skip(1)
        .filter_map(|&(u, force)| Some((100.0 * (force_at(&own, u)? / force - 1.0)).abs()));
    let worst = worst.reduce(f64::max).filter(|_| run.done());
    let reason = "one plate by three methods: what is left is their spacings";
    Ok(vec![Metric::error(NAME, worst, "%").within(2.0, reason)])
}

/// Slope of the force between two multiples of the critical force \[kN/mm\].
fn slope(points: &[(f64, f64)], from: f64, to: f64) -> Option<f64> {
    let at = |wanted: f64| {
        let row = points.iter().position(|point| point.1 >= wanted)?;
        let [a, b] = [points.get(row.checked_sub(1)?)?, points.get(row)?];
        Some(a.0 + (wanted - a.1) / (b.1 - a.1) * (b.0 - a.0))
    };
    Some((to - from) * CRITICAL / (at(to * CRITICAL)? - at(from * CRITICAL)?))
}

fn knee(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let points = points(run)?;
    let kept = slope(&points, 1.3, 1.9).map(|slope| slope / FLAT_STIFFNESS);
    // One term of the plate's equations: P/(1 − w₀/w) = P_cr + k w (w + w₀), w from the flat plane. The line through these.
    let centre: Vec<f64> = run.column("centre")?;
    let near = points.iter().zip(&centre).filter(|(point, _)| (0.5..1.5).contains(&(point.1 / CRITICAL)));
    let line: Vec<(f64, f64)> = near
        .map(|(&(_, force), u)| {
            let w = u + BENT;
            (w * (w + BENT), force / (1.0 - BENT / w))
        })
        .collect();
    let knee = intercept(&line).map(|force| force / CRITICAL);
    Ok(vec![
        Metric::compared("knee over critical force", knee, "-", 1.0).within(
            0.02,
            "one term of the plate's equations, fitted between .5 and 1.5 of the critical force",
        ),
        Metric::compared("stiffness kept", kept, "-", 0.70)
            .within(0.03, "one term gives .704 at the critical force, and falls from there on"),
    ])
}

/// Where the straight line that fits points best crosses the axis.
fn intercept(points: &[(f64, f64)]) -> Option<f64> {
    let n = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let across: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    let slope = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / across;
    (points.len() > 2).then_some(y - slope * x)
}

/// The jump: its force, and which way the middle goes.
fn jump(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let points = points(run)?;
    let drop = points.windows(2).position(|pair| pair[1].1 < pair[0].1);
    let before = drop.map(|row| points[row].1 / CRITICAL).filter(|_| run.done());
    let centre = run.last("centre")?;
    let about = "one lattice and one way of loading; published 3.67 and 4.1 times the knee for two events";
    Ok(vec![
        Metric::compared("force of the jump over critical", before, "-", 3.4).within(0.2, about),
        Metric::error("deflection of the centre at the end, reversed", centre, "mm")
            .shown("negative: three half-waves, the middle one against the deflection at rest"),
    ])
}

/// The shell of particles: the same plate, bent at rest like its first buckling mode, which is one half-wave each way.
fn shell() -> Variant {
    let [length, width] = LENGTHS;
    let held = |side: &str, along: &str| {
        format!("{{ on = \"{side}\", held = {{ displacement = [{along}[0.0, 0.0, 1.0]] }} }}")
    };
    let moved = format!("{{ on = \"u1\", moved = {{ direction = [-1.0, 0.0, 0.0], by = {FULL} }} }}");
    let (x, y) = ("[1.0, 0.0, 0.0], ", "[0.0, 1.0, 0.0], ");
    let supports = [held("u0", x), held("u1", ""), moved, held("v0", y), held("v1", y)];
    Variant::new(STATIC, SHELL, "plate", [31, 21])
        .set("geometry.plate.lengths", format!("[{length}, {width}]"))
        .set("material.elastic", format!("{{ young = {YOUNG}, poisson = {POISSON}, density = 2.7e-9 }}"))
        .set("section.homogeneous.thickness", THICKNESS)
        .set("imperfection", format!("{{ amplitude = {BENT}, mode = 1 }}"))
        .set("supports", format!("[{}]", supports.join(", ")))
        .set("loads", "[]")
        .set("curve[0].unit", "\"kN\"")
        .set("curve[2].on", "\"all\"")
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut series = Vec::new();
    if let Some(run) = runs.get(ELEMENTS, "31×21")? {
        series.push(Series::line("finite elements 31×21", points(run)?, BLACK, Line::Solid));
    }
    if let Some(run) = runs.get(STATIC, "31×21")? {
        series.push(Series::both("shell of particles 31×21", points(run)?, BLUE, Mark::Square));
    }
    if let Some(run) = runs.get(SHEETS, "10 mm")? {
        series.push(Series::both("two sheets, 10 mm", points(run)?, VERMILION, Mark::Circle));
    }
    if let Some(run) = runs.get(SHEETS, "10 mm to the end")? {
        series.push(Series::line("two sheets, 10 mm, to the end", points(run)?, VERMILION, Line::Solid));
    }
    let force = Figure::Chart(Chart {
        title: "Force against shortening".into(),
        caption: "Published events: 9.6, 35.2 and 39.6 kN, of another stiffness and other supports; here the first is at 6.9 kN \
                  and the jump at 3.4 times that."
            .into(),
        x: Axis::linear("shortening [mm]"),
        y: Axis::linear("force [kN]"),
        series,
    });
    let Some(far) = runs.get(SHEETS, "10 mm to the end")? else { return Ok(vec![force]) };
    let forces = far.column("P")?.into_iter().map(|force| 1e-3 * force.abs());
    let ways = forces.zip(far.column("centre")?).collect();
    let centre = Figure::Chart(Chart {
        title: "Deflection of the centre against force".into(),
        caption: "As the seed paper's figure 4: the centre grows from the knee on, and goes to the other side where one half-wave \
                  becomes three."
            .into(),
        x: Axis::linear("force [kN]"),
        y: Axis::linear("deflection of the centre [mm]"),
        series: vec![Series::line("two sheets, 10 mm, to the end", ways, VERMILION, Line::Solid)],
    });
    Ok(vec![force, centre])
}
