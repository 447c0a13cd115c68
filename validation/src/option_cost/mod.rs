//! What each option costs: a bare scene, every option added to it alone, and the same shell without any scene.
//!
//! A scene pays only for what it names. The rows are marched in turn, round after round, so that whatever the machine
//! does meanwhile hits all of them; the least time of the rounds counts, their spread is the noise, and the bare scene
//! stands in the table twice. Processor time is timed between two steps of the run itself, set-up left out.

mod rows;
mod sitting;
mod stopwatch;
pub mod table;

pub use rows::{AGAIN, BARE, CLAMPED, Pace, Row, SCENE, WITHOUT, rows};
pub use sitting::{Body, Sitting, bare_step, model, shell_without_scene, sit, stir};
pub use table::{CASE, what_each_option_costs};

/// How much is marched.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// Particles along an edge of the plate.
    pub side: usize,
    /// Steps timed in a sitting, one frame of fields among them.
    pub steps: u64,
    /// Sittings of each row.
    pub rounds: usize,
}

/// What a row costs.
#[derive(Clone, Debug)]
pub struct Cost {
    /// The row.
    pub row: Row,
    /// What was marched.
    pub body: Body,
    /// Steps of all sittings.
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
    let mut sittings: Vec<Vec<Sitting>> = vec![Vec::new(); rows.len()];
    for round in 0..extent.rounds.max(1) {
        for (row, own) in rows.iter().zip(&mut sittings).filter(|(row, _)| round < 2 || !row.dear) {
            let steps = if row.dear { extent.steps.div_ceil(4) } else { extent.steps };
            own.push(sit(row, extent.side, steps)?);
        }
    }
    Ok(rows.into_iter().zip(sittings).filter_map(|(row, own)| Cost::of(row, &own)).collect())
}

impl Cost {
    fn of(row: Row, sittings: &[Sitting]) -> Option<Self> {
        let last = sittings.last()?;
        let each = |time: fn(&Sitting) -> std::time::Duration| {
            let per = |s: &Sitting| time(s).as_nanos() as f64 / (s.steps as f64 * s.body.particles as f64);
            let mut all: Vec<f64> = sittings.iter().map(per).collect();
            all.sort_by(f64::total_cmp);
            all
        };
        let (processor, wall) = (each(|s| s.processor), each(|s| s.wall));
        let median = processor[processor.len() / 2];
        Some(Self {
            row,
            body: last.body,
            steps: sittings.iter().map(|s| s.steps).sum(),
            nanoseconds: processor[0],
            spread: 100.0 * (median / processor[0] - 1.0),
            wall: wall[0],
            held_bytes: last.held.map(|bytes| bytes / last.body.particles as f64),
        })
    }
}
