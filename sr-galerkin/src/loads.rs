//! Loads as forces on nodal parameters: dead ones once, pressure that follows the face as it deforms, with its stiffness.

use solid_kinematics::Tensor;
use sph_core::{FacePoint, Hexahedra, MovingLeastSquares, PointShape, Vec3};

use crate::discretisation::Discretisation;
use crate::error::GalerkinError;
use crate::images::Images;
use crate::parts::Load;

/// A point of a face under pressure.
pub(crate) struct PressedPoint {
    /// Nodes, ascending.
    pub nodes: Vec<u32>,
    /// Pressure times φ, one a node, at level one.
    values: Vec<f64>,
    /// Derivatives of the shape functions along the tangents, which hold the area of the point.
    slopes: Vec<[f64; 2]>,
    /// Tangents at rest \[L\].
    tangents: [Vec3; 2],
}

/// All loads of a body at level one.
#[derive(Default)]
pub(crate) struct Loads {
    /// Dead forces on nodes and images \[F\].
    pub dead: Vec<Vec3>,
    /// Faces under pressure.
    pub pressed: Vec<PressedPoint>,
}

impl Loads {
    pub fn new(
        loads: &[Load],
        (cells, rule): (&Hexahedra, usize),
        squares: &MovingLeastSquares,
        space: &Discretisation,
    ) -> Result<Self, GalerkinError> {
        let mut out = Self { dead: vec![Vec3::zeros(); space.integrals.len()], pressed: Vec::new() };
        for (number, load) in loads.iter().enumerate() {
            match load {
                Load::Body(force) => {
                    finite("body force", number, force.as_slice())?;
                    for (node, integral) in space.integrals.iter().enumerate() {
                        out.dead[node] += force * integral[0];
                    }
                }
                Load::Point { place, force } => {
                    finite("the force of load", number, force.as_slice())?;
                    finite("the place of load", number, place.as_slice())?;
                    out.add(&squares.at(place)?, force);
                }
                Load::Traction { faces, traction } => {
                    out.pull(number, &points(cells, faces, rule)?, traction, squares)?;
                }
                Load::TractionOver { points, traction } => out.pull(number, points, traction, squares)?,
                Load::Pressure { faces, pressure } => {
                    out.press(number, &points(cells, faces, rule)?, *pressure, squares)?;
                }
                Load::PressureOver { points, pressure } => out.press(number, points, *pressure, squares)?,
            }
        }
        Ok(out)
    }

    /// Adds a traction at points of faces.
    fn pull(
        &mut self,
        number: usize,
        points: &[FacePoint],
        traction: &Vec3,
        squares: &MovingLeastSquares,
    ) -> Result<(), GalerkinError> {
        finite("the traction of load", number, traction.as_slice())?;
        for point in some(points)? {
            self.add(&squares.at(&point.place)?, &(traction * point.area().norm()));
        }
        Ok(())
    }

    /// Adds a pressure at points of faces.
    fn press(
        &mut self,
        number: usize,
        points: &[FacePoint],
        pressure: f64,
        squares: &MovingLeastSquares,
    ) -> Result<(), GalerkinError> {
        finite("the pressure of load", number, &[pressure])?;
        for point in some(points)? {
            let shape = squares.at(&point.place)?;
            let along = |g: &[f64; 3], t: &Vec3| (0..3).map(|k| g[k] * t[k]).sum::<f64>();
            let [a, b] = point.tangents;
            self.pressed.push(PressedPoint {
                values: shape.values.iter().map(|phi| pressure * phi).collect(),
                slopes: shape.gradients.iter().map(|g| [along(g, &a), along(g, &b)]).collect(),
                nodes: shape.nodes,
                tangents: point.tangents,
            });
        }
        Ok(())
    }

    fn add(&mut self, shape: &PointShape, force: &Vec3) {
        for (node, phi) in shape.nodes.iter().zip(&shape.values) {
            self.dead[*node as usize] += force * *phi;
        }
    }

    /// Forces on parameters at a level.
    pub fn forces(&self, level: f64, (images, parameters): (&Images, &[f64]), out: &mut [f64]) {
        out.fill(0.0);
        self.visit(level, (images, parameters), |number, force| images.add(out, number, force));
    }

    /// Visits forces on nodes and images at a level \[F\], some of them in parts.
    pub fn visit(
        &self,
        level: f64,
        (images, parameters): (&Images, &[f64]),
        mut found: impl FnMut(u32, &Vec3),
    ) {
        for (number, dead) in self.dead.iter().enumerate() {
            found(number as u32, &(dead * level));
        }
        for point in &self.pressed {
            let [a, b] = point.present(images, parameters);
            let area = a.cross(&b) * level;
            for (node, value) in point.nodes.iter().zip(&point.values) {
                found(*node, &(area * -*value));
            }
        }
    }

    /// Visits `∂f_I/∂d_J` of the pressure at level one for all pairs of nodes of every point.
    pub fn stiffness(
        &self,
        (images, parameters): (&Images, &[f64]),
        mut found: impl FnMut(u32, u32, [[f64; 3]; 3]),
    ) {
        for point in &self.pressed {
            let [a, b] = point.present(images, parameters);
            for (row, value) in point.nodes.iter().zip(&point.values) {
                for (column, slopes) in point.nodes.iter().zip(&point.slopes) {
                    // d(a × b) = −[b]ₓ da + [a]ₓ db
                    let v = (a * slopes[1] - b * slopes[0]) * -*value;
                    let k = [[0.0, -v.z, v.y], [v.z, 0.0, -v.x], [-v.y, v.x, 0.0]];
                    if !(images.is_image(*row) || images.is_image(*column)) {
                        found(*row, *column, k);
                        continue;
                    }
                    let ((row, left), (column, right)) = (images.real(*row), images.real(*column));
                    let k = left.transpose() * Tensor::from_fn(|i, j| k[i][j]) * right;
                    found(row, column, std::array::from_fn(|i| std::array::from_fn(|j| k[(i, j)])));
                }
            }
        }
    }
}

impl PressedPoint {
    /// Tangents of the deformed face.
    fn present(&self, images: &Images, parameters: &[f64]) -> [Vec3; 2] {
        let mut out = self.tangents;
        for (node, slopes) in self.nodes.iter().zip(&self.slopes) {
            let d = images.parameter(parameters, *node);
            out[0] += d * slopes[0];
            out[1] += d * slopes[1];
        }
        out
    }
}

/// Points of a load, which has some.
fn some(points: &[FacePoint]) -> Result<&[FacePoint], GalerkinError> {
    if points.is_empty() { Err(GalerkinError::EmptySet("a load")) } else { Ok(points) }
}

fn points(cells: &Hexahedra, faces: &[[u32; 4]], rule: usize) -> Result<Vec<FacePoint>, GalerkinError> {
    let count = cells.corners.len();
    if let Some(&node) = faces.iter().flatten().find(|&&corner| corner as usize >= count) {
        return Err(GalerkinError::NoSuchNode { what: "the face of a load", node, count });
    }
    // The moment of a face that is no parallelogram takes two points.
    Ok(cells.face_points(faces, rule.max(2))?)
}

fn finite(what: &'static str, number: usize, values: &[f64]) -> Result<(), GalerkinError> {
    match values.iter().find(|value| !value.is_finite()) {
        None => Ok(()),
        Some(&value) => Err(GalerkinError::NotFinite { what, number, value }),
    }
}
