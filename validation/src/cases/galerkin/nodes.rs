//! galerkin-nodes: the source's three problems on coarser and finer nodes, by its basis and by one that suits them.

use super::{INCREMENTS, off, table};
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, GREEN, GREY, Line, Mark, Numbers, Series, VERMILION};
use crate::judge::{Case, Headline, Recorded, Run, Runs, Variant};
use crate::{JudgeError, Metric};

const CANTILEVER: &str = include_str!("../../../../scenes/cantilever-solid.toml");
const ISOTROPIC: &str = include_str!("../../../../scenes/plate-solid.toml");
const ORTHOTROPIC: &str = include_str!("../../../../scenes/plate-orthotropic.toml");
/// What the source takes.
const SOURCE: &str = "{ basis = \"linear\", support.sphere = 2.5 }";
const LINEAR: &str = "linear basis";
const NAME: &str = "curve against theory";
const CHANGE: &str = "change to the finest nodes";
const INCH: f64 = 0.138;

/// One of the source's problems.
struct Problem {
    name: &'static str,
    scene: &'static str,
    body: &'static str,
    /// Spacings of so many nodes along a side.
    spacing: fn(f64) -> [f64; 3],
    nodes: [usize; 3],
    /// Table of the theory with its columns, and the unit of its deflections.
    table: [&'static str; 3],
    unit: f64,
    /// The basis of the scene.
    basis: &'static str,
    /// Distances from theory when this was reviewed, of that basis and of the source's \[%\].
    theory: [[f64; 3]; 2],
    /// Changes from the coarser nodes to the finest, likewise \[%\].
    change: [[f64; 2]; 2],
    axes: [&'static str; 2],
}

#[rustfmt::skip] // a table
const PROBLEMS: [Problem; 3] = [
    Problem { name: "cantilever", scene: CANTILEVER, body: "beam", spacing: |n| [254.0 / (n - 1.0), 12.7, 12.7], nodes: [11, 21, 31],
        table: ["holden_cantilever", "K", "reissner_top_surface_load_w_over_L"], unit: 1.0, basis: "quadratic basis",
        theory: [[1.85, 0.94, 0.81], [2.6, 1.6, 1.45]], change: [[1.8, 0.2], [1.15, 0.15]], axes: ["K", "w/L"] },
    Problem { name: "isotropic plate", scene: ISOTROPIC, body: "plate", spacing: |n| [100.0 / (n - 1.0), 100.0 / (n - 1.0), 0.5], nodes: [7, 11, 15],
        table: ["levy_plate", "P", "w_immovable_normal"], unit: 1.0, basis: "plate17",
        theory: [[2.35, 0.36, 0.29], [9.4, 2.15, 0.46]], change: [[2.1, 0.07], [8.9, 1.7]], axes: ["P = q a⁴/(E h⁴)", "w/h"] },
    Problem { name: "orthotropic plate", scene: ORTHOTROPIC, body: "plate", spacing: |n| [304.8 / (n - 1.0), 304.8 / (n - 1.0), 1.7526], nodes: [7, 11, 15],
        table: ["zaghloul_orthotropic_plate", "q_psi", "w_in_tangential_fixed_normal_free"], unit: INCH, basis: "plate17",
        theory: [[1.0, 0.23, 0.26], [8.1, 1.6, 0.18]], change: [[0.86, 0.08], [7.9, 1.45]], axes: ["q [psi]", "w/h"] },
];

const MESH: &str =
    "what is left is the mesh at the least load, of the cantilever the law at the greatest too (.5 %)";
const LOCKS: &str =
    "the linear basis locks in bending: most at the least load, where membrane stresses bear little";
const SETTLED: &str = "the greatest of all levels: that of the least load";

/// The problems, their theories, and how far nodes may be from each other.
pub fn case() -> Case {
    Case {
        name: "galerkin-nodes",
        title: "Strain and rotation on ever more nodes: cantilever 11, 21, 31×3×3, plates of 7, 11 and 15²×3 nodes",
        about: "The source says of its three problems that 21×3×3 and 11×11×3 nodes have converged. By its linear basis on balls the \
                cantilever has, to .15 %; plates still change by 1.4 and 1.7 % at the least load, and by less than .1 % at the greatest, which \
                is what a chart shows. By bases that do not lock all three change by less than .25 %.",
        citation: "Song and Zhou 2018, Figs. 4, 6 and 7; Levy 1942; Zaghloul and Kennedy 1975",
        variants: variants(),
        together,
        headline: Some(Headline::new(NAME, 0.01)),
        figures,
        ..Case::default()
    }
}

impl Problem {
    /// Name of a run.
    fn grid(&self, number: usize, source: bool) -> String {
        let nodes = self.nodes[number];
        let grid =
            if self.body == "beam" { format!("{nodes}×3×3") } else { format!("{nodes}×{nodes}×3") };
        format!("{}, {grid}, {}", self.name, if source { LINEAR } else { self.basis })
    }

    /// Loads and deflections of the theory.
    fn theory(&self) -> Result<Vec<(f64, f64)>, JudgeError> {
        let [name, loads, deflections] = self.table;
        table(name, [loads, deflections], self.unit)
    }
}

fn variants() -> Vec<Variant> {
    let mut out = Vec::new();
    for (problem, number, source) in all() {
        let spacing = (problem.spacing)(problem.nodes[number] as f64);
        let path = |key: &str| format!("bodies.{}.solid.{key}", problem.body);
        let mut variant = Variant::scene(INCREMENTS, problem.scene, problem.grid(number, source))
            .set(&path("geometry.block.spacing"), format!("{spacing:?}"));
        if source {
            variant = variant.set(&path("formulation.galerkin"), SOURCE);
        }
        let expensive = problem.name == "orthotropic plate" || (problem.body == "plate" && number == 2);
        let measured = problem.theory[usize::from(source)][number];
        let reason = if source && problem.body == "plate" { LOCKS } else { MESH };
        out.push(variant.full_if(expensive).judged(move |run, _| {
            let found = off(run, "w", &problem.theory()?)?;
            Ok(vec![Metric::error(NAME, found, "%").near(measured, reason)])
        }));
    }
    out
}

/// Every problem on each of its grids by both bases.
fn all() -> impl Iterator<Item = (&'static Problem, usize, bool)> {
    let grids =
        |problem| (0..3).flat_map(move |number| [false, true].map(|source| (problem, number, source)));
    PROBLEMS.iter().flat_map(grids)
}

/// What finer nodes change.
fn together(runs: &Runs) -> Result<Vec<Recorded>, JudgeError> {
    let mut out = Vec::new();
    for (problem, number, source) in all().filter(|(_, number, _)| *number < 2) {
        let Some(at) = runs.number(INCREMENTS, &problem.grid(number, source))? else { continue };
        let Some(finest) = runs.get(INCREMENTS, &problem.grid(2, source))? else { continue };
        let curve: Vec<_> = points(finest)?.into_iter().filter(|row| row.0 > 0.0).collect();
        let found = off(&runs.chosen[at], "w", &curve)?;
        let measured = problem.change[usize::from(source)][number];
        out.push((at, Metric::error(CHANGE, found, "%").near(measured, SETTLED)));
    }
    Ok(out)
}

/// Loads and deflections of a run.
fn points(run: &Run) -> Result<Vec<(f64, f64)>, JudgeError> {
    Ok(run.column("level")?.into_iter().zip(run.column("w")?).collect())
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let (mut out, mut rows) = (Vec::new(), Vec::new());
    for problem in &PROBLEMS {
        let mut series = Vec::new();
        for (source, colour) in [(true, VERMILION), (false, BLUE)] {
            for (number, mark) in [Mark::Cross, Mark::Square, Mark::Disc].into_iter().enumerate() {
                let grid = problem.grid(number, source);
                let Some(run) = runs.get(INCREMENTS, &grid)? else { continue };
                let points = points(run)?;
                let ends = [points.get(1), points.last()].map(|row| row.map_or(0.0, |row| row.1));
                let [first, last] = ends.map(|w| format!("{w:.5}"));
                rows.push(vec![grid.clone(), first, last]);
                let label = grid.split_once(", ").map_or(grid.as_str(), |(_, rest)| rest);
                series.push(Series::marks(label, points, colour, mark));
            }
        }
        let Some(last) = series.iter().flat_map(|one| one.points.last()).map(|row| row.0).reduce(f64::max)
        else {
            continue;
        };
        let up_to = |rows: Vec<(f64, f64)>| rows.into_iter().filter(|row| row.0 <= last).collect();
        if problem.body == "beam" {
            let column = |name: &str| table(problem.table[0], [problem.table[1], name], 1.0);
            let linear = column("linear_w_over_L")?.into_iter().filter(|row| row.1 < 0.8).collect();
            series.push(Series::line("linear theory", linear, GREY, Line::Dashed));
            series.push(Series::line("Holden", up_to(column("dead_w_over_L")?), GREEN, Line::Solid));
        }
        let label = if problem.body == "beam" { "beam, upper face" } else { "von Kármán" };
        series.push(Series::line(label, up_to(problem.theory()?), BLACK, Line::Solid));
        out.push(Figure::Chart(Chart {
            title: format!("On ever more nodes: {}", problem.name),
            caption: "The source's basis in red, the basis of the scene in blue.".into(),
            x: Axis::linear(problem.axes[0]),
            y: Axis::linear(problem.axes[1]),
            series,
        }));
    }
    out.push(Figure::Numbers(Numbers {
        title: "Deflection by nodes".into(),
        caption: "Over the length of the cantilever, over the thickness of plates.".into(),
        head: ["", "first level", "last level"].map(String::from).into(),
        rows,
    }));
    Ok(out)
}
