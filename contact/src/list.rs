//! What may touch while nothing has moved far: faces near each vertex, edges near each edge, with their gaps.

use crate::edges::{Line, of_edges};
use crate::nearest::{of_segments, on_triangle};
use crate::patches::{Marks, Span, Spread};

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

/// How far apart parts count as touching \[L\], and how much farther they are listed \[L\].
#[derive(Clone, Copy)]
pub(crate) struct Range {
    pub distance: f64,
    pub skin: f64,
}

impl List {
    /// Lists the faces near the vertices that belong to a patch, among those of some patches of another surface, but those of marked vertices.
    pub fn add_faces(
        &mut self,
        (own, patch): (&Spread<'_>, u32),
        (other, near): (&Spread<'_>, &[u32]),
        range: Range,
        marks: &mut Marks<'_>,
    ) {
        let reach = range.distance + range.skin;
        for &vertex in own.patches.vertices(patch) {
            let point = own.places[vertex as usize];
            let here = Span::about([point]);
            marks.put(&[vertex]);
            for &near in near.iter().filter(|near| here.is_near(other.span(**near), reach * reach)) {
                for face in other.patches.faces(near) {
                    let corners = &other.mesh.faces()[face as usize];
                    if marks.any(corners) {
                        continue;
                    }
                    let corners = corners.map(|corner| other.places[corner as usize]);
                    if !here.is_near(&Span::about(corners), reach * reach) {
                        continue;
                    }
                    let (_, square) = on_triangle(&point, corners);
                    if square < reach * reach {
                        self.add(face, square.sqrt() - range.distance);
                    }
                }
            }
            self.close(vertex);
        }
    }

    /// The same of the edges near those of a patch, from the distances of edges on; of one surface with itself those of higher numbers alone.
    pub fn add_edges(
        &mut self,
        (own, patch): (&Spread<'_>, u32),
        (other, near): (&Spread<'_>, &[u32]),
        range: Range,
        marks: &mut Marks<'_>,
    ) {
        let itself = std::ptr::eq(own.mesh, other.mesh);
        let ends = |of: &Spread<'_>, ends: [u32; 2]| ends.map(|end| of.places[end as usize]);
        let mut found: Vec<(u32, f64)> = Vec::new();
        for &edge in own.patches.edges(patch) {
            let numbers = own.mesh.edges()[edge as usize];
            let [a, b] = ends(own, numbers);
            let (here, line) = (Span::about([a, b]), Line::through([a, b]));
            marks.put(&numbers);
            found.clear();
            let rim = own.mesh.is_rim(edge as usize);
            let most = of_edges(range.distance, rim) + range.skin;
            for &near in near.iter().filter(|near| here.is_near(other.span(**near), most * most)) {
                for &partner in other.patches.edges(near).iter().filter(|partner| !itself || **partner > edge)
                {
                    let numbers = other.mesh.edges()[partner as usize];
                    let distance = of_edges(range.distance, rim && other.mesh.is_rim(partner as usize));
                    let (reach, [c, d]) = (distance + range.skin, ends(other, numbers));
                    if marks.any(&numbers)
                        || !here.is_near(&Span::about([c, d]), reach * reach)
                        || !line.is_near([c, d], reach)
                    {
                        continue;
                    }
                    let (_, square) = of_segments([a, b], [c, d]);
                    if square < reach * reach {
                        found.push((partner, square.sqrt() - distance));
                    }
                }
            }
            found.sort_unstable_by_key(|(partner, _)| *partner);
            found.iter().for_each(|&(partner, gap)| self.add(partner, gap));
            self.close(edge);
        }
    }

    /// Puts parts in the order of their numbers when all are listed.
    pub fn sort(&mut self) {
        self.entries.sort_unstable_by_key(|entry| entry.part);
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

    /// Empties it.
    pub fn clear(&mut self) {
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
