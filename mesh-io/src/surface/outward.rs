//! To which side the normals of a cloud point, as text for people: pressure is positive along them.

use sph_core::{Cloud, Vec3};

use super::error::place;

/// Height over the plane of the centroid, in units of the extent, below which a cloud is flat there.
const FLAT: f64 = 1e-6;

/// The part of the area whose normals point away from the area centroid, with the normal at the particle farthest from it;
/// of a flat cloud the normal alone.
pub fn side(cloud: &Cloud) -> String {
    let area: f64 = cloud.areas.iter().sum();
    let centroid: Vec3 = cloud.positions.iter().zip(&cloud.areas).map(|(x, a)| x * (*a / area)).sum();
    let arm = |a: usize| cloud.positions[a] - centroid;
    let height = |a: usize| cloud.frames[a].n.dot(&arm(a));
    let far = |best: usize, a: usize| if arm(a).norm() > arm(best).norm() * (1.0 + FLAT) { a } else { best };
    let farthest = (0..cloud.len()).reduce(far).unwrap_or(0);
    let here = format!("along {} at {}", place(&cloud.frames[farthest].n), place(&cloud.positions[farthest]));
    let extent = arm(farthest).norm();
    if (0..cloud.len()).all(|a| height(a).abs() <= FLAT * extent) {
        return here;
    }
    // A sum of nothing is −0.
    let outward =
        (0..cloud.len()).filter(|&a| height(a) > 0.0).fold(0.0, |sum, a| sum + cloud.areas[a]) / area;
    format!("away from the centroid on {:.0} % of the area, {here}", 100.0 * outward)
}
