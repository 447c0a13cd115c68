//! Second moments of masses that are lumped at the corners of cells, and masses of modes that have those of the surface.
//!
//! Corners integrate `f = |v|²` over a rectangle of mass m and sides h by `½ E:∇∇f` too much, `E = m h²/6` along either side. A lattice of n
//! cells a side turns with `1 + 2/n²` of its inertia. Inside a lattice the sum over cells is that of the trapezoidal rule, which is
//! exact there but for terms of a higher order (masses consistent with the stencils would take it away inside too, and triple the error of waves);
//! what is left is a term of the edge (Euler and Maclaurin). So from the masses goes what corners have too much of a polynomial of second
//! degree, and that polynomial is fitted to f at particles inside:
//!
//! ```text
//! δm·f = −Σ_c m_c [ mean over corners of p_c − mean over the cell of p_c ]     p_c = mean of the fits at the inner corners of c
//! ```
//!
//! Moments of order zero, one and two of a flat sheet come out exactly, on any cells; on a lattice this is Gregory's rule along edges,
//! ⅜, 7/6, 23/24, 1, … \[davis1984\], and nothing inside. Without particles inside (a strip of one cell) nothing is changed.

use nalgebra::{Matrix3, SMatrix, SVector, SymmetricEigen};
use sph_core::{Cell, Cloud, Vec3};

use std::ops::DerefMut;

use crate::Shell;
use crate::material::Material;
use crate::reference::Reference;
use crate::statics::static_shell::StaticShell;

/// Part of a particle's mass that is left to it at least; the corner of a lattice keeps half.
const LEFT: f64 = 0.1;
/// Least part of the mass of its cells that a particle has where areas come from cells: Gregory's rule has put the edge right already.
const BY_CELLS: f64 = 0.9;
/// Neighbours from which a fit is made: those of a lattice.
const NEIGHBOURS: usize = 8;
/// Least over greatest eigenvalue of a fit; a lattice has 0.1.
const DEFINED: f64 = 1e-4;

/// `y₁, y₂, y₁², y₁y₂, y₂²`.
type Polynomial = SVector<f64, 5>;

fn powers([x, y]: [f64; 2]) -> Polynomial {
    Polynomial::new(x, y, x * x, x * y, y * y)
}

/// Cuts of a cell into triangles along its diagonals, and the share of each.
fn cuts(cell: &Cell) -> (&'static [[usize; 3]], f64) {
    if cell.count == 3 { (&[[0, 1, 2]], 1.0) } else { (&[[0, 1, 2], [0, 2, 3], [1, 2, 3], [1, 3, 0]], 0.5) }
}

/// What corners have more than the cell, means of polynomials over both.
fn excess(cell: &Cell, corners: &[[f64; 2]]) -> Polynomial {
    let (cuts, _) = cuts(cell);
    let mut whole = Polynomial::zeros();
    let mut area = 0.0;
    for cut in cuts {
        let [a, b, c] = cut.map(|k| corners[k]);
        let part = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let sum = [a[0] + b[0] + c[0], a[1] + b[1] + c[1]];
        // Means over a triangle: of y a third of the sum, of y yᵀ a twelfth of the sum of squares and the square of the sum.
        let squares = powers(a) + powers(b) + powers(c) + powers(sum);
        let mean = Polynomial::new(
            sum[0] / 3.0,
            sum[1] / 3.0,
            squares[2] / 12.0,
            squares[3] / 12.0,
            squares[4] / 12.0,
        );
        whole += mean * part;
        area += part;
    }
    corners.iter().map(|&y| powers(y)).sum::<Polynomial>() / corners.len() as f64 - whole / area
}

/// A least-squares fit about an inner particle, `p(y) − p(0)` by differences to its neighbours.
struct Fit {
    neighbours: Vec<u32>,
    /// Inverse of its normal matrix, lengths in spacings.
    inverse: SMatrix<f64, 5, 5>,
}

/// A cloud as its particles see it.
struct Around<'a> {
    cloud: &'a Cloud,
    cells_at: Vec<Vec<u32>>,
    spacing: f64,
}

impl Around<'_> {
    /// A place in the tangent plane of a particle: along its projection, as long as the chord, in spacings.
    fn flattened(&self, a: usize, b: u32) -> [f64; 2] {
        let arm = self.cloud.positions[b as usize] - self.cloud.positions[a];
        let frame = &self.cloud.frames[a];
        let [x, y] = [arm.dot(&frame.t1), arm.dot(&frame.t2)];
        let scale = arm.norm() / libm::hypot(x, y).max(f64::MIN_POSITIVE) / self.spacing;
        [x * scale, y * scale]
    }

    fn ring(&self, particles: &[u32]) -> Vec<u32> {
        let cells = particles.iter().flat_map(|&a| &self.cells_at[a as usize]);
        let mut all: Vec<u32> =
            cells.flat_map(|&c| self.cloud.cells[c as usize].particles()).copied().collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Weight of a neighbour.
    fn weight(y: [f64; 2]) -> f64 {
        1.0 / (y[0] * y[0] + y[1] * y[1])
    }

    /// None on an edge, and where neighbours do not define a polynomial.
    fn fit(&self, a: usize) -> Option<Fit> {
        if self.cloud.edge_lengths[a] > 0.0 || self.cells_at[a].is_empty() {
            return None;
        }
        let mut neighbours = self.ring(&[a as u32]);
        if neighbours.len() <= NEIGHBOURS {
            neighbours = self.ring(&neighbours);
        }
        neighbours.retain(|&b| b as usize != a);
        let normal: SMatrix<f64, 5, 5> = neighbours
            .iter()
            .map(|&b| {
                let y = self.flattened(a, b);
                powers(y) * powers(y).transpose() * Self::weight(y)
            })
            .sum();
        let values = SymmetricEigen::new(normal).eigenvalues;
        let defined = values.min() > DEFINED * values.max();
        let inverse = normal.try_inverse().filter(|_| defined)?;
        Some(Fit { neighbours, inverse })
    }
}

/// What goes to each particle in modes, beside its lumped mass, for cells of some masses; sums to nothing.
///
/// Particles that are not free get nothing: a rigid body turns about its centre of mass, which stays where it is.
pub(crate) fn moved_masses(
    reference: &Reference,
    cell_mass: impl Fn(usize) -> f64,
    free: impl Fn(u32) -> bool,
) -> Vec<f64> {
    let cloud = &reference.cloud;
    let mut moved = vec![0.0; cloud.len()];
    let mut cells_at = vec![Vec::new(); cloud.len()];
    let mut shares = vec![0.0; cloud.len()];
    for (c, cell) in cloud.cells.iter().enumerate() {
        let share = cell.geometry(&cloud.positions).area / f64::from(cell.count);
        for &b in cell.particles() {
            cells_at[b as usize].push(c as u32);
            shares[b as usize] += share;
        }
    }
    if cloud.areas.iter().zip(&shares).any(|(area, share)| *area < BY_CELLS * share) {
        return moved;
    }
    let around = Around { cloud, cells_at, spacing: cloud.spacing() };
    let fit = |a: usize| {
        let fit = around.fit(a).filter(|_| free(a as u32))?;
        fit.neighbours.iter().all(|&b| free(b)).then_some(fit)
    };
    let fits: Vec<Option<Fit>> = (0..cloud.len()).map(fit).collect();
    let inner = |particles: &[u32]| -> Vec<u32> {
        particles.iter().copied().filter(|&a| fits[a as usize].is_some()).collect()
    };
    let mut too_much = vec![Polynomial::zeros(); cloud.len()];
    for (c, cell) in cloud.cells.iter().enumerate() {
        let mut by = inner(cell.particles());
        if by.is_empty() {
            by = inner(&around.ring(cell.particles()));
        }
        for &a in &by {
            let corners: Vec<[f64; 2]> =
                cell.particles().iter().map(|&b| around.flattened(a as usize, b)).collect();
            too_much[a as usize] += excess(cell, &corners) * (cell_mass(c) / by.len() as f64);
        }
    }
    for (a, fit) in fits.iter().enumerate() {
        let Some(fit) = fit else { continue };
        let by = fit.inverse * too_much[a];
        for &b in &fit.neighbours {
            let y = around.flattened(a, b);
            let part = powers(y).dot(&by) * Around::weight(y);
            moved[b as usize] -= part;
            moved[a] += part;
        }
    }
    // As much as leaves every particle a mass.
    let least = moved.iter().zip(&reference.masses).map(|(m, whole)| m / whole).fold(0.0, f64::min);
    if -least > 1.0 - LEFT {
        moved.iter_mut().for_each(|mass| *mass *= (1.0 - LEFT) / -least);
    }
    moved
}

/// `∫x xᵀ dm` of a cell of the surface less that of its corners, about a pole, a unit of mass \[L²\].
///
/// `curvature` holds k₁₁, k₂₂, k₁₂ + k₂₁ along the tangents of the frame: between its corners a curved cell rises by
/// `½ k:(⟨ξξ⟩ of the corners − ⟨ξξ⟩ of the cell)` above them, in the mean.
fn missing(
    cell: &Cell,
    cloud: &Cloud,
    pole: &Vec3,
    tangents: [Vec3; 2],
    curvature: [f64; 3],
) -> Matrix3<f64> {
    let place = |b: u32| cloud.positions[b as usize];
    let count = f64::from(cell.count);
    let middle = cell.particles().iter().map(|&b| place(b)).sum::<Vec3>() / count;
    let arms: Vec<Vec3> = cell.particles().iter().map(|&b| place(b) - middle).collect();
    let geometry = cell.geometry(&cloud.positions);
    let (cuts, share) = cuts(cell);
    let mut whole = Matrix3::zeros();
    for cut in cuts {
        let [a, b, c] = cut.map(|k| arms[k]);
        let vector = 0.5 * (b - a).cross(&(c - a));
        let sum = a + b + c;
        let squares = [a, b, c, sum].iter().map(|r| r * r.transpose()).sum::<Matrix3<f64>>();
        whole += squares * (share * vector.norm().copysign(vector.dot(&geometry.normal)) / 12.0);
    }
    let of_corners = arms.iter().map(|r| r * r.transpose()).sum::<Matrix3<f64>>() / count;
    let less = whole / geometry.area - of_corners;
    let [t1, t2] = tangents;
    let along = |a: &Vec3, b: &Vec3| a.dot(&(less * b));
    let rise = -0.5
        * (curvature[0] * along(&t1, &t1) + curvature[1] * along(&t2, &t2) + curvature[2] * along(&t1, &t2));
    let shift = geometry.centroid - middle + geometry.normal * rise;
    let arm = middle - pole;
    less + arm * shift.transpose() + shift * arm.transpose()
}

/// What lumped masses lack of the inertia about a pole of the cells all of whose corners are among some particles, ascending; and for each
/// particle the part of its area in other cells.
pub(crate) fn of_rigid_cells(
    reference: &Reference,
    material: &Material,
    particles: &[u32],
    pole: &Vec3,
) -> (Matrix3<f64>, Vec<f64>) {
    let cloud = &reference.cloud;
    let mut areas = vec![[0.0; 2]; particles.len()];
    let mut moment = Matrix3::zeros();
    for (c, cell) in cloud.cells.iter().enumerate() {
        let places = || cell.particles().iter().map(|b| particles.binary_search(b));
        let within = places().all(|place| place.is_ok());
        let share = cell.geometry(&cloud.positions).area / f64::from(cell.count);
        places().flatten().for_each(|place| areas[place][usize::from(within)] += share);
        if within {
            moment += missing_moment(reference, c, pole) * material.cell_mass(reference, c);
        }
    }
    let outside = areas.iter().map(|[out, within]| out / (out + within)).collect();
    (Matrix3::identity() * moment.trace() - moment, outside)
}

/// `∫x xᵀ dm` of a cell less that of its corners, about a pole, a unit of mass \[L²\].
pub(crate) fn missing_moment(reference: &Reference, cell: usize, pole: &Vec3) -> Matrix3<f64> {
    let Reference { cloud, operator, .. } = reference;
    let (point, stencil) = (&operator.points[cell], operator.stencil(cell));
    let tangents = [point.frame.t1, point.frame.t2];
    let mut curvature = [0.0; 3];
    for (k, &b) in stencil.particles.iter().enumerate() {
        let along = tangents.map(|t| t.dot(&cloud.frames[b as usize].n));
        curvature[0] += stencil.g1[k] * along[0];
        curvature[1] += stencil.g2[k] * along[1];
        curvature[2] += stencil.g1[k] * along[1] + stencil.g2[k] * along[0];
    }
    missing(&cloud.cells[cell], cloud, pole, tangents, curvature)
}

impl Shell {
    /// What moves with each particle in modes beside [`Shell::moving_masses`] \[M\].
    pub(crate) fn moved_masses(&self) -> Vec<f64> {
        let junctions = &self.dependents.junctions;
        let within = |c: usize| junctions.body_around(&self.reference.cloud.cells[c]).is_some();
        let mass = |c: usize| if within(c) { 0.0 } else { self.material.cell_mass(&self.reference, c) };
        let mut moved = moved_masses(&self.reference, mass, |a| junctions.body_of(a as usize).is_none());
        self.dependents.ties.hang(&mut moved);
        moved
    }
}

impl<S: DerefMut<Target = Shell>> StaticShell<S> {
    /// Masses of unknowns with what moves beside.
    pub(crate) fn with_moved_masses(&self, mut masses: Vec<f64>) -> Vec<f64> {
        let moved = self.shell.moved_masses();
        for (unknown, mass) in masses.iter_mut().enumerate() {
            let (particle, _, moves) = self.dofs.find(unknown);
            *mass += match self.shell.dependents.junctions.of(particle) {
                None if moves => moved[particle],
                None => 0.0,
                Some(group) if moves => group.particles.iter().map(|&a| moved[a as usize]).sum(),
                Some(_) => 0.0,
            };
        }
        masses
    }
}
