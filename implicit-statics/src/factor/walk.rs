//! Along the tree: from the leaves to the roots, and back. The order of all that is summed is that of the tree, whatever the threads.

use std::mem::take;
use std::ops::Range;

use super::room::Room;
use super::tree::{Tree, Work};

/// Visits supernodes of a range of whole subtrees, children first: `visit(s, own, left, update, scratch)` with the supernode's own
/// numbers, what its children left one after the other, the update that it leaves for its parent, and scratch.
///
/// The updates of those without a parent in the range stand at the start of the room in the end.
pub(super) fn upward<T: Copy + Send>(
    (tree, sizes): (&Tree, &Room),
    work: Work,
    range: Range<usize>,
    mut own: &mut [T],
    room: &mut [T],
    visit: &(impl Fn(usize, &mut [T], &[T], &mut [T], &mut [T]) + Sync),
) {
    let (mut s, mut held) = (range.start, 0);
    while s < range.end {
        if let Some(node) = tree.task(s, range.end) {
            let middle = tree.middle(node);
            let (below, rest) = take(&mut own).split_at_mut(tree.extent(s..node, work));
            let (first, second) = below.split_at_mut(tree.extent(s..middle, work));
            let [a, b] = sizes.of_tasks(node, work);
            let (room_a, room_b) = room[held..held + a + b].split_at_mut(a);
            parallel::both(
                || upward((tree, sizes), work, s..middle, first, room_a, visit),
                || upward((tree, sizes), work, middle..node, second, room_b, visit),
            );
            let of = |child: &u32| tree.update(*child as usize, work);
            let (one, other): (Vec<u32>, Vec<u32>) =
                tree.children(node).iter().partition(|&&child| (child as usize) < middle);
            let [one, other]: [usize; 2] = [one, other].map(|half| half.iter().map(of).sum());
            room.copy_within(held + a..held + a + other, held + one);
            held += one + other;
            (own, s) = (rest, node);
        }
        let (mine, rest) = take(&mut own).split_at_mut(tree.extent(s..s + 1, work));
        let (before, free) = room.split_at_mut(held);
        let start = held - tree.updates(s, work);
        let update = tree.update(s, work);
        let (new, scratch) = free.split_at_mut(update);
        visit(s, mine, &before[start..], new, scratch);
        if start != held {
            room.copy_within(held..held + update, start);
        }
        held = start + update;
        (own, s) = (rest, s + 1);
    }
}

/// Visits supernodes of a range of whole subtrees, parents first: `visit(s, own, above, front)` with the supernode's own numbers, the
/// front of its parent as `visit` left it, and its own front to be filled. `above` is the front of the parent of the last.
pub(super) fn downward<T: Copy + Send + Sync>(
    (tree, sizes): (&Tree, &Room),
    range: Range<usize>,
    mut own: &mut [T],
    above: &[T],
    room: &mut [T],
    visit: &(impl Fn(usize, &mut [T], &[T], &mut [T]) + Sync),
) {
    // Fronts whose children are not all done, each after its parent's, and where the last ends.
    let (mut fronts, mut end) = (Vec::new(), 0);
    let mut s = range.end;
    while s > range.start {
        s -= 1;
        let height = tree.height(s);
        let columns = own.len() - tree.extent(s..s + 1, Work::Back);
        let (rest, mine) = take(&mut own).split_at_mut(columns);
        own = rest;
        let (held, free) = room.split_at_mut(end);
        visit(s, mine, fronts.last().map_or(above, |&start| &held[start..]), &mut free[..height]);
        let mut start = end;
        if tree.leads(s)
            && let Some(parent) = fronts.pop()
        {
            // The first child is the last in turn: nothing asks for the front of the parent any more.
            room.copy_within(start..start + height, parent);
            start = parent;
        }
        (fronts, end) = match (tree.children(s), tree.middle(s)) {
            ([], _) => (fronts, start),
            (_, middle) if middle == s => {
                fronts.push(start);
                (fronts, start + height)
            }
            (_, middle) => {
                let first = tree.first(s);
                let (rest, below) = take(&mut own).split_at_mut(tree.extent(range.start..first, Work::Back));
                let (one, other) = below.split_at_mut(tree.extent(first..middle, Work::Back));
                let (held, free) = room.split_at_mut(start + height);
                let front = &held[start..];
                let (room_a, room_b) = free.split_at_mut(sizes.of_tasks(s, Work::Back)[0]);
                parallel::both(
                    || downward((tree, sizes), first..middle, one, front, room_a, visit),
                    || downward((tree, sizes), middle..s, other, front, room_b, visit),
                );
                (own, s) = (rest, first);
                (fronts, start)
            }
        };
    }
}
