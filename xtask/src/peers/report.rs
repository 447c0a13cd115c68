//! The report: one page, a row for each comparison, what stands beside it.

use std::fmt::Write;
use std::process::Command;

use super::place::{self, Place};
use super::reading::Reading;
use super::row::{Comparison, Outcome, apart, median};

/// What is said over the table.
const HEAD: &str = "\
| problem | ours | the other | unit | ours (processor) | the other (processor) | other over ours | answers: ours; the other's | apart (allowed) [%] | memory | threads |
|---|---|---|---|---|---|---|---|---|---|---|
";

/// A page that grows row by row.
pub struct Report {
    head: String,
    rows: Vec<String>,
    notes: Vec<String>,
}

impl Report {
    /// Names the machine, the commit and how runs are made.
    pub fn new(place: &Place, times: u32) -> Self {
        let commit = first_line(
            Command::new("git").args(["describe", "--always", "--dirty"]).current_dir(&place.root),
        );
        Self::of(
            &processor().unwrap_or_else(|| "a processor that the system does not name".to_owned()),
            &commit.unwrap_or_else(|| env!("CARGO_PKG_VERSION").to_owned()),
            times,
        )
    }

    fn of(processor: &str, commit: &str, times: u32) -> Self {
        let head = format!(
            "# coque beside other codes\n\n\
             {processor}. coque {commit}, release build. Answers are compared first; then {times} runs of each in turn, medians; \
             the ratio is the median of those of the pairs, by the clock: above one ours is faster, below one slower.\n\n"
        );
        Self { head, rows: Vec::new(), notes: Vec::new() }
    }

    /// A row more.
    pub fn add(&mut self, place: &Place, of: &Comparison, outcome: Outcome) {
        let version = (of.peer.find)(place).map(|found| found.version).unwrap_or_default();
        self.row(of, &version, place.threads, &outcome);
    }

    fn row(&mut self, of: &Comparison, version: &str, threads: u32, outcome: &Outcome) {
        let name = format!("{} {version}", of.peer.name);
        let name = name.trim_end();
        let theirs = format!("{name}, {}", of.theirs.by);
        let threads = format!("{threads}; {}", if of.peer.threaded { threads } else { 1 });
        let cells = match outcome {
            Outcome::NotInstalled => {
                self.note(format!("{name} is not installed: `{}`", of.peer.install));
                ["not installed", "", "", "", "", "", ""].map(str::to_owned)
            }
            Outcome::Failed(why) => {
                self.note(format!("{name} failed on {}: {why}", of.problem));
                ["failed", "", "", "", "", "", ""].map(str::to_owned)
            }
            Outcome::Apart { ours, theirs } => {
                self.note(format!(
                    "{}: answers differ by more than is allowed, so that nothing was timed",
                    of.problem
                ));
                let [answers, apart, memory] = said(of, ours, theirs);
                let none = || "not timed".to_owned();
                [none(), none(), String::new(), answers, apart, memory, threads]
            }
            Outcome::Timed { ours, theirs } => {
                let ratio = ratio(ours, theirs);
                if ratio < 1.0 {
                    let times = digits(1.0 / ratio);
                    self.note(format!("behind {name}: {} takes {times} times as long here", of.problem));
                }
                let [answers, apart, memory] = said(of, &ours[0], &theirs[0]);
                [cost(ours), cost(theirs), digits(ratio), answers, apart, memory, threads]
            }
        };
        let row =
            format!("| {} | {} | {theirs} | {} | {} |", of.problem, of.ours.by, of.unit, cells.join(" | "));
        self.rows.push(row);
    }

    fn note(&mut self, text: String) {
        if !self.notes.contains(&text) {
            self.notes.push(text);
        }
    }

    /// The row that was added last.
    pub fn last_line(&self) -> &str {
        self.rows.last().map_or("", String::as_str)
    }

    /// The whole page.
    pub fn page(&self) -> String {
        let mut page = format!("{}{HEAD}", self.head);
        for row in &self.rows {
            let _ = writeln!(page, "{row}");
        }
        if !self.notes.is_empty() {
            page.push('\n');
        }
        for note in &self.notes {
            let _ = writeln!(page, "- {note}");
        }
        page
    }
}

/// Answers of both, how far they are apart, memory of both.
fn said(of: &Comparison, ours: &Reading, theirs: &Reading) -> [String; 3] {
    let answers = format!("{}: {}; {}", of.answers, listed(&ours.answers), listed(&theirs.answers));
    let apart = apart(&ours.answers, &theirs.answers).map_or("–".to_owned(), digits);
    let (by_node, unit) = if ours.bytes.is_some() { (true, "bytes a node") } else { (false, "MB") };
    let memory = [ours, theirs].map(|side| if by_node { side.bytes } else { side.memory });
    let memory = match memory {
        [None, None] => String::new(),
        sides => format!("{} {unit}", sides.map(|side| side.map_or("–".to_owned(), digits)).join("; ")),
    };
    [answers, format!("{apart} ({})", digits(of.share)), memory]
}

/// The first and the last of some answers.
fn listed(answers: &[f64]) -> String {
    let five = |x: f64| rounded(x, 5);
    match answers {
        [] => "none".to_owned(),
        [one] => five(*one),
        [first, .., last] => format!("{} … {}", five(*first), five(*last)),
    }
}

fn cost(side: &[Reading]) -> String {
    let clock = digits(median(side.iter().map(|one| one.cost).collect()));
    let processor: Option<Vec<f64>> = side.iter().map(|one| one.processor).collect();
    processor.map_or(clock.clone(), |all| format!("{clock} ({})", digits(median(all))))
}

/// How many times as long the other side takes: the median over pairs of runs.
fn ratio(ours: &[Reading], theirs: &[Reading]) -> f64 {
    median(ours.iter().zip(theirs).map(|(ours, theirs)| theirs.cost / ours.cost).collect())
}

/// Three significant digits.
fn digits(x: f64) -> String {
    rounded(x, 3)
}

/// So many significant digits, no zero before the point, no zeros at the end.
fn rounded(x: f64, digits: usize) -> String {
    if x == 0.0 || !x.is_finite() {
        return if x == 0.0 { "0".to_owned() } else { "–".to_owned() };
    }
    let magnitude = libm::floor(libm::log10(x.abs())) as i32;
    if !(-5..9).contains(&magnitude) {
        return format!("{x:.*e}", digits - 1);
    }
    let places = usize::try_from(digits as i32 - 1 - magnitude).unwrap_or(0);
    let text = format!("{x:.places$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    text.replacen("0.", ".", usize::from(text.trim_start_matches('-').starts_with("0.")))
}

fn processor() -> Option<String> {
    let text = place::read(std::path::Path::new("/proc/cpuinfo")).ok()?;
    let value =
        |key: &str| text.lines().find(|line| line.starts_with(key))?.split_once(':').map(|(_, v)| v.trim());
    let cores = std::thread::available_parallelism().ok()?;
    Some(format!(
        "{}, family {}, model {}, {cores} virtual cores",
        value("model name")?,
        value("cpu family")?,
        value("model\t")?
    ))
}

fn first_line(command: &mut Command) -> Option<String> {
    let output = command.output().ok().filter(|output| output.status.success())?;
    String::from_utf8_lossy(&output.stdout).lines().next().map(|line| line.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::super::row::{Peer, Side};
    use super::*;

    fn comparison() -> Comparison {
        let side = |by: &str| Side { by: by.to_owned(), run: Box::new(|_, _| Err("not run".to_owned())) };
        Comparison {
            problem: "a roof",
            peer: Peer { name: "Other", install: "apt-get install other", threaded: false, find: |_| None },
            unit: "s",
            answers: "deflection",
            share: 0.5,
            ours: side("9² particles"),
            theirs: side("4² elements"),
        }
    }

    fn reading(answer: f64, cost: f64, processor: Option<f64>) -> Reading {
        Reading { answers: vec![answer], cost, processor, memory: Some(12.3456), bytes: None }
    }

    #[test]
    fn a_page_has_medians_ratios_answers_and_what_is_behind() {
        let mut report = Report::of("A processor", "abc", 3);
        let ours = [0.2, 0.4, 0.3].map(|cost| reading(1.0, cost, Some(0.1))).to_vec();
        let theirs = [0.1, 0.1, 0.1].map(|cost| reading(1.004, cost, None)).to_vec();
        report.row(&comparison(), "2.0", 2, &Outcome::Timed { ours, theirs });
        assert_eq!(
            report.last_line(),
            "| a roof | 9² particles | Other 2.0, 4² elements | s | .3 (.1) | .1 | .333 | deflection: 1; 1.004 | .4 (.5) | 12.3; 12.3 MB | 2; 1 |"
        );
        let page = report.page();
        assert!(page.contains("A processor. coque abc, release build.") && page.contains("3 runs of each"));
        assert!(page.ends_with("\n- behind Other 2.0: a roof takes 3 times as long here\n"), "{page}");
        let bars = |line: &str| line.matches('|').count();
        let rows: Vec<usize> = page.lines().filter(|line| line.starts_with('|')).map(bars).collect();
        assert!(rows.iter().all(|&bars| bars == rows[0]), "{rows:?}");
    }

    #[test]
    fn what_is_missing_failed_or_differs_is_said_and_not_timed() {
        let mut report = Report::of("A processor", "abc", 1);
        report.row(&comparison(), "", 1, &Outcome::NotInstalled);
        report.row(&comparison(), "", 1, &Outcome::NotInstalled);
        assert!(report.last_line().contains("| Other, 4² elements | s | not installed |"));
        report.row(&comparison(), "2.0", 1, &Outcome::Failed("no answer".to_owned()));
        assert!(report.last_line().contains("| failed |"));
        let (ours, theirs) = (reading(1.0, 1.0, None), reading(2.0, 1.0, None));
        report.row(&comparison(), "2.0", 1, &Outcome::Apart { ours, theirs });
        assert!(report.last_line().contains("| not timed | not timed |  | deflection: 1; 2 | 100 (.5) |"));
        let page = report.page();
        assert_eq!(page.matches("is not installed: `apt-get install other`").count(), 1);
        assert!(page.contains("- Other 2.0 failed on a roof: no answer\n"));
        let bars = |line: &str| line.matches('|').count();
        let rows: Vec<usize> = page.lines().filter(|line| line.starts_with('|')).map(bars).collect();
        assert!(rows.iter().all(|&bars| bars == rows[0]), "{rows:?}");
    }

    #[test]
    fn numbers_have_significant_digits() {
        assert_eq!(
            [0.30325, 12.3456, 1234.5, 1.0, 0.0, -0.05].map(digits),
            [".303", "12.3", "1234", "1", "0", "-.05"]
        );
        assert_eq!([f64::NAN, 1.5e-7].map(digits), ["–", "1.50e-7"]);
        assert_eq!(rounded(19.73323, 5), "19.733");
    }
}
