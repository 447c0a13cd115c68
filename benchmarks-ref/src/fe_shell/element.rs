//! Energy, forces and tangent of one quadrilateral in the coordinates of its nodes and directors.

use super::geometry::{
    Corners, EDGES, Geometry, Point, arc, derivatives, differences, means, mid_lines, tied_measures,
};
use super::membrane::Ties;
use super::point::{self, Measures};
use super::section::Stiffness;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// Forces: the four positions' three components each, then the four directors'.
pub type Forces = SVector<f64, 24>;

/// Second derivatives of the energy in the order of [`Forces`], directors taken as free vectors.
pub type Tangent = SMatrix<f64, 24, 24>;

/// Sign with which an edge counts a node.
fn sign(edge: usize, node: usize) -> f64 {
    let (from, to) = EDGES[edge];
    f64::from(u8::from(node == to)) - f64::from(u8::from(node == from))
}

/// The motion as the strains see it: vectors along the edges.
struct Motion {
    /// Edge vectors of the surface Δx.
    edges: [Vector3<f64>; 4],
    /// Chords Δd between directors.
    chords: [Vector3<f64>; 4],
    /// The arcs that belong to them.
    arcs: [Vector3<f64>; 4],
    /// Directors at the middle of the edges.
    middles: [Vector3<f64>; 4],
    /// Tied membrane strains.
    ties: Ties,
    /// Tied shears.
    shears: [f64; 4],
}

/// Resultants of the whole element, conjugate to the quantities of [`Motion`].
#[derive(Default)]
struct Resultants {
    /// To the tied membrane strains.
    ties: Ties,
    /// To Δx_e·(arc)_f, row e, column f.
    bending: [[f64; 4]; 4],
    /// To the tied shears.
    shears: [f64; 4],
}

impl Motion {
    fn new(geometry: &Geometry, corners: &Corners) -> Self {
        let edges = differences(&corners.positions);
        let chords = differences(&corners.directors);
        let middles = means(&corners.directors);
        let shears = std::array::from_fn(|edge| edges[edge].dot(&middles[edge]) - geometry.shears[edge]);
        let ties = tied_measures(&edges) - geometry.ties;
        Self { edges, chords, arcs: chords.map(|chord| arc(&chord)), middles, ties, shears }
    }

    /// Measures of a point, with the derivatives of the position and of the director.
    fn measures(&self, point: &Point) -> (Measures, [Vector3<f64>; 2], [Vector3<f64>; 2]) {
        let membrane = point.spread * self.ties;
        let tangents = derivatives(&point.slopes, &self.edges);
        let turns = derivatives(&point.slopes, &self.arcs);
        let k = |a: usize, b: usize| tangents[a].dot(&turns[b]);
        let shear = point.slopes.map(|row| (0..4).map(|edge| row[edge] * self.shears[edge]).sum::<f64>());
        let (e, s) = (membrane, shear);
        let z = Measures::from([e[0], e[1], e[2], k(0, 0), k(0, 1), k(1, 0), k(1, 1), s[0], s[1]]);
        (z, tangents, turns)
    }
}

impl Resultants {
    /// Adds what a point contributes.
    fn add(&mut self, point: &Point, force: &Measures) {
        let membrane = Vector3::new(force[0], force[1], force[2]);
        self.ties += point.spread.tr_mul(&membrane) * point.area;
        let s = &point.slopes;
        for edge in 0..4 {
            self.shears[edge] += point.area * (force[7] * s[0][edge] + force[8] * s[1][edge]);
            for other in 0..4 {
                self.bending[edge][other] += point.area
                    * (s[0][edge] * (force[3] * s[0][other] + force[4] * s[1][other])
                        + s[1][edge] * (force[5] * s[0][other] + force[6] * s[1][other]));
            }
        }
    }

    /// Forces conjugate to the arcs.
    fn on_arcs(&self, motion: &Motion) -> [Vector3<f64>; 4] {
        std::array::from_fn(|arc| (0..4).map(|edge| motion.edges[edge] * self.bending[edge][arc]).sum())
    }

    fn forces(&self, motion: &Motion) -> Forces {
        let on_arcs = self.on_arcs(motion);
        let (r, s) = mid_lines(&motion.edges);
        let mut forces = Forces::zeros();
        for edge in 0..4 {
            let mid_line = if edge < 2 { s } else { r };
            let mut on_edge = motion.edges[edge] * (0.25 * self.ties[edge])
                + mid_line * (0.125 * self.ties[4])
                + motion.middles[edge] * self.shears[edge];
            for arc in 0..4 {
                on_edge += motion.arcs[arc] * self.bending[edge][arc];
            }
            let on_chord = arc_derivative(&motion.chords[edge]) * on_arcs[edge];
            let on_middle = motion.edges[edge] * (0.5 * self.shears[edge]);
            let (from, to) = EDGES[edge];
            for (node, sign) in [(from, -1.0), (to, 1.0)] {
                let mut position = forces.fixed_rows_mut::<3>(3 * node);
                position += on_edge * sign;
                let mut director = forces.fixed_rows_mut::<3>(12 + 3 * node);
                director += on_chord * sign + on_middle;
            }
        }
        forces
    }

    /// Adds the second derivatives of the measures times their resultants.
    fn add_geometric(&self, motion: &Motion, tangent: &mut Tangent) {
        let on_arcs = self.on_arcs(motion);
        let turns = motion.chords.map(|chord| arc_derivative(&chord));
        for edge in 0..4 {
            let (from, to) = EDGES[edge];
            let on_chord = arc_second(&motion.chords[edge], &on_arcs[edge]);
            for (i, j) in [(from, from), (from, to), (to, from), (to, to)] {
                let sign = if i == j { 1.0 } else { -1.0 };
                add_block(
                    tangent,
                    3 * i,
                    3 * j,
                    &Matrix3::from_diagonal_element(0.25 * sign * self.ties[edge]),
                );
                add_block(tangent, 12 + 3 * i, 12 + 3 * j, &(on_chord * sign));
            }
            for arc in 0..4 {
                let block = turns[arc] * self.bending[edge][arc];
                let (first, last) = EDGES[arc];
                for (i, j, sign) in
                    [(from, first, 1.0), (from, last, -1.0), (to, first, -1.0), (to, last, 1.0)]
                {
                    add_mixed(tangent, i, j, &(block * sign));
                }
            }
            for (i, sign) in [(from, -0.5), (to, 0.5)] {
                for j in [from, to] {
                    add_mixed(tangent, i, j, &Matrix3::from_diagonal_element(sign * self.shears[edge]));
                }
            }
        }
        // the shear at the centre, ½ x,_r·x,_s
        let (along_r, along_s) = ([-0.25, 0.25, 0.25, -0.25], [-0.25, -0.25, 0.25, 0.25]);
        for i in 0..4 {
            for j in 0..4 {
                let value = 0.5 * self.ties[4] * (along_r[i] * along_s[j] + along_s[i] * along_r[j]);
                add_block(tangent, 3 * i, 3 * j, &Matrix3::from_diagonal_element(value));
            }
        }
    }
}

/// ∂(arc)/∂(chord), symmetric.
fn arc_derivative(chord: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::from_diagonal_element(1.0 + chord.norm_squared() / 24.0) + chord * chord.transpose() / 12.0
}

/// Second derivatives of force·arc(chord).
fn arc_second(chord: &Vector3<f64>, force: &Vector3<f64>) -> Matrix3<f64> {
    let product = force * chord.transpose();
    (product + product.transpose() + Matrix3::from_diagonal_element(force.dot(chord))) / 12.0
}

fn add_block(tangent: &mut Tangent, row: usize, column: usize, block: &Matrix3<f64>) {
    let mut view = tangent.fixed_view_mut::<3, 3>(row, column);
    view += block;
}

/// Adds a block between the position of node i and the director of node j, on both sides of the diagonal.
fn add_mixed(tangent: &mut Tangent, i: usize, j: usize, block: &Matrix3<f64>) {
    add_block(tangent, 3 * i, 12 + 3 * j, block);
    add_block(tangent, 12 + 3 * j, 3 * i, &block.transpose());
}

/// Energy of an element \[F L\].
pub fn energy(geometry: &Geometry, corners: &Corners, stiffness: &Stiffness) -> f64 {
    let motion = Motion::new(geometry, corners);
    let of_point = |point: &Point| {
        let (z, ..) = motion.measures(point);
        point.area * point::energy(&z, &point.curvature, stiffness)
    };
    geometry.points.iter().map(of_point).sum()
}

/// Forces on positions \[F\] and directors \[F L\].
pub fn forces(geometry: &Geometry, corners: &Corners, stiffness: &Stiffness) -> Forces {
    let motion = Motion::new(geometry, corners);
    let mut resultants = Resultants::default();
    for point in &geometry.points {
        let (z, ..) = motion.measures(point);
        resultants.add(point, &point::gradient(&z, &point.curvature, stiffness));
    }
    resultants.forces(&motion)
}

/// Forces and their derivatives.
pub fn tangent(geometry: &Geometry, corners: &Corners, stiffness: &Stiffness) -> (Forces, Tangent) {
    let motion = Motion::new(geometry, corners);
    let tie_rows = tie_rows(&motion.edges);
    let turns_of_arcs = motion.chords.map(|chord| arc_derivative(&chord));
    let mut resultants = Resultants::default();
    let mut tangent = Tangent::zeros();
    for point in &geometry.points {
        let (z, tangents, turns) = motion.measures(point);
        let (force, second) = point::hessian(&z, &point.curvature, stiffness);
        resultants.add(point, &force);
        let mut rows = SMatrix::<f64, 9, 24>::zeros();
        rows.fixed_view_mut::<3, 12>(0, 0).copy_from(&(point.spread * tie_rows));
        add_bending_rows(point, &tangents, &turns, &turns_of_arcs, &mut rows);
        add_shear_rows(point, &motion, &mut rows);
        let weighted = (second * point.area) * rows;
        tangent.gemm_tr(1.0, &rows, &weighted, 1.0);
    }
    resultants.add_geometric(&motion, &mut tangent);
    (resultants.forces(&motion), tangent)
}

/// Derivatives of the tied membrane strains by the positions.
fn tie_rows(edges: &[Vector3<f64>; 4]) -> SMatrix<f64, 5, 12> {
    let (r, s) = mid_lines(edges);
    let mut rows = SMatrix::<f64, 5, 12>::zeros();
    for edge in 0..4 {
        for node in [EDGES[edge].0, EDGES[edge].1] {
            let sign = sign(edge, node);
            let mid_line = if edge < 2 { s } else { r };
            for axis in 0..3 {
                rows[(edge, 3 * node + axis)] += 0.25 * sign * edges[edge][axis];
                rows[(4, 3 * node + axis)] += 0.125 * sign * mid_line[axis];
            }
        }
    }
    rows
}

/// Derivatives of k_ab = a_a·d,_b.
fn add_bending_rows(
    point: &Point,
    tangents: &[Vector3<f64>; 2],
    turns: &[Vector3<f64>; 2],
    turns_of_arcs: &[Matrix3<f64>; 4],
    rows: &mut SMatrix<f64, 9, 24>,
) {
    for edge in 0..4 {
        let of_arc = tangents.map(|tangent| turns_of_arcs[edge] * tangent);
        for (a, b) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let row = 3 + 2 * a + b;
            let (by_position, by_director) =
                (turns[b] * point.slopes[a][edge], of_arc[a] * point.slopes[b][edge]);
            for node in [EDGES[edge].0, EDGES[edge].1] {
                let sign = sign(edge, node);
                for axis in 0..3 {
                    rows[(row, 3 * node + axis)] += sign * by_position[axis];
                    rows[(row, 12 + 3 * node + axis)] += sign * by_director[axis];
                }
            }
        }
    }
}

/// Derivatives of the shear strains γ_b = Σ slopes (Δx·d̄).
fn add_shear_rows(point: &Point, motion: &Motion, rows: &mut SMatrix<f64, 9, 24>) {
    for edge in 0..4 {
        for b in 0..2 {
            let slope = point.slopes[b][edge];
            for node in [EDGES[edge].0, EDGES[edge].1] {
                let signed = sign(edge, node) * slope;
                for axis in 0..3 {
                    rows[(7 + b, 3 * node + axis)] += signed * motion.middles[edge][axis];
                    rows[(7 + b, 12 + 3 * node + axis)] += 0.5 * slope * motion.edges[edge][axis];
                }
            }
        }
    }
}
