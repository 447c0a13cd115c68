//! Peridynamic bodies in time: marches that are watched, and what a study of one leaves behind.

use std::error::Error;
use std::ops::ControlFlow;
use std::time::Instant;

use coque::{Column, Curve};
use explicit_dynamics::{March, Record, Transient};
use peridynamics::{Law, Solid};

use crate::judge::{Outcome, Solver};
use crate::methods::{PAIRWISE, STATE};

/// Both laws of bonds with their names in tables.
pub const LAWS: [(&str, Law); 2] = [(PAIRWISE, Law::BondBased), (STATE, Law::StateBased)];

/// The name of a law in tables.
pub fn method(law: Law) -> &'static str {
    if law == Law::BondBased { PAIRWISE } else { STATE }
}

/// Marches a body without damping at 0.9 of the stable step and shows it at equal intervals, to the end or to `Break`; returns the steps done.
///
/// # Errors
/// A motion that diverges.
pub fn march(
    body: &mut Solid,
    duration: f64,
    record_every: f64,
    mut show: impl FnMut(&mut Solid, &Record) -> ControlFlow<()>,
) -> Result<u64, Box<dyn Error>> {
    let run = Transient { duration, record_every, damping: 0.0, safety: 0.9 };
    let mut march = March::start(run, body)?;
    while let Some(record) = march.next_record(body)? {
        if show(body, &record).is_break() {
            // The step that the record was taken in is done to its end.
            march.advance(body)?;
            break;
        }
    }
    Ok(march.clock().steps)
}

/// The greatest error of the energy balance of a march, and what it is measured by.
#[derive(Clone, Copy, Debug, Default)]
pub struct Balanced {
    worst: f64,
    most: f64,
}

impl Balanced {
    /// Takes in a record.
    pub fn see(&mut self, record: &Record) {
        self.worst = self.worst.max(record.balance_error.abs());
        let energy = record.energy;
        self.most = self.most.max(energy.kinetic + energy.internal).max(energy.external);
    }

    /// The greatest error over the greatest energy \[%\].
    pub fn percent(&self) -> f64 {
        if self.most > 0.0 { 100.0 * self.worst / self.most } else { 0.0 }
    }
}

/// What a march leaves behind: one row of figures with their units.
pub fn marched(body: &Solid, steps: u64, started: Instant, figures: &[(&str, &str, f64)]) -> Outcome {
    let wall_seconds = started.elapsed().as_secs_f64();
    Outcome {
        particles: body.len(),
        spacing: body.block().greatest_spacing(),
        dof: body.dof(),
        steps,
        wall_seconds,
        particle_steps_per_second: body.len() as f64 * steps as f64 / wall_seconds,
        ..Outcome::row(Solver::Explicit, figures)
    }
}

/// Figures in time: names with units, and a row for each record.
pub fn in_time(columns: &[(&str, &str)], rows: Vec<Vec<f64>>) -> Curve {
    let column = |&(name, unit): &(&str, &str)| Column { name: name.into(), unit: unit.into() };
    Curve { columns: columns.iter().map(column).collect(), rows }
}

/// Energy of all broken bonds \[F L\].
pub fn fracture_energy(body: &Solid) -> f64 {
    (0..body.len()).map(|node| body.fracture_energy(node)).sum()
}
