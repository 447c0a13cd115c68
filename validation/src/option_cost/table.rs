//! The table of the report and of the printed output.

use super::rows::{AGAIN, BARE, Pace, Row, WITHOUT, rows};
use crate::record::Record;
use crate::report::Numbers;
use crate::run::CaseResult;

/// Name of the case.
pub const CASE: &str = "option-cost";
/// Metric: processor time of a particle-step \[ns\].
pub const TIME: &str = "time a particle-step";
/// Metric: how far the median of the rounds lies above the least \[%\].
pub const SPREAD: &str = "spread";
/// Metric: time beyond the row that it is added to \[%\].
pub const MORE_TIME: &str = "increment";
/// Metric: memory that a step touches \[bytes a particle\].
pub const STEP_BYTES: &str = "memory of a step";
/// Metric: memory that the run holds \[bytes a particle\].
pub const HELD_BYTES: &str = "memory held";

/// One row a scene: its time and memory, and how much more that is than the row it is added to; none if not measured.
pub fn what_each_option_costs(results: &[CaseResult]) -> Option<Numbers> {
    let result = results.iter().find(|result| result.case.name == CASE)?;
    let record = |name: &str| result.records.iter().find(|record| record.method == name);
    let noise = Noise::of(&result.records);
    // Pace and lattice do not show in names.
    let known = rows(Pace { side: 2, dt: 1.0, frame: 1 });
    let lines = known.iter().filter_map(|row| {
        let over = record(row.over).filter(|_| row.name != row.over);
        Some(line(row, record(row.name)?, over, &noise))
    });
    let particles = record(BARE).map_or(0, |bare| bare.particles);
    Some(Numbers {
        title: "What each option costs".into(),
        caption: format!(
            "A bare scene of {particles} particles, and every option added to it alone. Time: processor time of a \
             particle-step, over 200 steps of the run itself, set-up left out, the least of the rounds; the rows take \
             turns. Noise: how far the medians of the rounds lie above the least, of the row and \
             of what it is added to together; nowhere less than is usual in the table, or than what the bare scene \
             differs from itself. \"{WITHOUT}\" marches the same particles without a line of coque. Step memory: what a step touches, as \
             the shell counts it, in bytes a particle. Held: all that the run holds between two steps, as the allocator \
             counts it; beyond the shell a bare scene holds itself, and cells and a shape for pictures."
        ),
        head: [
            "scene",
            "time [ns]",
            "more [%]",
            "noise [%]",
            "beyond noise",
            "step memory",
            "more",
            "held",
            "more",
        ]
        .map(String::from)
        .into(),
        rows: lines.collect(),
    })
}

fn value(record: &Record, metric: &str) -> Option<f64> {
    record.metric(metric)?.value
}

/// What the machine adds by itself \[%\].
struct Noise {
    /// The median of all spreads: rows are not believed to be quieter.
    usual: f64,
    /// What the bare scene differs from itself.
    twice: f64,
}

impl Noise {
    fn of(records: &[Record]) -> Self {
        let mut spreads: Vec<f64> = records.iter().filter_map(|record| value(record, SPREAD)).collect();
        spreads.sort_by(f64::total_cmp);
        let again = records.iter().find(|record| record.method == AGAIN);
        let twice = again.and_then(|again| value(again, MORE_TIME)).unwrap_or(0.0).abs();
        Self { usual: spreads.get(spreads.len() / 2).copied().unwrap_or(0.0), twice }
    }

    /// Of a difference between two rows, or of one row.
    fn between(&self, own: &Record, over: Option<&Record>) -> f64 {
        let spread = |record: &Record| value(record, SPREAD).unwrap_or(0.0).max(self.usual);
        (spread(own) + over.map_or(0.0, spread)).max(self.twice)
    }
}

fn line(row: &Row, own: &Record, over: Option<&Record>, noise: &Noise) -> Vec<String> {
    let blank = String::new;
    let more = over.and_then(|_| value(own, MORE_TIME));
    let noise = noise.between(own, over);
    let whole = |metric: &str| value(own, metric).map_or_else(blank, |bytes| format!("{bytes:.0}"));
    let beyond = |metric: &str| {
        let more = over.and_then(|over| Some(value(own, metric)? - value(over, metric)?));
        more.map_or_else(blank, |bytes| format!("{bytes:+.0}"))
    };
    vec![
        format!("{}: {}", row.name, row.about),
        value(own, TIME).map_or_else(blank, |time| format!("{time:.1}")),
        more.map_or_else(blank, |more| format!("{more:+.1}")),
        format!("{noise:.1}"),
        more.map_or_else(blank, |more| if more.abs() > noise { "yes".into() } else { "no".into() }),
        whole(STEP_BYTES),
        beyond(STEP_BYTES),
        whole(HELD_BYTES),
        beyond(HELD_BYTES),
    ]
}
