//! What a body tells of its state: displacements, and at points stress, strain, rotation.

use nalgebra::DMatrix;
use solid_kinematics::{PAIRS, PointState, PointTangent, Tangent, Tensor, Trial, angle, strains};
use sph_core::{ShapeError, Vec3};

use crate::assembly::over_parameters;
use crate::body::Galerkin;

/// The state of a point of the quadrature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointResult {
    /// Place at rest \[L\].
    pub place: Vec3,
    /// Cauchy stress in material axes that turn with the point: 11, 22, 33, 12, 23, 13 \[F/L²\].
    pub stress: [f64; 6],
    /// Green's strain in material axes, shears twice.
    pub strain: [f64; 6],
    /// Angle by which the point has turned, 0 … π.
    pub angle: f64,
    /// Where the material axes of the stress point, as columns.
    pub axes: Tensor,
}

impl Galerkin {
    /// Places of the nodes at rest \[L\].
    pub fn rest(&self) -> &[Vec3] {
        &self.space.nodes
    }

    /// Displacement of a node \[L\].
    pub fn displacement(&self, node: usize) -> Vec3 {
        let shape = &self.space.nodal[node];
        let of = |node: u32| self.space.images.parameter(&self.parameters, node);
        shape.nodes.iter().zip(&shape.values).map(|(&node, phi)| of(node) * *phi).sum()
    }

    /// Displacement of any place \[L\].
    ///
    /// # Errors
    /// [`ShapeError`] where too few nodes are near.
    pub fn displacement_at(&self, place: &Vec3) -> Result<Vec3, ShapeError> {
        let shape = self.squares.at(place)?;
        let of = |node: u32| self.space.images.parameter(&self.parameters, node);
        Ok(shape.nodes.iter().zip(&shape.values).map(|(&node, phi)| of(node) * *phi).sum())
    }

    /// The displacement of nodes along a direction, its mean, as weights of the unknowns: what displacement control prescribes.
    pub fn functional(&self, nodes: &[u32], direction: Vec3) -> Vec<f64> {
        let mut forces = vec![0.0; self.parameters.len()];
        let share = direction.normalize() / nodes.len() as f64;
        for &node in nodes {
            let shape = &self.space.nodal[node as usize];
            for (&other, phi) in shape.nodes.iter().zip(&shape.values) {
                self.space.images.add(&mut forces, other, &(share * *phi));
            }
        }
        let mut out = vec![0.0; self.unknowns.count()];
        self.unknowns.project(&forces, &mut out);
        out
    }

    /// Force and moment about the origin of the loads at a level, on the body as it stands at rest \[F, F L\]: shape functions
    /// reproduce places, so that both are those of the tractions and pressures themselves.
    pub fn load_resultant(&self, level: f64) -> [Vec3; 2] {
        let (space, rest) = (&self.space, vec![0.0; self.parameters.len()]);
        let (mut force, mut moment) = (Vec3::zeros(), Vec3::zeros());
        self.loads.visit(level, (&space.images, &rest), |number, f| {
            let image = (number as usize).checked_sub(space.nodes.len());
            let x = image.map_or_else(|| space.nodes[number as usize], |image| space.images.places[image]);
            force += f;
            moment += x.cross(f);
        });
        [force, moment]
    }

    /// Material axes at rest, as columns.
    pub fn axes(&self) -> &Tensor {
        &self.axes
    }

    /// All points of the quadrature, as they were when forces were last evaluated.
    pub fn point_results(&self) -> Vec<PointResult> {
        let of = |(number, (trial, place)): (usize, (&Trial, &Vec3))| {
            let (f, axes) = (trial.state.gradient, trial.state.axes);
            let rotation = polar(&f);
            let turned = if self.remembers() { axes } else { rotation * axes };
            let cauchy = turned.transpose() * trial.kirchhoff * turned / f.determinant();
            let f = self.heat.as_ref().map_or(f, |heat| f * heat.stretch[number]);
            let green = (f.transpose() * f - Tensor::identity()) * 0.5;
            let local = strains(&(self.axes.transpose() * green * self.axes));
            let stress = PAIRS.map(|(i, j)| cauchy[(i, j)]);
            PointResult { place: *place, stress, strain: local, angle: angle(&rotation), axes: turned }
        };
        self.trials.iter().zip(&self.space.places).enumerate().map(of).collect()
    }

    /// Equivalent plastic strain \[–\] and energy dissipated \[F L\] of all points of the quadrature, as they were committed last; empty where
    /// the material does not yield.
    pub fn flowed(&self) -> Vec<[f64; 2]> {
        let Some(plastic) = &self.material.plastic else { return Vec::new() };
        let volumes = self.space.cells.iter().flat_map(|cell| &cell.volumes);
        let of = |(state, volume): (&PointState, &f64)| {
            [state.flow.strain, volume * plastic.dissipated(&state.flow)]
        };
        self.history.iter().zip(volumes).map(of).collect()
    }

    /// Greatest principal Green strain of any point, by magnitude; the law of increments is meant for less than .2.
    pub fn greatest_strain(&self) -> f64 {
        let of = |trial: &Trial| {
            let f = trial.state.gradient;
            let green = (f.transpose() * f - Tensor::identity()) * 0.5;
            green.symmetric_eigenvalues().amax()
        };
        self.trials.iter().map(of).fold(0.0, f64::max)
    }

    /// The derivative of `internal − external` by the unknowns as it is, not symmetrised, all of it: for small bodies, to see how
    /// Newton's method converges and whether loads that follow make a body flutter.
    pub fn exact_tangent(&mut self, level: f64) -> DMatrix<f64> {
        self.evaluate_internal(level);
        let count = self.parameters.len();
        // Of nodes and images, and what the parameters of images are.
        let all = 3 * self.space.integrals.len();
        let mut full = DMatrix::zeros(all, all);
        for (number, cell) in self.space.cells.iter().enumerate() {
            let all = 0..cell.volumes.len();
            let moduli = |at| self.moduli_of(number * self.space.points + at, Tangent::Consistent);
            let mut moduli: Vec<PointTangent> = all.map(moduli).collect();
            let coupled = self.couple(number, &mut moduli);
            for (at, volume) in cell.volumes.iter().enumerate() {
                let moduli = &moduli[at];
                let gradients = [0, 1, 2].map(|j| cell.gradient(at, j));
                for (a, row) in cell.nodes.iter().enumerate() {
                    let left: [[f64; 9]; 3] = std::array::from_fn(|i| {
                        std::array::from_fn(|c| {
                            (0..3).map(|j| volume * gradients[j][a] * moduli[3 * i + j][c]).sum()
                        })
                    });
                    for (b, column) in cell.nodes.iter().enumerate() {
                        for i in 0..3 {
                            for k in 0..3 {
                                let sum: f64 = (0..3).map(|l| left[i][3 * k + l] * gradients[l][b]).sum();
                                full[(3 * *row as usize + i, 3 * *column as usize + k)] += sum;
                            }
                        }
                    }
                }
            }
            let Some(coupled) = coupled else { continue };
            let [b, rows, columns] =
                [&coupled.mean, &coupled.rows, &coupled.columns].map(|nines| over_parameters(cell, nines));
            let parameter = |at: usize| 3 * cell.nodes[at % cell.width] as usize + at / cell.width;
            let real = |at: &usize| at % cell.width < cell.nodes.len();
            for row in (0..3 * cell.width).filter(real) {
                for column in (0..3 * cell.width).filter(real) {
                    full[(parameter(row), parameter(column))] +=
                        rows[row] * b[column] + b[row] * (columns[column] + coupled.scalar * b[column]);
                }
            }
        }
        let mut mirrored = DMatrix::zeros(all, count);
        for number in 0..all / 3 {
            let (node, turn) = self.space.images.real(number as u32);
            (0..9).for_each(|c| {
                mirrored[(3 * number + c / 3, 3 * node as usize + c % 3)] = turn[(c / 3, c % 3)]
            });
        }
        let mut full = mirrored.transpose() * full * mirrored;
        self.loads.stiffness((&self.space.images, &self.parameters), |row, column, k| {
            for i in 0..3 {
                (0..3).for_each(|j| {
                    full[(3 * row as usize + i, 3 * column as usize + j)] -= level * k[i][j];
                });
            }
        });
        let mut basis = DMatrix::zeros(count, self.unknowns.count());
        for (unknown, &parameter) in self.unknowns.parameters.iter().enumerate() {
            basis[(parameter as usize, unknown)] = 1.0;
        }
        for held in &self.unknowns.held {
            held.terms.iter().for_each(|&(u, t)| basis[(held.parameter as usize, u as usize)] = t);
        }
        basis.transpose() * full * basis
    }
}

/// The rotation of a deformation gradient, by the mean of a matrix and its inverse transposed.
fn polar(gradient: &Tensor) -> Tensor {
    let mut rotation = *gradient;
    for _ in 0..12 {
        if let Some(inverse) = rotation.try_inverse() {
            rotation = (rotation + inverse.transpose()) * 0.5;
        }
    }
    rotation
}
