//! Which parts of a surface may touch a tool: a part is looked at again when what moved since may have closed the gap that it had.

use sph_core::Vec3;

use crate::surface::{Surface, Vertex};
use crate::tool::ToolShape;

/// Vertices of a part.
const PART: usize = 64;
/// Room over half of the thickness up to which a part counts as near, whatever rounding of distances says.
const NEAR: f64 = 1e-6;

/// The gaps that parts of a surface had from a tool, and how far both have moved since.
///
/// It changes no force: a part is passed over as long as a bound of the motion says that none of it touches.
#[derive(Clone, Debug, PartialEq)]
pub struct Watch {
    parts: Vec<Part>,
    /// How far surface and tool have moved towards each other at most \[L\].
    way: f64,
    /// The least way at which a part is due.
    soonest: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Part {
    /// Greatest half thickness of its vertices \[L\].
    half: f64,
    /// The way at which it may touch.
    due: f64,
}

impl Watch {
    /// The watch of a surface, of which nothing is known.
    pub fn new(surface: &Surface) -> Self {
        let part = |vertices: &[Vertex]| Part {
            half: vertices.iter().fold(0.0, |half, vertex| vertex.half.max(half)),
            due: 0.0,
        };
        Self { parts: parts(surface).map(part).collect(), way: 0.0, soonest: 0.0 }
    }

    /// Forgets all gaps: every part is due.
    pub fn forget(&mut self) {
        self.parts.iter_mut().for_each(|part| part.due = 0.0);
        (self.way, self.soonest) = (0.0, 0.0);
    }

    /// Counts a motion of every vertex against the tool by this much at most \[L\].
    pub fn count(&mut self, motion: f64) {
        self.way += motion;
    }

    /// Bytes that it holds.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.parts[..])
    }

    /// Calls `visit` for every vertex of the parts that are near, with its number, in their order.
    pub(crate) fn each_near(
        &mut self,
        (tool, surface): (&ToolShape, &Surface),
        moved: &Vec3,
        at: impl Fn(u32) -> Vec3,
        mut visit: impl FnMut(u32, &Vertex),
    ) {
        if self.way < self.soonest {
            return;
        }
        self.soonest = f64::INFINITY;
        let mut first = 0;
        for (part, vertices) in self.parts.iter_mut().zip(parts(surface)) {
            if self.way >= part.due {
                let least = match vertices {
                    [first, ..] if first.nodes().len() == 1 => {
                        tool.least_distance(vertices.iter().map(|vertex| at(vertex.corners()[0])), moved)
                    }
                    _ => tool.least_distance(vertices.iter().map(|vertex| middle(vertex, &at)), moved),
                };
                let room = least - (1.0 + NEAR) * part.half;
                part.due = self.way + room.max(0.0);
                if room <= 0.0 {
                    (first..).zip(vertices).for_each(|(number, vertex)| visit(number, vertex));
                }
            }
            self.soonest = self.soonest.min(part.due);
            first += vertices.len() as u32;
        }
    }
}

/// The vertices of a surface part by part, each of particles alone or of middles alone.
fn parts(surface: &Surface) -> impl Iterator<Item = &[Vertex]> {
    surface.kinds().into_iter().flat_map(|kind| kind.chunks(PART))
}

/// Where the middle of four particles is, but for rounding.
#[inline(always)]
fn middle(vertex: &Vertex, at: impl Fn(u32) -> Vec3) -> Vec3 {
    let [a, b, c, d] = vertex.corners();
    ((at(a) + at(b)) + (at(c) + at(d))) * 0.25
}

#[cfg(test)]
mod tests {
    use sph_core::Cell;

    use super::*;

    /// A strip of two hundred cells over a plane: what is passed over, and that nothing is passed over that touches.
    #[test]
    fn far_parts_are_passed_over_until_motion_may_have_brought_them() {
        let cells: Vec<Cell> =
            (0..200).map(|c| Cell { corners: [2 * c, 2 * c + 2, 2 * c + 3, 2 * c + 1], count: 4 }).collect();
        let at = |a: u32| Vec3::new(f64::from(a / 2), f64::from(a % 2), 0.01 * f64::from(a / 2));
        let rest: Vec<Vec3> = (0..402).map(at).collect();
        let plane = ToolShape::Plane { point: Vec3::zeros(), normal: Vec3::z() };
        let surface = Surface::new(&cells, &rest, |_| 0.005);
        let mut watch = Watch::new(&surface);
        let seen = |watch: &mut Watch, down: f64| {
            let mut count = 0;
            watch.each_near(
                (&plane, &surface),
                &Vec3::zeros(),
                |a| at(a) - Vec3::z() * down,
                |_, _| count += 1,
            );
            count
        };
        // The first part of particles and the first of middles, of which each has some at the plane.
        assert_eq!(seen(&mut watch, 0.0), 128);
        let far = |watch: &Watch| watch.parts.iter().filter(|part| part.due > watch.way).count();
        let parts = watch.parts.len();
        assert_eq!(far(&watch), parts - 2);
        watch.count(0.5);
        let plain = seen(&mut Watch::new(&surface), 0.5);
        assert_eq!(seen(&mut watch, 0.5), plain);
        assert!(plain > 128);
        watch.forget();
        assert_eq!((far(&watch), seen(&mut watch, 0.5)), (0, plain));
    }
}
