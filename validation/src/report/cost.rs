//! Error against cost: one mark a run, in a figure for each case and in one for each family of cases.

use crate::JudgeError;
use crate::figures::{
    Axis, BLACK, Chart, Colour, Figure, GREEN, GREY, Line, Mark, ORANGE, PURPLE, SKY, Series,
};
use crate::format::short;
use crate::judge::measure::frontier;
use crate::judge::{CaseResult, Peer, Run};
use crate::methods::setting;
use crate::tables::{answers, unit_of_answers};

/// Error over wall time, one mark a run; none for fewer than three.
///
/// # Errors
/// [`JudgeError`] from the stored answers of other programs.
pub fn cost_chart(result: &CaseResult) -> Result<Option<Figure>, JudgeError> {
    let Some(headline) = result.case.headline else { return Ok(None) };
    let peers = peers_here(result)?;
    let mut methods: Vec<(&str, Vec<(f64, f64)>)> = Vec::new();
    let answers = answers(result);
    if answers.len() < 3 {
        return Ok(None);
    }
    for answer in &answers {
        let point = (answer.run.outcome.seconds_per_point(), answer.error.max(headline.floor));
        add(&mut methods, answer.run.variant.method.as_str(), point);
    }
    for peer in &peers {
        add(&mut methods, &peer.method, (peer.cost, peer.error.max(headline.floor)));
    }
    let all: Vec<(f64, f64)> = methods.iter().flat_map(|(_, own)| own).copied().collect();
    let best: Vec<(f64, f64)> = frontier(&all).into_iter().map(|i| all[i]).collect();
    let ahead = most_often_best(&methods, std::slice::from_ref(&best));
    let mut series = vec![Series::line("best of error and cost", best, GREY, Line::Solid)];
    series.extend(marks(methods));
    let note = if peers.is_empty() { "" } else { PEERS };
    Ok(Some(Figure::Chart(Chart {
        title: format!("{}: error against cost", result.case.name),
        caption: format!(
            "Each mark is a run: error ({}) against the wall time of a point of its curve. Left and down is better; the \
             grey line joins the runs that none beats in both: {ahead}. Errors below {} {} are drawn there: the reference is not \
             known better.{note}",
            headline.metric,
            short(headline.floor),
            unit_of_answers(result)
        ),
        x: Axis::log("wall time of a point of the curve, one thread [s]"),
        y: Axis::log(&format!("error [{}]", unit_of_answers(result))),
        series,
    })))
}

/// What is said of answers that were not found here.
const PEERS: &str = " Other programs were measured another day: in turn with ours on one thread of one machine, and drawn at that ratio to our run here.";

/// The answers of other programs to a case with their costs in seconds here: as long as our run took, times their cost. None
/// where that run was not made.
///
/// # Errors
/// [`JudgeError`] from the stored answers.
fn peers_here(result: &CaseResult) -> Result<Vec<Peer>, JudgeError> {
    let Some(peers) = (result.case.peers)()? else { return Ok(Vec::new()) };
    let here = |run: &&Run| run.variant.method == peers.method && run.variant.grid == peers.grid;
    let Some(unit) = result.runs.iter().find(here).map(|run| run.outcome.seconds_per_point()) else {
        return Ok(Vec::new());
    };
    Ok(peers.answers.into_iter().map(|peer| Peer { cost: peer.cost * unit, ..peer }).collect())
}

/// Marks of the runs of each method, with its own look or one of the others.
fn marks(methods: Vec<(&str, Vec<(f64, f64)>)>) -> impl Iterator<Item = Series> {
    let mut others = OTHERS.into_iter().cycle();
    methods.into_iter().map(move |(method, own)| {
        let look = setting(method).map(|setting| (setting.colour, setting.mark)).or_else(|| others.next());
        let (colour, mark) = look.unwrap_or((GREY, Mark::Cross));
        Series::marks(method, own, colour, mark)
    })
}

/// Adds a point to those of a method.
fn add<'a>(methods: &mut Vec<(&'a str, Vec<(f64, f64)>)>, method: &'a str, point: (f64, f64)) {
    match methods.iter_mut().find(|(name, _)| *name == method) {
        Some((_, own)) => own.push(point),
        None => methods.push((method, vec![point])),
    }
}

/// Looks of methods that have none of their own, in the order in which they appear.
const OTHERS: [(Colour, Mark); 5] = [
    (SKY, Mark::Disc),
    (ORANGE, Mark::Square),
    (GREEN, Mark::Triangle),
    (PURPLE, Mark::Diamond),
    (BLACK, Mark::Circle),
];

/// Errors in percent over wall times of a point: a chart for each family of cases that has at least three such runs.
///
/// # Errors
/// [`JudgeError`] from the stored answers of other programs.
pub fn family_charts(results: &[&CaseResult]) -> Result<Vec<Chart>, JudgeError> {
    let mut families: Vec<&str> = Vec::new();
    for result in results {
        if !families.contains(&result.case.family) {
            families.push(result.case.family);
        }
    }
    let members =
        |family: &str| results.iter().copied().filter(|result| result.case.family == family).collect();
    families.into_iter().filter_map(|family| family_chart(family, members(family)).transpose()).collect()
}

fn family_chart(family: &str, results: Vec<&CaseResult>) -> Result<Option<Chart>, JudgeError> {
    let peers = results.iter().map(|result| peers_here(result)).collect::<Result<Vec<_>, _>>()?;
    let mut methods: Vec<(&str, Vec<(f64, f64)>)> = Vec::new();
    let mut bests = Vec::new();
    let mut names = Vec::new();
    for (result, peers) in results.into_iter().zip(&peers) {
        let Some(headline) = result.case.headline else { continue };
        if unit_of_answers(result) != "%" {
            continue;
        }
        let mut points = Vec::new();
        for answer in answers(result) {
            let point = (answer.run.outcome.seconds_per_point(), answer.error.max(headline.floor));
            // A run without steps of its own, as one that shares its cloud, has no cost to show.
            if !(point.0 > 0.0 && point.1 > 0.0) {
                continue;
            }
            points.push(point);
            add(&mut methods, answer.run.variant.method.as_str(), point);
        }
        for peer in peers {
            let point = (peer.cost, peer.error.max(headline.floor));
            points.push(point);
            add(&mut methods, &peer.method, point);
        }
        if !points.is_empty() {
            names.push(result.case.name);
            bests.push(frontier(&points).into_iter().map(|i| points[i]).collect::<Vec<_>>());
        }
    }
    if methods.iter().map(|(_, own)| own.len()).sum::<usize>() < 3 {
        return Ok(None);
    }
    let ahead = most_often_best(&methods, &bests);
    let mut series: Vec<Series> = Vec::new();
    for (number, best) in bests.into_iter().enumerate() {
        let label = if number == 0 { "best of a case in error and cost" } else { "" };
        series.push(Series::line(label, best, GREY, Line::Solid));
    }
    series.extend(marks(methods));
    let note = if peers.iter().all(Vec::is_empty) { "" } else { PEERS };
    Ok(Some(Chart {
        title: family.to_owned(),
        caption: format!(
            "Left and down is better. A mark is a run of {}. Runs that no other of their case beats in both: {ahead}.{note}",
            names.join(", ")
        ),
        x: Axis::log("wall time of a point of the curve, one thread [s]"),
        y: Axis::log("error [%]"),
        series,
    }))
}

/// Which methods the best runs are of, most first, in words.
fn most_often_best(methods: &[(&str, Vec<(f64, f64)>)], bests: &[Vec<(f64, f64)>]) -> String {
    let best: Vec<(f64, f64)> = bests.iter().flatten().copied().collect();
    let count = |own: &[(f64, f64)]| best.iter().filter(|point| own.contains(point)).count();
    let mut counts: Vec<(&str, usize)> = methods.iter().map(|(name, own)| (*name, count(own))).collect();
    counts.retain(|&(_, count)| count > 0);
    counts.sort_by_key(|&(_, count)| std::cmp::Reverse(count));
    let words: Vec<String> = counts.iter().map(|(name, count)| format!("{name}, {count}")).collect();
    words.join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_are_named_by_how_often_none_beats_them() {
        let methods =
            [("slow", vec![(9.0, 1.0)]), ("fast", vec![(1.0, 9.0), (2.0, 3.0)]), ("poor", vec![(9.0, 9.0)])];
        let bests = [vec![(1.0, 9.0), (2.0, 3.0)], vec![(9.0, 1.0)]];
        assert_eq!(most_often_best(&methods, &bests), "fast, 2; slow, 1");
    }
}
