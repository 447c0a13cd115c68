//! Springs of rigid sets as a whole: against the rotation of one, between the reference points of two. What they exert: `junction/springs.rs`.

use sph_core::Vec3;

/// A spring of rigid sets.
#[derive(Clone, Debug)]
pub enum BodySpring {
    /// Between the rotation of a body and the ground.
    Turning {
        /// Number of the rigid set.
        body: usize,
        /// Moment by radian \[F L\].
        stiffness: f64,
        /// Axis (any length).
        axis: Vec3,
    },
    /// Between the reference points of two bodies, along a direction fixed in space.
    Between {
        /// Numbers of the rigid sets.
        bodies: [usize; 2],
        /// Stiffness \[F/L\].
        stiffness: f64,
        /// Direction (any length).
        direction: Vec3,
    },
}

impl BodySpring {
    pub(super) fn normalize(&mut self) {
        match self {
            Self::Turning { axis, .. } => axis.normalize_mut(),
            Self::Between { direction, .. } => direction.normalize_mut(),
        };
    }

    /// Its stiffness \[F L, F/L\].
    pub(crate) fn stiffness(&self) -> f64 {
        match self {
            Self::Turning { stiffness, .. } | Self::Between { stiffness, .. } => *stiffness,
        }
    }

    /// Numbers of the rigid sets on which it acts.
    pub(crate) fn bodies(&self) -> Vec<usize> {
        match self {
            Self::Turning { body, .. } => vec![*body],
            Self::Between { bodies, .. } => bodies.to_vec(),
        }
    }
}
