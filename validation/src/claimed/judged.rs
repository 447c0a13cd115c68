//! The share of the numbers whose bar holds the true error, judged; the table and the chart of all of them.

use std::collections::BTreeSet;

use super::dots::{Dot, Half};
use crate::figures::{Axis, BLUE, Chart, Figure, GREY, Line, Mark, ORANGE, Series, escape};
use crate::report::{Page, show};
use crate::{JudgeError, Metric};

/// What the bars of some numbers are worth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// Numbers with a bar.
    pub count: usize,
    /// Those whose bar holds the true error \[%\].
    pub inside: f64,
    /// Those whose bar is less than a third of it \[%\].
    pub under_third: f64,
    /// Median of bar over true error \[–\].
    pub median: f64,
    /// Numbers without a bar.
    pub without: usize,
}

impl Share {
    /// Of some dots; none without a bar among them.
    pub fn of<'a>(dots: impl Iterator<Item = &'a Dot>) -> Option<Self> {
        let (with, without): (Vec<&Dot>, Vec<&Dot>) = dots.partition(|dot| dot.bar.is_some());
        let count = with.len();
        let percent = |keeps: &dyn Fn(&Dot) -> bool| {
            100.0 * with.iter().filter(|dot| keeps(dot)).count() as f64 / count as f64
        };
        let mut ratios: Vec<f64> =
            with.iter().map(|dot| dot.bar.unwrap_or(0.0) / dot.error().max(f64::MIN_POSITIVE)).collect();
        ratios.sort_by(f64::total_cmp);
        let median = *ratios.get(count / 2)?;
        Some(Self {
            count,
            inside: percent(&|dot| dot.inside() == Some(true)),
            under_third: percent(&|dot| dot.bar.is_some_and(|bar| 3.0 * bar < dot.error())),
            median,
            without: without.len(),
        })
    }
}

/// Groups of the table: all of a half, and what of it is no shell.
fn groups(dots: &[Dot]) -> Vec<(&'static str, Option<Share>)> {
    let of = |half: Half| dots.iter().filter(move |dot| dot.half == half && dot.theory.is_none());
    vec![
        ("judged half, references of the same theory", Share::of(of(Half::Judged))),
        ("… without shells", Share::of(of(Half::Judged).filter(|dot| !dot.shell))),
        ("half of the choice, references of the same theory", Share::of(of(Half::Chosen))),
        ("… without shells", Share::of(of(Half::Chosen).filter(|dot| !dot.shell))),
        ("references of other theories", Share::of(dots.iter().filter(|dot| dot.theory.is_some()))),
    ]
}

/// What is asked of the judged half: percent inside at least, of what is no shell, percent under a third at most, median at most.
const ASKED: [f64; 4] = [90.0, 85.0, 2.0, 2.5];

/// The verdicts on the half of which the rule knows nothing.
pub fn judged(dots: &[Dot]) -> Vec<Metric> {
    let reason = "what a bar is worth to whoever has no reference: nine numbers of ten lie in it";
    let [all, others, ..] = &groups(dots)[..] else { return Vec::new() };
    let share = |found: &Option<Share>, of: fn(&Share) -> f64| found.as_ref().map(of);
    let [inside, without_shells, under_third, median] = ASKED;
    vec![
        Metric::at_least("inside the bar", share(&all.1, |s| s.inside), "%", inside).within(0.0, reason),
        Metric::at_least(
            "inside the bar, without shells",
            share(&others.1, |s| s.inside),
            "%",
            without_shells,
        )
        .within(0.0, reason),
        Metric::error("bar under a third of the error", share(&all.1, |s| s.under_third), "%")
            .within(under_third, "a bar that is far too small misleads"),
        Metric::error("bar over error, median", share(&all.1, |s| s.median), "-")
            .within(median, "a bar that is far too large tells nothing"),
    ]
}

/// The table of docs/accuracy.md, the verdicts on the judged half, and every number outside its bar.
pub fn table(dots: &[Dot]) -> String {
    let cases: BTreeSet<&str> = dots.iter().filter_map(|dot| dot.name.split(':').next()).collect();
    let [inside, _, under_third, median] = ASKED;
    let mut text = format!(
        "| measured on {} cases | numbers | inside the bar | bar under a third of the error | bar over error, median | without a bar |\n\
         |---|---|---|---|---|---|\n\
         | asked | | {inside:.0} % | {under_third:.0} % at most | {median:.1} at most | |\n",
        cases.len()
    );
    for (name, share) in groups(dots) {
        let Some(Share { count, inside, under_third, median, without }) = share else { continue };
        text.push_str(&format!(
            "| {name} | {count} | {inside:.1} % | {under_third:.1} % | {median:.1} | {without} |\n"
        ));
    }
    text.push('\n');
    for Metric { name, value, unit, verdict, .. } in judged(dots) {
        let value = value.map_or("none".into(), |value| format!("{value:.2}"));
        text.push_str(&format!("{name}: {value} {unit}: {}\n", verdict.word()));
    }
    for dot in dots.iter().filter(|dot| dot.inside() == Some(false)) {
        let bar = dot.bar.unwrap_or(0.0);
        text.push_str(&format!(
            "outside: {}: {:.6e} ± {bar:.1e}, true error {:.1e} ({}{})\n",
            dot.name,
            dot.value,
            dot.error(),
            dot.verdict.words(),
            dot.theory.map_or(String::new(), |theory| format!("; the reference is {theory}"))
        ));
    }
    text
}

/// The page with the chart: one dot a number.
///
/// # Errors
/// [`JudgeError`] from the drawing.
pub fn page(dots: &[Dot]) -> Result<Page, JudgeError> {
    // Over the reference; what is exact to all digits stands at the edge.
    let least = 1e-9;
    let place = |dot: &Dot| {
        let scale = dot.scale;
        Some(((dot.error() / scale).clamp(least, 1.0), (dot.bar? / scale).clamp(least, 1.0)))
    };
    let of = |half: Half| {
        let own = dots.iter().filter(|dot| dot.half == half && dot.theory.is_none());
        own.filter_map(place).collect()
    };
    let others = dots.iter().filter(|dot| dot.theory.is_some()).filter_map(place).collect();
    let diagonal = vec![(least, least), (1.0, 1.0)];
    let chart = Chart {
        title: "Claimed against true error".into(),
        caption: "One dot a number: its bar over its true error, both as shares of the reference. Above the line the bar holds.".into(),
        x: Axis::log("true error over reference").between(least, 1.0),
        y: Axis::log("bar over reference").between(least, 1.0),
        series: vec![
            Series::line("", diagonal, GREY, Line::Dashed),
            Series::marks("references of other theories", others, GREY, Mark::Circle),
            Series::marks("half on which the rule was chosen", of(Half::Chosen), ORANGE, Mark::Cross),
            Series::marks("half on which it is judged", of(Half::Judged), BLUE, Mark::Disc),
        ],
    };
    let words = escape(&table(dots));
    let text =
        format!("<h1>Claimed against true error</h1>{}<pre>{words}</pre>", show(&Figure::Chart(chart))?);
    Ok(Page::new("claimed.html", "coque: claimed against true error", &text))
}

#[cfg(test)]
mod tests {
    use coque::Verdict;

    use super::*;

    #[test]
    fn the_table_counts_what_is_inside_by_half_and_kind() {
        let dot = |name: &str, half, family, bar, off| Dot {
            name: format!("{name}: cells: w"),
            family,
            shell: family == "Shells",
            half,
            theory: None,
            value: 1.0 + off,
            reference: 1.0,
            scale: 1.0,
            rounding: 0.0,
            bar,
            verdict: Verdict::Converging,
            answers: Vec::new(),
        };
        let dots = [
            dot("a", Half::Judged, "Shells", Some(0.2), 0.1),
            dot("a", Half::Judged, "Shells", Some(0.02), 0.1),
            dot("b", Half::Judged, "Fluids", Some(0.3), 0.1),
            dot("c", Half::Chosen, "Shells", None, 0.1),
            dot("c", Half::Chosen, "Shells", Some(0.4), 0.1),
        ];
        let text = table(&dots);
        assert!(text.starts_with("| measured on 3 cases |"), "{text}");
        assert!(
            text.contains("| judged half, references of the same theory | 3 | 66.7 % | 33.3 % | 2.0 | 0 |"),
            "{text}"
        );
        assert!(text.contains("| … without shells | 1 | 100.0 % | 0.0 % | 3.0 | 0 |"), "{text}");
        assert!(text.contains(
            "| half of the choice, references of the same theory | 1 | 100.0 % | 0.0 % | 4.0 | 1 |"
        ));
        assert!(text.contains("inside the bar: 66.67 %: "), "{text}");
        assert!(judged(&dots).iter().any(|metric| !metric.pass));
        assert!(text.contains("outside: a: cells: w"));
    }
}
