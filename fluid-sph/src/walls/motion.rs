//! Where a rigid wall is at a time.

use sph_core::Vec3;

use crate::parts::{Motion, Rotation};

/// The place of a wall's particle at a time, from its place in the motion's zero.
pub(crate) fn place(motion: &Motion, point: &Vec3, time: f64) -> Vec3 {
    let moved =
        motion.translation.as_ref().map_or_else(Vec3::zeros, |(way, amplitude)| way * amplitude.value(time));
    let turned = motion.rotation.as_ref().map_or(*point, |rotation| turned(rotation, point, time));
    turned + moved
}

/// Rodrigues' formula.
fn turned(rotation: &Rotation, point: &Vec3, time: f64) -> Vec3 {
    let Rotation { centre, axis, by, angle } = rotation;
    let axis = axis / axis.norm();
    let angle = by * angle.value(time);
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    let arm = point - centre;
    centre + arm * cosine + axis.cross(&arm) * sine + axis * (axis.dot(&arm) * (1.0 - cosine))
}

#[cfg(test)]
mod tests {
    use super::*;
    use explicit_dynamics::Amplitude;

    /// A quarter of a turn about a point, and a way that the centre takes with it; round-off of a sine.
    #[test]
    fn a_wall_turns_about_its_centre_and_goes_its_way() {
        let quarter = Amplitude::Table(vec![[0.0, 0.0], [1.0, std::f64::consts::FRAC_PI_2]]);
        let motion = Motion {
            translation: Some((Vec3::new(0.0, 0.0, 3.0), Amplitude::Ramp(1.0))),
            rotation: Some(Rotation { centre: Vec3::x(), axis: Vec3::z() * 2.0, by: 1.0, angle: quarter }),
        };
        let point = Vec3::new(2.0, 0.0, 0.5);
        assert_eq!(place(&motion, &point, 0.0), point);
        assert!((place(&motion, &point, 1.0) - Vec3::new(1.0, 1.0, 3.5)).norm() < 1e-15);
    }
}
