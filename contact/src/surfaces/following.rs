//! Which parts are near: lists that last until something has moved by half of the skin.

use sph_core::Vec3;

use super::{Node, SurfaceContact};
use crate::list::Range;
use crate::mesh::Mesh;
use crate::patches::{Marks, Spread};

impl SurfaceContact {
    /// How many lists were made.
    pub fn lists(&self) -> u64 {
        self.lists
    }

    /// Where nodes were when the last list was made, body by body \[L\]; none before the first.
    pub fn listed(&self) -> &[Vec<Vec3>] {
        &self.listed
    }

    /// Hands every pair of nodes that may share a block of the tangent until the next list to `pair`.
    pub fn pattern(&self, mut pair: impl FnMut(Node, Node)) {
        let mut nodes = Vec::new();
        for pass in &self.passes {
            let (own, other) = (&self.meshes[pass.of], &self.meshes[pass.on]);
            for (vertex, face) in pass.list.pairs() {
                nodes.clear();
                nodes.extend(own.surface().vertices()[vertex as usize].nodes().iter().map(|&a| (pass.of, a)));
                for corner in other.faces()[face as usize] {
                    let of = other.surface().vertices()[corner as usize].nodes();
                    nodes.extend(of.iter().map(|&a| (pass.on, a)));
                }
                nodes.iter().for_each(|&a| nodes.iter().for_each(|&b| pair(a, b)));
            }
        }
    }

    /// How far nodes may still come nearer to each other before anything touches, or is near enough to be listed \[L\]; none where something may
    /// touch now.
    pub fn left_alone(&self) -> Option<f64> {
        let left = self.least_gap().min(self.touching.skin) - self.way;
        (left > 0.0).then_some(left)
    }

    /// Whether nothing is near enough to be listed.
    pub fn nothing_is_listed(&self) -> bool {
        self.passes.iter().all(|pass| pass.list.is_empty()) && self.crossings.is_empty()
    }

    /// Makes the lists that were made where nodes were, body by body as [`SurfaceContact::listed`] has them; false, and nothing changed,
    /// if these are nodes of other bodies.
    pub fn take_up(&mut self, listed: &[&[[f64; 3]]]) -> bool {
        let fits = |(mesh, listed): (&Mesh, &&[[f64; 3]])| mesh.nodes().count() == listed.len();
        if listed.len() != self.meshes.len() || !self.meshes.iter().zip(listed).all(fits) {
            return false;
        }
        let place = |(mesh, listed): (&Mesh, &&[[f64; 3]])| {
            let last = mesh.nodes().max().map_or(0, |a| a as usize + 1);
            let mut places = vec![Vec3::zeros(); last];
            mesh.nodes().zip(*listed).for_each(|(a, x)| places[a as usize] = Vec3::from(*x));
            places
        };
        let places: Vec<Vec<Vec3>> = self.meshes.iter().zip(listed).map(place).collect();
        self.list(|(body, a)| places[body][a as usize]);
        true
    }

    /// Makes new lists where something has moved by half of the skin since the last.
    pub(super) fn follow(&mut self, at: impl Fn(Node) -> Vec3) {
        self.way = if self.listed.is_empty() { f64::INFINITY } else { 2.0 * self.moved(&at) };
        if self.way > self.touching.skin {
            self.list(at);
        }
    }

    /// Least gap of all that is listed, as it was when it was \[L\]; infinite where nothing is.
    pub(super) fn least_gap(&self) -> f64 {
        self.passes.iter().map(|pass| pass.list.least_gap()).fold(self.crossings.least_gap(), f64::min)
    }

    /// Puts the vertices that lists name where nodes are now.
    pub(super) fn put_places(&mut self, at: impl Fn(Node) -> Vec3) {
        for (body, (involved, places)) in self.involved.iter().zip(&mut self.places).enumerate() {
            let vertices = self.meshes[body].surface().vertices();
            for &v in involved {
                places[v as usize] = vertices[v as usize].place(|a| at((body, a)));
            }
        }
    }

    /// Makes lists where nodes are now.
    pub fn list(&mut self, at: impl Fn(Node) -> Vec3) {
        self.list_near(at);
        let Self { meshes, passes, crossings, involved, .. } = self;
        let last = meshes.len() - 1;
        let mut named: Vec<Vec<bool>> =
            meshes.iter().map(|mesh| vec![false; mesh.surface().vertices().len()]).collect();
        for pass in passes.iter() {
            for (vertex, face) in pass.list.pairs() {
                named[pass.of][vertex as usize] = true;
                meshes[pass.on].faces()[face as usize]
                    .iter()
                    .for_each(|&v| named[pass.on][v as usize] = true);
            }
        }
        for (edge, partner) in crossings.pairs() {
            meshes[0].edges()[edge as usize].iter().for_each(|&v| named[0][v as usize] = true);
            meshes[last].edges()[partner as usize].iter().for_each(|&v| named[last][v as usize] = true);
        }
        involved.resize(meshes.len(), Vec::new());
        for (involved, named) in involved.iter_mut().zip(&named) {
            involved.clear();
            involved.extend((0..).zip(named).filter(|(_, named)| **named).map(|(v, _): (u32, _)| v));
        }
    }

    fn list_near(&mut self, at: impl Fn(Node) -> Vec3) {
        let Self { meshes, patches, touching, passes, near, crossings, listed, places, lists, way, .. } =
            self;
        (*way, *lists) = (0.0, *lists + 1);
        listed.resize(meshes.len(), Vec::new());
        places.resize(meshes.len(), Vec::new());
        for (body, mesh) in meshes.iter().enumerate() {
            let vertices = mesh.surface().vertices();
            places[body].clear();
            places[body].extend(vertices.iter().map(|vertex| vertex.place(|a| at((body, a)))));
            listed[body].clear();
            listed[body].extend(mesh.nodes().map(|a| at((body, a))));
        }
        let edges = touching.edges && !meshes.iter().any(Mesh::is_of_points);
        let range = Range { distance: touching.distance, skin: touching.skin };
        let spread = |body: usize| Spread::new(&meshes[body], &patches[body], &places[body]);
        let spreads: Vec<Spread<'_>> = (0..meshes.len()).map(spread).collect();
        crossings.clear();
        for pass in passes.iter_mut() {
            let (own, other) = (&spreads[pass.of], &spreads[pass.on]);
            let mut marks = Marks::new(near.as_ref(), other.places.len());
            pass.list.clear();
            own.each_near(other, range.distance + range.skin, |patch, near| {
                pass.list.add_faces((own, patch), (other, near), range, &mut marks);
                if edges && pass.of == 0 {
                    crossings.add_edges((own, patch), (other, near), range, &mut marks);
                }
            });
            pass.list.sort();
        }
        crossings.sort();
    }

    /// Greatest way of a node since the last list, the mean way taken out \[L\].
    fn moved(&self, at: impl Fn(Node) -> Vec3) -> f64 {
        let all = || {
            let bodies = self.meshes.iter().zip(&self.listed).enumerate();
            bodies.flat_map(|(body, (mesh, listed))| mesh.nodes().map(move |a| (body, a)).zip(listed))
        };
        let (mut sum, mut count) = (Vec3::zeros(), 0.0);
        for (node, from) in all() {
            sum += at(node) - from;
            count += 1.0;
        }
        let common = sum / f64::max(count, 1.0);
        let mut most: f64 = 0.0;
        for (node, from) in all() {
            let way = (at(node) - from - common).norm_squared();
            most = f64::max(most, way);
        }
        most.sqrt()
    }
}
