//! The same factor in another order: each column right after those that are eliminated into it.

/// An order of elimination in which every subtree of the elimination tree is a run of columns \[liu1990\]: it fills as much, its columns of
/// the same rows are neighbours, and what hangs below two columns that have nothing in common lies apart. `pointers` and `rows` are
/// compressed columns of the lower triangle of the pattern.
pub(crate) fn postordered(order: &[usize], pointers: &[usize], rows: &[usize]) -> Vec<usize> {
    let parents = parents(order, pointers, rows);
    let count = order.len();
    // Children of each column in a list, those of none last: the next of each, and the first.
    let (mut first, mut next) = (vec![usize::MAX; count + 1], vec![usize::MAX; count]);
    for column in (0..count).rev() {
        let parent = parents[column].min(count);
        next[column] = first[parent];
        first[parent] = column;
    }
    let mut out = Vec::with_capacity(count);
    let mut way = vec![count];
    while let Some(&column) = way.last() {
        let child = first[column];
        if child == usize::MAX {
            way.pop();
            out.extend(order.get(column));
        } else {
            first[column] = next[child];
            way.push(child);
        }
    }
    out
}

/// The first row below the diagonal of each column of the factor, beyond all of them where there is none.
fn parents(order: &[usize], pointers: &[usize], rows: &[usize]) -> Vec<usize> {
    let count = order.len();
    let mut place = vec![0; count];
    order.iter().enumerate().for_each(|(new, &old)| place[old] = new);
    let pairs = || {
        (0..count).flat_map(|column| {
            let (place, at) = (&place, place[column]);
            rows[pointers[column]..pointers[column + 1]]
                .iter()
                .map(move |&row| (place[row].max(at), place[row].min(at)))
        })
    };
    // Columns before each that it couples with, in a row.
    let mut starts = vec![0; count + 1];
    pairs().for_each(|(later, _)| starts[later + 1] += 1);
    (0..count).for_each(|k| starts[k + 1] += starts[k]);
    let (mut fill, mut before) = (starts.clone(), vec![0; starts[count]]);
    for (later, earlier) in pairs() {
        before[fill[later]] = earlier;
        fill[later] += 1;
    }
    let (mut parents, mut roots) = (vec![usize::MAX; count], vec![usize::MAX; count]);
    for column in 0..count {
        for &earlier in &before[starts[column]..starts[column + 1]] {
            // Up to the root of its tree so far; those on the way learn of this column.
            let mut at = earlier;
            while at < column {
                let up = std::mem::replace(&mut roots[at], column);
                if up == usize::MAX {
                    parents[at] = column;
                    break;
                }
                at = up;
            }
        }
    }
    parents
}

#[cfg(test)]
mod tests {
    use super::postordered;

    /// Of two branches that are eliminated in turn and meet in the last column, one comes after the other.
    #[test]
    fn branches_lie_apart() {
        // 0 – 2 – 4 and 1 – 3 – 4, lower triangle by columns
        let (pointers, rows) = ([0, 2, 4, 6, 8, 9], [0, 2, 1, 3, 2, 4, 3, 4, 4]);
        assert_eq!(postordered(&[0, 1, 2, 3, 4], &pointers, &rows), [0, 2, 1, 3, 4]);
    }
}
