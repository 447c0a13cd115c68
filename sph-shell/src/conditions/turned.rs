//! A set that turns as one body about an axis through a point: positions and directors together.

use explicit_dynamics::Amplitude;
use sph_core::Vec3;

use crate::conditions::case::LoadCase;
use crate::conditions::prescribed::{Motion, Rotation};
use crate::conditions::supports::{DirectorHold, Holds, Support};
use crate::conditions::turn::Turn;

/// Position and director turn about an axis through a point by a prescribed angle: `x = p + R (X − p)`, `d = R D`.
#[derive(Clone, Debug)]
pub struct Turned {
    /// Axis (any length).
    pub axis: Vec3,
    /// A point of the axis \[L\].
    pub point: Vec3,
    /// Angle at load level one \[rad\].
    pub by: f64,
    /// Its course in time.
    pub amplitude: Amplitude,
}

impl Support for Turned {
    fn holds(&self) -> Holds {
        let (axis, amplitude) = (self.axis.normalize(), &self.amplitude);
        let turn = Turn { axis, point: self.point, angle: self.by, case: LoadCase::Loading };
        Holds {
            translations: vec![Vec3::x(), Vec3::y(), Vec3::z()],
            director: DirectorHold::Fixed,
            section: None,
            motion: Some(Motion { turn: Some(turn), ..Motion::by(Vec3::zeros(), amplitude.clone()) }),
            rotation: Some(Rotation {
                axis,
                angle: self.by,
                amplitude: amplitude.clone(),
                case: LoadCase::Loading,
            }),
        }
    }
}
