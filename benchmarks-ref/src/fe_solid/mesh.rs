//! Blocks of bricks, and what loads on them amount to at nodes.

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::element::{NODES, Point, function, gauss, places};

/// Bricks with shared nodes.
#[derive(Debug, Clone)]
pub struct Mesh {
    /// Places of the nodes \[L\].
    pub positions: Vec<Vector3<f64>>,
    /// Nodes of the bricks: corners and middles of edges, the first axis fastest.
    pub elements: Vec<[usize; NODES]>,
}

impl Mesh {
    /// A box from the origin with so many bricks along the axes.
    pub fn block(lengths: [f64; 3], counts: [usize; 3]) -> Self {
        let mut numbers: BTreeMap<[usize; 3], usize> = BTreeMap::new();
        let (mut positions, mut elements) = (Vec::new(), Vec::new());
        for at in 0..counts.iter().product() {
            let brick = [at / (counts[1] * counts[2]), at / counts[2] % counts[1], at % counts[2]];
            elements.push(places().map(|place| {
                let key: [usize; 3] =
                    std::array::from_fn(|k| (2 * brick[k] + 1).wrapping_add_signed(place[k] as isize));
                *numbers.entry(key).or_insert_with(|| {
                    let part = |k: usize| key[k] as f64 / (2 * counts[k]) as f64;
                    positions.push(Vector3::from_fn(|k, _| lengths[k] * part(k)));
                    positions.len() - 1
                })
            }));
        }
        Self { positions, elements }
    }

    /// Nodes where something holds.
    pub fn nodes(&self, holds: impl Fn(&Vector3<f64>) -> bool) -> Vec<usize> {
        (0..self.positions.len()).filter(|&node| holds(&self.positions[node])).collect()
    }

    /// Places of the nodes of a brick.
    pub(super) fn corners(&self, element: usize) -> [Vector3<f64>; NODES] {
        self.elements[element].map(|node| self.positions[node])
    }

    /// Forces at nodes that a traction \[F/L²\] does the same work as, on every side of a brick all of whose nodes lie on the face
    /// where something holds.
    pub fn traction(
        &self,
        holds: impl Fn(&Vector3<f64>) -> bool,
        traction: Vector3<f64>,
    ) -> Vec<(usize, Vector3<f64>)> {
        let mut out = Vec::new();
        let own = places();
        for (number, nodes) in self.elements.iter().enumerate() {
            let corners = self.corners(number);
            for (axis, side) in (0..6).map(|at| (at / 2, 2 * (at as i32 % 2) - 1)) {
                let on = |node: &usize| own[*node][axis] == side;
                if !(0..NODES).filter(on).all(|node| holds(&corners[node])) {
                    continue;
                }
                for (a, b) in (0..9).map(|at| (gauss(3)[at % 3], gauss(3)[at / 3])) {
                    let mut place = [f64::from(side); 3];
                    (place[(axis + 1) % 3], place[(axis + 2) % 3]) = (a.0, b.0);
                    let both = own.map(|node| function(node, place));
                    let tangent = |k: usize| {
                        let parts = corners.iter().zip(&both).map(|(x, (_, slopes))| x * slopes[k]);
                        parts.sum::<Vector3<f64>>()
                    };
                    let area = a.1 * b.1 * tangent((axis + 1) % 3).cross(&tangent((axis + 2) % 3)).norm();
                    out.extend(
                        (0..NODES).filter(on).map(|node| (nodes[node], traction * (area * both[node].0))),
                    );
                }
            }
        }
        out
    }

    /// Forces at nodes of a force by volume \[F/L³\].
    pub fn body_force(&self, force: Vector3<f64>) -> Vec<(usize, Vector3<f64>)> {
        let of_brick = |(number, nodes): (usize, &[usize; NODES])| {
            let points = Point::of(&self.corners(number), 3).unwrap_or_default();
            let share =
                |node: usize| points.iter().map(|point| point.volume * point.values[node]).sum::<f64>();
            std::array::from_fn::<_, NODES, _>(|node| (nodes[node], force * share(node)))
        };
        self.elements.iter().enumerate().flat_map(of_brick).collect()
    }
}
