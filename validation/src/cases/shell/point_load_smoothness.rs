//! point-load-smoothness: one loaded particle on the panel; its neighbours have to follow without a checkerboard.

use crate::figures::{Axis, BLUE, Chart, Figure, GREEN, Line, Mark, Series, shade};
use crate::judge::Measured;
use crate::judge::{Case, Recorded, Run, Runs, Variant};
use crate::support::scenes;
use crate::{JudgeError, Metric};

use crate::methods::CELL;

const GRIDS: [usize; 3] = [11, 21, 41];
/// Rings of particles about the crown that are looked at.
const RINGS: usize = 4;

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "point-load-smoothness",
        title: "One loaded particle on the panel: do its neighbours follow?",
        about: "The crown is pushed in by 10 mm through a single particle. Second differences of the displacement about \
                it, in parts of the crown's displacement, have to fall with the spacing, and its checkerboard part \
                (what changes sign from particle to particle) with them: a zero-energy mode would not care.",
        citation: "the panel of Sze, Liu and Lo 2004; reference: itself at a coarser spacing",
        variants: GRIDS
            .iter()
            .map(|&n| {
                let variant = Variant::new(CELL, scenes::PANEL, "cylinder", [n, n]).set(
                    "analysis.explicit.quasi-static.levels",
                    "[0.16666666666666666, 0.3333333333333333]",
                );
                variant.quick_if(n < 41)
            })
            .collect(),
        together,
        figures,
        ..Case::default()
    }
}

/// Downward displacement at lattice place (i, j), both counted from the crown and mirrored there; in parts of the crown's.
fn displacement(run: &Run) -> Option<impl Fn(usize, usize) -> f64> {
    let (rest, pushed) = (run.outcome.shapes.first()?, run.outcome.shapes.last()?);
    if run.outcome.shapes.len() < 3 {
        return None;
    }
    let side = (rest.positions.len() as f64).sqrt().round() as usize;
    let down: Vec<f64> = rest.positions.iter().zip(&pushed.positions).map(|(a, b)| a[2] - b[2]).collect();
    // Particle (i, j) has number i·side + j; the crown is (0, 0).
    Some(move |i: usize, j: usize| down[i * side + j] / down[0])
}

/// Largest second difference at the crown, along either line of particles.
pub fn second_difference(run: &Run) -> Option<f64> {
    let w = displacement(run)?;
    Some((2.0 * (w(1, 0) - w(0, 0))).abs().max((2.0 * (w(0, 1) - w(0, 0))).abs()))
}

/// Largest amplitude of (−1)^(i+j) at particles at least `from` away from the crown: second differences in both
/// directions over sixteen.
pub fn checkerboard(run: &Run, from: usize) -> Option<f64> {
    const DIFFERENCE: [(isize, f64); 3] = [(-1, 1.0), (0, -2.0), (1, 1.0)];
    let w = displacement(run)?;
    let mirrored = |i: usize, by: isize| i.checked_add_signed(by).unwrap_or(1);
    let amplitude = |i: usize, j: usize| {
        let along = |a: isize| DIFFERENCE.map(|(b, weight)| weight * w(mirrored(i, a), mirrored(j, b)));
        let across = DIFFERENCE.map(|(a, weight)| weight * along(a).iter().sum::<f64>());
        (across.iter().sum::<f64>() / 16.0).abs()
    };
    let near = (0..RINGS).flat_map(|i| (0..RINGS).map(move |j| (i, j))).filter(|(i, j)| *i.max(j) >= from);
    Some(near.map(|(i, j)| amplitude(i, j)).fold(0.0, f64::max))
}

/// Second differences \[% of the crown's displacement\].
#[rustfmt::skip] // a paragraph a method
const SECOND: Measured = Measured(&[
    (CELL, &[("11×11", 9.1), ("21×21", 4.1), ("41×41", 2.4)]),
]);

/// Amplitudes of the checkerboard.
#[rustfmt::skip] // a paragraph a method
const BOARD: Measured = Measured(&[
    (CELL, &[("11×11", 0.63), ("21×21", 0.37), ("41×41", 0.26)]),
]);

/// The same from the third ring on.
#[rustfmt::skip] // a paragraph a method
const FARTHER: Measured = Measured(&[
    (CELL, &[("11×11", 0.19), ("21×21", 0.071), ("41×41", 0.031)]),
]);

fn together(runs: &Runs) -> Result<Vec<Recorded>, JudgeError> {
    let mut metrics = Vec::new();
    for (number, run) in runs.iter().enumerate() {
        let (second, board) = (second_difference(run), checkerboard(run, 0));
        let mut of_crown = |name, value: Option<f64>, measured: &Measured| -> Result<(), JudgeError> {
            let found = Metric::error(name, value.map(|v| 100.0 * v), "% of crown");
            let reason = "the shear strain of a point load, 1.7 % of the crown's displacement times a logarithm; a zero-energy \
                          mode would grow without bound";
            metrics.push((number, found.near(measured.of(run)?, reason)));
            Ok(())
        };
        of_crown("second difference", second, &SECOND)?;
        of_crown("checkerboard", board, &BOARD)?;
        of_crown("checkerboard farther off", checkerboard(run, 2), &FARTHER)?;
        let Some(coarser) = number.checked_sub(1).map(|at| &runs.chosen[at]) else { continue };
        let falls = |name, fine: Option<f64>, coarse: Option<f64>| {
            let ratio = fine.zip(coarse).map(|(fine, coarse)| fine / coarse);
            let reason = "falls with the spacing (1 would be no fall, a tenth for certainty); it does not fall \
                          to zero, for the shear strain of a point load, P/(κGt) = 1.7 % of the crown's \
                          displacement times a logarithm, is the same at every spacing";
            (number, Metric::error(name, ratio, "-").within(0.9, reason))
        };
        metrics.push(falls("second difference / coarser", second, second_difference(coarser)));
        metrics.push(falls("checkerboard / coarser", board, checkerboard(coarser, 0)));
    }
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut series = Vec::new();
    for (number, run) in runs.iter().enumerate() {
        let Some(w) = displacement(run) else { continue };
        let last = GRIDS[number.min(2)] - 1;
        let along = |by_u: bool| -> Vec<(f64, f64)> {
            (0..=last)
                .map(|i| (i as f64 / last as f64, if by_u { w(i, 0) } else { w(0, i) }))
                .filter(|(s, _)| *s <= 0.5)
                .collect()
        };
        let colour = shade(number as f64 / 2.0);
        let label = format!("{} along the arc", run.variant.grid);
        series.push(Series::both(&label, along(true), colour, Mark::Disc));
        if number + 1 == runs.chosen.len() {
            series.push(Series::line("finest, along the axis", along(false), GREEN, Line::Dashed));
        }
    }
    if series.is_empty() {
        series.push(Series::marks("no run got this far", Vec::new(), BLUE, Mark::Disc));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Displacement beside the loaded particle".into(),
        caption: "From the crown halfway to the edges. The curves of three spacings lie on each other. The loaded particle stands out by less than one percent, a tooth that is gone after three particles and falls with the spacing.".into(),
        x: Axis::linear("distance from the crown / half length of the panel"),
        y: Axis::linear("displacement / that of the crown"),
        series,
    })])
}
