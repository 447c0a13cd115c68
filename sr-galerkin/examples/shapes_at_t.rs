//! Shape functions at rest against shape functions of time t (eq. 32 of [song2018]), on the cantilever of 21×3×3 nodes.
//!
//! After each step that balances moving least squares are built anew on the present places of nodes, points and face points; what a step
//! adds is `Δu = Σ φ_I^t Δd_I`, and the gradient `F = F_n + Σ Δd_I ⊗ (F_nᵀ ∇_x φ_I^t)`. All else is the same for both, dense and slow.
//!
//! ```text
//! cargo run -p sr-galerkin --example shapes_at_t
//! ```

#![allow(clippy::unwrap_used, clippy::print_stdout)] // a measurement

use std::time::Instant;

use nalgebra::{DMatrix, DVector, Rotation3};
use solid_kinematics::{Formulation, Material, Moduli, PointState, StressMeasure, Tangent, Tensor, Update};
use sph_core::{Basis, Hexahedra, MovingLeastSquares, PointShape, Support, Vec3, Weight};

const LENGTH: f64 = 254.0;
const HIGH: f64 = 25.4;
const YOUNG: f64 = 82.74;

/// A place that is carried along, and its shape functions.
struct Carried {
    place: Vec3,
    shape: PointShape,
}

struct Body {
    basis: Basis,
    support: Support,
    material: Material,
    updated: bool,
    nodes: Vec<Carried>,
    rest: Vec<Vec3>,
    /// Gauss points with their volumes at rest and states; gradients are those by places at rest.
    points: Vec<(Carried, f64, PointState)>,
    /// Face points with their forces at level one.
    loads: Vec<(Carried, Vec3)>,
    /// Time spent on shape functions after the first ones \[s\].
    shapes: f64,
}

impl Body {
    fn new(columns: usize, basis: Basis, radius: f64, formulation: Formulation, updated: bool) -> Self {
        let planes = |length: f64, count: usize| -> Vec<f64> {
            (0..count).map(|i| length * i as f64 / (count - 1) as f64).collect()
        };
        let (x, y) = (planes(LENGTH, columns), planes(HIGH, 3));
        let cells = Hexahedra::between(&[x.clone(), y.clone(), y.clone()]).unwrap();
        let mut rest = Vec::new();
        for &x in &x {
            for &b in &y {
                y.iter().for_each(|&c| rest.push(Vec3::new(x, b, c)));
            }
        }
        let carried = |place: Vec3| Carried { place, shape: PointShape::default() };
        let state = PointState::rest(Tensor::identity());
        let line = -YOUNG * HIGH.powi(4) / 12.0 / LENGTH.powi(3);
        let all = cells.volume_points(3).unwrap().into_iter().flatten();
        let face = cells.face_points(&cells.faces[5], 3).unwrap();
        let mut body = Self {
            basis,
            support: Support::sphere(radius),
            material: Material { moduli: Moduli::isotropic(YOUNG, 0.2).unwrap(), formulation, plastic: None },
            updated,
            nodes: rest.iter().map(|&x| carried(x)).collect(),
            points: all.map(|point| (carried(point.place), point.volume, state)).collect(),
            loads: face
                .iter()
                .map(|point| (carried(point.place), Vec3::z() * (line / HIGH * point.area().norm())))
                .collect(),
            rest,
            shapes: 0.0,
        };
        body.reshape();
        body.shapes = 0.0;
        body
    }

    /// Shape functions on the present places.
    fn reshape(&mut self) {
        let begun = Instant::now();
        let places: Vec<Vec3> = self.nodes.iter().map(|node| node.place).collect();
        let squares = MovingLeastSquares::new(&places, self.basis, self.support, Weight::Csrbf2).unwrap();
        let all = self.nodes.iter_mut().chain(self.loads.iter_mut().map(|load| &mut load.0));
        all.for_each(|carried| carried.shape = squares.at(&carried.place).unwrap());
        for (point, _, state) in &mut self.points {
            point.shape = squares.at(&point.place).unwrap();
            for gradient in &mut point.shape.gradients {
                *gradient = (state.gradient.transpose() * Vec3::from(*gradient)).into();
            }
        }
        self.shapes += begun.elapsed().as_secs_f64();
    }

    /// One load step to a level; the number of iterations.
    fn step(&mut self, level: f64, tolerance: f64) -> usize {
        let clamped: Vec<usize> = (0..self.rest.len()).filter(|&node| self.rest[node].x == 0.0).collect();
        let (free, held) = (3 * self.nodes.len(), 3 * clamped.len());
        let mut external = DVector::<f64>::zeros(free);
        for (at, force) in &self.loads {
            for (node, value) in at.shape.nodes.iter().zip(&at.shape.values) {
                (0..3).for_each(|k| external[3 * *node as usize + k] += level * value * force[k]);
            }
        }
        let mut moved = DVector::<f64>::zeros(free + held);
        for iteration in 0..40 {
            let mut matrix = DMatrix::zeros(free + held, free + held);
            let mut right = DVector::zeros(free + held);
            right.rows_mut(0, free).copy_from(&external);
            let mut trials = Vec::with_capacity(self.points.len());
            for (point, volume, state) in &self.points {
                let shape = &point.shape;
                let mut gradient = state.gradient;
                for (node, slope) in shape.nodes.iter().zip(&shape.gradients) {
                    gradient += moved.fixed_rows::<3>(3 * *node as usize) * Vec3::from(*slope).transpose();
                }
                let trial = self.material.trial(state, &gradient).unwrap();
                // The derivative over the step, so that long steps converge as well.
                let a = self.material.tangent(Tangent::Consistent, state, &trial).unwrap();
                for (column, other) in shape.nodes.iter().zip(&shape.gradients) {
                    let mut m = [[0.0; 3]; 9];
                    for (row, out) in m.iter_mut().enumerate() {
                        for (k, out) in out.iter_mut().enumerate() {
                            *out = volume * (0..3).map(|l| a[row][3 * k + l] * other[l]).sum::<f64>();
                        }
                    }
                    for (row, slope) in shape.nodes.iter().zip(&shape.gradients) {
                        for i in 0..3 {
                            for k in 0..3 {
                                let sum = (0..3).map(|j| slope[j] * m[3 * i + j][k]).sum::<f64>();
                                matrix[(3 * *row as usize + i, 3 * *column as usize + k)] += sum;
                            }
                        }
                    }
                }
                for (node, slope) in shape.nodes.iter().zip(&shape.gradients) {
                    let force = trial.piola * Vec3::from(*slope) * *volume;
                    (0..3).for_each(|k| right[3 * *node as usize + k] -= force[k]);
                }
                trials.push(trial.state);
            }
            // Nodes of the clamp keep their places.
            for (number, &node) in clamped.iter().enumerate() {
                let shape = &self.nodes[node].shape;
                for (other, value) in shape.nodes.iter().zip(&shape.values) {
                    for k in 0..3 {
                        let (row, column) = (free + 3 * number + k, 3 * *other as usize + k);
                        (matrix[(row, column)], matrix[(column, row)]) = (YOUNG * value, YOUNG * value);
                        right[row] -= YOUNG * value * moved[column];
                    }
                }
            }
            for column in 0..held {
                for row in 0..free {
                    right[row] -= matrix[(row, free + column)] * moved[free + column];
                }
            }
            if iteration > 0 && right.norm() < tolerance * external.norm().max(1.0) {
                self.accept(&moved, trials);
                return iteration;
            }
            moved += matrix.lu().solve(&right).unwrap();
        }
        panic!("no balance at level {level}");
    }

    fn accept(&mut self, moved: &DVector<f64>, states: Vec<PointState>) {
        let all = self.nodes.iter_mut().chain(self.loads.iter_mut().map(|load| &mut load.0));
        for carried in all.chain(self.points.iter_mut().map(|point| &mut point.0)) {
            for (node, value) in carried.shape.nodes.iter().zip(&carried.shape.values) {
                carried.place += moved.fixed_rows::<3>(3 * *node as usize) * *value;
            }
        }
        self.points.iter_mut().zip(states).for_each(|(point, state)| point.2 = state);
        if self.updated {
            self.reshape();
        }
    }

    /// Deflection of the axis at the tip over the length.
    fn tip(&self) -> f64 {
        let tip = Vec3::new(LENGTH, 0.5 * HIGH, 0.5 * HIGH);
        let at = (0..self.rest.len()).find(|&node| (self.rest[node] - tip).norm() < 1e-9).unwrap();
        (self.rest[at] - self.nodes[at].place).z / LENGTH
    }
}

/// Shape functions in the middle of a plate that has turned about an axis in its plane, by a support along fixed axes: whether nodes still
/// determine the basis there.
fn turned() {
    let support = Support::tensor([35.0, 35.0, 1.25]);
    for degrees in [0.0, 1.0, 2.0, 5.0, 10.0, 30.0] {
        let turn = Rotation3::from_axis_angle(&Vec3::y_axis(), f64::to_radians(degrees));
        let places = (0..363).map(|at| {
            let [x, y, z] = [at % 11, at / 11 % 11, at / 121].map(f64::from);
            turn * Vec3::new(10.0 * x - 50.0, 10.0 * y - 50.0, 0.5 * z - 0.5)
        });
        let places: Vec<Vec3> = places.collect();
        let basis = Basis::Plate17 { across: 2 };
        let squares = MovingLeastSquares::new(&places, basis, support, Weight::Csrbf2).unwrap();
        match squares.at(&(turn * Vec3::new(3.0, 4.0, 0.2))) {
            Ok(shape) => println!("plate turned by {degrees}°: {} nodes", shape.nodes.len()),
            Err(error) => println!("plate turned by {degrees}°: {error}"),
        }
    }
}

fn main() {
    turned();
    let increments =
        Formulation::StrainRotation { update: Update::Midpoint, measure: StressMeasure::Kirchhoff };
    println!(
        "basis, nodes, steps, law: shapes, w/L at K = 1 4 8 10, after unloading; iterations, time, of it shapes [s]"
    );
    for (words, basis, columns, steps, formulation) in [
        ("quadratic", Basis::Quadratic, 21, 10, increments),
        ("quadratic", Basis::Quadratic, 21, 10, Formulation::StVenant),
        ("linear", Basis::Linear, 21, 10, increments),
    ] {
        for updated in [false, true] {
            let begun = Instant::now();
            let mut body = Body::new(columns, basis, 2.5 * 12.7, formulation, updated);
            let (mut figures, mut iterations) = (Vec::new(), 0);
            for step in 1..=steps {
                let level = 10.0 * step as f64 / steps as f64;
                iterations += body.step(level, 1e-8);
                if [1.0, 4.0, 8.0, 10.0].contains(&level) {
                    figures.push(body.tip());
                }
            }
            let (time, shapes) = (begun.elapsed().as_secs_f64(), body.shapes);
            for step in (0..steps).rev() {
                body.step(10.0 * step as f64 / steps as f64, 1e-8);
            }
            let law = if formulation == Formulation::StVenant { "St Venant" } else { "increments" };
            let kind = if updated { "of time t" } else { "at rest" };
            println!(
                "{words}, {columns}×3×3, {steps}, {law}: {kind:9} {figures:.5?} {:+.1e}; {iterations}, {time:.1}, {shapes:.2}",
                body.tip()
            );
        }
    }
}
