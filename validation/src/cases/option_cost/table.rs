//! The table of the report and of the printed output.

use super::rows::{AGAIN, BARE, Pace, Row, WITHOUT, rows};
use super::{HELD_BYTES, SPREAD, STEP_BYTES, TIME, more_time};
use crate::JudgeError;
use crate::figures::Numbers;
use crate::judge::{Run, Runs};

/// One row a scene: its time and memory, and how much more that is than the row it is added to.
///
/// # Errors
/// [`JudgeError`] if a row was not measured.
pub fn table(runs: &Runs) -> Result<Numbers, JudgeError> {
    let run = |name: &str| runs.iter().find(|run| run.is(name));
    let noise = Noise::of(runs)?;
    let mut lines = Vec::new();
    for row in rows(Pace::ANY) {
        let over = run(row.over).filter(|_| row.name != row.over);
        lines.extend(run(row.name).map(|own| line(&row, own, over, &noise)));
    }
    let particles = run(BARE).map_or(0, |bare| bare.outcome.particles);
    Ok(Numbers {
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
        rows: lines,
    })
}

/// A column of a row's outcome.
fn value(run: &Run, column: &str) -> Option<f64> {
    run.outcome.curve.column(column)?.last().copied()
}

/// What the machine adds by itself \[%\].
struct Noise {
    /// The median of all spreads: rows are not believed to be quieter.
    usual: f64,
    /// What the bare scene differs from itself.
    twice: f64,
}

impl Noise {
    fn of(runs: &Runs) -> Result<Self, JudgeError> {
        let mut spreads: Vec<f64> = runs.iter().filter_map(|run| value(run, SPREAD)).collect();
        spreads.sort_by(f64::total_cmp);
        let run = |name: &str| runs.iter().find(|run| run.is(name));
        let twice = run(AGAIN).zip(run(BARE)).map(|(again, bare)| more_time(again, bare)).transpose()?;
        let usual = spreads.get(spreads.len() / 2).copied().unwrap_or(0.0);
        Ok(Self { usual, twice: twice.unwrap_or(0.0).abs() })
    }

    /// Of a difference between two rows, or of one row.
    fn between(&self, own: &Run, over: Option<&Run>) -> f64 {
        let spread = |run: &Run| value(run, SPREAD).unwrap_or(0.0).max(self.usual);
        (spread(own) + over.map_or(0.0, spread)).max(self.twice)
    }
}

fn line(row: &Row, own: &Run, over: Option<&Run>, noise: &Noise) -> Vec<String> {
    let or_blank = |text: Option<String>| text.unwrap_or_default();
    let more = over.and_then(|over| more_time(own, over).ok());
    let noise = noise.between(own, over);
    let whole = |column: &str| or_blank(value(own, column).map(|bytes| format!("{bytes:.0}")));
    let beyond = |column: &str| {
        let more = over.and_then(|over| Some(value(own, column)? - value(over, column)?));
        or_blank(more.map(|bytes| format!("{bytes:+.0}")))
    };
    vec![
        format!("{}: {}", row.name, row.about),
        or_blank(value(own, TIME).map(|time| format!("{time:.1}"))),
        or_blank(more.map(|more| format!("{more:+.1}"))),
        format!("{noise:.1}"),
        or_blank(more.map(|more| if more.abs() > noise { "yes".into() } else { "no".into() })),
        whole(STEP_BYTES),
        beyond(STEP_BYTES),
        whole(HELD_BYTES),
        beyond(HELD_BYTES),
    ]
}
