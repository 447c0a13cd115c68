//! Cracks that are there at the start: which bonds they cut.
//!
//! A bond is cut where its ends lie on different sides of the crack's line or plane, and crosses it inside the crack, ends
//! and corners included. A node on the line or plane belongs to the positive side: left of a segment, and where the
//! corners of a polygon run anticlockwise. All of this holds to a rounding of 1e-9 of the size of the crack.

use sph_core::Vec3;

use crate::error::SolidError;
use crate::fracture::Crack;

/// Distances below this part of the size of a crack are zero.
const ROUNDING: f64 = 1e-9;

/// A crack made ready to be held against bonds: a plane, and the planes that bound the crack in it.
#[derive(Clone, Debug)]
pub(crate) struct Cut {
    on: Vec3,
    normal: Vec3,
    /// Points with normals that look into the crack, in its plane.
    bounds: Vec<[Vec3; 2]>,
    /// A distance that is zero \[L\].
    zero: f64,
}

impl Crack {
    /// Makes the crack of this number ready, in a body of two or three dimensions.
    ///
    /// # Errors
    /// [`SolidError::Crack`].
    pub(crate) fn cut(&self, number: usize, dimensions: usize) -> Result<Cut, SolidError> {
        let refused = |problem| Err(SolidError::Crack { number, problem });
        match self {
            Self::Segment(_) if dimensions == 3 => refused("is a segment; in space give a polygon"),
            Self::Polygon(_) if dimensions == 2 => refused("is a polygon; in a plane give a segment"),
            Self::Segment([from, to]) => {
                let along = Vec3::new(to.x - from.x, to.y - from.y, 0.0);
                let length = along.norm();
                if !(length > 0.0 && length.is_finite()) {
                    return refused("has no length; its ends must differ");
                }
                let along = along / length;
                let normal = Vec3::new(-along.y, along.x, 0.0);
                let bounds = vec![[*from, along], [*to, -along]];
                Ok(Cut { on: *from, normal, bounds, zero: ROUNDING * length })
            }
            Self::Polygon(corners) => polygon(corners).or_else(refused),
        }
    }
}

/// A polygon as a plane and the planes through its edges.
fn polygon(corners: &[Vec3]) -> Result<Cut, &'static str> {
    let [on, .., _] = corners else { return Err("has fewer than three corners") };
    let next = |corner: usize| corners[(corner + 1) % corners.len()];
    let area = (0..corners.len())
        .fold(Vec3::zeros(), |sum, corner| sum + (corners[corner] - on).cross(&(next(corner) - on)));
    let size = corners.iter().fold(0.0_f64, |most, corner| most.max((corner - on).norm()));
    let zero = ROUNDING * size;
    if !(area.norm() > zero * size && area.norm().is_finite()) {
        return Err("has no area");
    }
    let normal = area.normalize();
    if corners.iter().any(|corner| (corner - on).dot(&normal).abs() > zero.max(1e-6 * size)) {
        return Err("is not plane; give a polygon for each plane part");
    }
    let mut bounds = Vec::with_capacity(corners.len());
    for corner in 0..corners.len() {
        let along = next(corner) - corners[corner];
        if along.norm() <= zero {
            return Err("has two corners in one place");
        }
        bounds.push([corners[corner], normal.cross(&along).normalize()]);
    }
    let inside = |[on, inward]: &[Vec3; 2]| corners.iter().all(|corner| (corner - on).dot(inward) >= -zero);
    if !bounds.iter().all(inside) {
        return Err("is not convex; divide it into convex ones");
    }
    Ok(Cut { on: *on, normal, bounds, zero })
}

impl Cut {
    /// Whether it cuts the bond between two nodes.
    pub fn cuts(&self, a: &Vec3, b: &Vec3) -> bool {
        let height = |x: &Vec3| (x - self.on).dot(&self.normal);
        let (of_a, of_b) = (height(a), height(b));
        if (of_a >= -self.zero) == (of_b >= -self.zero) {
            return false;
        }
        let at = a + (b - a) * (of_a / (of_a - of_b)).clamp(0.0, 1.0);
        self.bounds.iter().all(|[on, inward]| (at - on).dot(inward) >= -self.zero)
    }
}
