//! Supports of particles that hang on others: none of their own, since those of their hosts hold them.

use sph_core::Vec3;

use crate::conditions::supports::{Constraint, DirectorHold, join_directors};

impl Constraint {
    /// Nothing moves: of a particle that hangs on others and is put where they are.
    pub(crate) fn still(rest: (Vec3, Vec3)) -> Self {
        let held = [Vec3::x(), Vec3::y(), Vec3::z()];
        let director = DirectorHold::Fixed;
        Self { held, count: 3, director, motion: None, rotation: None, rest, tied: false }
    }

    /// Whether what is asked of another particle is asked of this one as well.
    pub(crate) fn implies(&self, other: &Self) -> bool {
        let held = |n: &Vec3| Vec3::from(self.free_translation((*n).into())).norm() < 1e-9;
        let director = other.director == DirectorHold::Free
            || self.director == DirectorHold::Fixed
            || join_directors(self.director, other.director) == self.director;
        let moved = other.count == 0 || self.motion == other.motion;
        other.held[..other.count].iter().all(held) && director && moved && self.rotation == other.rotation
    }
}
