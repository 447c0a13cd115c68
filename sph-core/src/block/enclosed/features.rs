//! Sharp edges and corners of a surface: nodes beside them go there, so that a face that is held has nodes all along its border.
//!
//! An edge of a flat side of the box round the body in which corners of the lattice lie is none: that may be a plane of symmetry, behind which the surface
//! goes on, and they stay in it.

use std::collections::{BTreeSet, HashMap};

use super::nearest::on_edge;
use super::{ClosedSurface, Laid};
use crate::Vec3;

/// Cosine of the angle between two normals from which an edge is sharp: 40 degrees, more than those of a circle in nine parts.
const SHARP: f64 = 0.766;
/// Distance within which a node goes to an edge, in spacings: of a right edge, whose cells are nodes from half full on, the mean of the nearest places of
/// both faces is no farther off, `½ √2 · √½`.
const BESIDE: f64 = 0.5;
/// The same of a corner, by the mean of three faces, `⅔ √3 · ∛½` and rounding.
const BESIDE_CORNER: f64 = 0.92;
/// Difference of distances that is rounding, in spacings.
const AS_NEAR: f64 = 1e-9;
/// Sharp edges that make a corner.
const CORNER: usize = 3;

/// Sharp edges by their ends, the lower first, and corners.
pub(super) struct Features {
    edges: BTreeSet<(u32, u32)>,
    corners: BTreeSet<u32>,
}

impl Features {
    pub fn new(surface: &ClosedSurface, laid: &Laid, spacing: f64) -> Self {
        let normals = surface.normals();
        let mut seen: HashMap<(u32, u32), usize> = HashMap::new();
        let mut edges = BTreeSet::new();
        let in_lattice = [0, 1, 2, 3, 4, 5].map(|side| laid.in_lattice(side, spacing));
        let flat = |triangle: usize| (0..6).any(|side| in_lattice[side] && laid.flat[side][triangle]);
        for (number, &[a, b, c]) in surface.triangles.iter().enumerate() {
            for (a, b) in [(a, b), (b, c), (c, a)] {
                let edge = (a.min(b), a.max(b));
                if let Some(other) = seen.insert(edge, number) {
                    let sharp = normals[number].dot(&normals[other]) < SHARP;
                    if sharp && !flat(number) && !flat(other) {
                        edges.insert(edge);
                    }
                }
            }
        }
        let mut meet: HashMap<u32, usize> = HashMap::new();
        edges.iter().for_each(|&(a, b)| [a, b].iter().for_each(|end| *meet.entry(*end).or_default() += 1));
        let corners = meet.into_iter().filter(|own| own.1 >= CORNER).map(|own| own.0).collect();
        Self { edges, corners }
    }

    /// Where a node at x goes, and whether that is a corner: to the nearest corner of these triangles, else to the nearest edge; none where there is none
    /// beside it, or two as near.
    pub fn beside(
        &self,
        surface: &ClosedSurface,
        (x, spacing): (&Vec3, f64),
        triangles: &BTreeSet<u32>,
    ) -> Option<(Vec3, bool)> {
        if self.edges.is_empty() {
            return None;
        }
        let at = |vertex: u32| surface.vertices[vertex as usize];
        let of = || triangles.iter().map(|&triangle| surface.triangles[triangle as usize]);
        let corners = of().flatten().filter(|corner| self.corners.contains(corner)).map(at);
        if let Some(corner) = nearest(x, BESIDE_CORNER, spacing, corners) {
            return Some((corner, true));
        }
        let edges = of().flat_map(|[a, b, c]| [(a, b), (b, c), (c, a)]);
        let sharp = edges.filter(|&(a, b)| self.edges.contains(&(a.min(b), a.max(b))));
        let place =
            nearest(x, BESIDE, spacing, sharp.map(|(a, b)| on_edge(x, [at(a.min(b)), at(a.max(b))])))?;
        Some((place, false))
    }
}

/// The nearest of places within so many spacings of x; none where two are as near.
fn nearest(x: &Vec3, beside: f64, spacing: f64, places: impl Iterator<Item = Vec3>) -> Option<Vec3> {
    let mut all: Vec<(f64, Vec3)> = places.map(|place| ((place - x).norm(), place)).collect();
    all.retain(|own| own.0 <= beside * spacing);
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (least, place) = *all.first()?;
    let slack = AS_NEAR * spacing;
    let alone = all.iter().all(|own| own.0 > least + slack || (own.1 - place).norm() <= slack);
    alone.then_some(place)
}
