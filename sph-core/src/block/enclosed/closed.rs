//! Closed surfaces of triangles, and what keeps one from being closed.

use std::collections::HashMap;
use std::f64::consts::PI;

use libm::atan2;

use super::crossing::crossing;
use crate::Vec3;

/// Pairs of places and triangles that are looked at, at most.
const LOOKS: usize = 10_000_000;
/// How deep a place lies under its triangle, over the size of that.
const DEPTH: f64 = 1e-6;

/// Why a surface encloses no body, or no node fits into it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SurfaceFault {
    /// An edge of one triangle.
    #[error(
        "the surface is open at the edge from {} to {}; close it: a body is what a closed surface encloses",
        at(from),
        at(to)
    )]
    Open {
        /// One end \[L\].
        from: Vec3,
        /// The other \[L\].
        to: Vec3,
    },
    /// An edge that triangles share otherwise than two and two.
    #[error(
        "more than two triangles meet at the edge from {} to {}, or they look to different sides; leave out what lies inside, or give each body a \
         surface of its own",
        at(from),
        at(to)
    )]
    Shared {
        /// One end \[L\].
        from: Vec3,
        /// The other \[L\].
        to: Vec3,
    },
    /// A piece that looks inwards where no other one is round it.
    #[error(
        "the piece of the surface at {} looks inwards, and lies in no other one; turn its triangles round, all of them with flip = true",
        at(place)
    )]
    InsideOut {
        /// A vertex of it \[L\].
        place: Vec3,
    },
    /// A piece that looks outwards within another one.
    #[error(
        "the piece of the surface at {} looks outwards, and lies in another one; turn its triangles round for a cavity, or leave it out",
        at(place)
    )]
    Within {
        /// A vertex of it \[L\].
        place: Vec3,
    },
    /// Triangles that pass through each other.
    #[error("the surface passes through itself at {}; unite its parts before it is written", at(place))]
    Crossing {
        /// A place of it \[L\].
        place: Vec3,
    },
    /// What lies inside twice, or less than not at all.
    #[error(
        "the surface encloses what lies at {} more than once; unite its parts before it is written",
        at(place)
    )]
    Overlap {
        /// The place \[L\].
        place: Vec3,
    },
    /// Less than half of each cell inside, and no node near.
    #[error("the body is thinner than half a spacing at {}; use a narrower spacing", at(place))]
    Thin {
        /// The place \[L\].
        place: Vec3,
    },
    /// No number of cells that can be cut.
    #[error("{cells:.3e} cells in the box round the surface, at most 1e7 are allowed; use a wider spacing")]
    Cells {
        /// How many.
        cells: f64,
    },
}

/// A place as text, to six digits.
fn at(x: &Vec3) -> String {
    let six = |x: f64| format!("{x:.5e}").parse().unwrap_or(x);
    format!("[{}, {}, {}]", six(x.x), six(x.y), six(x.z))
}

/// A closed surface of triangles that looks outwards, of one piece or several; pieces in others are cavities.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedSurface {
    pub(super) vertices: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl ClosedSurface {
    /// A surface of triangles counter-clockwise seen from outside.
    ///
    /// # Errors
    /// [`SurfaceFault`] for one that is open, turned inside out in whole or in part, or passes through itself.
    pub fn new(vertices: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self, SurfaceFault> {
        let surface = Self { vertices, triangles };
        surface.check_edges()?;
        let [low, high] = surface.corners();
        let triangles = surface.triangles.iter().map(|corners| surface.places(corners));
        if let Some(place) = crossing(triangles, high - low) {
            return Err(SurfaceFault::Crossing { place });
        }
        surface.check_pieces()?;
        Ok(surface)
    }

    /// Corners of its triangles.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Volume that it encloses \[L³\], and its centroid \[L\].
    pub fn volume(&self) -> (f64, Vec3) {
        // From a vertex: little is lost far from zero.
        let origin = self.vertices.first().copied().unwrap_or_default();
        let (mut volume, mut moment) = (0.0, Vec3::zeros());
        for corners in &self.triangles {
            let [a, b, c] = self.places(corners).map(|x| x - origin);
            let part = a.dot(&b.cross(&c)) / 6.0;
            volume += part;
            moment += (a + b + c) * (part / 4.0);
        }
        (volume, origin + moment / volume)
    }

    /// Normal times area of a triangle \[L²\].
    pub(super) fn area(&self, corners: &[u32; 3]) -> Vec3 {
        let [a, b, c] = self.places(corners);
        (b - a).cross(&(c - a)) * 0.5
    }

    pub(super) fn places(&self, corners: &[u32; 3]) -> [Vec3; 3] {
        corners.map(|corner| self.vertices[corner as usize])
    }

    /// Least and greatest coordinates.
    pub(super) fn corners(&self) -> [Vec3; 2] {
        let used = || self.triangles.iter().flatten().map(|&corner| self.vertices[corner as usize]);
        let low = used().reduce(|a, b| a.inf(&b)).unwrap_or_default();
        let high = used().reduce(|a, b| a.sup(&b)).unwrap_or_default();
        [low, high]
    }

    /// Each edge is run through once in either direction.
    fn check_edges(&self) -> Result<(), SurfaceFault> {
        let mut runs: HashMap<(u32, u32), [u32; 2]> = HashMap::new();
        let edges = |[a, b, c]: [u32; 3]| [(a, b), (b, c), (c, a)];
        for (a, b) in self.triangles.iter().copied().flat_map(edges) {
            runs.entry((a.min(b), a.max(b))).or_default()[usize::from(a > b)] += 1;
        }
        for (a, b) in self.triangles.iter().copied().flat_map(edges) {
            let [from, to] = [a, b].map(|end| self.vertices[end as usize]);
            match runs.get(&(a.min(b), a.max(b))) {
                Some([1, 1]) => {}
                Some([1, 0] | [0, 1]) => return Err(SurfaceFault::Open { from, to }),
                _ => return Err(SurfaceFault::Shared { from, to }),
            }
        }
        Ok(())
    }

    /// Every piece looks away from what it encloses, and a cavity into itself.
    fn check_pieces(&self) -> Result<(), SurfaceFault> {
        let pieces = self.pieces();
        for piece in &pieces {
            let others: Vec<u32> =
                pieces.iter().filter(|other| !std::ptr::eq(*other, piece)).flatten().copied().collect();
            let volume: f64 = piece.iter().map(|&number| self.cone(number)).sum();
            // One place tells, but where pieces lie in each other with sides in one plane, which do not cross.
            let every = (piece.len() * others.len()).div_ceil(LOOKS).max(1);
            for &triangle in piece.iter().step_by(every) {
                let Some(below) = self.below(triangle) else { continue };
                let sum: f64 = others.iter().map(|&number| self.angle(number, &below)).sum();
                let place = self.places(&self.triangles[triangle as usize])[0];
                match (volume > 0.0, (sum / (4.0 * PI)).round() as i64) {
                    (true, 0) | (false, 1) => {}
                    (true, _) => return Err(SurfaceFault::Within { place }),
                    (false, _) => return Err(SurfaceFault::InsideOut { place }),
                }
            }
        }
        Ok(())
    }

    /// A place under the middle of a triangle, on the side of the body: off all triangles of others that touch it.
    fn below(&self, triangle: u32) -> Option<Vec3> {
        let corners = &self.triangles[triangle as usize];
        let (area, [a, b, c]) = (self.area(corners), self.places(corners));
        let size = area.norm();
        (size > 0.0).then(|| (a + b + c) / 3.0 - area * (DEPTH / size.sqrt()))
    }

    /// Triangles of each connected piece.
    fn pieces(&self) -> Vec<Vec<u32>> {
        let mut parent: Vec<u32> = (0..self.vertices.len() as u32).collect();
        fn root(parent: &mut [u32], mut a: u32) -> u32 {
            while parent[a as usize] != a {
                parent[a as usize] = parent[parent[a as usize] as usize];
                a = parent[a as usize];
            }
            a
        }
        for &[a, b, c] in &self.triangles {
            let a = root(&mut parent, a);
            for other in [b, c] {
                let other = root(&mut parent, other);
                parent[other as usize] = a;
            }
        }
        let mut numbers = HashMap::new();
        let mut pieces: Vec<Vec<u32>> = Vec::new();
        for (number, corners) in (0..).zip(&self.triangles) {
            let root = root(&mut parent, corners[0]);
            let piece = *numbers.entry(root).or_insert_with(|| {
                pieces.push(Vec::new());
                pieces.len() - 1
            });
            pieces[piece].push(number);
        }
        pieces
    }

    /// Volume of the cone from a vertex of the surface to a triangle \[L³\].
    fn cone(&self, triangle: u32) -> f64 {
        let origin = self.vertices[0];
        let [a, b, c] = self.places(&self.triangles[triangle as usize]).map(|x| x - origin);
        a.dot(&b.cross(&c)) / 6.0
    }

    /// Solid angle under which a triangle is seen from a place \[vanoosterom1983\].
    fn angle(&self, triangle: u32, from: &Vec3) -> f64 {
        let [a, b, c] = self.places(&self.triangles[triangle as usize]).map(|x| x - from);
        let [p, q, r] = [a, b, c].map(|x| x.norm());
        let below = p * q * r + a.dot(&b) * r + b.dot(&c) * p + c.dot(&a) * q;
        2.0 * atan2(a.dot(&b.cross(&c)), below)
    }
}
