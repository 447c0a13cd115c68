//! What may touch while nothing has moved far: faces near each vertex, edges near each edge, with their gaps.

use sph_core::{CellList, Vec3};

use crate::mesh::Mesh;
use crate::nearest::{of_segments, on_triangle};

/// Partners of some parts of a surface, the parts in the order of their numbers, the partners of each too.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct List {
    entries: Vec<Entry>,
    partners: Vec<u32>,
    /// Gap of each partner when it was listed \[L\].
    gaps: Vec<f64>,
    /// Least of all gaps, where anything is listed \[L\].
    least: f64,
}

/// A part with partners near.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    part: u32,
    /// Its partners.
    first: u32,
    end: u32,
    /// Least of their gaps \[L\].
    gap: f64,
}

/// Which parts may touch at all, how far apart they count as touching \[L\], and how much farther they are listed \[L\].
pub(crate) struct Range<A, D> {
    pub allowed: A,
    pub distance: D,
    pub skin: f64,
}

impl List {
    /// Lists the faces of a mesh near points, both where they are now.
    pub fn faces<A: Fn(u32, &[u32; 3]) -> bool>(
        &mut self,
        points: &[Vec3],
        mesh: &Mesh,
        places: &[Vec3],
        range: &Range<A, f64>,
    ) {
        self.clear();
        let corners = |face: &[u32; 3]| face.map(|corner| places[corner as usize]);
        let faces = mesh.faces();
        let middles: Vec<Vec3> = faces.iter().map(|face| corners(face).iter().sum::<Vec3>() / 3.0).collect();
        let size = |(face, middle): (&[u32; 3], &Vec3)| {
            corners(face).iter().fold(0.0_f64, |most, corner| most.max((corner - middle).norm_squared()))
        };
        let largest = faces.iter().zip(&middles).map(size).fold(0.0, f64::max).sqrt();
        let reach = range.distance + range.skin;
        let boxes = CellList::new(&middles, reach + largest);
        let mut near = Vec::new();
        for (v, point) in points.iter().enumerate() {
            boxes.within(point, reach + largest, &mut near);
            for &face in &near {
                let own = &faces[face as usize];
                if !(range.allowed)(v as u32, own) {
                    continue;
                }
                let (_, square) = on_triangle(point, corners(own));
                if square < reach * reach {
                    self.add(face, square.sqrt() - range.distance);
                }
            }
            self.close(v as u32);
        }
    }

    /// Lists the edges of a mesh near those of another, or of the same where only higher numbers are partners.
    pub fn edges<A: Fn(usize, usize) -> bool, D: Fn(usize, usize) -> f64>(
        &mut self,
        [one, other]: [(&Mesh, &[Vec3]); 2],
        itself: bool,
        farthest: f64,
        range: &Range<A, D>,
    ) {
        self.clear();
        let ends = |(mesh, places): (&Mesh, &[Vec3]), edge: usize| -> [Vec3; 2] {
            mesh.edges()[edge].map(|end| places[end as usize])
        };
        let longest = |of: (&Mesh, &[Vec3])| {
            let all = (0..of.0.edges().len()).map(|edge| {
                let [a, b] = ends(of, edge);
                (b - a).norm_squared()
            });
            all.fold(0.0, f64::max).sqrt()
        };
        let middle = |of: (&Mesh, &[Vec3]), edge: usize| {
            let [a, b] = ends(of, edge);
            (a + b) * 0.5
        };
        let reach = farthest + range.skin + 0.5 * (longest(one) + longest(other));
        let middles: Vec<Vec3> = (0..other.0.edges().len()).map(|edge| middle(other, edge)).collect();
        let boxes = CellList::new(&middles, reach);
        let mut near = Vec::new();
        for edge in 0..one.0.edges().len() {
            let own = ends(one, edge);
            boxes.within(&middle(one, edge), reach, &mut near);
            for &partner in near.iter().filter(|partner| !itself || **partner as usize > edge) {
                let against = partner as usize;
                if !(range.allowed)(edge, against) {
                    continue;
                }
                let distance = (range.distance)(edge, against);
                let (_, square) = of_segments(own, ends(other, against));
                if square < (distance + range.skin) * (distance + range.skin) {
                    self.add(partner, square.sqrt() - distance);
                }
            }
            self.close(edge as u32);
        }
    }

    /// Parts with the partners that may touch them after each of both has moved by half of a way \[L\].
    pub fn after(&self, way: f64) -> impl Iterator<Item = (u32, impl Iterator<Item = u32>)> {
        self.entries.iter().filter(move |entry| entry.gap <= way).map(move |entry| {
            let own = entry.first as usize..entry.end as usize;
            let partners = self.partners[own.clone()].iter().zip(&self.gaps[own]);
            (entry.part, partners.filter(move |(_, gap)| **gap <= way).map(|(partner, _)| *partner))
        })
    }

    /// Whether nothing is near.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Least gap of all \[L\]; infinite where nothing is near.
    pub fn least_gap(&self) -> f64 {
        if self.is_empty() { f64::INFINITY } else { self.least }
    }

    /// Every part with each of its partners.
    pub fn pairs(&self) -> impl Iterator<Item = (u32, u32)> {
        self.after(f64::INFINITY).flat_map(|(part, partners)| partners.map(move |partner| (part, partner)))
    }

    /// Bytes that it holds.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.entries[..]) + size_of_val(&self.partners[..]) + size_of_val(&self.gaps[..])
    }

    fn clear(&mut self) {
        self.entries.clear();
        self.partners.clear();
        self.gaps.clear();
        self.least = f64::INFINITY;
    }

    fn add(&mut self, partner: u32, gap: f64) {
        self.partners.push(partner);
        self.gaps.push(gap);
    }

    /// Ends the partners of a part, if it has any.
    fn close(&mut self, part: u32) {
        let (first, end) = (self.entries.last().map_or(0, |entry| entry.end), self.partners.len() as u32);
        if end > first {
            let gap = self.gaps[first as usize..].iter().copied().fold(f64::INFINITY, f64::min);
            self.entries.push(Entry { part, first, end, gap });
            self.least = self.least.min(gap);
        }
    }
}
