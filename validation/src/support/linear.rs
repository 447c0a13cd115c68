//! Problems with one solution: figures of it, and answers on several lattices.

use benchmarks_ref::fe_shell::cases::{CaseError, Solved};
use benchmarks_ref::reference;

use crate::JudgeError;
use crate::judge::{Measured, Metric, Peer, Peers, Published, Run, Variant};
use crate::methods::{ELEMENTS, STATIC};

/// The last value of a column against its reference, judged by the error \[%\] measured on this run, for a reason.
pub fn figure(
    run: &Run,
    name: &str,
    column: &str,
    expected: f64,
    (measured, reason): (&Measured, &str),
) -> Result<Metric, JudgeError> {
    let value = run.column(column)?.last().copied();
    Ok(Metric::compared(name, value, "-", expected).near(measured.of(run)?, reason))
}

/// The scene on square lattices, and the finite-element case on meshes with the same nodes; of each the lattice that is of usual
/// fineness, `usual` = (particles, nodes).
pub fn lattices(
    scene: &'static str,
    geometry: &'static str,
    counts: &[usize],
    usual: (usize, usize),
    elements: impl Fn(usize) -> Result<Solved, CaseError> + Clone + Send + Sync + 'static,
) -> Vec<Variant> {
    let mut variants = Vec::new();
    for &n in counts {
        let solve = elements.clone();
        let particles = Variant::new(STATIC, scene, geometry, [n, n]).usual_if(n == usual.0);
        let nodes = Variant::elements(ELEMENTS, [n, n], move || solve(n - 1)).usual_if(n == usual.1);
        // Up to 21×21 a linear answer takes a blink.
        variants.extend([particles, nodes].map(|variant| variant.quick_if(n <= 21)));
    }
    variants
}

/// Answers of CalculiX by shells to a case, over the expected one, with their times in units of the static run on 41×41.
pub fn calculix(case: &str, expected: f64) -> Result<Option<Peers>, JudgeError> {
    let table = reference("calculix_linear_shells")?;
    let mut answers = Vec::new();
    for row in 0..table.rows.len() {
        if table.text(row, "case")? == case {
            answers.push(Peer {
                method: format!("CalculiX {}", table.text(row, "element")?),
                error: 100.0 * (table.number(row, "displacement")? / expected - 1.0).abs(),
                cost: table.number(row, "time")?,
            });
        }
    }
    Ok(Some(Peers { method: STATIC, grid: "41×41", answers }))
}

/// The answer of bricks (CalculiX), noted in a row of the linear obstacle course.
pub fn bricks(row: usize) -> Result<f64, JudgeError> {
    Ok(reference("linear_obstacle_course")?.number(row, "computed_CalculiX")?)
}

/// How far that is from the published one, in percent of that.
pub fn bricks_off(row: usize, expected: f64) -> Result<f64, JudgeError> {
    Ok(100.0 * (bricks(row)? / expected - 1.0).abs())
}

/// The published answer of a row of the linear obstacle course, and that of bricks.
pub fn published(row: usize, expected: f64) -> Result<Vec<Published>, JudgeError> {
    Ok(vec![
        Published { source: "MacNeal and Harder 1985", error: None },
        Published { source: "CalculiX, bricks", error: Some(bricks_off(row, expected)?) },
    ])
}
