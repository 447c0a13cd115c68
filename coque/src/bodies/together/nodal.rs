//! What a contact between bodies does now, to be read.

use std::collections::BTreeMap;

use contact::{NodalContact, Node};
use sph_core::Vec3;

use super::contact::TouchingBodies;
use crate::bodies::shell::tools::TOUCHING;
use crate::bodies::{ContactNow, Spanned, With};

impl TouchingBodies {
    /// The bodies that touch, the first side first.
    fn bodies(&self) -> [usize; 2] {
        let mut own = (0..self.particles.len()).filter(|&body| !self.particles[body].is_empty());
        std::array::from_fn(|_| own.next().unwrap_or_default())
    }

    /// A place: its side, and its particle there.
    fn particle(&self, place: usize) -> (usize, u32) {
        let [first, second] = self.bodies().map(|body| &self.particles[body]);
        match first.get(place) {
            Some(&particle) => (0, particle),
            None => (1, second[place - first.len()]),
        }
    }

    /// Where a node is, all particles of both bodies being at places \[L\].
    fn node_at(&self, at: &[Vec<Vec3>; 2], node: Node) -> Vec3 {
        let mut sum = Vec3::zeros();
        self.skin.each(node, |place, weight| {
            let (side, particle) = self.particle(place);
            sum += at[side][particle as usize] * weight;
        });
        sum
    }

    /// Adds what each particle of a body feels, where it is one of the two; what a node feels goes to the particles that carry it.
    pub fn nodal_contact(&self, body: usize, nodal: &mut [NodalContact]) {
        let Some(side) = self.bodies().iter().position(|own| *own == body) else { return };
        let count = self.skin.nodes(side).last().map_or(0, |(_, node)| node as usize + 1);
        let mut of_nodes = vec![NodalContact::default(); count];
        self.contact.nodal_contact(side, &mut of_nodes);
        let mut own = vec![NodalContact::default(); nodal.len()];
        for node in self.skin.nodes(side) {
            let whole = of_nodes[node.1 as usize];
            self.skin.each(node, |place, weight| {
                let (_, particle) = self.particle(place);
                let sum = &mut own[particle as usize];
                let of = sum.of + weight * whole.of;
                sum.join(&whole.share(weight));
                sum.of = of;
            });
        }
        nodal.iter_mut().zip(&own).for_each(|(sum, own)| sum.join(own));
    }

    /// Gaps at some particles of a body, where it is one of the two, all particles of a body being at `places` \[L\]; the least of those of
    /// the nodes that a particle carries.
    pub fn gaps(
        &self,
        body: usize,
        particles: &[u32],
        places: impl Fn(usize) -> Vec<Vec3>,
    ) -> Option<Vec<f64>> {
        let bodies = self.bodies();
        let side = bodies.iter().position(|own| *own == body)?;
        let at = bodies.map(places);
        let asked: BTreeMap<u32, usize> = particles.iter().copied().zip(0..).collect();
        let mut carried: Vec<(usize, u32)> = Vec::new();
        for node in self.skin.nodes(side) {
            self.skin.each(node, |place, _| {
                let (_, particle) = self.particle(place);
                carried.extend(asked.get(&particle).map(|&number| (number, node.1)));
            });
        }
        let nodes: Vec<u32> = carried.iter().map(|(_, node)| *node).collect();
        let found = self.contact.gaps(side, &nodes, |node| self.node_at(&at, node));
        let mut gaps = vec![f64::INFINITY; particles.len()];
        carried.iter().zip(found).for_each(|((number, _), gap)| gaps[*number] = gaps[*number].min(gap));
        Some(gaps)
    }

    /// What it does now, all particles of a body being at `places` \[L\].
    pub fn now(&self, places: impl Fn(usize) -> Vec<Vec3>) -> ContactNow {
        let bodies = self.bodies();
        let deep = self.touch.greatest_depth > ContactNow::DEEP;
        let counted = self.touch.greatest_depth > TOUCHING && self.rows.iter().any(Option::is_some);
        let (mut place, mut rows) = (None, None);
        if deep || counted {
            let at = bodies.map(places);
            let at = |node: Node| self.node_at(&at, node);
            place = deep.then(|| self.contact.deepest(at)).flatten().map(|found| found.places[0]);
            rows = [0, 1].into_iter().filter_map(|side| self.spanned(side, at)).reduce(Spanned::narrower);
        }
        ContactNow {
            body: bodies[0],
            with: With::Body(bodies[1]),
            stiffness: self.contact.touching().stiffness,
            by_thickness: None,
            depth: self.touch.greatest_depth,
            area: self.touch.area,
            place,
            rows,
        }
    }

    /// The rows of nodes of a side that touch, a node being at a place \[L\].
    fn spanned(&self, side: usize, at: impl Fn(Node) -> Vec3) -> Option<Spanned> {
        let rows = self.rows[side].as_ref()?;
        let vertices = self.contact.meshes()[side].surface().vertices();
        let mut touching = BTreeMap::new();
        self.contact.each_touching(side, |number, normal| {
            if let &[node] = vertices[number as usize].nodes() {
                touching.insert(node, *normal);
            }
        });
        rows.spanned(&touching, |node| at((side, node)))
    }
}
