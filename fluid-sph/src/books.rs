//! Sums over particles that do not depend on who adds them: plainly within a cell, by the numbers of its particles, and the cells exactly.
//!
//! What is in a cell depends on places alone, so that the sum is the same for any number of threads and of those who march a fluid
//! together.

use peers::Exact;

/// Sums of numbers by slot over the cells that count, those of cell c having the slots `starts[c]..starts[c + 1]`; `numbers(slot,
/// entry)` is called for every slot, with its entry of a list, and does not count of slots that are left out.
pub(crate) fn by_cells<const N: usize, T: Send>(
    threads: usize,
    starts: &[u32],
    left: &[bool],
    list: &mut [T],
    counts: &(impl Fn(usize) -> bool + Sync),
    numbers: &(impl Fn(usize, &mut T) -> [f64; N] + Sync),
) -> [Exact; N] {
    split(threads, Part { starts, left, cell: 0, list }, &|part| part.sums(counts, numbers))
}

/// Cells from one on, whose entries of a list they are.
struct Part<'a, 'b, T> {
    starts: &'a [u32],
    left: &'a [bool],
    cell: usize,
    list: &'b mut [T],
}

/// In as many parts as there are threads.
fn split<'b, const N: usize, T: Send>(
    threads: usize,
    Part { starts, left, cell, list }: Part<'_, 'b, T>,
    sums: &(impl Fn(Part<'_, 'b, T>) -> [Exact; N] + Sync),
) -> [Exact; N] {
    if threads < 2 {
        return sums(Part { starts, left, cell, list });
    }
    let (before, first) = (threads / 2, starts[cell] as usize);
    let middle = first + list.len() / threads * before;
    let next = cell + starts[cell..].partition_point(|&start| (start as usize) < middle);
    let (list, after) = list.split_at_mut(starts[next] as usize - first);
    let (mut found, after) = rayon::join(
        || split(before, Part { starts, left, cell, list }, sums),
        || split(threads - before, Part { starts, left, cell: next, list: after }, sums),
    );
    found.iter_mut().zip(&after).for_each(|(sum, after)| sum.merge(after));
    found
}

impl<T> Part<'_, '_, T> {
    #[inline(always)]
    fn sums<const N: usize>(
        self,
        counts: &impl Fn(usize) -> bool,
        numbers: &impl Fn(usize, &mut T) -> [f64; N],
    ) -> [Exact; N] {
        let Self { starts, left, mut cell, mut list } = self;
        let mut sums = [const { Exact::new() }; N];
        while !list.is_empty() {
            let (from, to) = (starts[cell], starts[cell + 1]);
            if from < to {
                let (own, rest) = std::mem::take(&mut list).split_at_mut((to - from) as usize);
                list = rest;
                let mut sum = [0.0; N];
                for (slot, entry) in (from as usize..).zip(own) {
                    let found = numbers(slot, entry);
                    if left.get(slot).is_none_or(|left| !left) {
                        sum.iter_mut().zip(found).for_each(|(sum, number)| *sum += number);
                    }
                }
                if counts(cell) {
                    sums.iter_mut().zip(sum).for_each(|(sum, own)| put(sum, own));
                }
            }
            cell += 1;
        }
        sums
    }
}

/// Adds a number; zero, of which there are many, changes no sum.
#[inline(always)]
pub(crate) fn put(sum: &mut Exact, number: f64) {
    if number != 0.0 {
        sum.add(number);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Any number of threads, and any two who share the cells, come to the same bits; with empty cells, at the ends too.
    #[test]
    fn sums_do_not_depend_on_who_adds() {
        let sizes = [0, 3, 0, 0, 7, 1, 12, 0, 2, 5, 0];
        let mut starts = vec![0_u32];
        sizes.iter().for_each(|size| starts.push(starts[starts.len() - 1] + size));
        let number = |slot: usize, visits: &mut usize| {
            *visits += 1;
            [libm::sin(1e3 * slot as f64) * libm::exp2(slot as f64), 0.1]
        };
        let mut visits = vec![0; starts[starts.len() - 1] as usize];
        let bits = |sums: [Exact; 2]| sums.map(|sum| sum.value().to_bits());
        let one = bits(by_cells(1, &starts, &[], &mut visits, &|_| true, &number));
        assert!(one.iter().all(|&bits| bits != 0));
        for threads in 2..=7 {
            let sums = by_cells(threads, &starts, &[], &mut visits, &|_| true, &number);
            assert_eq!(bits(sums), one, "{threads} threads");
            assert!(visits.iter().all(|&count| count == threads), "{threads} threads: {visits:?}");
        }
        for share in 0..1 << sizes.len() {
            let mut of = |who: usize| {
                by_cells(1, &starts, &[], &mut visits, &|cell| share >> cell & 1 == who, &number)
            };
            let (mut sums, other) = (of(0), of(1));
            sums.iter_mut().zip(&other).for_each(|(sum, other)| sum.merge(other));
            assert_eq!(bits(sums), one, "{share:b}");
        }
    }
}
