//! The error of every number of a run: the scene on other lattices, row by row beside it.

use std::ops::ControlFlow;

use super::OF_CASES;
use super::bars::{OnLattice, bar, order_of, sharpened};
use super::companions::finest;
use super::found::{Found, Starts, rows, run};
use super::nested::Nested;
use super::pairing::{Key, key};
use super::probes::probed;
use super::refined::Refined;
use super::said::{holds, lacks};
use crate::results::curve::{Column, Curve};
use crate::results::error_bars::{ColumnErrors, CriticalError, ErrorBar, Errors, LatticeRun, Verdict};
use crate::run::outcome::{Ended, Outcome};
use crate::run::progress::Progress;
use crate::scene::{Analysis, Checked};

/// Columns that count or place a row and have no error.
const PLACES: [&str; 7] =
    ["time", "mode", "iterations", "negative_pivots", "residual", "unbalanced", "remaining_displacement"];
/// Columns that are so small beside others of their unit are zero by symmetry: what differs in them is round-off.
const VANISHING: f64 = 1e-6;
/// Growth of time with the cells along an edge: those of a surface and its factor, or of a surface and its steps.
const GROWTH: f64 = 2.8;
/// Critical points that are located, and so have an error.
const LOCATED: [&str; 2] = ["limit point", "bifurcation"];

impl Checked {
    /// The errors of what a run of the scene found, by runs on other lattices, one after the other; `progress` may end them, and those that ended
    /// count. Where there can be no bar, it is said in [`Errors::without`].
    pub fn errors(&self, outcome: &Outcome, threads: usize, progress: &mut dyn Progress) -> Errors {
        if outcome.ended != Ended::Done {
            return Errors::none(format!("the run did not reach its end: {}", outcome.ended));
        }
        if !self.cases().is_empty() {
            return Errors::none(OF_CASES);
        }
        let found = match self.companions(threads) {
            Ok(found) => found,
            Err(why) => return Errors::none(why),
        };
        let own_words = LatticeRun {
            lattice: "its own".into(),
            spacing: 1.0,
            seconds: outcome.summary.record.wall_seconds,
            ended: outcome.ended.to_string(),
        };
        let mut errors = Errors { lattices: vec![own_words], holds: holds(self), ..Errors::default() };
        let own = Found::of(1.0, found.rest, outcome);
        let nested = Nested::of(self, outcome);
        let wanted = self.error.as_ref().filter(|wanted| wanted.sharpen);
        let finer = wanted.and_then(|_| match finest(self, threads) {
            Ok(finer) => Some(finer),
            Err(why) => {
                errors.lacks.push(format!("sharpening: {why}"));
                None
            }
        });
        let lattices = found.lattices.iter().map(|companion| (companion, false));
        let lattices: Vec<_> = lattices.chain(finer.iter().map(|finer| (finer, true))).collect();
        let (mut others, mut sharp) = (Vec::new(), None);
        for (number, (companion, last)) in lattices.iter().enumerate() {
            let price = price(companion.spacing).filter(|_| !*last || nested.is_none());
            let price = price
                .map_or_else(String::new, |price| format!(", about {price:.1} times as long as the run"));
            progress.companion(number + 1, lattices.len(), &format!("{}{price}", companion.lattice));
            let starts = Starts { nested: nested.as_ref(), own: &own.curve, last: *last };
            match run(companion, starts, threads, progress, &mut errors) {
                ControlFlow::Continue(found) if *last => sharp = found,
                ControlFlow::Continue(found) => others.extend(found),
                ControlFlow::Break(()) => {
                    errors.without.push("a run on another lattice was interrupted".into());
                    break;
                }
            }
        }
        if others.is_empty() {
            errors.without.push("no run on another lattice came to answers".into());
            return errors;
        }
        fill(&mut errors, self, &own, (&others, sharp.as_ref()), &found.moved);
        let itself = Refined { scene: self.clone(), spacing: 1.0, lattice: "its own lattice".into() };
        let of = |other: &Found| found.lattices.iter().find(|lattice| lattice.spacing == other.spacing);
        let known = others.iter().filter_map(|other| Some((of(other)?, other))).chain([(&itself, &own)]);
        let coarsest = known.max_by(|(a, _), (b, _)| a.spacing.total_cmp(&b.spacing));
        self.probe(coarsest, threads, progress, &mut errors);
        errors
    }

    /// Runs the probes that are asked for on a lattice whose answers are known, and says what bars leave out beside.
    fn probe(
        &self,
        on: Option<(&Refined, &Found)>,
        threads: usize,
        progress: &mut dyn Progress,
        errors: &mut Errors,
    ) {
        let wanted = self.error.as_ref().map_or(&[][..], |wanted| &wanted.probes);
        let names: Vec<String> = errors.columns.iter().map(|found| found.column.name.clone()).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let mut measured = Vec::new();
        for ((number, &probe), (lattice, known)) in (1..).zip(wanted).zip(on.into_iter().cycle()) {
            progress.companion(number, wanted.len(), &format!("{} on {}", probe.word(), lattice.lattice));
            match probed(lattice, known, probe, &names, threads, progress) {
                Ok(found) => {
                    errors.probes.push(found);
                    measured.push(probe);
                }
                Err(why) => errors.lacks.push(why),
            }
        }
        let left =
            lacks(self).into_iter().filter(|(probe, _)| probe.is_none_or(|probe| !measured.contains(&probe)));
        errors.lacks.extend(left.map(|(_, words)| words));
    }
}

/// How much longer than the run a finer lattice will take; none of coarser ones.
fn price(spacing: f64) -> Option<f64> {
    (spacing < 1.0).then(|| libm::pow(spacing, -GROWTH))
}

/// Pairs the rows and gives each number its bar.
fn fill(
    errors: &mut Errors,
    scene: &Checked,
    own: &Found,
    (others, finer): (&[Found], Option<&Found>),
    moved: &[String],
) {
    let curves: Vec<&Curve> =
        [&own.curve].into_iter().chain(others.iter().map(|other| &other.curve)).collect();
    let most = order_of(scene);
    errors.critical = critical(own, others, most);
    let key = match key(&scene.analysis, &curves) {
        Ok(key) => key,
        Err(why) => {
            errors.without.push(why);
            return;
        }
    };
    let paired: Vec<Vec<Option<Vec<f64>>>> = others.iter().map(|other| rows(own, other, &key)).collect();
    let sharp = finer.map(|finer| rows_of_finer(scene, own, finer, &key)).unwrap_or_default();
    let placed = matches!(scene.analysis, Analysis::Buckling(_));
    for (at, column) in own.curve.columns.iter().enumerate() {
        let name = column.name.as_str();
        let given = name == "level" && !placed && !matches!(scene.analysis, Analysis::ArcLength(_));
        if PLACES.contains(&name) || given || key == Key::Column(at) {
            continue;
        }
        if let Some(set) = moved_set(scene, name, moved) {
            errors.without.push(format!("{name}: its set `{set}` is on no particle of the other lattices"));
            continue;
        }
        let (greatest, beside) = scales(&own.curve, at);
        let vanishes = greatest <= VANISHING * beside;
        let bars = (0..own.curve.rows.len()).map(|row| {
            let answers: Vec<OnLattice> = paired
                .iter()
                .zip(others)
                .filter_map(|(rows, other)| {
                    Some(OnLattice { spacing: other.spacing, value: rows[row].as_ref()?[at] })
                })
                .collect();
            let value = own.curve.rows[row][at];
            let answer = OnLattice { spacing: own.spacing, value };
            let found = bar(answer, &answers, greatest, most);
            if vanishes {
                return zero(found, &answers);
            }
            let finer = finer.zip(sharp.get(row).and_then(Option::as_ref));
            let finer = finer.map(|(finer, row)| OnLattice { spacing: finer.spacing, value: row[at] });
            let coarser = answers.iter().copied().filter(|other| other.spacing > own.spacing);
            let coarsest = coarser.max_by(|a, b| a.spacing.total_cmp(&b.spacing));
            let sharper = coarsest.zip(finer).and_then(|(coarse, fine)| sharpened(answer, coarse, fine));
            sharper.filter(|_| found.verdict != Verdict::Exact).unwrap_or(found)
        });
        let mut bars: Vec<ErrorBar> = bars.collect();
        others.iter().for_each(|other| widen_between(&mut bars, &other.balanced));
        errors.columns.push(ColumnErrors { column: column.clone(), bars });
    }
}

/// Makes bars of rows between those that were balanced no narrower than the line through the bars there: the cubic of the differences may cross zero
/// where they do not.
fn widen_between(bars: &mut [ErrorBar], balanced: &[usize]) {
    for ends in balanced.windows(2) {
        let &[from, to] = ends else { continue };
        let (Some(first), Some(last)) = (bars[from].bar, bars[to].bar) else { continue };
        for row in from + 1..to {
            let share = (row - from) as f64 / (to - from) as f64;
            bars[row].bar = bars[row].bar.map(|bar| bar.max(first + share * (last - first)));
        }
    }
}

/// The rows of a finer lattice that answer those of the run; of levels the last alone.
fn rows_of_finer(scene: &Checked, own: &Found, finer: &Found, key: &Key) -> Vec<Option<Vec<f64>>> {
    if !matches!(scene.analysis, Analysis::Static(_)) {
        return rows(own, finer, key);
    }
    let mut found = vec![None; own.curve.rows.len()];
    if let Some(last) = found.last_mut() {
        *last = finer.curve.rows.last().cloned();
    }
    found
}

/// The bar of a number that is zero by symmetry: what is there is round-off.
fn zero(found: ErrorBar, answers: &[OnLattice]) -> ErrorBar {
    let most = answers.iter().map(|answer| answer.value.abs()).fold(found.value.abs(), f64::max);
    let known = !answers.is_empty() && most.is_finite();
    if known { ErrorBar { bar: Some(most), order: None, verdict: Verdict::Exact, ..found } } else { found }
}

/// Greatest values of a column and of all columns of its unit.
fn scales(curve: &Curve, at: usize) -> (f64, f64) {
    let greatest = |at: usize| curve.rows.iter().fold(0.0, |most: f64, row| most.max(row[at].abs()));
    let alike =
        |column: &Column| column.unit == curve.columns[at].unit && !PLACES.contains(&column.name.as_str());
    let beside = curve
        .columns
        .iter()
        .enumerate()
        .filter(|(_, column)| alike(column))
        .map(|(other, _)| greatest(other));
    (greatest(at), beside.fold(0.0, f64::max))
}

/// The set of a column, if it is one of those that are on no particle of the other lattices.
fn moved_set<'a>(scene: &Checked, column: &str, moved: &'a [String]) -> Option<&'a String> {
    let probe = scene.curve.iter().find(|probe| probe.name == column)?;
    moved.iter().find(|set| **set == probe.on)
}

/// Levels of critical points, paired by kind and order.
fn critical(own: &Found, others: &[Found], most: f64) -> Vec<CriticalError> {
    let scale = own.critical.iter().fold(0.0, |most: f64, (_, level)| most.max(level.abs()));
    let located = |kind: &str| LOCATED.iter().any(|located| kind.starts_with(located));
    let mut found: Vec<CriticalError> = Vec::new();
    for (kind, level) in own.critical.iter().filter(|(kind, _)| located(kind)) {
        let before = found.iter().filter(|known| known.kind == *kind).count();
        let on = |other: &Found| {
            let value = other.critical.iter().filter(|(known, _)| known == kind).nth(before)?.1;
            Some(OnLattice { spacing: other.spacing, value })
        };
        let answers: Vec<OnLattice> = others.iter().filter_map(on).collect();
        let bar = bar(OnLattice { spacing: own.spacing, value: *level }, &answers, scale, most);
        found.push(CriticalError { kind: kind.clone(), bar });
    }
    found
}
