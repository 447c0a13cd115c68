//! `coque check --accuracy`: the lattice, method and analysis that an accuracy takes, as a table.

use std::ops::ControlFlow;
use std::path::Path;
use std::time::Duration;

use crate::accuracy::{Asked, ClimbError, Forecast, Ladder, Needed};
use crate::{Checked, Costs, costs_svg};

use super::bar::clock;
use super::stderr::{Refused, print, say};

/// Longest time for the runs of a method \[s\]: a day.
const LONGEST: f64 = 86_400.0;
/// Lattices of a method: the last has a hundred times the cells along an edge of the first.
const LATTICES: usize = 14;

/// A share from `0.5%` or `0.005`.
pub fn share(text: &str) -> Result<f64, String> {
    let (number, unit) = text.strip_suffix('%').map_or((text, 1.0), |number| (number.trim_end(), 0.01));
    let share = number.parse().map(|number: f64| unit * number).ok();
    share
        .filter(|share| (1e-6..=0.5).contains(share))
        .ok_or_else(|| "give a share from 0.0001% to 50%, such as 0.5% or 0.005".into())
}

/// A time in seconds.
pub fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|seconds| (0.1..=LONGEST).contains(seconds));
    seconds.ok_or_else(|| "give a time from 0.1 to 86400 seconds".into())
}

/// Runs the lattices and prints what they tell.
pub fn carry_out(
    scene: &Checked,
    accuracy: f64,
    within: f64,
    threads: usize,
    chart: Option<&Path>,
) -> Result<(), Refused> {
    let asked = Asked { accuracy, within: Duration::from_secs_f64(within), lattices: LATTICES, threads };
    let reported = scene.forecast(&asked, &mut |method, rung| {
        say(&format!("{method}: {} in {}", rung.lattice, time(rung.seconds)));
        ControlFlow::Continue(())
    });
    let forecasts = reported.map_err(|error| match error {
        ClimbError::Refused(error) => Refused::scene(&error),
        ClimbError::Silent(why) => format!("no accuracy can be estimated: {why}\n").into(),
    })?;
    let mut text = format!("\nwhat {} takes\n", percent(accuracy));
    text.push_str(&format!(
        "  {:<40} {:<18} {:>9} {:>9} {:>9} {:>9}\n",
        "method, analysis", "lattice", "particles", "error", "time", "memory"
    ));
    for Forecast { method, ladder, needed } in &forecasts {
        text.push_str(&match needed {
            Some(needed) => row(method, needed),
            None => format!("  {method:<40} {}\n", untold(ladder)),
        });
    }
    for forecast in &forecasts {
        text.push_str(&basis(forecast));
    }
    print(&text)?;
    let Some(file) = chart else { return Ok(()) };
    let costs: Vec<Costs> = forecasts
        .iter()
        .map(|Forecast { method, ladder, .. }| {
            let runs = ladder.rungs.iter().filter_map(|rung| Some([rung.seconds, rung.error?]));
            Costs { method: method.clone(), runs: runs.collect() }
        })
        .collect();
    costs_svg(&costs, &scene.title, file).map_err(|error| format!("{error}\n"))?;
    say(&format!("errors over times: {}", file.display()));
    Ok(())
}

fn row(method: &str, needed: &Needed) -> String {
    let Needed { lattice, particles, error, seconds, memory, ran, .. } = needed;
    let how = if *ran { "run" } else { "predicted" };
    format!(
        "  {method:<40} {lattice:<18} {particles:>9.0} {:>9} {:>9} {:>6.0} MB  {how}\n",
        percent(*error),
        time(*seconds),
        1e-6 * memory
    )
}

/// Why a method has no row.
fn untold(ladder: &Ladder) -> String {
    match ladder.rungs.len() {
        count @ 0..3 => {
            format!("{count} lattices ran in the time; three are needed: give more with --within")
        }
        _ => "needs more than 10⁷ particles, or its answers do not compare".into(),
    }
}

/// The runs that a forecast rests on, and what is doubtful about the finest.
fn basis(forecast: &Forecast) -> String {
    let Forecast { method, ladder, .. } = forecast;
    let mut text = format!("\nbasis: {method}\n");
    for rung in &ladder.rungs {
        let error = rung.error.map_or("–".into(), percent);
        let (lattice, spent) = (&rung.lattice, time(rung.seconds));
        text.push_str(&format!("  {lattice:<18} {:>9} particles {error:>9} {spent:>9}\n", rung.particles));
    }
    if let Some((found, column)) = &ladder.finest {
        let how = match found.regular {
            true => format!("order {:.1}, as found, two at most", found.order),
            false => "no order found: they do not approach each other yet; order 1 taken, error three times their steps".into(),
        };
        text.push_str(&format!("  answers among themselves, most by {column}: {how}\n"));
    }
    if let Some(last) = ladder.rungs.last() {
        let words = last.warnings.iter().map(|warning| (warning.kind.word(), &warning.message));
        words
            .for_each(|(word, message)| text.push_str(&format!("  {word} on {}: {message}\n", last.lattice)));
    }
    text
}

/// A share in percent, to two digits.
pub fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    let digits = if percent > 0.0 { (1 - libm::log10(percent).floor() as i32).max(0) as usize } else { 0 };
    format!("{percent:.digits$} %")
}

/// A time: tenths of a second while they tell something.
pub fn time(seconds: f64) -> String {
    if seconds < 10.0 { format!("{seconds:.2} s") } else { clock(seconds) }
}
