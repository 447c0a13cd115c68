//! Where the particles of a fluid stand at the start, and their velocities.

use sph_core::Vec3;

use crate::scene::{Annulus, FluidScene};

/// The particles of a fluid: cells of its boxes, the last axis running fastest, or rings from the inside out.
pub(in crate::bodies) fn places(fluid: &FluidScene) -> Vec<Vec3> {
    let spacing = fluid.geometry.spacing();
    if let Some(annulus) = fluid.geometry.rings() {
        return rings(&annulus);
    }
    let mut all = Vec::new();
    for (_, lengths, origin) in fluid.geometry.boxes() {
        let count =
            |axis: usize| lengths.get(axis).map_or(1, |length| libm::round(length.get() / spacing) as usize);
        let [nx, ny, nz] = [0, 1, 2].map(count);
        let least = [0, 1, 2].map(|axis| origin.and_then(|origin| origin.get(axis)).copied().unwrap_or(0.0));
        let at = |axis: usize, i: usize| match axis < lengths.len() {
            true => least[axis] + (i as f64 + 0.5) * spacing,
            false => 0.0,
        };
        for i in 0..nx {
            for j in 0..ny {
                all.extend((0..nz).map(|k| Vec3::new(at(0, i), at(1, j), at(2, k))));
            }
        }
    }
    all
}

/// Rings a spacing apart, each of as many particles as its length has spacings: areas differ from the square of the spacing by
/// its share of the circumference at most.
fn rings(annulus: &Annulus) -> Vec<Vec3> {
    let Annulus { centre, inner, outer, spacing } = *annulus;
    let count = libm::round((outer.get() - inner.get()) / spacing.get()) as usize;
    let ring = |k: usize| {
        let radius = inner.get() + (k as f64 + 0.5) * spacing.get();
        let particles = libm::round(std::f64::consts::TAU * radius / spacing.get()).max(1.0) as usize;
        (0..particles).map(move |i| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * (i as f64 + 0.5) / particles as f64);
            Vec3::new(centre[0] + radius * cos, centre[1] + radius * sin, 0.0)
        })
    };
    (0..count).flat_map(ring).collect()
}

/// The velocities with which particles set out, `v + ω × (x − p)`; none where the scene gives none.
pub(in crate::bodies) fn velocities(fluid: &FluidScene, places: &[Vec3]) -> Vec<Vec3> {
    let Some(velocity) = &fluid.velocity else { return Vec::new() };
    let linear = Vec3::from(velocity.linear.unwrap_or_default());
    let (spin, point) = velocity.spin.map_or_else(Default::default, |spin| {
        (Vec3::from(spin.axis).normalize() * spin.rate, Vec3::from(spin.point))
    });
    places.iter().map(|x| linear + spin.cross(&(x - point))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::bounded::{NotNegative, Positive};

    #[test]
    fn rings_fill_their_area() {
        let [outer, spacing] = [1.0, 0.05].map(Positive::usual);
        let annulus = Annulus { centre: [1.0, 2.0], inner: NotNegative::usual(0.5), outer, spacing };
        let rings = rings(&annulus);
        let area = std::f64::consts::PI * 0.75;
        // Each of ten rings rounds its number by half a particle at most.
        assert!((rings.len() as f64 * 0.05 * 0.05 - area).abs() < 5.0 * 0.05 * 0.05);
        let radius = |x: &Vec3| (x - Vec3::new(1.0, 2.0, 0.0)).norm();
        assert!(rings.iter().all(|x| (0.5..1.0).contains(&radius(x))));
    }
}
