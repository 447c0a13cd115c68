//! What a sweep reads of a particle, and of four at a time.

use sph_core::Vec3;
use sph_core::lanes::{LANES, Lanes, Pack};

/// A particle, in a cache line; in a plane the last half is not read.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub(crate) struct Row {
    /// The first two coordinates \[L\], density \[M/L³\] and P/ρ² \[L⁵/(M T²)\].
    first: Pack,
    /// The first two velocities \[L/T\], the third coordinate and the third velocity.
    second: Pack,
}

impl Row {
    /// The row of a particle.
    pub fn new(place: Vec3, density: f64, velocity: Vec3, share: f64) -> Self {
        Self {
            first: [place.x, place.y, density, share],
            second: [velocity.x, velocity.y, place.z, velocity.z],
        }
    }

    /// Its place.
    #[inline(always)]
    pub fn at(&self) -> [f64; 3] {
        [self.first[0], self.first[1], self.second[2]]
    }

    /// Its velocity.
    pub fn velocity(&self) -> [f64; 3] {
        [self.second[0], self.second[1], self.second[3]]
    }

    /// Its density.
    #[inline(always)]
    pub fn density(&self) -> f64 {
        self.first[2]
    }

    /// Its P/ρ².
    pub fn share(&self) -> f64 {
        self.first[3]
    }

    /// Puts density and P/ρ².
    pub fn press(&mut self, density: f64, share: f64) {
        (self.first[2], self.first[3]) = (density, share);
    }

    /// Puts the velocity.
    pub fn set_velocity(&mut self, velocity: [f64; 3]) {
        (self.second[0], self.second[1], self.second[3]) = velocity.into();
    }
}

/// Four particles.
pub(crate) struct Four<L: Lanes> {
    pub at: [L::Four; 3],
    pub velocity: [L::Four; 3],
    pub density: L::Four,
    /// P/ρ².
    pub share: L::Four,
}

impl<L: Lanes> Four<L> {
    /// One of each row.
    #[inline(always)]
    pub fn of(lanes: L, [a, b, c, d]: [&Row; LANES]) -> Self {
        let first = lanes.columns([&a.first, &b.first, &c.first, &d.first]);
        Self::join(first, lanes.columns([&a.second, &b.second, &c.second, &d.second]))
    }

    /// The same in all lanes.
    #[inline(always)]
    pub fn all(lanes: L, row: &Row) -> Self {
        Self::join(lanes.splats(&row.first), lanes.splats(&row.second))
    }

    #[inline(always)]
    fn join([x, y, density, share]: [L::Four; LANES], [u, v, z, w]: [L::Four; LANES]) -> Self {
        Self { at: [x, y, z], velocity: [u, v, w], density, share }
    }
}
