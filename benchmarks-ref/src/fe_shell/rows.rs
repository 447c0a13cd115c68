//! Derivatives of a point's measures by the nodal vectors, and their product with a point's tangent.

use super::geometry::{EDGES, mid_lines};
use super::membrane::Spread;
use super::point::Curvature;
use nalgebra::{Matrix3, SMatrix, Vector3};

/// Columns: the components of the four positions, then of the four directors.
const COLUMNS: usize = 24;

/// Second derivatives of an element's energy by these components, directors taken as free vectors.
pub type Tangent = SMatrix<f64, COLUMNS, COLUMNS>;

/// Derivatives of the tied membrane strains by the positions' components.
pub type TieRows = [[f64; 12]; 5];

/// A row for each of the nine measures.
#[derive(Debug, Clone, Default)]
pub struct Rows([[f64; COLUMNS]; 9]);

/// Adds a vector to the three columns of a node.
fn add(row: &mut [f64], start: usize, vector: &Vector3<f64>, factor: f64) {
    for axis in 0..3 {
        row[start + axis] += factor * vector[axis];
    }
}

/// Derivatives of the tied membrane strains ¼Δx·δΔx and ½(x,_r·δx,_s + x,_s·δx,_r).
pub fn of_ties(edges: &[Vector3<f64>; 4]) -> TieRows {
    let (r, s) = mid_lines(edges);
    let mut rows = TieRows::default();
    for (edge, &(from, to)) in EDGES.iter().enumerate() {
        let mid_line = if edge < 2 { s } else { r };
        for (node, sign) in [(from, -1.0), (to, 1.0)] {
            add(&mut rows[edge], 3 * node, &edges[edge], 0.25 * sign);
            add(&mut rows[4], 3 * node, &mid_line, 0.125 * sign);
        }
    }
    rows
}

impl Rows {
    /// Rows of the assumed membrane strains.
    pub fn set_membrane(&mut self, spread: &Spread, ties: &TieRows) {
        for component in 0..3 {
            for (tie, row) in ties.iter().enumerate() {
                let factor = spread[(component, tie)];
                for (value, of_tie) in self.0[component].iter_mut().zip(row) {
                    *value += factor * of_tie;
                }
            }
        }
    }

    /// Rows of k_ab = a_a·d,_b.
    pub fn add_bending(
        &mut self,
        slopes: &[[f64; 4]; 2],
        tangents: &[Vector3<f64>; 2],
        turns: &[Vector3<f64>; 2],
        turns_of_arcs: &[Matrix3<f64>; 4],
    ) {
        for (edge, &(from, to)) in EDGES.iter().enumerate() {
            for a in 0..2 {
                let of_arc = turns_of_arcs[edge] * tangents[a];
                for b in 0..2 {
                    let row = &mut self.0[3 + 2 * a + b];
                    for (node, sign) in [(from, -1.0), (to, 1.0)] {
                        add(row, 3 * node, &turns[b], sign * slopes[a][edge]);
                        add(row, 12 + 3 * node, &of_arc, sign * slopes[b][edge]);
                    }
                }
            }
        }
    }

    /// Rows of γ_b = Σ slopes (Δx·d̄).
    pub fn add_shear(
        &mut self,
        slopes: &[[f64; 4]; 2],
        edges: &[Vector3<f64>; 4],
        middles: &[Vector3<f64>; 4],
    ) {
        for (edge, &(from, to)) in EDGES.iter().enumerate() {
            for b in 0..2 {
                let (row, slope) = (&mut self.0[7 + b], slopes[b][edge]);
                for (node, sign) in [(from, -1.0), (to, 1.0)] {
                    add(row, 3 * node, &middles[edge], sign * slope);
                    add(row, 12 + 3 * node, &edges[edge], 0.5 * slope);
                }
            }
        }
    }

    /// Adds rowsᵀ · second · rows.
    pub fn add_product(&self, second: &Curvature, tangent: &mut Tangent) {
        let mut weighted = [[0.0; COLUMNS]; 9];
        for (s, out) in weighted.iter_mut().enumerate() {
            for (t, row) in self.0.iter().enumerate() {
                let factor = second[(s, t)];
                for (value, entry) in out.iter_mut().zip(row) {
                    *value += factor * entry;
                }
            }
        }
        for (index, mut column) in tangent.column_iter_mut().enumerate() {
            let mut sums = [0.0; COLUMNS];
            for (row, other) in self.0.iter().zip(&weighted) {
                let factor = row[index];
                for (sum, entry) in sums.iter_mut().zip(other) {
                    *sum += factor * entry;
                }
            }
            for (value, sum) in column.iter_mut().zip(sums) {
                *value += sum;
            }
        }
    }
}
