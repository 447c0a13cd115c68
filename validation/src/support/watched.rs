//! Scenes that are looked at: led from record to record, with figures of their fields beside the columns of their curve.

use std::ops::ControlFlow;
use std::sync::Arc;

use coque::{Column, Event, Simulation};

use super::studies::model;
use crate::judge::{Outcome, Problem, Variant};

/// What a look at a record sees: a figure for each column that is added; `Break` ends the run behind it.
pub type Seen = ControlFlow<Vec<f64>, Vec<f64>>;

/// The same scene, whose curve has further columns, names with units, that `look` reads off the fields at each record.
pub fn watched(
    scene: Variant,
    columns: &[(&str, &str)],
    look: impl Fn(&Simulation<'_>) -> Result<Seen, String> + Send + Sync + 'static,
) -> Variant {
    let built = scene.clone();
    let column = |&(name, unit): &(&str, &str)| Column { name: name.into(), unit: unit.into() };
    let columns: Vec<Column> = columns.iter().map(column).collect();
    let run = move || {
        let mut simulation = Simulation::new(model(&built, 1)?);
        let mut seen = Vec::new();
        // How a run ends that fails stands in its outcome.
        while let Ok(event) = simulation.advance() {
            match event {
                Event::Step => {}
                Event::End => break,
                Event::Record => match look(&simulation)? {
                    ControlFlow::Continue(row) => seen.push(row),
                    ControlFlow::Break(row) => {
                        seen.push(row);
                        break;
                    }
                },
            }
        }
        let stopped = simulation.ended().is_none();
        let mut outcome = simulation.finish();
        outcome.curve.columns.extend(columns.iter().cloned());
        for (row, more) in outcome.curve.rows.iter_mut().zip(seen) {
            row.extend(more);
        }
        let outcome = Outcome::from(outcome);
        Ok(if stopped { Outcome { failure: None, ..outcome } } else { outcome })
    };
    Variant { source: Problem::Study(Arc::new(run)), settles: false, ..scene }
}
