//! The yield surfaces of families and the round parts of their bonds, fitted to the bonds that a network has.

use std::collections::BTreeSet;

use nalgebra::{SMatrix, SVector};
use sph_core::Vec3;

use super::correction::{least_of_six, products};
use super::flow::{Flow, Past, Surface};
use super::network::{LANES, Network};
use crate::plastic::Plastic;

impl Flow {
    /// Nothing has flowed; families are whole, `places` those of nodes and images at rest, volumes what the body has of nodes.
    pub fn new(network: &Network, plastic: Plastic, places: &[Vec3], volumes: &[f64]) -> Self {
        let (count, packs) = (network.len(), network.packs());
        let none = || vec![[0.0; LANES]; packs];
        let mut out = Self {
            plastic,
            surfaces: Vec::with_capacity(count),
            own: none(),
            twin: none(),
            round: none(),
            round_twin: none(),
            places: places.to_vec(),
            past: vec![Past::default(); count],
            trial: vec![[0.0; 2]; places.len()],
            coming: vec![Past::default(); count],
            flows: false,
            works: Vec::with_capacity(count.div_ceil(parallel::CHUNK)),
        };
        for node in 0..count {
            let [whole, round] = out.fit(network, node);
            out.surfaces
                .push(Surface { shear: whole / (30.0 * volumes[node]), share: volumes[node] / round });
        }
        (0..count).for_each(|node| out.take_round(network, node));
        out
    }

    /// Fits ρ to the bonds that a node has left; returns `Σ c r²` and `Σ c ρ²` \[F L\].
    pub fn fit(&mut self, network: &Network, node: usize) -> [f64; 2] {
        let (mut whole, mut squares) = (0.0, SMatrix::<f64, 6, 6>::zeros());
        let direction = |places: &[Vec3], other: usize, length: f64| (places[other] - places[node]) / length;
        for (_, bond) in network.bonds_of(node) {
            let share = bond.stiffness * bond.length * bond.length;
            let phi = products::<6>(&direction(&self.places, bond.other, bond.length));
            whole += share;
            squares += phi * (phi * share).transpose();
        }
        if whole == 0.0 {
            return [0.0; 2];
        }
        let even = SVector::from_fn(|p, _| if p < 3 { whole / 3.0 } else { 0.0 });
        let form = least_of_six(squares, &even);
        let mut sum = 0.0;
        for (lane, bond) in network.bonds_of(node) {
            let round =
                bond.length * form.dot(&products::<6>(&direction(&self.places, bond.other, bond.length)));
            sum += bond.stiffness * round * round;
            self.round[lane / LANES][lane % LANES] = round;
        }
        [whole, sum]
    }

    /// Takes ρ of the bonds of a node over from their other ends.
    fn take_round(&mut self, network: &Network, node: usize) {
        for (lane, bond) in network.bonds_of(node) {
            let twin = network.twin_of(node, bond.other);
            self.round_twin[lane / LANES][lane % LANES] = self.round[twin / LANES][twin % LANES];
        }
    }
}

impl Network {
    /// The lane of a bond as seen from its other end.
    fn twin_of(&self, node: usize, other: usize) -> usize {
        let (from, seen) = match &self.images {
            Some(images) => (images.source(other), images.seen_back(node, other)),
            None => (other, node),
        };
        LANES * self.packs_of(from).start + self.family(from).before(seen)
    }

    /// Fits what yields to the bonds that these nodes have left.
    pub fn fit_flow(&mut self, nodes: impl IntoIterator<Item = usize>) {
        if let Some(mut flow) = self.flow.take() {
            let mut around = BTreeSet::new();
            for node in nodes {
                flow.fit(self, node);
                around.extend(self.neighbours(node));
            }
            around.into_iter().for_each(|node| flow.take_round(self, node as usize));
            self.flow = Some(flow);
        }
    }
}
