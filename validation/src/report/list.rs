//! What a person looks at first: one line a case, with a mark, its drawing small, its error and its time.

use super::runs::nearest;
use super::section::{drawing, missed};
use crate::figures::escape;
use crate::format::{duration, three};
use crate::judge::{CaseResult, Metric, Record, Verdict};
use crate::tables::{answers, unit_of_answers};

/// The list of all cases by family; `drawn` says of each case whether it has a drawing.
pub fn list(results: &[&CaseResult], drawn: &[bool]) -> String {
    let mut text = String::from("<table class='cases'>");
    let mut family = "";
    for (result, &drawn) in results.iter().zip(drawn) {
        if result.case.family != family {
            family = result.case.family;
            text.push_str(&format!(
                "<tbody><tr><th colspan='5' scope='rowgroup'>{}</th></tr></tbody>",
                escape(family)
            ));
        }
        text.push_str(&line(result, drawn));
    }
    text + "</table>"
}

fn line(result: &CaseResult, drawn: bool) -> String {
    let case = &result.case;
    let metrics = || result.records.iter().flat_map(|record| &record.metrics);
    let of = |verdict| metrics().filter(|metric| metric.verdict == verdict).count();
    let judged = of(Verdict::Pass) + of(Verdict::Missed);
    let (class, mark, word) = match (missed(result), judged) {
        (true, _) => ("bad", "✗", "missed"),
        (_, 0) => ("shown", "○", "shown"),
        _ => ("good", "✓", "kept"),
    };
    let small = if drawn {
        format!(
            "<svg class='small' aria-hidden='true'><use href='#{}' width='112' height='68'/></svg>",
            drawing(case.name)
        )
    } else {
        String::new()
    };
    let (error, time) = stands(result);
    let runs = result.records.len();
    format!(
        "<tr><td class='{class} mark' title='{word}'>{mark}</td><td class='look'>{small}</td>\
         <td><a href='#{name}'>{title}</a><br><span class='name'>{name}: {runs} run{s}, {judged} figures judged</span></td>\
         <td>{error}</td><td class='n'>{time}</td></tr>",
        name = escape(case.name),
        title = escape(case.title),
        s = if runs == 1 { "" } else { "s" },
    )
}

/// Error and time of the run that stands for a case: of usual fineness if it has one, the worst of these; without an error
/// of its own, the run that is nearest to a tolerance.
fn stands(result: &CaseResult) -> (String, String) {
    let all = answers(result);
    let usual = all.iter().any(|answer| answer.run.variant.usual);
    let chosen = all.iter().filter(|answer| answer.run.variant.usual || !usual);
    if let (Some(answer), Some(headline)) =
        (chosen.max_by(|a, b| a.error.total_cmp(&b.error)), result.case.headline)
    {
        let unit = unit_of_answers(result);
        let unit = if unit == "-" { String::new() } else { format!(" {unit}") };
        let run = &answer.run.variant;
        let error = format!(
            "<b>{}{}</b> {}<br><span class='name'>{}, {}</span>",
            three(answer.error),
            escape(&unit),
            escape(headline.metric),
            escape(&run.method),
            escape(&run.grid)
        );
        return (error, duration(answer.run.outcome.wall_seconds));
    }
    let share = |record: &Record| record.nearest().map_or(-3.0, Metric::share);
    let pairs = result.runs.iter().zip(&result.records);
    let closest = pairs.max_by(|(_, a), (_, b)| share(a).total_cmp(&share(b)));
    closest
        .map_or_else(Default::default, |(run, record)| (nearest(run, record), duration(record.wall_seconds)))
}
