//! A surface that nodes carry along: its vertices go with the nodes beside them.
//!
//! A vertex at x before the node at x₀ has the weights of a force there (spread.rs), `wᵢ = φᵢ(x₀) + (x − x₀)·∇φᵢ(x₀)`: it goes with any uniform
//! motion of the nodes as a point of the body does, and forces on vertices come to nodes by the same weights, so that they do the work of the surface.

use std::collections::{BTreeMap, HashMap};

use super::ClosedSurface;
use super::spread::nets;
use crate::Vec3;
use crate::block::Block;
use crate::neighbours::CellList;
use crate::sampling::moving_least_squares::PointShape;

/// Most triangles into which a surface is divided.
const MOST_TRIANGLES: usize = 2_000_000;

/// Triangles whose vertices nodes carry.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Carried {
    /// Corners, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The triangle of the surface that each is a part of.
    pub part_of: Vec<u32>,
    /// Vertices at rest \[L\].
    pub vertices: Vec<Vec3>,
    /// First bearer of each vertex, and the end.
    starts: Vec<u32>,
    /// Nodes with their weights.
    bearers: Vec<(u32, f64)>,
}

impl ClosedSurface {
    /// The surface as the nodes of a block carry it, its triangles divided until no edge is longer than `longest` \[L\], both triangles at an edge alike, so
    /// that it stays closed.
    pub fn carried(&self, block: &Block, longest: f64) -> Carried {
        let (vertices, triangles, part_of) = self.divided(longest);
        let near = CellList::new(&block.positions, block.greatest_spacing());
        let nearest = |x: &Vec3| near.nearest_particle(x).unwrap_or_default();
        let nets = nets(&block.positions, block.greatest_spacing());
        let at = |node: u32| nets.iter().find_map(|net| net.at(&block.positions[node as usize]).ok());
        let mut shapes = BTreeMap::<u32, Option<PointShape>>::new();
        let (mut starts, mut bearers) = (vec![0], Vec::new());
        for x in &vertices {
            let node = nearest(x);
            match shapes.entry(node).or_insert_with(|| at(node)) {
                // One layer thick the body carries it as its node goes.
                None => bearers.push((node, 1.0)),
                Some(shape) => {
                    let before = x - block.positions[node as usize];
                    let all = shape.nodes.iter().zip(&shape.values).zip(&shape.gradients);
                    bearers.extend(
                        all.map(|((node, value), slope)| (*node, value + before.dot(&Vec3::from(*slope)))),
                    );
                }
            }
            starts.push(bearers.len() as u32);
        }
        Carried { triangles, part_of, vertices, starts, bearers }
    }

    /// Vertices, triangles, and the triangle that each is a part of.
    fn divided(&self, longest: f64) -> (Vec<Vec3>, Vec<[u32; 3]>, Vec<u32>) {
        let (mut vertices, mut triangles) = (self.vertices.clone(), self.triangles.clone());
        let mut part_of = Vec::from_iter(0..triangles.len() as u32);
        while triangles.len() < MOST_TRIANGLES {
            let mut middles: HashMap<(u32, u32), u32> = HashMap::new();
            for &[a, b, c] in &triangles {
                for (a, b) in [(a, b), (b, c), (c, a)] {
                    let ends = [a, b].map(|end| vertices[end as usize]);
                    if (ends[1] - ends[0]).norm() > longest {
                        middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                            vertices.push((ends[0] + ends[1]) * 0.5);
                            vertices.len() as u32 - 1
                        });
                    }
                }
            }
            if middles.is_empty() {
                break;
            }
            let middle = |a: u32, b: u32| middles.get(&(a.min(b), a.max(b))).copied();
            let (mut divided, mut parents) = (Vec::new(), Vec::new());
            for (corners, parent) in triangles.iter().zip(&part_of) {
                let before = divided.len();
                in_parts(*corners, &middle, &mut divided);
                parents.extend(std::iter::repeat_n(*parent, divided.len() - before));
            }
            (triangles, part_of) = (divided, parents);
        }
        (vertices, triangles, part_of)
    }
}

/// The parts of a triangle some of whose edges have a vertex in the middle.
fn in_parts([a, b, c]: [u32; 3], middle: &impl Fn(u32, u32) -> Option<u32>, out: &mut Vec<[u32; 3]>) {
    match [middle(a, b), middle(b, c), middle(c, a)] {
        [None, None, None] => out.push([a, b, c]),
        [Some(p), Some(q), Some(r)] => out.extend([[a, p, r], [p, b, q], [r, q, c], [p, q, r]]),
        [Some(p), Some(q), None] => out.extend([[p, b, q], [a, p, q], [a, q, c]]),
        [Some(p), None, None] => out.extend([[a, p, c], [p, b, c]]),
        // As one of these, from another corner.
        [None, _, _] => in_parts([b, c, a], middle, out),
        [Some(_), None, Some(_)] => in_parts([c, a, b], middle, out),
    }
}

impl Carried {
    /// Nodes that carry a vertex, with their weights.
    pub fn bearers(&self, vertex: usize) -> &[(u32, f64)] {
        &self.bearers[self.starts[vertex] as usize..self.starts[vertex + 1] as usize]
    }

    /// The triangles that `kept` says by their number, with their vertices.
    pub fn only(&self, kept: impl Fn(usize) -> bool) -> Self {
        let own: Vec<usize> = (0..self.triangles.len()).filter(|&number| kept(number)).collect();
        let mut used = vec![false; self.vertices.len()];
        own.iter().flat_map(|&k| self.triangles[k]).for_each(|vertex| used[vertex as usize] = true);
        let mut out = Self { starts: vec![0], ..Self::default() };
        let mut numbers = vec![0; used.len()];
        for vertex in (0..used.len()).filter(|&vertex| used[vertex]) {
            numbers[vertex] = out.vertices.len() as u32;
            out.vertices.push(self.vertices[vertex]);
            out.bearers.extend(self.bearers(vertex));
            out.starts.push(out.bearers.len() as u32);
        }
        out.triangles =
            own.iter().map(|&k| self.triangles[k].map(|vertex| numbers[vertex as usize])).collect();
        out.part_of = own.iter().map(|&k| self.part_of[k]).collect();
        out
    }

    /// Where nodes carry the vertices, from places of nodes \[L\].
    pub fn places(&self, node: impl Fn(u32) -> Vec3) -> Vec<Vec3> {
        let place = |vertex: usize| self.bearers(vertex).iter().map(|&(a, weight)| node(a) * weight).sum();
        (0..self.vertices.len()).map(place).collect()
    }
}
