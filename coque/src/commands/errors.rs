//! The errors of a run on the terminal: a line a number.

use std::path::Path;

use crate::{
    Column, ColumnErrors, Costs, ErrorBar, Errors, LatticeRun, Outcome, ProbedColumn, Verdict, costs_svg,
};

use super::stderr::{Refused, say};

/// Most lines of one column, as of modes.
const MOST: usize = 12;

/// Prints each measured number at the last record, or of each mode, with its bar; what the bars hold, and where there are none.
pub fn report(outcome: &Outcome, own: &[String]) {
    let Some(errors) = &outcome.summary.errors else { return };
    let mut lines = Vec::new();
    let modes = outcome.curve.columns.first().is_some_and(|column| column.name == "mode");
    for found in errors.columns.iter().filter(|found| modes || own.contains(&found.column.name)) {
        let Column { name, unit } = &found.column;
        if modes && name == "circular_frequency" {
            continue;
        }
        let first = if modes { 0 } else { found.bars.len().saturating_sub(1) };
        for (mode, bar) in found.bars.iter().enumerate().skip(first).take(MOST) {
            let name = if modes { format!("{name} {}", mode + 1) } else { name.clone() };
            lines.push((name, line(bar, unit, errors)));
        }
    }
    for critical in &errors.critical {
        lines.push((critical.kind.clone(), line(&critical.bar, "-", errors)));
    }
    let width = lines.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    lines.iter().for_each(|(name, line)| say(&format!("  {name:width$}  {line}")));
    let list = |words: &[String]| words.join(", ");
    if !errors.columns.is_empty() {
        say(&format!("  a bar holds: {}; not in it: {}", list(&errors.holds), list(&errors.lacks)));
    }
    for probe in &errors.probes {
        let own = probe.columns.iter().filter(|column| modes || own.contains(&column.name));
        let changes: Vec<String> = own.map(change).collect();
        say(&format!("  {} on {}: {}", probe.changed, probe.lattice, changes.join(", ")));
    }
    if let Some(cost) = errors.cost() {
        let others = errors.lattices.iter().skip(1).map(|run| run.lattice.clone());
        say(&format!(
            "  lattices beside its own: {} ({cost:.2} of the time of the run)",
            list(&others.collect::<Vec<_>>())
        ));
    }
    errors.without.iter().for_each(|why| say(&format!("  no bar: {why}")));
}

/// Draws the error of each measured number on each lattice over the time that it took: at the last record, as its order has it.
///
/// # Errors
/// Numbers without an order; a file that cannot be written.
pub fn chart(errors: &Errors, own: &[String], title: &str, file: &Path) -> Result<(), Refused> {
    let line = |found: &ColumnErrors| {
        let last = found.bars.last()?;
        let (error, order) = (last.convergence()?, last.order?);
        let greatest = found.bars.iter().fold(0.0, |most: f64, bar| most.max(bar.value.abs()));
        let mut lattices: Vec<&LatticeRun> = errors.lattices.iter().collect();
        lattices.sort_by(|a, b| b.spacing.total_cmp(&a.spacing));
        let runs = lattices.iter().map(|run| [run.seconds, error / greatest * libm::pow(run.spacing, order)]);
        Some(Costs { method: found.column.name.clone(), runs: runs.collect() })
    };
    let measured = errors.columns.iter().filter(|found| own.contains(&found.column.name));
    let costs: Vec<Costs> = measured.filter_map(line).collect();
    if costs.is_empty() {
        return Err("no chart: no measured number shows an order on these lattices\n".to_string().into());
    }
    costs_svg(&costs, title, file).map_err(|error| format!("{error}\n"))?;
    say(&format!("errors over times: {}", file.display()));
    Ok(())
}

/// What a probe changes of a column: `w_edge by 1.2e-3 mm`, with the greatest change where that is another.
fn change(column: &ProbedColumn) -> String {
    let ProbedColumn { name, unit, last, greatest } = column;
    let unit = if unit == "-" { String::new() } else { format!(" {unit}") };
    match last {
        Some(last) if last.abs() >= 0.5 * greatest => format!("{name} by {last:+.1e}{unit}"),
        Some(last) => format!("{name} by {last:+.1e}{unit}, {greatest:.1e}{unit} on the way"),
        None => format!("{name} by up to {greatest:.1e}{unit}"),
    }
}

/// `7.46139 ± .0009 mm (order 2.0, three lattices, converging)`.
fn line(found: &ErrorBar, unit: &str, errors: &Errors) -> String {
    let unit = if unit == "-" { String::new() } else { format!(" {unit}") };
    let words = found.verdict.words();
    let Some(bar) = found.bar else {
        return format!("{} ± ?{unit}  ({words})", significant(found.value, 6));
    };
    let (value, bar) = pair(found.value, bar);
    let how = match (found.verdict, found.order) {
        (Verdict::Converging | Verdict::Sharpened, Some(order)) => {
            let count = if errors.lattices.len() == 3 { "three" } else { "several" };
            format!("order {order:.1}, {count} lattices, {words}")
        }
        _ => words.into(),
    };
    let corrected = found
        .corrected
        .map_or_else(String::new, |corrected| format!("; without its error {}", significant(corrected, 6)));
    format!("{value} ± {bar}{unit}  ({how}{corrected})")
}

/// A number and its bar: the bar with two digits, the number as far as its second.
fn pair(value: f64, bar: f64) -> (String, String) {
    let plain = (1e-4..1e7).contains(&value.abs()) && (1e-8..1e7).contains(&bar);
    if !plain {
        return (significant(value, 6), format!("{bar:.1e}"));
    }
    let digits = (1 - libm::floor(libm::log10(bar)) as i32).max(0) as usize;
    (format!("{value:.digits$}"), format!("{bar:.digits$}"))
}

/// A number to so many digits.
fn significant(value: f64, digits: usize) -> String {
    let size = if value == 0.0 { 0 } else { libm::floor(libm::log10(value.abs())) as i32 };
    if !(-4..7).contains(&size) {
        return format!("{value:.0$e}", digits - 1);
    }
    format!("{value:.0$}", (digits as i32 - 1 - size).max(0) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_ends_with_the_second_digit_of_its_bar() {
        assert_eq!(pair(7.461_391, 0.000_91), ("7.46139".into(), "0.00091".into()));
        assert_eq!(pair(2.2241, 0.0114), ("2.224".into(), "0.011".into()));
        assert_eq!(pair(12_345.6, 240.0), ("12346".into(), "240".into()));
        assert_eq!(pair(31.2, 0.0), ("31.2000".into(), "0.0e0".into()));
        assert_eq!(pair(0.0, 0.0), ("0.00000".into(), "0.0e0".into()));
        assert_eq!(pair(1.5e-9, 2e-12), ("1.50000e-9".into(), "2.0e-12".into()));
    }
}
