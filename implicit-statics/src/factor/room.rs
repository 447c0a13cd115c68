//! How much room work along the tree takes, so that all of it is there beforehand.

use super::tree::{Tree, Work};

/// Numbers that the subtree of each supernode needs at a time, by the work; the last is the parent of the roots.
#[derive(Default)]
pub(super) struct Room {
    of: [Vec<usize>; 3],
    tasks: [Vec<[usize; 2]>; 3],
}

impl Room {
    /// What `walk` needs.
    pub fn of(tree: &Tree) -> Self {
        let mut room = Self::default();
        for s in 0..=tree.count() {
            for work in [Work::Factor, Work::Forward, Work::Back] {
                let own = room.with_front(tree, s, work);
                room.of[work as usize].push(own);
            }
        }
        room
    }

    pub fn of_all(&self, work: Work) -> usize {
        self.of[work as usize].last().copied().unwrap_or(0)
    }

    pub fn of_tasks(&self, s: usize, work: Work) -> [usize; 2] {
        self.tasks[work as usize][s]
    }

    /// What a supernode needs with all below, what its children need known; and what its tasks need.
    fn with_front(&mut self, tree: &Tree, s: usize, work: Work) -> usize {
        let children = tree.children(s);
        let second = children.partition_point(|&child| tree.first(child as usize) < tree.middle(s));
        let two = tree.middle(s) != s;
        let tasks = if two {
            let (first, second) = children.split_at(second);
            [self.one_by_one(tree, first, work, 0), self.one_by_one(tree, second, work, 0)]
        } else {
            [0, 0]
        };
        self.tasks[work as usize].push(tasks);
        let (height, width) = (tree.height(s), tree.width(s));
        match work {
            Work::Factor | Work::Forward => {
                let below = if two { tasks[0] + tasks[1] } else { self.one_by_one(tree, children, work, 0) };
                let scratch = if matches!(work, Work::Factor) { width * height } else { height };
                below.max(tree.updates(s, work) + tree.update(s, work) + scratch)
            }
            Work::Back if two => height + tasks[0] + tasks[1],
            Work::Back => self.one_by_one(tree, children, work, height).max(height),
        }
    }

    /// What some subtrees need one after the other: forwards each leaves its update beside those before; backwards the front of their
    /// parent stays until the first of them, the last in turn, has taken its part of it.
    fn one_by_one(&self, tree: &Tree, some: &[u32], work: Work, front: usize) -> usize {
        let (mut held, mut most) = (0, 0);
        for (k, &child) in some.iter().enumerate() {
            let child = child as usize;
            let own = self.of[work as usize][child];
            most = most.max(match work {
                Work::Factor | Work::Forward => held + own,
                Work::Back if k == 0 => own.max(front + tree.height(child)),
                Work::Back => front + own,
            });
            held += tree.update(child, work);
        }
        most
    }
}
