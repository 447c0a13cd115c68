//! Tools from a scene, and as they are drawn: surfaces of cells that go with them, planes and cylinders as long as the body needs them.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::io;

use contact::{Pose, ToolShape};
use mesh_io::{At, Connectivity, FieldWriter, Kind, Values, rows};
use sph_core::{Frame, Vec3};

use crate::scene::ToolScene;
use crate::scene::units::{Quantity, Units};

/// Cells round a round tool, and along the side of a plane.
const ROUND: usize = 48;
/// Cells along half of a meridian of a ball.
const MERIDIAN: usize = 12;
/// How long planes and cylinders are over the body along them.
const BEYOND: f64 = 1.3;
/// How long they are at least, over the diagonal of the body.
const LEAST: f64 = 0.25;
/// Cells along a side of a plane and along a cylinder.
const ALONG: usize = 16;

/// Places of the tools at level zero, and cells of three or four of them.
#[derive(Default)]
struct Drawn {
    places: Vec<Vec3>,
    cells: Vec<(Kind, [u32; 8])>,
    /// Number of the tool, by place.
    tools: Vec<usize>,
}

/// The shape of a tool, places and directions being turned.
pub(super) fn shape(tool: &ToolScene, turned: impl Fn([f64; 3]) -> Vec3) -> Option<ToolShape> {
    let ToolScene { plane, sphere, cylinder, capsule, block, .. } = tool;
    let plane =
        plane.map(|plane| ToolShape::Plane { point: turned(plane.point), normal: turned(plane.normal) });
    let sphere =
        sphere.map(|sphere| ToolShape::Sphere { centre: turned(sphere.centre), radius: sphere.radius.get() });
    let cylinder = cylinder.map(|drum| ToolShape::Cylinder {
        point: turned(drum.point),
        axis: turned(drum.axis),
        radius: drum.radius.get(),
    });
    let capsule = capsule
        .map(|capsule| ToolShape::Capsule { ends: capsule.ends.map(&turned), radius: capsule.radius.get() });
    let block = block.map(|block| ToolShape::Block { min: block.min.into(), max: block.max.into() });
    plane.or(sphere).or(cylinder).or(capsule).or(block)
}

/// A checked tool with its face moved inward by a depth \[L\]; none of a round one whose radius is no greater.
pub(super) fn inset(tool: ToolShape, depth: f64) -> Option<ToolShape> {
    let less = |radius: f64| Some(radius - depth).filter(|left| *left > 0.0);
    Some(match tool {
        ToolShape::Plane { point, normal } => ToolShape::Plane { point: point - normal * depth, normal },
        ToolShape::Sphere { centre, radius } => ToolShape::Sphere { centre, radius: less(radius)? },
        ToolShape::Cylinder { point, axis, radius } => {
            ToolShape::Cylinder { point, axis, radius: less(radius)? }
        }
        ToolShape::Capsule { ends, radius } => ToolShape::Capsule { ends, radius: less(radius)? },
        // Its edges become round by the depth.
        ToolShape::Block { min, max } => {
            let (min, max) = (min.add_scalar(depth), max.add_scalar(-depth));
            Some(ToolShape::Block { min, max }).filter(|_| (0..3).all(|k| max[k] > min[k]))?
        }
    })
}

/// Writes the tools of a body of these places at rest \[L\], with how far they had moved and turned when its forces were last evaluated.
pub(super) fn write(
    tools: &[(ToolShape, Pose)],
    rest: &[Vec3],
    units: &Units,
    to: &mut dyn FieldWriter,
) -> io::Result<()> {
    let mut drawn = Drawn::default();
    for (number, (shape, _)) in tools.iter().enumerate() {
        drawn.add(shape, rest);
        drawn.tools.resize(drawn.places.len(), number);
    }
    let now = |i: usize| {
        let (shape, pose) = &tools[drawn.tools[i]];
        pose.carry(shape, &drawn.places[i])
    };
    let count = drawn.places.len();
    let points = rows(count, |i| <[f64; 3]>::from(now(i)));
    to.geometry(&points, Connectivity { count: drawn.cells.len(), cell: &|c| drawn.cells[c] })?;
    let moved = rows(count, |i| <[f64; 3]>::from(now(i) - drawn.places[i]));
    to.numbers(At::Points, "displacement", &units.symbol(Quantity::Length), &[], Values::Double(&moved))?;
    let numbers = rows(count, |i| [drawn.tools[i] as f32]);
    to.numbers(At::Points, "tool", "-", &[], Values::Single(&numbers))
}

/// Where the body lies along a direction: the ends of what is drawn there.
fn reach(rest: &[Vec3], along: &Vec3) -> [f64; 2] {
    let corner = |pick: fn(f64, f64) -> f64| rest.iter().copied().reduce(|a, b| a.zip_map(&b, pick));
    let diagonal = (corner(f64::max).unwrap_or_default() - corner(f64::min).unwrap_or_default()).norm();
    let ends = rest
        .iter()
        .map(|x| along.dot(x))
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
    let [low, high] = if ends[0] <= ends[1] { ends } else { [0.0; 2] };
    let (middle, half) = (0.5 * (low + high), 0.5 * (BEYOND * (high - low)).max(LEAST * diagonal));
    [middle - half, middle + half]
}

/// A place between two ends, so many of so many steps along.
fn between([low, high]: [f64; 2], step: usize, of: usize) -> f64 {
    low + (high - low) * step as f64 / of as f64
}

/// Two directions across one, at right angles.
fn across(axis: &Vec3) -> [Vec3; 2] {
    let Frame { t1, t2, .. } = Frame::from_normal(*axis);
    [t1, t2]
}

impl Drawn {
    fn add(&mut self, shape: &ToolShape, rest: &[Vec3]) {
        match *shape {
            ToolShape::Plane { point, normal } => {
                let [u, v] = across(&normal);
                let [of_u, of_v] = [u, v].map(|axis| reach(rest, &axis));
                let foot = normal * normal.dot(&point);
                self.grid([ALONG, ALONG], |i, j| {
                    foot + u * between(of_u, i, ALONG) + v * between(of_v, j, ALONG)
                });
            }
            ToolShape::Sphere { centre, radius } => self.ball([centre; 2], &Vec3::z(), radius),
            ToolShape::Cylinder { point, axis, radius } => {
                let [u, v] = across(&axis);
                let (foot, ends) = (point - axis * axis.dot(&point), reach(rest, &axis));
                self.grid([ROUND, ALONG], |i, j| {
                    let (sin, cos) = libm::sincos(TAU * i as f64 / ROUND as f64);
                    foot + axis * between(ends, j, ALONG) + (u * cos + v * sin) * radius
                });
            }
            ToolShape::Capsule { ends, radius } => {
                let axis = (ends[1] - ends[0]).try_normalize(0.0).unwrap_or_else(Vec3::z);
                self.ball(ends, &axis, radius);
            }
            ToolShape::Block { min, max } => {
                let ends = [0, 1, 2].map(|k| {
                    let [low, high] = reach(rest, &Vec3::ith(k, 1.0));
                    [
                        if min[k].is_finite() { min[k] } else { low },
                        if max[k].is_finite() { max[k] } else { high },
                    ]
                });
                for k in 0..3 {
                    let [u, v] = [(k + 1) % 3, (k + 2) % 3];
                    for (side, along) in ends[k].into_iter().enumerate() {
                        let finite = [min, max][side][k].is_finite();
                        let place = |i, j| {
                            let mut place = Vec3::zeros();
                            (place[k], place[u]) = (along, between(ends[u], i, ALONG));
                            place[v] = between(ends[v], j, ALONG);
                            place
                        };
                        if finite {
                            self.grid([ALONG, ALONG], place);
                        }
                    }
                }
            }
        }
    }

    /// The halves of a ball about two places of an axis, and what lies between them.
    fn ball(&mut self, [from, to]: [Vec3; 2], axis: &Vec3, radius: f64) {
        let [u, v] = across(axis);
        self.grid([ROUND, 2 * MERIDIAN + 1], |i, j| {
            let (centre, step) = if j <= MERIDIAN { (from, j) } else { (to, j - 1) };
            let (up, out) = libm::sincos(PI * step as f64 / (2 * MERIDIAN) as f64 - FRAC_PI_2);
            let (sin, cos) = libm::sincos(TAU * i as f64 / ROUND as f64);
            centre + (axis * up + (u * cos + v * sin) * out) * radius
        });
    }

    /// Quadrilaterals between rows of places.
    fn grid(&mut self, [wide, high]: [usize; 2], place: impl Fn(usize, usize) -> Vec3) {
        let first = self.places.len() as u32;
        let number = |i: usize, j: usize| first + (j * (wide + 1) + i) as u32;
        for j in 0..=high {
            self.places.extend((0..=wide).map(|i| place(i, j)));
        }
        for j in 0..high {
            for i in 0..wide {
                let corners = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
                let [a, b, c, d] = corners;
                self.cells.push((Kind::Quadrangle, [a, b, c, d, 0, 0, 0, 0]));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_place_of_a_drawn_tool_lies_on_its_face() {
        let axis = Vec3::new(1.0, 2.0, -0.5).normalize();
        let point = Vec3::new(0.3, -0.2, 0.1);
        let shapes = [
            ToolShape::Plane { point, normal: axis },
            ToolShape::Sphere { centre: point, radius: 0.7 },
            ToolShape::Cylinder { point, axis, radius: 0.7 },
            ToolShape::Capsule { ends: [point, point + axis * 2.0], radius: 0.7 },
            ToolShape::Block { min: point - Vec3::new(1.0, 2.0, f64::INFINITY), max: point },
        ];
        for shape in shapes {
            let mut drawn = Drawn::default();
            drawn.add(&shape, &[Vec3::zeros(), Vec3::new(1.0, 2.0, 3.0)]);
            assert!(drawn.places.len() > 200);
            for place in &drawn.places {
                assert!(shape.face(place, &Vec3::zeros()).distance.abs() < 1e-14, "{shape:?}: {place:?}");
            }
            for (_, corners) in &drawn.cells {
                assert!(corners[..4].iter().all(|&corner| (corner as usize) < drawn.places.len()));
            }
        }
    }
}
