//! Loads, all dead and all proportional to the load level.

use nalgebra::Vector3;

/// A load at level λ = 1.
#[derive(Debug, Clone, PartialEq)]
pub enum Load {
    /// A force on a node \[F\].
    Node(usize, Vector3<f64>),
    /// A force spread evenly along the line through the nodes, in order; its total \[F\].
    Edge(Vec<usize>, Vector3<f64>),
    /// A couple about an axis fixed in space, spread evenly along the line through the nodes; its total \[F L\].
    ///
    /// Only its part across the director works. It has a potential as long as the directors stay in the plane
    /// across the axis.
    EdgeCouple(Vec<usize>, Vector3<f64>),
    /// A force per reference area, fixed in direction \[F/L²\].
    Area(Vector3<f64>),
}

/// The share of each node of a line in what is spread evenly along it.
pub fn shares(nodes: &[usize], positions: &[Vector3<f64>]) -> Vec<(usize, f64)> {
    let lengths: Vec<f64> =
        nodes.windows(2).map(|pair| (positions[pair[1]] - positions[pair[0]]).norm()).collect();
    let total: f64 = lengths.iter().sum();
    let length = |index: Option<usize>| index.and_then(|index| lengths.get(index)).copied().unwrap_or(0.0);
    let share = |(index, &node): (usize, &usize)| {
        (node, 0.5 * (length(index.checked_sub(1)) + length(Some(index))) / total)
    };
    nodes.iter().enumerate().map(share).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_inner_node_takes_half_of_both_neighbours() {
        let positions: Vec<_> = [0.0, 1.0, 4.0].iter().map(|&x| Vector3::new(x, 0.0, 0.0)).collect();
        assert_eq!(shares(&[0, 1, 2], &positions), [(0, 0.125), (1, 0.5), (2, 0.375)]);
    }
}
