//! What the linear problems share: figures of one solution, and answers on several lattices.

use benchmarks_ref::fe_shell::cases::{CaseError, Solved};
use benchmarks_ref::reference;

use super::dial::{ELEMENTS, STATIC};
use crate::case::{Run, Variant};
use crate::{JudgeError, Metric};

/// The last value of a column against its reference, judged in percent of it.
pub fn figure(
    run: &Run,
    name: &str,
    column: &str,
    expected: f64,
    (percent, reason): (Option<f64>, &str),
) -> Result<Metric, JudgeError> {
    let value = run.column(column)?.last().copied();
    let metric = Metric::compared(name, value, "-", expected);
    Ok(match percent {
        Some(percent) => metric.within(0.01 * percent * expected.abs(), reason),
        None => metric.because(reason),
    })
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

/// The answer of bricks (CalculiX) noted in a row of the linear obstacle course.
pub fn bricks(row: usize) -> Result<f64, JudgeError> {
    Ok(reference("linear_obstacle_course")?.number(row, "computed_CalculiX")?)
}
