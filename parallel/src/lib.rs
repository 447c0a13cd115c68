//! Loops over chunks of a fixed size, so that neither what is written nor what is summed depends on the number of threads.
//!
//! ```
//! let mut squares = vec![0.0; 2000];
//! parallel::chunks(2, &mut squares[..], |first, chunk: &mut [f64]| {
//!     for (i, square) in chunk.iter_mut().enumerate() {
//!         *square = ((first + i) * (first + i)) as f64;
//!     }
//! });
//! assert_eq!(squares[1999], 1999.0 * 1999.0);
//! ```
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | every entry is met once, in chunks that do not depend on threads | `chunks_are_the_same_for_any_number_of_threads` |
#![warn(missing_docs)]

/// Entries of a chunk.
pub const CHUNK: usize = 512;

/// Lists that are worked on in chunks, entry by entry of all of them.
pub trait Lists: Sized + Send {
    /// Number of entries.
    fn len(&self) -> usize;
    /// Whether there are none.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// Those before an entry, a whole number of chunks, and the rest.
    fn split(self, entry: usize) -> (Self, Self);
}

impl<T: Send> Lists for &mut [T] {
    fn len(&self) -> usize {
        (**self).len()
    }

    fn split(self, entry: usize) -> (Self, Self) {
        self.split_at_mut(entry)
    }
}

impl<A: Lists, B: Lists> Lists for (A, B) {
    fn len(&self) -> usize {
        self.0.len()
    }

    fn split(self, entry: usize) -> (Self, Self) {
        let ((a, c), (b, d)) = (self.0.split(entry), self.1.split(entry));
        ((a, b), (c, d))
    }
}

/// One entry for each chunk of the lists beside it.
pub struct ByChunk<'a, R>(pub &'a mut [R]);

impl<R: Send> Lists for ByChunk<'_, R> {
    fn len(&self) -> usize {
        self.0.len() * CHUNK
    }

    fn split(self, entry: usize) -> (Self, Self) {
        let (a, b) = self.0.split_at_mut(entry / CHUNK);
        (Self(a), Self(b))
    }
}

/// Calls `work(first, chunk)` for each chunk of lists.
pub fn chunks<L: Lists>(threads: usize, lists: L, work: impl Fn(usize, L) + Sync) {
    each(threads, 0, lists, &work);
}

fn each<L: Lists>(threads: usize, first: usize, lists: L, work: &(impl Fn(usize, L) + Sync)) {
    let count = lists.len();
    if threads > 1 && count > CHUNK {
        let middle = count.div_ceil(CHUNK) / 2 * CHUNK;
        let (before, after) = lists.split(middle);
        rayon::join(|| each(threads, first, before, work), || each(threads, first + middle, after, work));
        return;
    }
    let (mut next, mut rest) = (first, lists);
    while rest.len() > CHUNK {
        let (chunk, after) = rest.split(CHUNK);
        work(next, chunk);
        (next, rest) = (next + CHUNK, after);
    }
    work(next, rest);
}

/// Calls `work(first, chunk)` for each chunk of lists and keeps what it returns, by chunk.
pub fn reduced<L: Lists, R: Send + Clone + Default>(
    threads: usize,
    lists: L,
    found: &mut Vec<R>,
    work: impl Fn(usize, L) -> R + Sync,
) {
    found.clear();
    found.resize(lists.len().div_ceil(CHUNK), R::default());
    chunks(threads, (lists, ByChunk(found)), |first, (chunk, found)| {
        let reported = work(first, chunk);
        found.0.iter_mut().for_each(|found| *found = reported.clone());
    });
}

/// Whether the caller runs in a pool of several threads.
fn among_several() -> bool {
    rayon::current_thread_index().is_some() && rayon::current_num_threads() > 1
}

/// Does two pieces of work: at once where the caller runs in a pool of several threads, else one after the other.
pub fn both(one: impl FnOnce() + Send, other: impl FnOnce() + Send) {
    if among_several() {
        rayon::join(one, other);
    } else {
        one();
        other();
    }
}

/// Calls `work(k, piece)` for the pieces of a list of a size, the last what is left: shared among the threads of the pool that the
/// caller runs in, if that is asked for.
pub fn pieces<T: Send>(shared: bool, size: usize, list: &mut [T], work: &(impl Fn(usize, &mut [T]) + Sync)) {
    if shared && among_several() {
        halves(0, size, list, work);
    } else {
        list.chunks_mut(size).enumerate().for_each(|(k, piece)| work(k, piece));
    }
}

fn halves<T: Send>(first: usize, size: usize, list: &mut [T], work: &(impl Fn(usize, &mut [T]) + Sync)) {
    let count = list.len().div_ceil(size);
    if count <= 1 {
        return work(first, list);
    }
    let (before, after) = list.split_at_mut(count / 2 * size);
    rayon::join(|| halves(first, size, before, work), || halves(first + count / 2, size, after, work));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every entry is met once, with its own number, and each chunk of whole size but the last.
    #[test]
    fn chunks_are_the_same_for_any_number_of_threads() {
        for count in [0, 1, CHUNK, CHUNK + 1, 7 * CHUNK - 3] {
            for threads in [1, 4] {
                let (mut a, mut b, mut found) = (vec![0; count], vec![0; count], Vec::new());
                reduced(
                    threads,
                    (&mut a[..], &mut b[..]),
                    &mut found,
                    |first, (a, b): (&mut [usize], &mut [usize])| {
                        for (i, (a, b)) in a.iter_mut().zip(b).enumerate() {
                            *a += first + i;
                            *b += first;
                        }
                        first
                    },
                );
                assert!(a.iter().enumerate().all(|(i, &a)| a == i));
                assert!(b.iter().enumerate().all(|(i, &b)| b == i / CHUNK * CHUNK));
                assert!(found.iter().enumerate().all(|(k, &first)| first == k * CHUNK));
            }
        }
    }
}
