//! How far nodes may go at once, so that no part leaps through another.

use sph_core::Vec3;

use super::{Node, SurfaceContact, pair_of};
use crate::euler::Feature;
use crate::list::{List, Range};
use crate::mesh::Mesh;
use crate::nearest::{Part, on_triangle};
use crate::patches::{Marks, Spread};

/// Part of their distance by which a vertex and a face may come nearer to each other at once.
const OF_DISTANCE: f64 = 0.8;
/// How far is looked at most, over the skin.
const FARTHEST: f64 = 8.0;

impl SurfaceContact {
    /// The share of a way from one place of every node to another, one at most, after which no vertex has come through a face.
    ///
    /// A pair at a distance d may come nearer by .8 d: by the ways along its normal, and what turning may add, their square over the skin or D. Nodes
    /// whose ways are many skins are held to as far as is looked.
    pub fn reach(&self, at: impl Fn(Node) -> Vec3, to: impl Fn(Node) -> Vec3) -> f64 {
        let place = |body: usize, of: &dyn Fn(Node) -> Vec3| -> Vec<Vec3> {
            let vertices = self.meshes[body].surface().vertices();
            vertices.iter().map(|vertex| vertex.place(|a| of((body, a)))).collect()
        };
        let bodies = || 0..self.meshes.len();
        let here: Vec<Vec<Vec3>> = bodies().map(|body| place(body, &at)).collect();
        let there = bodies().map(|body| place(body, &to));
        let ways: Vec<Vec<Vec3>> = there
            .zip(&here)
            .map(|(there, here)| there.iter().zip(here).map(|(b, a)| b - a).collect())
            .collect();
        let count = ways.iter().map(Vec::len).sum::<usize>().max(1);
        let common = ways.iter().flatten().sum::<Vec3>() / count as f64;
        let greatest = ways.iter().flatten().fold(0.0_f64, |most, way| most.max((way - common).norm()));
        if greatest == 0.0 {
            return 1.0;
        }
        let (distance, skin) = (self.touching.distance, self.touching.skin);
        let looked = (2.0 * greatest).min(FARTHEST * skin);
        let mut share = (OF_DISTANCE * (distance + looked) / (2.0 * greatest)).min(1.0);
        let mut list = List::default();
        for pass in &self.passes {
            let mesh = &self.meshes[pass.on];
            let places = &here[pass.on];
            let spread = |body: usize| Spread::new(&self.meshes[body], &self.patches[body], &here[body]);
            let (own, other) = (spread(pass.of), spread(pass.on));
            let mut marks = Marks::new(self.near.as_ref(), places.len());
            list.clear();
            own.each_near(&other, distance + looked, |patch, near| {
                let range = Range { distance, skin: looked };
                list.add_faces((&own, patch), (&other, near), range, &mut marks);
            });
            list.sort();
            for (vertex, face) in list.pairs() {
                let point = here[pass.of][vertex as usize];
                let pair = nearest(mesh, face, point, places);
                let (mut along, mut square) = (0.0_f64, 0.0_f64);
                for corner in mesh.faces()[face as usize] {
                    let way = ways[pass.of][vertex as usize] - ways[pass.on][corner as usize];
                    along = along.max(-pair.normal.dot(&way));
                    square = square.max(way.norm_squared());
                }
                let (turned, most) = (square / skin.max(distance), OF_DISTANCE * pair.distance);
                // The least s with s·along + s²·turned = most.
                if along + turned > most {
                    share = share.min(2.0 * most / (along + (along * along + 4.0 * turned * most).sqrt()));
                }
            }
        }
        share
    }
}

/// A point and the place of a face nearest to it.
pub(super) fn nearest(mesh: &Mesh, face: u32, point: Vec3, places: &[Vec3]) -> crate::Pair {
    let at = |corner: u32| places[corner as usize];
    let corners = mesh.faces()[face as usize];
    let feature = match on_triangle(&point, corners.map(at)).0 {
        Part::Inside => Feature::Face(face),
        Part::Side(i) => Feature::Edge(mesh.sides()[face as usize][i]),
        Part::Corner(i) => Feature::Vertex(corners[i]),
    };
    pair_of(mesh, feature, point, at)
}
