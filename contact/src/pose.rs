//! Where a tool has come: moved by a translation, turned about its own axis, which changes nothing of its shape.

use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::tool::ToolShape;

/// How far a tool has moved and turned.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// Translation \[L\].
    pub moved: Vec3,
    /// Angle about its own axis \[rad\], about the normal of a plane; a sphere has none.
    pub angle: f64,
}

impl Pose {
    /// Where a place of a checked tool has come to.
    pub fn carry(&self, tool: &ToolShape, place: &Vec3) -> Vec3 {
        ToolFrame::new(tool, self).in_space(place)
    }

    /// Moved, not turned.
    pub fn moved(moved: Vec3) -> Self {
        Self { moved, angle: 0.0 }
    }
}

/// A frame that goes with a tool: the one of space at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ToolFrame {
    rotation: Matrix3<f64>,
    /// A point of the axis at the start \[L\].
    centre: Vec3,
    /// Axis times the rate of turning.
    axis: Vec3,
    moved: Vec3,
}

impl ToolFrame {
    /// The frame of a checked tool in a pose, by Rodrigues' formula `R = 1 + sin α A + (1 − cos α) A²`.
    pub fn new(shape: &ToolShape, pose: &Pose) -> Self {
        let [centre, axis] = shape.axis();
        let turning = axis.cross_matrix();
        let (sin, cos) = (libm::sin(pose.angle), libm::cos(pose.angle));
        let rotation = Matrix3::identity() + turning * sin + turning * turning * (1.0 - cos);
        Self { rotation, centre, axis, moved: pose.moved }
    }

    /// A place of the tool in space.
    pub fn in_space(&self, place: &Vec3) -> Vec3 {
        self.rotation * (place - self.centre) + self.centre + self.moved
    }

    /// A place in space on the tool.
    pub fn on_tool(&self, place: &Vec3) -> Vec3 {
        self.rotation.tr_mul(&(place - self.moved - self.centre)) + self.centre
    }

    /// A vector of the tool in space.
    pub fn turned(&self, vector: &Vec3) -> Vec3 {
        self.rotation * vector
    }

    /// A vector in space on the tool.
    pub fn turned_back(&self, vector: &Vec3) -> Vec3 {
        self.rotation.tr_mul(vector)
    }

    /// Velocity of the tool at a place in space where it turns by one in a unit \[L/·\].
    pub fn turning(&self, place: &Vec3) -> Vec3 {
        self.axis.cross(&(place - self.moved - self.centre))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_turns_about_the_axis_and_leaves_the_shape() {
        let point = Vec3::new(1.0, -2.0, 0.5);
        let drum = ToolShape::Cylinder { point, axis: Vec3::new(0.0, 0.0, 3.0), radius: 2.0 };
        let drum = drum.checked().unwrap_or(drum);
        let pose = Pose { moved: Vec3::new(0.0, 0.0, 4.0), angle: std::f64::consts::FRAC_PI_2 };
        let frame = ToolFrame::new(&drum, &pose);
        let place = Vec3::new(3.0, -2.0, 0.5);
        let found = frame.in_space(&place);
        assert!((found - Vec3::new(1.0, 0.0, 4.5)).norm() < 1e-15, "{found}");
        assert!((frame.on_tool(&found) - place).norm() < 1e-15);
        assert!((frame.turning(&found) - Vec3::new(-2.0, 0.0, 0.0)).norm() < 1e-15);
        assert_eq!(drum.face(&found, &pose.moved).distance, 0.0);
        assert!((frame.turned_back(&frame.turned(&place)) - place).norm() < 1e-15);
    }
}
