//! Fragments: nodes that whole bonds join.

use super::network::Network;

/// The number of nodes of each fragment, in the order of their first nodes.
pub(crate) fn fragments(network: &Network, whole: impl Fn(usize) -> bool) -> Vec<usize> {
    let mut seen = vec![false; network.len()];
    let mut sizes = Vec::new();
    let mut waiting = Vec::new();
    for first in 0..network.len() {
        if std::mem::replace(&mut seen[first], true) {
            continue;
        }
        waiting.push(first);
        let mut size = 0;
        while let Some(node) = waiting.pop() {
            size += 1;
            for (_, bond) in network.bonds_of(node).filter(|(lane, _)| whole(*lane)) {
                let other = network.source(bond.other);
                if !std::mem::replace(&mut seen[other], true) {
                    waiting.push(other);
                }
            }
        }
        sizes.push(size);
    }
    sizes
}
