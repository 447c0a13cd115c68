//! solid-and-bricks: solids without elements and a solid of bonds beside bricks of twenty nodes, written without their mechanics.

use benchmarks_ref::fe_shell::cases::Solved;
use benchmarks_ref::{fe_solid, reference};
use implicit_statics::EquilibriumError;

use super::{ST_VENANT, off};
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, Line, Mark, SKY, Series};
use crate::judge::{Case, Headline, Outcome, Recorded, Run, Runs, Variant};
use crate::methods::PAIRWISE;
use crate::{JudgeError, Metric};

const CANTILEVER: &str = include_str!("../../../../scenes/cantilever-solid.toml");
const PLATE: &str = include_str!("../../../../scenes/plate-solid.toml");
/// The bricks.
const BRICKS: &str = "fe bricks";
const NAME: &str = "curve against bricks";
const LEVELS: [f64; 10] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0];
const PRESSURES: [f64; 3] = [12.1, 99.4, 497.0];

/// What is held against each other: method and grid, the bricks, the distance when this was reviewed \[%\], and what it is made of.
const PAIRS: [(&str, &str, &str, f64, &str); 5] = [
    (ST_VENANT, "upper face, 21×3×3", "upper face, 20×2×2", 0.38, "the mesh: stiff by .3 % at K = 1"),
    (
        ST_VENANT,
        "plate, 11×11×3",
        "plate, a quarter of 5×5×2",
        0.16,
        "the meshes: bricks on 10×10×2 are .26 % softer",
    ),
    (PAIRWISE, "volume, 4 spacings high", "volume, 10×2×2", 5.5, FEW),
    (PAIRWISE, "volume, 6 spacings high", "volume, 10×2×2", 2.2, FEW),
    (PAIRWISE, "volume, 8 spacings high", "volume, 10×2×2", 1.0, FEW),
];
const FEW: &str = "few layers bend stiffly; what is missing falls with the square of their number";

/// The solids, and how far they may be from bricks.
pub fn case() -> Case {
    Case {
        name: "solid-and-bricks",
        title: "Solids beside bricks of twenty nodes: cantilevers to K = 10, a thin plate",
        about: "Three methods that share no mechanics, on the same bodies: strain and rotation without elements (St Venant's law, which is \
                that of the bricks), bonds with balanced weights, bricks. The bricks are those of CalculiX to its digits.",
        citation: "this project's bricks; CalculiX 2.20, C3D20",
        variants: variants(),
        together,
        headline: Some(Headline::new(NAME, 0.05)),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let law = |body: &str| format!("bodies.{body}.solid.formulation.galerkin.law");
    let mut out = vec![
        bricks(PAIRS[0].2, || fe_solid::cantilever([20, 2, 2], 0.2, &LEVELS, false)).judged(of_calculix),
        bricks(PAIRS[2].2, || fe_solid::cantilever([10, 2, 2], 0.25, &LEVELS, true)),
        bricks(PAIRS[1].2, || fe_solid::plate(5, &PRESSURES)),
        Variant::scene(ST_VENANT, CANTILEVER, PAIRS[0].1).set(&law("beam"), "st-venant").judged(finest),
        Variant::scene(ST_VENANT, PLATE, PAIRS[1].1)
            .set(&law("plate"), "st-venant")
            .static_levels(&PRESSURES),
    ];
    out.extend([4_u8, 6, 8].map(|high| bonds(high).full_if(high > 4)));
    out
}

fn bricks(
    grid: &str,
    solve: impl Fn() -> Result<Solved, EquilibriumError> + Send + Sync + 'static,
) -> Variant {
    Variant::study(BRICKS, grid, move || solve().map(Outcome::from).map_err(|error| error.to_string()))
}

/// A cantilever of bonds under its weight, so many spacings high, half its height held behind the clamp.
fn bonds(high: u8) -> Variant {
    let spacing = 25.4 / f64::from(high);
    let block = format!(
        "{{ lengths = [266.7, 25.4, 25.4], spacing = {spacing}, origin = [-12.7, 0.0, 0.0], nodes = \"edges\" }}"
    );
    let region = |from: f64, to: f64| {
        format!("{{ box = {{ min = [{from:?}, -1.0, -1.0], max = [{to:?}, 26.0, 26.0] }} }}")
    };
    Variant::scene(PAIRWISE, CANTILEVER, format!("volume, {high} spacings high"))
        .set("bodies.beam.solid.geometry.block", block)
        .set("bodies.beam.solid.material.elastic.poisson", 0.25)
        .set("bodies.beam.solid.formulation", "{ bond-based = { horizon = 1.5, correction = \"balanced\" } }")
        .set("sets.root", region(-13.0, 0.01))
        .set("sets.tip", region(253.9, 255.0))
        .set("supports", "[{ on = \"root\", clamped = {} }]")
        .set("loads", "[{ on = \"all\", gravity = { acceleration = [0.0, 0.0, -271456.69291338584] } }]")
        .set("curve.2.on", "root")
}

/// The bricks of another program on the same mesh.
fn of_calculix(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let table = reference("calculix_cantilever")?;
    let mut most: f64 = 0.0;
    for k in [1.0, 4.0, 8.0, 10.0] {
        let known = table.number(4, &format!("w/L at K = {k}"))?;
        most = most.max(run.at("w", k)?.map_or(f64::NAN, |w| (w - known).abs()));
    }
    let reason = "its figures have five digits, and a tolerance of balance of their own";
    Ok(vec![Metric::error("bricks of CalculiX", Some(most), "L").within(5e-5, reason)])
}

/// The finest bricks of another program, by levels.
fn finest(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let table = reference("calculix_cantilever")?;
    let metric = |k: u8| {
        let name = format!("w/L at K = {k}");
        let known = table.number(table.rows.len() - 1, &name)?;
        let found = Metric::compared(name, run.at("w", f64::from(k))?, "L", known);
        Ok(found.near(0.5, "the mesh: two quadratic layers across bend stiffly"))
    };
    [1, 4, 8, 10].into_iter().map(metric).collect()
}

fn together(runs: &Runs) -> Result<Vec<Recorded>, JudgeError> {
    let mut out = Vec::new();
    for (method, grid, bricks, measured, reason) in PAIRS {
        let Some(at) = runs.number(method, grid)? else { continue };
        let Some(bricks) = runs.get(BRICKS, bricks)? else { continue };
        let curve: Vec<_> = points(bricks)?.into_iter().filter(|row| row.0 > 0.0).collect();
        let found = off(&runs.chosen[at], "w", &curve)?;
        out.push((at, Metric::error(NAME, found, "%").near(measured, reason)));
    }
    Ok(out)
}

fn points(run: &Run) -> Result<Vec<(f64, f64)>, JudgeError> {
    Ok(run.column("level")?.into_iter().zip(run.column("w")?).collect())
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut out = Vec::new();
    for (title, [x, y], grids) in [
        ("Cantilevers beside bricks", ["K", "w/L"], [0, 2, 3, 4].as_slice()),
        ("Thin plate beside bricks", ["P = q a⁴/(E h⁴)", "w/h"], &[1]),
    ] {
        let mut series: Vec<Series> = Vec::new();
        for &(method, grid, bricks, ..) in grids.iter().map(|&at| &PAIRS[at]) {
            let label = format!("bricks, {bricks}");
            let drawn = series.iter().any(|one| one.label == label);
            if let Some(run) = runs.get(BRICKS, bricks)?.filter(|_| !drawn) {
                series.push(Series::line(&label, points(run)?, BLACK, Line::Solid));
            }
            let Some(run) = runs.get(method, grid)? else { continue };
            let (colour, mark) = if method == PAIRWISE { (SKY, Mark::Cross) } else { (BLUE, Mark::Disc) };
            series.push(Series::marks(&format!("{method}, {grid}"), points(run)?, colour, mark));
        }
        let (x, y, caption) = (Axis::linear(x), Axis::linear(y), "Lines: bricks of twenty nodes.".into());
        out.push(Figure::Chart(Chart { title: title.into(), caption, x, y, series }));
    }
    Ok(out)
}
