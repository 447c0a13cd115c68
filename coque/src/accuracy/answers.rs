//! What a run answers, as numbers that a run on another lattice answers as well.

use crate::run::outcome::{Ended, Outcome};
use crate::scene::Analysis;

/// Columns that are so small beside others of their unit are zero by symmetry and tell of round-off only.
const VANISHING: f64 = 1e-6;

/// Numbers of one column: at levels, at times, of modes, at limit points.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// Name of the column.
    pub name: String,
    /// Its unit.
    unit: String,
    /// The numbers.
    values: Vec<f64>,
}

/// How far the answers of a run are from those of another, column by column.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Greatest difference over the greatest value of the column \[–\].
    pub distance: f64,
    /// The differences over that value.
    differences: Vec<f64>,
}

impl Step {
    /// Whether the numbers go back on the whole where another step went forth.
    pub fn turns_back(&self, after: &Step) -> bool {
        self.differences.iter().zip(&after.differences).map(|(a, b)| a * b).sum::<f64>() < 0.0
    }
}

impl Answer {
    /// From these numbers to those of a finer lattice, over the greatest of the latter.
    pub fn step_to(&self, finer: &Self) -> Step {
        let scale = finer.greatest();
        let differences: Vec<f64> =
            self.values.iter().zip(&finer.values).map(|(a, b)| (b - a) / scale).collect();
        let distance = differences.iter().fold(0.0, |most: f64, d| most.max(d.abs()));
        Step { distance, differences }
    }

    /// The last of them.
    pub fn last(&self) -> Option<f64> {
        self.values.last().copied()
    }

    /// How many they are.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    fn greatest(&self) -> f64 {
        self.values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
    }
}

/// What a run answers, columns that vanish left out; `load` where the level itself is sought.
///
/// # Errors
/// In words: a run that did not end, a scene that measures nothing.
pub fn answers(outcome: &Outcome, analysis: &Analysis, load: bool) -> Result<Vec<Answer>, String> {
    if outcome.ended != Ended::Done {
        return Err(format!("the run did not reach its end: {}", outcome.ended));
    }
    let found = match analysis {
        Analysis::ArcLength(path) => of_path(outcome, analysis.kind().columns, path.until.is_some()),
        Analysis::Modal(_) => of_columns(outcome, &["circular_frequency"]),
        Analysis::Buckling(_) => of_columns(outcome, &["level"]),
        _ => {
            let always = analysis.kind().columns;
            let probes = outcome.curve.columns.iter().map(|column| column.name.as_str());
            let mut names: Vec<&str> = probes.filter(|name| !always.contains(name)).collect();
            names.extend(load.then_some("level"));
            of_columns(outcome, &names)
        }
    };
    let largest = |unit: &str| {
        found.iter().filter(|answer| answer.unit == unit).fold(0.0, |most: f64, a| most.max(a.greatest()))
    };
    let kept: Vec<Answer> =
        found.iter().filter(|a| a.greatest() > VANISHING * largest(&a.unit)).cloned().collect();
    if kept.is_empty() {
        return Err("nothing is measured that differs from zero: add a [[curve]] column".into());
    }
    Ok(kept)
}

fn of_columns(outcome: &Outcome, names: &[&str]) -> Vec<Answer> {
    let column = |name: &&str| {
        let unit = outcome.curve.columns.iter().find(|column| column.name == **name)?.unit.clone();
        Some(Answer { name: (*name).to_owned(), unit, values: outcome.curve.column(name)? })
    };
    names.iter().filter_map(column).collect()
}

/// Levels of limit points, whose number is that of the path; where it ends at a level, its columns there as well.
fn of_path(outcome: &Outcome, always: &[&str], ends_at_level: bool) -> Vec<Answer> {
    let limits = outcome.summary.record.critical.iter().filter(|point| point.kind == "limit point");
    let levels: Vec<f64> = limits.map(|point| point.level).collect();
    let unit = outcome.curve.columns.first().map_or(String::new(), |column| column.unit.clone());
    let mut found = Vec::new();
    if !levels.is_empty() {
        found.push(Answer { name: "level of limit points".into(), unit, values: levels });
    }
    if let (true, Some(row)) = (ends_at_level, outcome.curve.rows.last()) {
        for (column, &value) in outcome.curve.columns.iter().zip(row) {
            if !always.contains(&column.name.as_str()) {
                let (name, unit) = (column.name.clone(), column.unit.clone());
                found.push(Answer { name, unit, values: vec![value] });
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answer(values: &[f64]) -> Answer {
        Answer { name: "w".into(), unit: "m".into(), values: values.into() }
    }

    #[test]
    fn distances_are_shares_of_the_greatest_value() {
        let step = answer(&[0.0, 1.0, -4.1]).step_to(&answer(&[0.2, 1.1, -4.0]));
        assert!((step.distance - 0.05).abs() < 1e-15, "{step:?}");
    }

    #[test]
    fn a_step_back_is_one_against_the_former() {
        let [a, b, c] = [[1.0, 2.0], [1.1, 2.3], [1.05, 2.2]].map(|values| answer(&values));
        assert!(a.step_to(&b).turns_back(&b.step_to(&c)));
        assert!(!a.step_to(&c).turns_back(&c.step_to(&b)));
    }
}
