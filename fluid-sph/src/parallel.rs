//! Loops over chunks of a fixed size, so that sums do not depend on threads.

use rayon::prelude::*;

/// Entries of a chunk.
pub(crate) const CHUNK: usize = 512;

/// Calls `work(first, chunk)` for each chunk of a list.
pub(crate) fn chunks<T: Send>(threads: usize, list: &mut [T], work: impl Fn(usize, &mut [T]) + Sync) {
    if threads > 1 {
        list.par_chunks_mut(CHUNK).enumerate().for_each(|(k, chunk)| work(k * CHUNK, chunk));
    } else {
        list.chunks_mut(CHUNK).enumerate().for_each(|(k, chunk)| work(k * CHUNK, chunk));
    }
}

/// Calls `work(first, chunk of a, chunk of b)`, two lists of one length.
pub(crate) fn chunks_of_two<A: Send, B: Send>(
    threads: usize,
    a: &mut [A],
    b: &mut [B],
    work: impl Fn(usize, &mut [A], &mut [B]) + Sync,
) {
    if threads > 1 {
        let both = a.par_chunks_mut(CHUNK).zip(b.par_chunks_mut(CHUNK));
        both.enumerate().for_each(|(k, (a, b))| work(k * CHUNK, a, b));
    } else {
        let both = a.chunks_mut(CHUNK).zip(b.chunks_mut(CHUNK));
        both.enumerate().for_each(|(k, (a, b))| work(k * CHUNK, a, b));
    }
}

/// Calls `work(first, chunk)` for each chunk of a list and keeps what it returns, by chunk.
pub(crate) fn reduced<T: Send, R: Send + Clone + Default>(
    threads: usize,
    list: &mut [T],
    found: &mut Vec<R>,
    work: impl Fn(usize, &mut [T]) -> R + Sync,
) {
    found.clear();
    found.resize(list.len().div_ceil(CHUNK), R::default());
    if threads > 1 {
        let both = list.par_chunks_mut(CHUNK).zip(found.par_iter_mut());
        both.enumerate().for_each(|(k, (chunk, found))| *found = work(k * CHUNK, chunk));
    } else {
        let both = list.chunks_mut(CHUNK).zip(found.iter_mut());
        both.enumerate().for_each(|(k, (chunk, found))| *found = work(k * CHUNK, chunk));
    }
}

/// As [`reduced`], over two lists of one length.
pub(crate) fn reduced_of_two<A: Send, B: Send, R: Send + Clone + Default>(
    threads: usize,
    a: &mut [A],
    b: &mut [B],
    found: &mut Vec<R>,
    work: impl Fn(usize, &mut [A], &mut [B]) -> R + Sync,
) {
    found.clear();
    found.resize(a.len().div_ceil(CHUNK), R::default());
    if threads > 1 {
        let all = a.par_chunks_mut(CHUNK).zip(b.par_chunks_mut(CHUNK)).zip(found.par_iter_mut());
        all.enumerate().for_each(|(k, ((a, b), found))| *found = work(k * CHUNK, a, b));
    } else {
        let all = a.chunks_mut(CHUNK).zip(b.chunks_mut(CHUNK)).zip(found.iter_mut());
        all.enumerate().for_each(|(k, ((a, b), found))| *found = work(k * CHUNK, a, b));
    }
}
