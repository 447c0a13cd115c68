//! The rows in turn, round after round, and what each costs by the least of its rounds.

use super::measurement::{Body, Measurement, bare_step, measure_row};
use super::rows::{Pace, Row, rows};

/// How much is marched.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// Particles along an edge of the plate.
    pub side: usize,
    /// Steps timed in a measurement, one frame of fields among them.
    pub steps: u64,
    /// Measurements of each row.
    pub rounds: usize,
}

/// What a row costs.
#[derive(Clone, Debug)]
pub struct Cost {
    /// The row.
    pub row: Row,
    /// What was marched.
    pub body: Body,
    /// Steps of all measurements.
    pub steps: u64,
    /// Processor time of a particle-step, the least of the rounds \[ns\].
    pub nanoseconds: f64,
    /// How far the median of the rounds lies above the least \[%\].
    pub spread: f64,
    /// Wall time of a particle-step, the least of the rounds \[ns\].
    pub wall: f64,
    /// Memory that the run holds between two steps \[bytes a particle\]; none where nobody counts allocations.
    pub held_bytes: Option<f64>,
}

/// All rows of the table, on a lattice of this many particles along an edge.
///
/// # Errors
/// What the layers below refuse, in words.
pub fn table_rows(extent: &Extent) -> Result<Vec<Row>, String> {
    let Extent { side, steps, .. } = *extent;
    Ok(rows(Pace { side, dt: bare_step(side)?, frame: steps }))
}

/// Measures every row.
///
/// # Errors
/// Why a row could not be run, in words.
pub fn measure(extent: &Extent) -> Result<Vec<Cost>, String> {
    let rows = table_rows(extent)?;
    let mut measurements: Vec<Vec<Measurement>> = vec![Vec::new(); rows.len()];
    for round in 0..extent.rounds.max(1) {
        for (row, own) in rows.iter().zip(&mut measurements).filter(|(row, _)| round < 2 || !row.expensive) {
            let steps = if row.expensive { extent.steps.div_ceil(4) } else { extent.steps };
            own.push(measure_row(row, extent.side, steps)?);
        }
    }
    Ok(rows.into_iter().zip(measurements).filter_map(|(row, own)| Cost::of(row, &own)).collect())
}

impl Cost {
    fn of(row: Row, measurements: &[Measurement]) -> Option<Self> {
        let last = measurements.last()?;
        let each = |time: fn(&Measurement) -> std::time::Duration| {
            let per =
                |s: &Measurement| time(s).as_nanos() as f64 / (s.steps as f64 * s.body.particles as f64);
            let mut all: Vec<f64> = measurements.iter().map(per).collect();
            all.sort_by(f64::total_cmp);
            all
        };
        let (processor, wall) = (each(|s| s.processor), each(|s| s.wall));
        let median = processor[processor.len() / 2];
        Some(Self {
            row,
            body: last.body,
            steps: measurements.iter().map(|s| s.steps).sum(),
            nanoseconds: processor[0],
            spread: 100.0 * (median / processor[0] - 1.0),
            wall: wall[0],
            held_bytes: last.held.map(|bytes| bytes / last.body.particles as f64),
        })
    }
}
