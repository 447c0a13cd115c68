//! What a solid and a tool do to each other now, to be read.

use std::collections::BTreeMap;

use contact::NodalContact;
use sph_core::Vec3;

use super::on_tool::OnTool;
use crate::bodies::shell::tools::TOUCHING;
use crate::bodies::{ContactNow, Spanned, With};

impl OnTool {
    /// Adds what each particle of the body feels, all of them being at `places` \[L\]; what a node feels goes to the particles that carry it.
    pub fn nodal_contact(&self, places: &[Vec3], nodal: &mut [NodalContact]) {
        let (skin, particles) = self.carried();
        let count = skin.nodes(0).last().map_or(0, |(_, node)| node as usize + 1);
        let mut of_nodes = vec![NodalContact::default(); count];
        let at = |node| self.node_at(places, node);
        self.contact.nodal_contact(self.friction(), &self.stood, at, &mut of_nodes);
        let mut own = vec![NodalContact::default(); nodal.len()];
        for node in skin.nodes(0) {
            let whole = of_nodes[node.1 as usize];
            skin.each(node, |place, weight| {
                let sum = &mut own[particles[place] as usize];
                let of = sum.of + weight * whole.of;
                sum.join(&whole.share(weight));
                sum.of = of;
            });
        }
        nodal.iter_mut().zip(&own).for_each(|(sum, own)| sum.join(own));
    }

    /// Gaps at some particles, all of them being at `places` \[L\]; the least of those of the nodes that a particle carries.
    pub fn gaps(&self, particles: &[u32], places: &[Vec3]) -> Vec<f64> {
        let (skin, carriers) = self.carried();
        let asked: BTreeMap<u32, usize> = particles.iter().copied().zip(0..).collect();
        let mut gaps = vec![f64::INFINITY; particles.len()];
        for node in skin.nodes(0) {
            let place = self.node_at(places, node.1);
            let Some(gap) = self.contact.gap_at(node.1, &self.stood.moved, &place) else { continue };
            skin.each(node, |place, _| {
                if let Some(&number) = asked.get(&carriers[place]) {
                    gaps[number] = gaps[number].min(gap);
                }
            });
        }
        gaps
    }

    /// What it does now, all particles of the body being at `places` \[L\].
    pub fn now(&self, places: impl FnOnce() -> Vec<Vec3>) -> ContactNow {
        let (mut place, mut rows) = (None, None);
        if self.touch.greatest_depth > TOUCHING {
            let places = places();
            let at = |node: u32| self.node_at(&places, node);
            let deep = self.touch.greatest_depth > ContactNow::DEEP;
            place = deep.then(|| self.contact.deepest(&self.stood, at)).flatten().map(|(_, place)| place);
            rows = self.spanned(at);
        }
        ContactNow {
            body: self.body,
            with: With::Tool(self.number),
            stiffness: self.contact.stiffness,
            by_thickness: None,
            depth: self.touch.greatest_depth,
            area: self.touch.area,
            place,
            rows,
        }
    }

    /// The rows of nodes that touch, a node being at a place \[L\].
    fn spanned(&self, at: impl Fn(u32) -> Vec3) -> Option<Spanned> {
        let rows = self.rows.as_ref()?;
        let (mut touching, moved) = (BTreeMap::new(), self.stood.moved);
        self.contact.each_touching(&moved, &at, |number, _| {
            if let &[node] = self.contact.surface.vertices()[number as usize].nodes() {
                touching.insert(node, self.contact.tool.face(&at(node), &moved).normal);
            }
        });
        rows.spanned(&touching, at)
    }
}
