//! Where the surfaces of two bodies are, by the particles that carry them: a node of a surface is a particle, or lies between some.

use contact::Node;
use sph_core::Vec3;

/// Particles of a body between which a node of its surface lies, with their weights, which sum to one.
pub(super) type Between = Vec<(u32, f64)>;

/// The nodes of two surfaces, numbered through, and the places that carry them: particles of the first body, then those of the second.
#[derive(Clone)]
pub(super) struct Skin {
    /// Number of each node of a side among those of both; of what is no node none.
    numbers: [Vec<u32>; 2],
    /// Places of each node with their weights; none where every node is a particle, whose place has its number.
    carried: Option<Vec<Between>>,
    /// The nodes that each place carries, with its weights.
    borne: Vec<Vec<(Node, f64)>>,
}

impl Skin {
    /// The skin of two surfaces of these nodes, ascending, and the particles of each that carry it; `inside` says between which a node lies.
    pub fn new(nodes: [&[u32]; 2], inside: [Option<&[Between]>; 2]) -> (Self, [Vec<u32>; 2]) {
        let mut first = 0;
        let numbers = nodes.map(|nodes| {
            let mut numbers = vec![u32::MAX; nodes.last().map_or(0, |&last| last as usize + 1)];
            (first..).zip(nodes).for_each(|(number, &node)| numbers[node as usize] = number);
            first += nodes.len() as u32;
            numbers
        });
        let particles = [0, 1].map(|side: usize| match inside[side] {
            None => nodes[side].to_vec(),
            Some(inside) => {
                let all = nodes[side].iter().flat_map(|&node| inside[node as usize].iter().map(|(a, _)| *a));
                let mut all: Vec<u32> = all.collect();
                all.sort_unstable();
                all.dedup();
                all
            }
        });
        let place = |side: usize, particle: u32| {
            let before = if side == 0 { 0 } else { particles[0].len() };
            (before + particles[side].partition_point(|&other| other < particle)) as u32
        };
        let carried = inside.iter().any(Option::is_some).then(|| {
            let of = |side: usize, node: u32| match inside[side] {
                None => vec![(place(side, node), 1.0)],
                Some(inside) => {
                    inside[node as usize].iter().map(|&(a, weight)| (place(side, a), weight)).collect()
                }
            };
            [0, 1].iter().flat_map(|&side| nodes[side].iter().map(move |&node| of(side, node))).collect()
        });
        let mut skin =
            Self { numbers, carried, borne: vec![Vec::new(); particles.iter().map(Vec::len).sum()] };
        let mut borne = std::mem::take(&mut skin.borne);
        for node in [0, 1].into_iter().flat_map(|side| skin.nodes(side)) {
            skin.each(node, |place, weight| borne[place].push((node, weight)));
        }
        (Self { borne, ..skin }, particles)
    }

    /// Where a node is.
    pub fn place(&self, places: &[[f64; 3]], node: Node) -> Vec3 {
        let number = self.number(node);
        match &self.carried {
            None => Vec3::from(places[number]),
            Some(carried) => {
                carried[number].iter().map(|&(a, weight)| Vec3::from(places[a as usize]) * weight).sum()
            }
        }
    }

    /// Hands each place that carries a node with its weight to `each`.
    pub fn each(&self, node: Node, mut each: impl FnMut(usize, f64)) {
        let number = self.number(node);
        match &self.carried {
            None => each(number, 1.0),
            Some(carried) => carried[number].iter().for_each(|&(a, weight)| each(a as usize, weight)),
        }
    }

    /// The nodes that a place carries, with its weights.
    pub fn borne(&self, place: usize) -> &[(Node, f64)] {
        &self.borne[place]
    }

    /// The nodes of a side.
    pub fn nodes(&self, side: usize) -> impl Iterator<Item = Node> + '_ {
        let numbers = (0..).zip(&self.numbers[side]);
        numbers.filter(|(_, number)| **number != u32::MAX).map(move |(node, _)| (side, node))
    }

    /// Mass that moves with a node at least, where places have these masses \[M\].
    pub fn mass(&self, masses: &[f64], node: Node) -> f64 {
        match &self.carried {
            None => masses[self.number(node)],
            Some(carried) => {
                let inverse = |&(a, weight): &(u32, f64)| weight * weight / masses[a as usize];
                1.0 / carried[self.number(node)].iter().map(inverse).sum::<f64>()
            }
        }
    }

    fn number(&self, (side, node): Node) -> usize {
        self.numbers[side][node as usize] as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A node that is a particle, and two that lie between three of another body.
    #[test]
    fn nodes_lie_between_their_particles_and_hand_them_what_they_feel() {
        let inside = [vec![(1, 0.75), (4, 0.25)], Vec::new(), vec![(4, 0.5), (7, 0.5)]];
        let (skin, particles) = Skin::new([&[3], &[0, 2]], [None, Some(&inside)]);
        assert_eq!(particles, [vec![3], vec![1, 4, 7]]);
        let places = [[5.0, 0.0, 0.0], [0.0; 3], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0]];
        assert_eq!(skin.place(&places, (0, 3)), Vec3::new(5.0, 0.0, 0.0));
        assert_eq!(skin.place(&places, (1, 0)), Vec3::new(1.0, 0.0, 0.0));
        assert_eq!(skin.place(&places, (1, 2)), Vec3::new(2.0, 1.0, 0.0));
        let mut handed = Vec::new();
        skin.each((1, 2), |a, weight| handed.push((a, weight)));
        assert_eq!(handed, [(2, 0.5), (3, 0.5)]);
        let masses = [1.0, 2.0, 3.0, 6.0];
        assert_eq!((skin.mass(&masses, (0, 3)), skin.mass(&masses, (1, 2))), (1.0, 8.0));
    }
}
