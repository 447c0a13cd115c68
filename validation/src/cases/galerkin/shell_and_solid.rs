//! shell-and-solid: the same plate, ring and panel as a shell and as a solid, and what the difference is made of.

use std::f64::consts::PI;

use benchmarks_ref::fe_shell::cases::{PlateEdges, plate_deflection};
use benchmarks_ref::{Curve, reference};

use super::INCREMENTS;
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, GREEN, Line, Mark, Numbers, Series};
use crate::judge::{Case, Headline, Recorded, Run, Runs, Variant};
use crate::methods::{ELEMENTS, STATIC};
use crate::support::path::value_at;
use crate::support::scenes;
use crate::{JudgeError, Metric};

const PLATE_SOLID: &str = include_str!("../../../../scenes/plate-clamped-solid.toml");
const PLATE_SHELL: &str = include_str!("../../../../scenes/plate-clamped.toml");
const RING_SOLID: &str = include_str!("../../../../scenes/thick-ring-solid.toml");
const RING_SHELL: &str = include_str!("../../../../scenes/thick-ring.toml");
const PANEL_SOLID: &str = include_str!("../../../../scenes/panel-solid.toml");

const RATIO: &str = "solid over shell";
const RING: &str = "ring";
const PANEL: &str = "panel";

/// Thickness over side, the deflection of Mindlin's plate (`plate_static_square`), and the solid's over the shell's when this was
/// reviewed.
const PLATES: [(f64, f64, f64); 3] =
    [(0.1, 0.001_504_63, 0.96442), (0.05, 0.001_327_26, 0.98029), (0.01, 0.001_267_85, 0.98625)];

/// The pairs, and how far a shell may be from its solid.
pub fn case() -> Case {
    Case {
        name: "shell-and-solid",
        title: "Plate, ring and panel as a shell and as a solid",
        about: "The error of the model that a shell is. A clamped plate: a solid clamped over its faces can neither warp there nor come in \
                across, which a shell lets it, and both vanish with h/a. A thick ring: a shell adds shear and stretch to bending \
                but takes its section as flat; curved, it is 6 % stiffer. The hinged panel of t = 12.7 mm is thin: shell and solid agree \
                but for the force at a point, under which a solid gives way.",
        citation: "reference: each other; Mindlin's plate, Winkler's curved beam, bricks of CalculiX",
        variants: variants(),
        together,
        headline: Some(Headline::new(RATIO, 0.01)),
        figures,
        ..Case::default()
    }
}

fn plate(h: f64) -> String {
    format!("plate h/a {h}")
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for (h, mindlin, _) in PLATES {
        let young = format!("{:?}", 10.92 / (h * h * h));
        let block = format!(
            "{{ lengths = [0.5, 0.5, {h}], spacing = [0.05, 0.05, {}], origin = [0.0, 0.0, {}] }}",
            0.5 * h,
            -0.5 * h
        );
        let solid = Variant::scene(INCREMENTS, PLATE_SOLID, plate(h))
            .set("bodies.plate.solid.geometry.block", block)
            .set("bodies.plate.solid.material.elastic.young", &young);
        let shell = Variant::scene(STATIC, PLATE_SHELL, plate(h))
            .set("section.homogeneous.thickness", format!("{h:?}"))
            .set("material.elastic.young", &young);
        let elements =
            Variant::elements(ELEMENTS, [21, 21], move || plate_deflection(20, h, PlateEdges::Clamped))
                .named(plate(h));
        variants.extend([shell, elements].map(|variant| {
            variant.quick().judged(move |run, _| {
                let found = Metric::compared("Mindlin's plate", run.last("w_centre")?, "a", mindlin);
                Ok(vec![found.near(0.2, "the mesh: 41×41 particles, 21×21 nodes on the whole plate")])
            })
        }));
        variants.push(solid.quick_if(h == 0.1));
    }
    variants.push(
        Variant::scene(INCREMENTS, RING_SOLID, RING)
            .set("bodies.ring.solid.geometry.arc.cells", "[20, 2, 6]")
            .judged(|run, _| {
                let found = Metric::compared("Winkler's curved beam", run.last("w_crown")?, "cm", winkler());
                Ok(vec![found.near(0.11, "the beam knows no stress across its axis")])
            }),
    );
    variants.push(Variant::scene(STATIC, RING_SHELL, RING).quick().judged(|run, _| {
        let found =
            Metric::compared("flat section with shear and stretch", run.last("w_crown")?, "cm", flat());
        Ok(vec![found.near(0.04, "the mesh: 41 particles on a quarter")])
    }));
    let levels: Vec<f64> = (1..=12).map(|level| f64::from(level) / 24.0).collect();
    variants.push(
        Variant::scene(INCREMENTS, PANEL_SOLID, PANEL)
            .static_levels(&levels)
            .judged(|run, _| limit_of(run, 0.15)),
    );
    let shell = Variant::new(STATIC, scenes::PANEL, "cylinder", [21, 21]).static_levels(&levels).named(PANEL);
    variants.push(shell.judged(|run, _| limit_of(run, 0.69)));
    variants
}

/// Radius, thickness, moduli, half the force of the ring.
const RADIUS: f64 = 1.591_549_430_918_953_5;
const YOUNG: f64 = 1200.0;
const HALF: f64 = 20.0;

/// Half of the opening of the ring by a flat section, bending and shear (5/6) and stretch \[cm\].
fn flat() -> f64 {
    let (inertia, area) = (1.0 / 12.0, 1.0);
    let bending = HALF * RADIUS.powi(3) / (YOUNG * inertia) * (PI / 4.0 - 2.0 / PI);
    let shear = HALF * RADIUS * PI / 4.0 / (YOUNG / 2.0 * area * 5.0 / 6.0);
    bending + shear + HALF * RADIUS * PI / 4.0 / (YOUNG * area)
}

/// The same by Winkler's beam, whose neutral axis lies e inside the middle one: its stretch couples with bending.
fn winkler() -> f64 {
    let neutral = 1.0 / libm::log((RADIUS + 0.5) / (RADIUS - 0.5));
    let e = RADIUS - neutral;
    let moments = HALF * (RADIUS * PI / 4.0 - 2.0 * neutral / PI);
    let shear = HALF * RADIUS * PI / 4.0 / (YOUNG / 2.0 * 5.0 / 6.0);
    moments * (RADIUS / e - 1.0) / YOUNG + shear
}

/// The first maximum of the load over the crown \[N\].
fn limit(run: &Run) -> Result<Option<f64>, JudgeError> {
    let (w, p) = (run.column("w_crown")?, run.column("P")?);
    Ok(Curve::new(w, p).and_then(|curve| curve.maximum(5.0..15.0)).ok().map(|limit| limit.y))
}

/// The limit load of the panel beside that of bricks.
fn limit_of(run: &Run, measured: f64) -> Result<Vec<Metric>, JudgeError> {
    let bricks = reference("fe_hinged_roof_t12p7_isotropic")?;
    let curve = bricks.curve("minus_W_C", "P");
    let Some(known) = curve.and_then(|curve| curve.maximum(5.0..15.0)).ok().map(|limit| limit.y) else {
        return Ok(Vec::new());
    };
    let found = Metric::compared("limit load of bricks", limit(run)?, "N", known);
    Ok(vec![found.near(measured, "meshes, and the place under the force, which a shell keeps whole")])
}

fn together(runs: &Runs) -> Result<Vec<Recorded>, JudgeError> {
    let mut metrics = Vec::new();
    let pairs = PLATES.map(|(h, _, ratio)| (plate(h), "w_centre", ratio));
    for (grid, column, ratio) in pairs.into_iter().chain([(RING.into(), "w_crown", 0.93814)]) {
        let (Some(at), Some(shell)) = (runs.number(INCREMENTS, &grid)?, runs.get(STATIC, &grid)?) else {
            continue;
        };
        let found =
            runs.chosen[at].last(column)?.zip(shell.last(column)?).map(|(solid, shell)| solid / shell);
        let reason = "a difference of models that is shown by the figures beside it: a change by a fifth of it is a change of mechanics";
        metrics.push((at, Metric::compared(RATIO, found, "-", ratio).within(0.2 * (1.0 - ratio), reason)));
    }
    if let (Some(at), Some(shell)) = (runs.number(INCREMENTS, PANEL)?, runs.get(STATIC, PANEL)?) {
        let found = limit(&runs.chosen[at])?.zip(limit(shell)?).map(|(solid, shell)| solid / shell);
        let reason = "thin as it is, t/R = 1/200: what bricks and shells of the literature differ by";
        metrics.push((at, Metric::compared(RATIO, found, "-", 1.0).within(0.015, reason)));
    }
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut rows = Vec::new();
    let words = |value: Option<f64>| value.map_or("-".into(), |value| format!("{value:.6}"));
    for (grid, column, made_of) in [
        (
            plate(0.1),
            "w_centre",
            "faces that may not warp nor come in at the clamp; shear is in both: 19 % over the thin plate",
        ),
        (plate(0.05), "w_centre", "half of that"),
        (plate(0.01), "w_centre", "nothing but the mesh: 1.4 % on 10 cells a quarter, 2.9 % on 5"),
        (RING.into(), "w_crown", "the curvature of the section: -6.1 % by Winkler's beam"),
        (PANEL.into(), "P", "the point load: in a solid the place under it gives way"),
    ] {
        let value = |method: &str| -> Result<Option<f64>, JudgeError> {
            let Some(run) = runs.iter().find(|run| run.is(method) && run.variant.grid == grid) else {
                return Ok(None);
            };
            if grid == PANEL { limit(run) } else { run.last(column) }
        };
        let (solid, shell, elements) = (value(INCREMENTS)?, value(STATIC)?, value(ELEMENTS)?);
        let ratio = solid.zip(shell).map(|(solid, shell)| solid / shell);
        rows.push(vec![
            grid.clone(),
            words(solid),
            words(shell),
            words(elements),
            words(ratio),
            made_of.into(),
        ]);
    }
    let numbers = Numbers {
        title: "Shell against solid".into(),
        caption:
            "Central deflections of the plate, half of the opening of the ring, limit load of the panel."
                .into(),
        head: ["", "solid", "shell", "fe shell", "solid / shell", "what the difference is made of"]
            .map(String::from)
            .into(),
        rows,
    };
    let mut series = Vec::new();
    for (method, label, colour, mark) in
        [(INCREMENTS, "solid", BLUE, Mark::Disc), (STATIC, "shell", GREEN, Mark::Circle)]
    {
        let Some(run) = runs.get(method, PANEL)? else { continue };
        let (w, p) = (run.column("w_crown")?, run.column("P")?);
        let fine: Vec<(f64, f64)> = (0..=60)
            .filter_map(|i| Some((0.25 * f64::from(i), value_at(&w, &p, 0.25 * f64::from(i))?)))
            .collect();
        series.push(Series::line(label, fine, if mark == Mark::Disc { colour } else { BLACK }, Line::Solid));
        series.push(Series::marks(label, w.into_iter().zip(p).collect(), colour, mark));
    }
    let chart = Chart {
        title: "Panel, load over crown".into(),
        caption: "The Galerkin solid beside the shell.".into(),
        x: Axis::linear("w [mm]"),
        y: Axis::linear("P [N]"),
        series,
    };
    Ok(vec![Figure::Numbers(numbers), Figure::Chart(chart)])
}
