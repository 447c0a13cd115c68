//! What the linear problems share: figures of one solution, and answers on several lattices.

use benchmarks_ref::fe_shell::cases::{CaseError, Solved};
use benchmarks_ref::reference;

use super::dial::{ELEMENTS, STATIC};
use crate::case::{Published, Run, Variant};
use crate::{JudgeError, Metric};

/// The last value of a column against its reference, judged in percent of it.
pub fn figure(
    run: &Run,
    name: &str,
    column: &str,
    expected: f64,
    (percent, reason): Judged,
) -> Result<Metric, JudgeError> {
    let value = run.column(column)?.last().copied();
    let metric = Metric::compared(name, value, "-", expected);
    Ok(match percent {
        Some(percent) => metric.within(0.01 * percent * expected.abs(), reason),
        None => metric.because(reason),
    })
}

/// A tolerance in percent, if there is one, and where it or its lack comes from.
pub type Judged = (Option<f64>, &'static str);

/// One percent for elements at 16 a side and for particles at 21².
pub fn one_percent(run: &Run) -> Judged {
    match (run.variant.method.as_str(), run.variant.grid.as_str()) {
        (ELEMENTS, "17×17") => (Some(1.0), "issue 3: finite elements within 1 % at 16 elements a side"),
        (ELEMENTS, _) => (None, "judged at 16 elements a side"),
        (_, "21×21") => (Some(1.0), "issue 3: particles within 1 % at 21² a quarter"),
        _ => (None, "judged at 21²"),
    }
}

/// The scene on square lattices, and the finite-element case on meshes with the same nodes.
pub fn lattices(
    scene: &'static str,
    geometry: &'static str,
    counts: &[usize],
    elements: impl Fn(usize) -> Result<Solved, CaseError> + Clone + Send + Sync + 'static,
) -> Vec<Variant> {
    let mut variants = Vec::new();
    for &n in counts {
        let solve = elements.clone();
        let particles = Variant::new(STATIC, scene, geometry, [n, n]);
        let nodes = Variant::elements(ELEMENTS, [n, n], move || solve(n - 1));
        // Up to 21×21 a linear answer takes a blink.
        let judged = |variant: Variant| if n <= 21 { variant.quick() } else { variant };
        variants.extend([judged(particles), judged(nodes)]);
    }
    variants
}

/// How far the answer of bricks (CalculiX), noted in a row of the linear obstacle course, is from the published one, in
/// percent of that.
pub fn bricks(row: usize, expected: f64) -> Result<f64, JudgeError> {
    let found = reference("linear_obstacle_course")?.number(row, "computed_CalculiX")?;
    Ok(100.0 * (found / expected - 1.0).abs())
}

/// The published answer of a row of the linear obstacle course, and that of bricks.
pub fn published(row: usize, expected: f64) -> Result<Vec<Published>, JudgeError> {
    Ok(vec![
        Published { source: "MacNeal and Harder 1985", error: None },
        Published { source: "CalculiX, bricks", error: Some(bricks(row, expected)?) },
    ])
}
