//! The tangent's pattern as compressed columns, and products with values in the order of the pattern.

use crate::EquilibriumError;
use crate::error::require;

/// Compressed columns of a pattern: pointers, rows, and the place of each entry of the pattern.
pub(crate) type Columns = (Vec<usize>, Vec<usize>, Vec<usize>);

pub(crate) fn columns(unknowns: usize, pattern: &[(usize, usize)]) -> Result<Columns, EquilibriumError> {
    require(unknowns > 0, "number of unknowns", 0.0, "one at least")?;
    let refuse = |(row, column): (usize, usize), what: &'static str| {
        Err(EquilibriumError::Pattern { row, column, unknowns, what })
    };
    if let Some(&entry) = pattern.iter().find(|entry| entry.0.max(entry.1) >= unknowns) {
        return refuse(entry, "outside");
    }
    let by_row = buckets(unknowns, &(0..pattern.len()).collect::<Vec<_>>(), |k| pattern[k].0);
    let order = buckets(unknowns, &by_row, |k| pattern[k].1);
    drop(by_row);
    let mut pointers = vec![0; unknowns + 1];
    let mut rows = Vec::with_capacity(pattern.len());
    let mut slots = vec![0; pattern.len()];
    for (slot, &k) in order.iter().enumerate() {
        let (row, column) = pattern[k];
        if row < column {
            return refuse((row, column), "above the diagonal");
        }
        if slot > 0 && pattern[order[slot - 1]] == (row, column) {
            return refuse((row, column), "there twice");
        }
        pointers[column + 1] = slot + 1;
        rows.push(row);
        slots[k] = slot;
    }
    for column in 0..unknowns {
        let begin = pointers[column];
        if pointers[column + 1] <= begin || rows[begin] != column {
            return refuse((column, column), "missing");
        }
    }
    Ok((pointers, rows, slots))
}

/// Entries by a number below `count` that each has, those with the same in the order given.
fn buckets(count: usize, entries: &[usize], of: impl Fn(usize) -> usize) -> Vec<usize> {
    let mut next = vec![0; count + 1];
    entries.iter().for_each(|&k| next[of(k) + 1] += 1);
    (0..count).for_each(|number| next[number + 1] += next[number]);
    let mut out = vec![0; entries.len()];
    for &k in entries {
        let place = &mut next[of(k)];
        out[*place] = k;
        *place += 1;
    }
    out
}

/// `out = K x` for values in the order of a lower-triangular pattern.
pub(crate) fn product(pattern: &[(usize, usize)], values: &[f64], x: &[f64], out: &mut [f64]) {
    out.fill(0.0);
    for (&(row, column), &value) in pattern.iter().zip(values) {
        out[row] += value * x[column];
        if row != column {
            out[column] += value * x[row];
        }
    }
}
