//! The table of every run.

use crate::figures::escape;
use crate::judge::{CaseResult, Record, Run};
use crate::tables::{unit, words};

/// One line a run, folded.
pub fn every_run(results: &[CaseResult]) -> String {
    let mut rows = String::new();
    for result in results {
        for (number, (run, record)) in result.runs.iter().zip(&result.records).enumerate() {
            let first = if number == 0 {
                let name = escape(&record.case);
                let height = result.records.len();
                format!("<th rowspan='{height}' scope='rowgroup'><a href='#{name}'>{name}</a></th>")
            } else {
                String::new()
            };
            let verdict = record.verdict().word();
            rows.push_str(&format!(
                "<tr>{first}<td class='m'>{}</td><td>{}</td><td class='n'>{}</td><td>{}</td><td class='n'>{:.2}</td>\
                 <td class='n'>{:.2}</td><td class='{verdict}'>{verdict}</td></tr>",
                escape(&record.method),
                run.variant.grid,
                record.particles,
                nearest(run, record),
                record.wall_seconds,
                record.particle_steps_per_second / 1e6,
            ));
        }
    }
    format!(
        "<details><summary>Every run</summary><div class='wide'><table class='summary'><thead><tr><th>case</th><th>method</th><th>grid</th>\
         <th class='n'>particles</th><th>nearest to its tolerance</th><th class='n'>wall s</th>\
         <th class='n'>10⁶ p·steps/s</th><th>verdict</th></tr></thead><tbody>{rows}</tbody></table></div></details>"
    )
}

/// The metric of a run that is nearest to its tolerance, in words.
pub fn nearest(run: &Run, record: &Record) -> String {
    let ended = if run.done() { String::new() } else { "diverged; ".into() };
    let text = record.nearest().map(|metric| format!("{}: {}{}", metric.name, words(metric), unit(metric)));
    escape(&format!("{ended}{}", text.unwrap_or_default()))
}
