//! Rigid tools: shapes with the distance of a point, its gradient and its second derivative.

use nalgebra::Matrix3;
use sph_core::Vec3;

/// What a tool is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ToolShape {
    /// A half space that ends at a plane through a point; bodies are on the side of its normal.
    Plane {
        /// A point of the plane \[L\].
        point: Vec3,
        /// Normal away from the tool (any length).
        normal: Vec3,
    },
    /// A ball.
    Sphere {
        /// Its centre \[L\].
        centre: Vec3,
        /// Its radius \[L\].
        radius: f64,
    },
    /// A cylinder without ends.
    Cylinder {
        /// A point of its axis \[L\].
        point: Vec3,
        /// Direction of its axis (any length).
        axis: Vec3,
        /// Its radius \[L\].
        radius: f64,
    },
    /// All that is nearer than a radius to a line between two points.
    Capsule {
        /// Ends of the line \[L\].
        ends: [Vec3; 2],
        /// Its radius \[L\].
        radius: f64,
    },
    /// A box along the axes of space, which may be without end along some.
    Block {
        /// Its least coordinates \[L\].
        min: Vec3,
        /// Its greatest coordinates \[L\].
        max: Vec3,
    },
}

/// Where a point is to a tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// Distance g from the face of the tool \[L\], negative inside.
    pub distance: f64,
    /// Its gradient ∇g, of length one.
    pub normal: Vec3,
    /// Its second derivative ∇∇g \[1/L\].
    pub curvature: Matrix3<f64>,
}

/// How far a point is from a tool, and in which direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Distance g from the face of the tool \[L\], negative inside.
    pub distance: f64,
    /// Its gradient ∇g, of length one.
    pub normal: Vec3,
}

/// A tool that makes no sense.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ToolError {
    /// A radius that is not positive and finite.
    #[error("a tool has the radius {0}; a tool needs a positive one")]
    Radius(f64),
    /// A place that is not finite.
    #[error("a tool stands at a place that is not finite")]
    Place,
    /// A box without room inside.
    #[error(
        "a block reaches from {0} to {1} along an axis; its greatest coordinates have to be above the least ones"
    )]
    Ends(f64, f64),
    /// A normal or an axis without a direction.
    #[error("a tool has a normal or an axis of length zero; name a direction")]
    Direction,
}

impl ToolShape {
    /// The same with directions of length one.
    ///
    /// # Errors
    /// [`ToolError`] for radii that are not positive, places that are not finite, boxes without room inside, directions of length zero.
    pub fn checked(self) -> Result<Self, ToolError> {
        let places = match &self {
            Self::Plane { point, .. } | Self::Cylinder { point, .. } => vec![*point],
            Self::Sphere { centre, .. } => vec![*centre],
            Self::Capsule { ends, .. } => ends.to_vec(),
            Self::Block { .. } => Vec::new(),
        };
        if places.iter().any(|place| !place.iter().all(|x| x.is_finite())) {
            return Err(ToolError::Place);
        }
        let unit = |direction: Vec3| {
            let length = direction.norm();
            if length > 0.0 && length.is_finite() {
                Ok(direction / length)
            } else {
                Err(ToolError::Direction)
            }
        };
        let positive = |radius: f64| {
            if radius > 0.0 && radius.is_finite() { Ok(radius) } else { Err(ToolError::Radius(radius)) }
        };
        Ok(match self {
            Self::Plane { point, normal } => Self::Plane { point, normal: unit(normal)? },
            Self::Sphere { centre, radius } => Self::Sphere { centre, radius: positive(radius)? },
            Self::Cylinder { point, axis, radius } => {
                Self::Cylinder { point, axis: unit(axis)?, radius: positive(radius)? }
            }
            Self::Capsule { ends, radius } => Self::Capsule { ends, radius: positive(radius)? },
            Self::Block { min, max } => {
                let narrow =
                    (0..3).find(|&k| max[k].partial_cmp(&min[k]) != Some(std::cmp::Ordering::Greater));
                narrow.map_or(Ok(self), |k| Err(ToolError::Ends(min[k], max[k])))?
            }
        })
    }

    /// A point of the axis about which a checked tool may turn, and its direction; zero for a sphere, for a capsule that is one, and for a
    /// block.
    pub fn axis(&self) -> [Vec3; 2] {
        match *self {
            Self::Plane { point, normal } => [point, normal],
            Self::Sphere { centre, .. } => [centre, Vec3::zeros()],
            Self::Cylinder { point, axis, .. } => [point, axis],
            Self::Capsule { ends: [a, b], .. } => [a, (b - a).try_normalize(0.0).unwrap_or_default()],
            Self::Block { .. } => [Vec3::zeros(); 2],
        }
    }

    /// Where a point is to a checked tool that has been moved by a translation.
    ///
    /// On the middle of a sphere or the axis of a cylinder, where there is no normal, it is an arbitrary one. Inside a block the nearest
    /// side counts; outside its edges and corners are round.
    pub fn gap(&self, point: &Vec3, moved: &Vec3) -> Gap {
        let Face { distance, normal } = self.face(point, moved);
        let curvature = match *self {
            Self::Plane { .. } => Matrix3::zeros(),
            // Within a side the normal stays, inside the block it is that of a side.
            Self::Block { .. } if distance <= 0.0 => Matrix3::zeros(),
            _ => match self.arm(&(point - moved)) {
                Arm { from, space } if from.norm() > 0.0 => {
                    (space.projection() - normal * normal.transpose()) / from.norm()
                }
                _ => Matrix3::zeros(),
            },
        };
        Gap { distance, normal, curvature }
    }

    /// The same without the second derivative.
    pub fn face(&self, point: &Vec3, moved: &Vec3) -> Face {
        let x = point - moved;
        match *self {
            Self::Plane { point, normal } => Face { distance: normal.dot(&(x - point)), normal },
            Self::Sphere { radius, .. } | Self::Cylinder { radius, .. } | Self::Capsule { radius, .. } => {
                let Arm { from, space } = self.arm(&x);
                let r = from.norm();
                let normal = if r > 0.0 { from / r } else { space.projection() * Vec3::new(0.48, 0.6, 0.64) };
                Face { distance: r - radius, normal }
            }
            Self::Block { min, max } => {
                let from = self.arm(&x).from;
                let distance = from.norm();
                if distance > 0.0 { Face { distance, normal: from / distance } } else { side(&x, &min, &max) }
            }
        }
    }

    /// The least distance of many points from a checked tool that has been moved by a translation, but for rounding: one root for all
    /// of them \[L\].
    pub fn least_distance(&self, points: impl Iterator<Item = Vec3>, moved: &Vec3) -> f64 {
        match *self {
            Self::Plane { point, normal } => {
                let zero = normal.dot(&(point + moved));
                points.fold(f64::INFINITY, |least, x| lesser(least, normal.dot(&x))) - zero
            }
            Self::Sphere { centre, radius } => {
                let centre = centre + moved;
                let square =
                    points.fold(f64::INFINITY, |least, x| lesser(least, (x - centre).norm_squared()));
                square.sqrt() - radius
            }
            Self::Cylinder { point, axis, radius } => {
                let point = point + moved;
                let square = points.fold(f64::INFINITY, |least, x| {
                    let arm = x - point;
                    lesser(least, (arm - axis * axis.dot(&arm)).norm_squared())
                });
                square.sqrt() - radius
            }
            Self::Capsule { radius, .. } => {
                let square = points.fold(f64::INFINITY, |least, x| {
                    lesser(least, self.arm(&(x - moved)).from.norm_squared())
                });
                square.sqrt() - radius
            }
            Self::Block { .. } => {
                points.fold(f64::INFINITY, |least, x| lesser(least, self.face(&x, moved).distance))
            }
        }
    }

    /// From the centre or the axis of a round tool, or from the nearest place of a block, to a point in its frame.
    fn arm(&self, x: &Vec3) -> Arm {
        match *self {
            Self::Plane { point, .. } => Arm { from: x - point, space: Space::All },
            Self::Sphere { centre, .. } => Arm { from: x - centre, space: Space::All },
            Self::Cylinder { point, axis, .. } => {
                let space = Space::Across { axis, square: 1.0 };
                Arm { from: space.projection() * (x - point), space }
            }
            Self::Capsule { ends: [a, b], .. } => {
                let along = b - a;
                let square = along.norm_squared();
                let part = if square > 0.0 { along.dot(&(x - a)) / square } else { 0.0 };
                if (0.0..=1.0).contains(&part) && square > 0.0 {
                    Arm { from: x - a - along * part, space: Space::Across { axis: along, square } }
                } else {
                    Arm { from: x - if part < 0.0 { a } else { b }, space: Space::All }
                }
            }
            Self::Block { min, max } => {
                let from = x - x.sup(&min).inf(&max);
                Arm { from, space: Space::Axes(from.map(|along| along != 0.0).into()) }
            }
        }
    }
}

/// The side of a block that is nearest to a point inside.
fn side(x: &Vec3, min: &Vec3, max: &Vec3) -> Face {
    let sides =
        (0..3).flat_map(|k| [(x[k] - max[k], Vec3::ith(k, 1.0)), (min[k] - x[k], Vec3::ith(k, -1.0))]);
    let inner = |best: Face, (distance, normal)| {
        if distance > best.distance { Face { distance, normal } } else { best }
    };
    sides.fold(Face { distance: f64::NEG_INFINITY, normal: Vec3::z() }, inner)
}

/// The way from the centre or the axis of a round tool to a point, and the space in which it lies.
struct Arm {
    from: Vec3,
    space: Space,
}

/// All of space, some of its axes, or what of it lies across an axis, whose length has a square.
enum Space {
    All,
    Axes([bool; 3]),
    Across { axis: Vec3, square: f64 },
}

impl Space {
    /// Projects onto it: `∇∇g = (P − n nᵀ)/r`.
    fn projection(&self) -> Matrix3<f64> {
        match *self {
            Self::All => Matrix3::identity(),
            Self::Axes(own) => {
                Matrix3::from_diagonal(&Vec3::from(own.map(|own| if own { 1.0 } else { 0.0 })))
            }
            Self::Across { axis, square } => Matrix3::identity() - axis * axis.transpose() / square,
        }
    }
}

/// The lesser of two numbers, the first where one is none.
fn lesser(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tools() -> [ToolShape; 5] {
        let (a, b) = (Vec3::new(0.1, -0.2, 0.3), Vec3::new(0.7, 0.4, -0.1));
        [
            ToolShape::Plane { point: a, normal: b },
            ToolShape::Sphere { centre: a, radius: 0.4 },
            ToolShape::Cylinder { point: a, axis: b, radius: 0.3 },
            ToolShape::Capsule { ends: [a, b], radius: 0.2 },
            ToolShape::Block {
                min: Vec3::new(-0.3, -0.2, f64::NEG_INFINITY),
                max: Vec3::new(0.4, 0.25, 0.5),
            },
        ]
        .map(|tool| tool.checked().unwrap())
    }

    /// Points about the tools, beyond both ends of the capsule among them.
    fn points() -> Vec<Vec3> {
        let turned = |i: u32| {
            let (s, c) = (libm::sin(f64::from(i)), libm::cos(2.3 * f64::from(i)));
            Vec3::new(1.4 * s, 1.1 * c, 0.9 * libm::sin(3.1 * f64::from(i)))
        };
        (1..60).map(turned).collect()
    }

    /// Differences of 1e-5 of numbers of the order of one: measured 2e-9 at most.
    #[test]
    fn gradient_and_second_derivative_are_those_of_the_distance() {
        let (h, moved) = (1e-5, Vec3::new(0.02, -0.03, 0.01));
        for tool in tools() {
            for x in points() {
                let here = tool.gap(&x, &moved);
                assert!((here.normal.norm() - 1.0).abs() < 1e-12);
                for k in 0..3 {
                    let step = Vec3::ith(k, h);
                    let [low, high] = [tool.gap(&(x - step), &moved), tool.gap(&(x + step), &moved)];
                    let slope = (high.distance - low.distance) / (2.0 * h);
                    assert!((slope - here.normal[k]).abs() < 1e-8, "{tool:?} {x}");
                    let change = (high.normal - low.normal) / (2.0 * h);
                    let error = (change - here.curvature.column(k)).norm();
                    assert!(error < 1e-7, "{tool:?} {x}: {error}");
                }
                let least = tool.least_distance([x, x + here.normal].into_iter(), &moved);
                assert!((least - here.distance).abs() < 1e-12, "{tool:?} {x}: {least}");
            }
        }
    }

    #[test]
    fn distances_are_those_of_the_shapes() {
        let x = Vec3::new(0.0, 0.0, 5.0);
        let at = |tool: ToolShape| tool.checked().unwrap().gap(&x, &Vec3::zeros());
        let plane =
            at(ToolShape::Plane { point: Vec3::new(3.0, 3.0, 1.0), normal: Vec3::new(0.0, 0.0, 7.0) });
        assert_eq!((plane.distance, plane.normal), (4.0, Vec3::z()));
        let sphere = at(ToolShape::Sphere { centre: Vec3::zeros(), radius: 2.0 });
        assert_eq!((sphere.distance, sphere.curvature[(0, 0)]), (3.0, 0.2));
        let cylinder =
            at(ToolShape::Cylinder { point: Vec3::new(9.0, 0.0, 0.0), axis: Vec3::x(), radius: 1.0 });
        assert_eq!(
            (cylinder.distance, cylinder.curvature[(0, 0)], cylinder.curvature[(1, 1)]),
            (4.0, 0.0, 0.2)
        );
        let capsule = at(ToolShape::Capsule { ends: [Vec3::zeros(), Vec3::z() * 3.0], radius: 1.0 });
        assert_eq!(capsule.distance, 1.0);
        let block = ToolShape::Block { min: Vec3::zeros(), max: Vec3::new(2.0, 2.0, 1.0) };
        let from = |x: [f64; 3]| block.checked().unwrap().gap(&x.into(), &Vec3::x());
        assert_eq!((at(block).distance, at(block).normal), (4.0, Vec3::z()));
        assert_eq!(
            (from([2.0, 0.1, 1.5]).distance, from([2.0, 0.1, 1.5]).curvature),
            (0.5, Matrix3::zeros())
        );
        // Over an edge 3 and 4 away, and inside, nearest to the side y = 0.
        assert_eq!((from([6.0, 1.0, 5.0]).distance, from([6.0, 1.0, 5.0]).curvature[(1, 1)]), (5.0, 0.0));
        assert_eq!((from([2.0, 0.1, 0.5]).distance, from([2.0, 0.1, 0.5]).normal), (-0.1, -Vec3::y()));
    }

    #[test]
    fn tools_without_sense_are_refused() {
        let sphere = |radius| ToolShape::Sphere { centre: Vec3::zeros(), radius }.checked();
        assert_eq!(sphere(-1.0), Err(ToolError::Radius(-1.0)));
        assert!(matches!(sphere(f64::NAN), Err(ToolError::Radius(_))));
        let plane = |normal| ToolShape::Plane { point: Vec3::zeros(), normal }.checked();
        assert_eq!(plane(Vec3::zeros()), Err(ToolError::Direction));
        let lost = ToolShape::Sphere { centre: Vec3::new(f64::NAN, 0.0, 0.0), radius: 1.0 }.checked();
        assert_eq!(lost, Err(ToolError::Place));
        let flat = ToolShape::Block { min: Vec3::zeros(), max: Vec3::new(1.0, 0.0, 1.0) };
        assert_eq!(flat.checked(), Err(ToolError::Ends(0.0, 0.0)));
    }
}
