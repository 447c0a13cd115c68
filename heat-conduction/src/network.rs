//! Pairs of nodes between which heat runs by the difference of their temperatures.

use crate::{Conducts, Entry};

/// A matrix of pairs, and what leaves each node by its own degrees so that rows sum to zero.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Network {
    own: Vec<f64>,
    pairs: Vec<(u32, u32, f64)>,
}

impl Network {
    /// So many nodes, and pairs of two different ones with what runs by degree of difference \[F L/(T Θ)\].
    pub fn new(nodes: usize, pairs: Vec<(u32, u32, f64)>) -> Self {
        let mut own = vec![0.0; nodes];
        for &(a, b, conductance) in &pairs {
            own[a as usize] += conductance;
            own[b as usize] += conductance;
        }
        Self { own, pairs }
    }

    /// Pairs of nodes with what runs by degree of difference \[F L/(T Θ)\].
    pub fn pairs(&self) -> &[(u32, u32, f64)] {
        &self.pairs
    }

    /// Nodes that conduct to each other, directly or through others: one list a piece, ascending; a node without a pair is one.
    pub fn pieces(&self) -> Vec<Vec<u32>> {
        let mut root: Vec<u32> = (0..self.own.len() as u32).collect();
        fn find(root: &mut [u32], mut a: u32) -> u32 {
            while root[a as usize] != a {
                root[a as usize] = root[root[a as usize] as usize];
                a = root[a as usize];
            }
            a
        }
        for &(a, b, _) in self.pairs.iter().filter(|pair| pair.2 != 0.0) {
            let (first, second) = (find(&mut root, a), find(&mut root, b));
            root[first.max(second) as usize] = first.min(second);
        }
        let mut pieces: Vec<Vec<u32>> = vec![Vec::new(); self.own.len()];
        for a in 0..self.own.len() as u32 {
            pieces[find(&mut root, a) as usize].push(a);
        }
        pieces.retain(|piece| !piece.is_empty());
        pieces
    }
}

impl Conducts for Network {
    fn parameters(&self) -> usize {
        self.own.len()
    }

    fn visit(&self, _temperatures: &[f64], mut found: impl FnMut(Entry)) {
        for (a, &value) in (0..).zip(&self.own) {
            found(Entry { row: a, column: a, value, factor: 1.0 });
        }
        for &(a, b, conductance) in &self.pairs {
            found(Entry { row: a, column: b, value: -conductance, factor: 1.0 });
            found(Entry { row: b, column: a, value: -conductance, factor: 1.0 });
        }
    }
}
