//! Where a rigid wall is at a time.

use sph_core::Vec3;

use crate::parts::{Motion, Rotation};

/// Where a wall is at a time.
pub(crate) struct Pose<'a> {
    moved: Vec3,
    turn: Option<Turn<'a>>,
}

/// A turn about an axis of length one.
struct Turn<'a> {
    centre: &'a Vec3,
    axis: Vec3,
    sine: f64,
    cosine: f64,
}

impl<'a> Pose<'a> {
    /// That of a motion.
    pub fn of(motion: &'a Motion, time: f64) -> Self {
        let turn = |Rotation { centre, axis, by, angle }: &'a Rotation| {
            let angle = by * angle.value(time);
            Turn { centre, axis: axis / axis.norm(), sine: libm::sin(angle), cosine: libm::cos(angle) }
        };
        let way = motion.translation.as_ref();
        let moved = way.map_or_else(Vec3::zeros, |(way, amplitude)| way * amplitude.value(time));
        Self { moved, turn: motion.rotation.as_ref().map(turn) }
    }

    /// The place of a wall's particle, from its place in the motion's zero.
    pub fn place(&self, point: &Vec3) -> Vec3 {
        self.turn.as_ref().map_or(*point, |turn| turn.turned(point)) + self.moved
    }
}

impl Turn<'_> {
    /// Rodrigues' formula.
    fn turned(&self, point: &Vec3) -> Vec3 {
        let Self { centre, axis, sine, cosine } = self;
        let arm = point - *centre;
        *centre + arm * *cosine + axis.cross(&arm) * *sine + axis * (axis.dot(&arm) * (1.0 - cosine))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use explicit_dynamics::Amplitude;

    /// A quarter of a turn about a point, and a way that the centre takes with it; round-off of a sine.
    #[test]
    fn a_wall_turns_about_its_centre_and_goes_its_way() {
        let quarter = Amplitude::Table(vec![[0.0, 0.0], [1.0, std::f64::consts::FRAC_PI_2]]).into();
        let motion = Motion {
            translation: Some((Vec3::new(0.0, 0.0, 3.0), Amplitude::Ramp(1.0).into())),
            rotation: Some(Rotation { centre: Vec3::x(), axis: Vec3::z() * 2.0, by: 1.0, angle: quarter }),
        };
        let point = Vec3::new(2.0, 0.0, 0.5);
        assert_eq!(Pose::of(&motion, 0.0).place(&point), point);
        assert!((Pose::of(&motion, 1.0).place(&point) - Vec3::new(1.0, 1.0, 3.5)).norm() < 1e-15);
    }
}
