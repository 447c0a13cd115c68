//! Energy, forces and tangent of one quadrilateral in the coordinates of its nodes and directors.

use super::geometry::{
    Corners, EDGES, Geometry, Point, arc, derivatives, differences, means, mid_lines, tied_measures,
};
use super::membrane::Ties;
use super::point::{self, Measures};
use super::rows::{self, Rows, Tangent};
use super::section::Stiffness;
use nalgebra::{Matrix3, SVector, Vector3};

/// Forces: the four positions' three components each, then the four directors'.
pub type Forces = SVector<f64, 24>;

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
struct Sums {
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

    /// First derivatives of the motion along an increment; its ties and shears change linearly with it.
    fn rate(&self, increment: &Corners) -> Self {
        let edges = differences(&increment.positions);
        let chords = differences(&increment.directors);
        let middles = means(&increment.directors);
        let arcs = std::array::from_fn(|edge| arc_derivative(&self.chords[edge]) * chords[edge]);
        let shears = std::array::from_fn(|edge| {
            edges[edge].dot(&self.middles[edge]) + self.edges[edge].dot(&middles[edge])
        });
        let stretch = |edge: usize| 0.25 * self.edges[edge].dot(&edges[edge]);
        let ((r, s), (of_r, of_s)) = (mid_lines(&self.edges), mid_lines(&edges));
        let shear = 0.5 * (r.dot(&of_s) + s.dot(&of_r));
        let ties = Ties::from([stretch(0), stretch(1), stretch(2), stretch(3), shear]);
        Self { edges, chords, arcs, middles, ties, shears }
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

impl Sums {
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

/// Resultants of the four quadrature points.
pub type Stresses = [point::Resultants; 4];

/// Forces on positions \[F\] and directors \[F L\].
pub fn forces(geometry: &Geometry, corners: &Corners, stiffness: &Stiffness) -> Forces {
    let motion = Motion::new(geometry, corners);
    let mut sums = Sums::default();
    for point in &geometry.points {
        let (z, ..) = motion.measures(point);
        sums.add(point, &point::gradient(&z, &point::resultants(&z, &point.curvature, stiffness)));
    }
    sums.forces(&motion)
}

/// Second derivatives of the energy, and the forces; with the given resultants in the place of the state's own.
pub fn tangent(
    geometry: &Geometry,
    corners: &Corners,
    stiffness: &Stiffness,
    given: Option<&Stresses>,
) -> (Forces, Tangent) {
    let motion = Motion::new(geometry, corners);
    let tie_rows = rows::of_ties(&motion.edges);
    let turns_of_arcs = motion.chords.map(|chord| arc_derivative(&chord));
    let mut sums = Sums::default();
    let mut tangent = Tangent::zeros();
    for (index, point) in geometry.points.iter().enumerate() {
        let (z, tangents, turns) = motion.measures(point);
        let resultants =
            given.map_or_else(|| point::resultants(&z, &point.curvature, stiffness), |given| given[index]);
        sums.add(point, &point::gradient(&z, &resultants));
        let second = point::hessian(&z, &resultants, stiffness);
        let mut rows = Rows::default();
        rows.set_membrane(&point.spread, &tie_rows);
        rows.add_bending(&point.slopes, &tangents, &turns, &turns_of_arcs);
        rows.add_shear(&point.slopes, &motion.edges, &motion.middles);
        rows.add_product(&(second * point.area), &mut tangent);
    }
    sums.add_geometric(&motion, &mut tangent);
    (sums.forces(&motion), tangent)
}

/// The resultants to which an increment of positions and directors leads by first order.
pub fn predicted(
    geometry: &Geometry,
    corners: &Corners,
    increment: &Corners,
    stiffness: &Stiffness,
) -> Stresses {
    let motion = Motion::new(geometry, corners);
    let rate = motion.rate(increment);
    std::array::from_fn(|index| {
        let point = &geometry.points[index];
        let (z, tangents, turns) = motion.measures(point);
        let (change, of_tangents, of_turns) = rate.measures(point);
        let k = |a: usize, b: usize| of_tangents[a].dot(&turns[b]) + tangents[a].dot(&of_turns[b]);
        let [e1, e2, e3, _, _, _, _, s1, s2] = <[f64; 9]>::from(change);
        let change = Measures::from([e1, e2, e3, k(0, 0), k(0, 1), k(1, 0), k(1, 1), s1, s2]);
        point::predicted(&z, &change, &point.curvature, stiffness)
    })
}
