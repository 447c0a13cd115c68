//! Matching on a graph of triangles: free ones are brought together along alternating paths.

/// Pairs on the longest path that is tried, beside the first: paths are enumerated, and their number doubles with each.
const LONGEST: usize = 10;

/// A bond between two nodes; a lower cost is better.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bond {
    pub nodes: [usize; 2],
    pub cost: i64,
}

/// Bonds that share no node: greedily the cheapest first, then two free nodes at a time are joined along an alternating path,
/// the one whose worst new bond is cheapest. For each node the index of its bond.
///
/// Ties go to the lower index. Paths are simple and at most 21 bonds long; in a triangulation that leaves next to
/// nothing free.
pub(crate) fn matching(nodes: usize, bonds: &[Bond]) -> Vec<Option<usize>> {
    let mut order: Vec<usize> = (0..bonds.len()).collect();
    order.sort_by_key(|&b| (bonds[b].cost, bonds[b].nodes));
    let mut taken: Vec<Option<usize>> = vec![None; nodes];
    let mut at: Vec<Vec<usize>> = vec![Vec::new(); nodes];
    for b in order {
        let [first, second] = bonds[b].nodes;
        at[first].push(b);
        at[second].push(b);
        if taken[first].is_none() && taken[second].is_none() {
            taken[first] = Some(b);
            taken[second] = Some(b);
        }
    }
    for length in 1..=LONGEST {
        for node in 0..nodes {
            if taken[node].is_none() && !at[node].is_empty() {
                let mut search =
                    Search { bonds, at: &at, taken: &taken, path: vec![node], used: Vec::new(), best: None };
                search.extend(length, i64::MIN);
                for b in search.best.map(|best| best.bonds).unwrap_or_default() {
                    for end in bonds[b].nodes {
                        taken[end] = Some(b);
                    }
                }
            }
        }
    }
    taken
}

/// Depth-first search for the best alternating path from a free node to another.
struct Search<'a> {
    bonds: &'a [Bond],
    at: &'a [Vec<usize>],
    taken: &'a [Option<usize>],
    /// Nodes on the path.
    path: Vec<usize>,
    /// New bonds on the path.
    used: Vec<usize>,
    best: Option<Found>,
}

struct Found {
    worst: i64,
    bonds: Vec<usize>,
}

impl Search<'_> {
    /// Goes on from the end of the path, over at most `length` nodes that have a bond to give up.
    fn extend(&mut self, length: usize, worst: i64) {
        let Some(&end) = self.path.last() else { return };
        for &b in &self.at[end] {
            let worst = worst.max(self.bonds[b].cost);
            let next = other(&self.bonds[b], end);
            if self.best.as_ref().is_some_and(|best| best.worst <= worst) || self.path.contains(&next) {
                continue;
            }
            self.used.push(b);
            match self.taken[next] {
                None => self.best = Some(Found { worst, bonds: self.used.clone() }),
                Some(old) if length > 0 => {
                    let after = other(&self.bonds[old], next);
                    if !self.path.contains(&after) {
                        self.path.extend([next, after]);
                        self.extend(length - 1, worst);
                        self.path.truncate(self.path.len() - 2);
                    }
                }
                Some(_) => {}
            }
            self.used.pop();
        }
    }
}

fn other(bond: &Bond, node: usize) -> usize {
    if bond.nodes[0] == node { bond.nodes[1] } else { bond.nodes[0] }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain(costs: &[i64]) -> Vec<Bond> {
        costs.iter().enumerate().map(|(i, &cost)| Bond { nodes: [i, i + 1], cost }).collect()
    }

    #[test]
    fn a_greedy_choice_is_taken_back_where_two_are_left_over() {
        assert_eq!(matching(4, &chain(&[5, 1, 5])), [Some(0), Some(0), Some(2), Some(2)]);
        // Nothing to gain with three.
        assert_eq!(matching(3, &chain(&[5, 1])), [None, Some(1), Some(1)]);
        // Cheap bonds 1–2, 3–4, … over expensive ones at both ends: one path takes them all back.
        let costs: Vec<i64> = (0..19).map(|i| if i % 2 == 0 { 9 } else { 1 }).collect();
        assert!(matching(20, &chain(&costs)).iter().all(Option::is_some));
    }

    #[test]
    fn of_two_paths_the_one_with_the_better_worst_bond_is_taken() {
        // Free node 0 may go by 1–2 to 3 (worst 7) or by 4–5 to 6 (worst 6).
        let bonds = [([0, 1], 7), ([1, 2], 1), ([2, 3], 5), ([0, 4], 6), ([4, 5], 1), ([5, 6], 4)];
        let bonds = bonds.map(|(nodes, cost)| Bond { nodes, cost });
        let taken = matching(7, &bonds);
        assert_eq!(taken, [Some(3), Some(1), Some(1), None, Some(3), Some(5), Some(5)]);
    }

    #[test]
    fn odd_rings_leave_one() {
        let mut bonds = chain(&[1, 1, 1, 1]);
        bonds.push(Bond { nodes: [0, 4], cost: 1 });
        assert_eq!(matching(5, &bonds).iter().filter(|taken| taken.is_none()).count(), 1);
    }
}
