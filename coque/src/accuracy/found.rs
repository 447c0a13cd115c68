//! What a run on one lattice found, and the runs on the others.

use std::ops::ControlFlow;
use std::time::Instant;

use sph_core::{Cell, Vec3};

use super::nested::Nested;
use super::pairing::{Key, Shapes, by_column, by_shape};
use super::refined::Refined;
use crate::results::curve::Curve;
use crate::results::error_bars::{Errors, LatticeRun};
use crate::run::outcome::{Ended, Outcome};
use crate::run::progress::{Progress, ProgressReport};
use crate::scene::error::SceneError;

/// A run on a lattice.
pub(super) struct Found {
    /// Spacing over that of the scene \[–\].
    pub spacing: f64,
    /// What was measured.
    pub curve: Curve,
    /// Kind and level of the critical points.
    pub critical: Vec<(String, f64)>,
    /// Rows that were balanced, the others being cubics of the level between; empty where all were.
    pub balanced: Vec<usize>,
    rest: Vec<Vec3>,
    cells: Vec<Cell>,
    /// Places in each shape.
    shapes: Vec<Vec<Vec3>>,
}

impl Found {
    /// What a run on a lattice of such spacing, with such places at rest, found.
    pub fn of(spacing: f64, rest: Vec<Vec3>, outcome: &Outcome) -> Self {
        let critical = outcome.summary.record.critical.iter();
        Self {
            spacing,
            curve: outcome.curve.clone(),
            critical: critical.map(|point| (point.kind.clone(), point.level)).collect(),
            balanced: Vec::new(),
            rest,
            cells: outcome.cells.clone(),
            shapes: outcome.shapes.iter().map(|shape| shape.positions.clone()).collect(),
        }
    }

    /// Shapes of modes, a row each.
    pub fn shapes(&self) -> Shapes<'_> {
        let modes = self.shapes.iter().take(self.curve.rows.len()).map(Vec::as_slice).collect();
        Shapes { rest: &self.rest, cells: &self.cells, modes }
    }
}

/// Where a run without time on another lattice begins.
#[derive(Clone, Copy)]
pub(super) struct Starts<'a> {
    /// The states of the run, if they are known.
    pub nested: Option<&'a Nested<'a>>,
    /// What the run measured.
    pub own: &'a Curve,
    /// Whether the last level alone is wanted.
    pub last: bool,
}

/// Runs a companion; none where it is refused or finds nothing, which is said; `Break` where it was ended from outside.
pub(super) fn run(
    companion: &Refined,
    starts: Starts<'_>,
    threads: usize,
    progress: &mut dyn Progress,
    errors: &mut Errors,
) -> ControlFlow<(), Option<Found>> {
    let Refined { spacing, lattice, .. } = companion;
    let begun = Instant::now();
    let (rest, outcome, balanced) = match from_starts(companion, starts, threads, progress) {
        Ok(found) => found,
        Err(error) => {
            errors.without.push(format!("the scene is refused on {lattice}: {error}"));
            return ControlFlow::Continue(None);
        }
    };
    let (seconds, ended) = (begun.elapsed().as_secs_f64(), outcome.ended.to_string());
    errors.lattices.push(LatticeRun { lattice: lattice.clone(), spacing: *spacing, seconds, ended });
    if let Ended::Interrupted { .. } = outcome.ended {
        return ControlFlow::Break(());
    }
    if outcome.ended != Ended::Done {
        let rows = "; rows beyond have a bar of fewer lattices, or none";
        errors.without.push(format!("the run on {lattice} ended early: {}{rows}", outcome.ended));
    }
    let found = Found { balanced, ..Found::of(*spacing, rest, &outcome) };
    ControlFlow::Continue((!outcome.curve.rows.is_empty()).then_some(found))
}

/// Places at rest, what a run finds, its levels begun at those of another lattice, and the rows that it balanced; begun anew where one of them is
/// not found from there.
fn from_starts(
    companion: &Refined,
    Starts { nested, own, last }: Starts<'_>,
    threads: usize,
    progress: &mut dyn Progress,
) -> Result<(Vec<Vec3>, Outcome, Vec<usize>), SceneError> {
    if let Some(nested) = nested {
        let scene = &companion.scene;
        let mut begun = if last { nested.begun_at_last(scene)? } else { nested.begun(scene)? };
        let mut model = begun.scene.build(threads)?;
        let rest = model.body.body().configuration().rest.to_vec();
        model.increments = std::mem::take(&mut begun.increments);
        let mut outcome = model.run(&mut Quiet(progress));
        if !matches!(outcome.ended, Ended::Diverged(_)) && begun.is_alike(own, &outcome.curve) {
            if last {
                return Ok((rest, outcome, Vec::new()));
            }
            outcome.curve = begun.at_all(own, &outcome.curve);
            return Ok((rest, outcome, begun.rows));
        }
    }
    let model = companion.scene.build(threads)?;
    let rest = model.body.body().configuration().rest.to_vec();
    Ok((rest, model.run(&mut Quiet(progress)), Vec::new()))
}

/// The rows of another run that answer those of a run.
pub(super) fn rows(own: &Found, other: &Found, key: &Key) -> Vec<Option<Vec<f64>>> {
    match key {
        Key::Only => {
            own.curve.rows.iter().enumerate().map(|(row, _)| other.curve.rows.get(row).cloned()).collect()
        }
        Key::Column(at) => by_column(&own.curve, &other.curve, *at),
        Key::Shape => {
            let pairs = by_shape(&own.shapes(), &other.shapes());
            (0..own.curve.rows.len())
                .map(|row| pairs.get(row).copied().flatten().and_then(|at| other.curve.rows.get(at).cloned()))
                .collect()
        }
    }
}

/// A run on another lattice, of which its rows are nobody's.
pub(super) struct Quiet<'a>(pub &'a mut dyn Progress);

impl Progress for Quiet<'_> {
    fn update(&mut self, news: &ProgressReport) -> ControlFlow<()> {
        self.0.update(news)
    }
}
