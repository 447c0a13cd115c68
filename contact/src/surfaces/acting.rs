//! What contact does to nodes, for the state last looked at: forces, tangent, bounds of stiffness, the time until parts meet.

use nalgebra::Matrix3;
use sph_core::Vec3;

use super::{Contact, Deepest, Node, Pushed, SurfaceContact, corners_of};
use crate::edges::Crossing;

impl SurfaceContact {
    /// Hands the forces on nodes to `add`, for the state last looked at: `−∂U/∂x`.
    pub fn forces(&self, mut add: impl FnMut(Node, Vec3)) {
        for contact in &self.contacts {
            let force = contact.pair.normal * -contact.slope;
            self.each_place(contact, |place, body, nodes, share| {
                let part = force * (contact.pair.weights[place] * share);
                nodes.iter().for_each(|&a| add((body, a), part));
            });
        }
        for pushed in &self.pushed {
            self.each_end(pushed, |node, share, end| add(node, pushed.crossing.forces[end] * share));
        }
        self.rubbing_forces(add);
    }

    /// Hands the derivatives of the force on a node by the place of another to `put`, for the state last looked at. Without edges.
    pub fn tangent(&self, at: impl Fn(Node) -> Vec3, mut put: impl FnMut(Node, Node, &Matrix3<f64>)) {
        for contact in &self.contacts {
            let (places, count) = self.places_of(contact, &at);
            let blocks = contact.pair.second(&places[..count], contact.slope, contact.curvature);
            self.each_pair(contact, |[a, b], node, to, share| put(node, to, &(blocks[a][b] * -share)));
        }
        self.rubbing_tangent(at, put);
    }

    /// Hands what contact adds at most to the stiffness against motions of each node to `add` \[F/L\]: the row of `Σ ψ″ w wᵀ`, whose
    /// weights have two as the sum of their sizes.
    pub fn rows(&self, mut add: impl FnMut(Node, f64)) {
        for contact in &self.contacts {
            self.each_node(contact, |node, weight| add(node, 2.0 * contact.curvature.abs() * weight.abs()));
        }
        for pushed in &self.pushed {
            let Crossing { curvature, weights, .. } = &pushed.crossing;
            self.each_end(pushed, |node, share, end| add(node, 2.0 * curvature * share * weights[end].abs()));
        }
    }

    /// The same at a vertex of a body that is touched on both faces while depths stay out of the barrier, 4 κ A \[F/L\].
    pub fn bound(&self, body: usize, vertex: usize) -> f64 {
        4.0 * self.touching.stiffness * self.meshes[body].surface().vertices()[vertex].area * self.tilted
    }

    /// The time in which those deeper than a depth \[–\], and edges, would meet with their present rates \[L/T\]; infinite where none comes nearer.
    pub fn meeting(&self, deeper: f64, rate: impl Fn(Node) -> Vec3) -> f64 {
        let mut least = f64::INFINITY;
        let mut meet = |distance: f64, closing: f64| {
            if closing > 0.0 {
                least = least.min(distance / closing);
            }
        };
        for contact in
            self.contacts.iter().filter(|contact| contact.depth > deeper && contact.coefficient > 0.0)
        {
            let mut closing = 0.0;
            self.each_node(contact, |node, weight| closing -= contact.pair.normal.dot(&rate(node)) * weight);
            meet(contact.pair.distance, closing);
        }
        for pushed in &self.pushed {
            let Crossing { normal, weights, distance, .. } = pushed.crossing;
            let mut closing = 0.0;
            self.each_end(pushed, |node, share, end| {
                closing -= normal.dot(&rate(node)) * share * weights[end]
            });
            meet(distance, closing);
        }
        least
    }

    /// The pair that is deepest in each other, for the state last looked at.
    pub fn deepest(&self, at: impl Fn(Node) -> Vec3) -> Option<Deepest> {
        let contact = self.contacts.iter().max_by(|a, b| a.depth.total_cmp(&b.depth))?;
        let pass = &self.passes[contact.pass];
        let own = &self.meshes[pass.of];
        let here = own.place(contact.vertex, |a| at((pass.of, a)));
        let there = here - contact.pair.normal * contact.pair.distance;
        let node = (pass.of, own.surface().vertices()[contact.vertex as usize].nodes()[0]);
        Some(Deepest { node, places: [here, there], depth: contact.depth })
    }

    /// Number of pairs of a vertex and a feature that touch, for the state last looked at.
    pub(crate) fn touched(&self) -> usize {
        self.contacts.len()
    }

    /// The body and the vertex of one of them, and its depth over D \[–\].
    pub(crate) fn vertex_of(&self, number: usize) -> (usize, u32, f64) {
        let contact = &self.contacts[number];
        (self.passes[contact.pass].of, contact.vertex, contact.depth)
    }

    /// Hands every vertex of a body that touches, by number and with the normal away from what it touches, to `visit`, some of them several times.
    pub fn each_touching(&self, body: usize, mut visit: impl FnMut(u32, &Vec3)) {
        for contact in self.contacts.iter().filter(|contact| self.passes[contact.pass].of == body) {
            visit(contact.vertex, &contact.pair.normal);
        }
    }

    /// Hands the size of the force of one of them on each of its nodes to `push` \[F\], negative where it takes away what counts twice.
    pub(crate) fn each_push(&self, number: usize, mut push: impl FnMut(Node, f64)) {
        let contact = &self.contacts[number];
        self.each_node(contact, |node, weight| push(node, -contact.slope * weight.abs()));
    }

    /// Whether it is that of one surface with itself.
    pub(crate) fn is_with_itself(&self) -> bool {
        self.near.is_some()
    }

    /// Whether a node may touch a face of the other surface, or of its own.
    pub(crate) fn may_touch(&self, (body, a): Node, face: &[u32; 3]) -> bool {
        let Some(near) = &self.near else { return true };
        let own = self.meshes[body].surface().number_of(a);
        own.is_some_and(|own| !near.any(own, face))
    }

    /// Greatest depth of edges that push, one less their distance over that from which they do \[–\].
    pub fn greatest_crossing(&self) -> f64 {
        let depth = |pushed: &Pushed| 1.0 - pushed.crossing.distance / pushed.within;
        self.pushed.iter().map(depth).fold(0.0, f64::max)
    }

    /// Places of a contact, those beyond their number that of the vertex.
    pub(super) fn places_of(&self, contact: &Contact, at: impl Fn(Node) -> Vec3) -> ([Vec3; 4], usize) {
        let pass = &self.passes[contact.pass];
        let (own, other) = (&self.meshes[pass.of], &self.meshes[pass.on]);
        let (corners, count) = corners_of(other, contact.feature);
        let mut places = [own.place(contact.vertex, |a| at((pass.of, a))); 4];
        for (place, &corner) in places[1..].iter_mut().zip(&corners[..count]) {
            *place = other.place(corner, |a| at((pass.on, a)));
        }
        (places, count + 1)
    }

    /// Hands two places of a contact, a node of each and the product of the shares that these have to `each`, for every two.
    pub(super) fn each_pair(&self, contact: &Contact, mut each: impl FnMut([usize; 2], Node, Node, f64)) {
        self.each_place(contact, |a, body, of_a, share_a| {
            self.each_place(contact, |b, other, of_b, share_b| {
                let share = share_a * share_b;
                for &node in of_a {
                    of_b.iter().for_each(|&to| each([a, b], (body, node), (other, to), share));
                }
            });
        });
    }

    /// Hands each corner of a face on which a pass acts, a node of it and the share that this has to `each`.
    pub(super) fn each_corner(&self, pass: u32, face: u32, mut each: impl FnMut(usize, Node, f64)) {
        let on = self.passes[pass as usize].on;
        for (corner, vertex) in self.meshes[on].faces()[face as usize].into_iter().enumerate() {
            let vertex = self.meshes[on].surface().vertices()[vertex as usize];
            vertex.nodes().iter().for_each(|&a| each(corner, (on, a), vertex.share()));
        }
    }

    /// Hands each place of a contact with its body, its nodes and the share that a node has in it to `each`.
    #[inline]
    pub(super) fn each_place(&self, contact: &Contact, mut each: impl FnMut(usize, usize, &[u32], f64)) {
        let pass = &self.passes[contact.pass];
        let (corners, count) = corners_of(&self.meshes[pass.on], contact.feature);
        let [of, on] = [pass.of, pass.on].map(|body| self.meshes[body].surface().vertices());
        let [a, b, c] = corners;
        let places = [(pass.of, of, contact.vertex), (pass.on, on, a), (pass.on, on, b), (pass.on, on, c)];
        for (place, &(body, vertices, vertex)) in places[..=count].iter().enumerate() {
            let vertex = &vertices[vertex as usize];
            each(place, body, vertex.nodes(), vertex.share());
        }
    }

    /// Hands each node of a contact with its weight in the distance to `each`.
    #[inline]
    fn each_node(&self, contact: &Contact, mut each: impl FnMut(Node, f64)) {
        self.each_place(contact, |place, body, nodes, share| {
            nodes.iter().for_each(|&a| each((body, a), contact.pair.weights[place] * share));
        });
    }

    /// Hands each node of two edges, its share in an end and the number of that to `each`.
    fn each_end(&self, pushed: &Pushed, mut each: impl FnMut(Node, f64, usize)) {
        let last = self.meshes.len() - 1;
        for (side, body) in [0, last].into_iter().enumerate() {
            for (i, end) in self.meshes[body].edges()[pushed.edges[side] as usize].into_iter().enumerate() {
                let vertex = self.meshes[body].surface().vertices()[end as usize];
                vertex.nodes().iter().for_each(|&a| each((body, a), vertex.share(), 2 * side + i));
            }
        }
    }
}
