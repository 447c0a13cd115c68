//! A closed surface, and mass, centre and inertia of what it encloses.
//!
//! A face with the corners a, b, c makes a tetrahedron with the origin, of the signed volume `V = a·(b × c)/6`. Over all faces that look outwards:
//!
//! ```text
//! ∫ dV = Σ V        ∫ x dV = Σ V (a + b + c)/4        ∫ x xᵀ dV = Σ V/20 (a aᵀ + b bᵀ + c cᵀ + s sᵀ),  s = a + b + c
//! ```
//!
//! A quadrangle is four triangles about the mean of its corners, as contact has it. The origin is the mean of the vertices, so that no digits are
//! lost far from zero.

use std::collections::BTreeMap;

use nalgebra::{Matrix3, SymmetricEigen};
use sph_core::{Cell, Vec3};

use crate::error::RigidError;

/// Part of the cube of the size of a surface below which its volume is rounding.
const NO_VOLUME: f64 = 1e-12;
/// Part of the greatest moment by which the triangle inequality of moments may fail by rounding.
const ROUNDING: f64 = 1e-9;

/// A surface: vertices \[L\], and cells whose corners run anticlockwise seen from outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Vertices \[L\].
    pub vertices: Vec<Vec3>,
    /// Triangles and quadrangles between them.
    pub cells: Vec<Cell>,
}

/// Mass of a body, its centre, and its inertia about that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    /// Mass \[M\].
    pub mass: f64,
    /// Centre of mass \[L\].
    pub centre: Vec3,
    /// Inertia about the centre, `∫ (|r|² 1 − r rᵀ) dm` \[M L²\].
    pub inertia: Matrix3<f64>,
}

impl Outline {
    /// What the surface encloses, filled with one density \[M/L³\].
    ///
    /// # Errors
    /// [`RigidError::Open`], [`RigidError::Volume`].
    pub fn filled(&self, density: f64) -> Result<MassProperties, RigidError> {
        self.refuse_open()?;
        let origin = self.vertices.iter().sum::<Vec3>() / self.vertices.len().max(1) as f64;
        let (mut volume, mut first, mut second) = (0.0, Vec3::zeros(), Matrix3::zeros());
        for [a, b, c] in self.triangles() {
            let [a, b, c] = [a - origin, b - origin, c - origin];
            let own = a.dot(&b.cross(&c)) / 6.0;
            let sum = a + b + c;
            volume += own;
            first += sum * (own / 4.0);
            let squares = a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose();
            second += squares * (own / 20.0);
        }
        let size = self.vertices.iter().map(|x| (x - origin).norm()).fold(0.0, f64::max);
        // Not a number is no volume.
        if volume.is_nan() || volume <= NO_VOLUME * size.powi(3) {
            return Err(RigidError::Volume(volume));
        }
        let centre = first / volume;
        let about_centre = second - centre * centre.transpose() * volume;
        let inertia = Matrix3::identity() * about_centre.trace() - about_centre;
        Ok(MassProperties { mass: density * volume, centre: origin + centre, inertia: inertia * density })
    }

    /// Area of all faces \[L²\].
    pub fn area(&self) -> f64 {
        self.triangles().map(|[a, b, c]| 0.5 * (b - a).cross(&(c - a)).norm()).sum()
    }

    /// Area of the faces seen across z, each by the part of its normal there: that of the sides of a prism along z \[L²\].
    pub fn area_of_sides(&self) -> f64 {
        let across = |normal: Vec3| libm::hypot(normal.x, normal.y);
        self.triangles().map(|[a, b, c]| 0.5 * across((b - a).cross(&(c - a)))).sum()
    }

    /// Triangles of all cells, by their corners.
    pub(crate) fn triangles(&self) -> impl Iterator<Item = [Vec3; 3]> {
        self.cells.iter().flat_map(|cell| {
            let at = |i: usize| self.vertices[cell.corners[i] as usize];
            let count = usize::from(cell.count);
            let middle = (0..count).map(at).sum::<Vec3>() / count as f64;
            let whole = (count == 3).then(|| [at(0), at(1), at(2)]);
            let parts =
                (0..if count == 3 { 0 } else { count }).map(move |i| [middle, at(i), at((i + 1) % count)]);
            whole.into_iter().chain(parts)
        })
    }

    /// Every edge is run through once from each end.
    fn refuse_open(&self) -> Result<(), RigidError> {
        let mut runs: BTreeMap<[u32; 2], u32> = BTreeMap::new();
        for cell in &self.cells {
            let count = usize::from(cell.count);
            for i in 0..count {
                *runs.entry([cell.corners[i], cell.corners[(i + 1) % count]]).or_default() += 1;
            }
        }
        let single = |&(&[a, b], &count): &(&[u32; 2], &u32)| count != 1 || runs.get(&[b, a]) != Some(&1);
        match runs.iter().find(single) {
            Some((ends, _)) => Err(RigidError::Open(ends.map(|a| self.vertices[a as usize].into()))),
            None => Ok(()),
        }
    }
}

impl MassProperties {
    /// Principal moments \[M L²\] and axes, right-handed columns, about the centre.
    ///
    /// # Errors
    /// [`RigidError::Inertia`] for a mass or moments that no body has.
    pub(crate) fn principal(&self) -> Result<(Vec3, Matrix3<f64>), RigidError> {
        let (mass, inertia) = (self.mass, self.inertia);
        let refused = |moments: Vec3| RigidError::Inertia { mass, moments: moments.into() };
        if !inertia.iter().all(|value| value.is_finite()) {
            return Err(refused(inertia.diagonal()));
        }
        // Axes of a tensor that is diagonal already stay what they are.
        let off = [(0, 1), (1, 2), (2, 0)].iter().map(|&at| inertia[at].abs()).fold(0.0, f64::max);
        if off <= f64::EPSILON * inertia.trace() {
            return checked(mass, inertia.diagonal(), Matrix3::identity())
                .ok_or_else(|| refused(inertia.diagonal()));
        }
        let eigen = SymmetricEigen::new(inertia);
        let mut axes = eigen.eigenvectors;
        if axes.determinant() < 0.0 {
            axes.column_mut(2).neg_mut();
        }
        checked(mass, eigen.eigenvalues, axes).ok_or_else(|| refused(eigen.eigenvalues))
    }
}

/// Moments and axes of a body that there can be.
fn checked(mass: f64, moments: Vec3, axes: Matrix3<f64>) -> Option<(Vec3, Matrix3<f64>)> {
    let (sum, most) = (moments.sum(), moments.max());
    let sound = mass > 0.0 && mass.is_finite() && moments.min() > 0.0 && 2.0 * most <= sum + ROUNDING * most;
    sound.then_some((moments, axes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{ball, cuboid};
    use sph_core::rotated;

    /// A block far from zero, turned: mass, centre and moments to rounding (3e-13 measured of the moments, for a distance of ten sizes).
    #[test]
    fn a_block_has_its_closed_form_wherever_it_is() {
        let [a, b, c] = [1.0, 2.0, 0.5];
        let (density, theta, away) = (3.0, Vec3::new(0.4, -0.7, 1.1), Vec3::new(7.0, -20.0, 3.0));
        let mut outline = cuboid([0.0; 3], [a, b, c], 0.3);
        outline.vertices.iter_mut().for_each(|x| *x = rotated(x, &theta) + away);
        let found = outline.filled(density).unwrap();
        let mass = density * a * b * c;
        assert!((found.mass / mass - 1.0).abs() < 1e-13, "{}", found.mass);
        let middle = rotated(&(Vec3::new(a, b, c) / 2.0), &theta) + away;
        assert!((found.centre - middle).norm() < 1e-13);
        let exact = Vec3::new(b * b + c * c, c * c + a * a, a * a + b * b) * (mass / 12.0);
        let axes = Matrix3::from_columns(&[Vec3::x(), Vec3::y(), Vec3::z()].map(|e| rotated(&e, &theta)));
        let inertia = axes * Matrix3::from_diagonal(&exact) * axes.transpose();
        let error = (found.inertia - inertia).norm() / inertia.norm();
        assert!(error < 1e-12, "{error:e}");
        let (moments, own) = found.principal().unwrap();
        assert!((own * Matrix3::from_diagonal(&moments) * own.transpose() - inertia).norm() < 1e-12);
        assert!((own.determinant() - 1.0).abs() < 1e-13);
    }

    /// A polyhedron in a ball has less than the ball, and with the square of its edges.
    #[test]
    fn a_ball_comes_near_its_closed_form_with_the_square_of_its_edges() {
        let errors = [0.4, 0.2].map(|spacing| {
            let found = ball([1.0, 2.0, 3.0], 1.0, spacing).filled(1.0).unwrap();
            assert!((found.centre - Vec3::new(1.0, 2.0, 3.0)).norm() < 1e-14);
            let mass = 4.0 / 3.0 * std::f64::consts::PI;
            let inertia = Matrix3::identity() * (0.4 * mass);
            assert!((found.inertia[(0, 0)] - found.inertia[(2, 2)]).abs() < 1e-13);
            [1.0 - found.mass / mass, (found.inertia - inertia).norm() / inertia.norm()]
        });
        for k in 0..2 {
            let order = libm::log2(errors[0][k] / errors[1][k]);
            assert!(errors[0][k] > 0.0 && (order - 2.0).abs() < 0.1, "{errors:?}");
        }
    }

    #[test]
    fn what_is_open_inside_out_or_flat_is_refused() {
        let mut open = cuboid([0.0; 3], [1.0; 3], 1.0);
        let last = open.cells.pop().unwrap();
        assert!(matches!(open.filled(1.0), Err(RigidError::Open(_))));
        open.cells.push(Cell::quadrangle([3, 2, 1, 0].map(|i| last.corners[i])));
        assert!(matches!(open.filled(1.0), Err(RigidError::Open(_))));
        let mut inside = cuboid([0.0; 3], [1.0; 3], 1.0);
        inside.cells.iter_mut().for_each(|cell| cell.corners.reverse());
        assert!(matches!(inside.filled(1.0), Err(RigidError::Volume(volume)) if volume < -0.99));
        let mut flat = cuboid([0.0; 3], [1.0; 3], 1.0);
        flat.vertices.iter_mut().for_each(|x| x.z = 0.0);
        assert!(matches!(flat.filled(1.0), Err(RigidError::Volume(_))));
        let wrong = MassProperties {
            mass: 1.0,
            centre: Vec3::zeros(),
            inertia: Matrix3::from_diagonal(&Vec3::new(1.0, 1.0, 2.1)),
        };
        assert!(matches!(wrong.principal(), Err(RigidError::Inertia { .. })));
    }
}
