//! Two particles: the row that a sweep reads of each, the way between them, their velocities and the slope of the kernel.

use lanes::{LANES, Lanes, Pack, Reals, Vector};
use sph_core::Vec3;

use crate::kernel::Wendland;

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
    pub fn new(place: Vec3, density: f64, velocity: Vec3, p_over_rho2: f64) -> Self {
        Self {
            first: [place.x, place.y, density, p_over_rho2],
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
    pub fn p_over_rho2(&self) -> f64 {
        self.first[3]
    }

    /// The same, gone on for a time \[T\] with its velocity and another.
    #[inline(always)]
    pub fn gone_on(&self, with: [f64; 3], ahead: f64) -> Self {
        let ([x, y, ..], [u, v, z, w]) = (self.first, self.second);
        let mut row = *self;
        (row.first[0], row.first[1]) = (x + (u + with[0]) * ahead, y + (v + with[1]) * ahead);
        row.second[2] = z + (w + with[2]) * ahead;
        row
    }

    /// Puts density and P/ρ².
    pub fn press(&mut self, density: f64, p_over_rho2: f64) {
        (self.first[2], self.first[3]) = (density, p_over_rho2);
    }

    /// Puts the velocity.
    pub fn set_velocity(&mut self, velocity: [f64; 3]) {
        (self.second[0], self.second[1], self.second[3]) = velocity.into();
    }
}

/// Four particles.
#[derive(Clone, Copy)]
pub(crate) struct Four<L: Lanes, const D: usize> {
    pub at: Vector<L, D>,
    pub velocity: Vector<L, D>,
    pub density: Reals<L>,
    /// P/ρ².
    pub p_over_rho2: Reals<L>,
}

impl<L: Lanes, const D: usize> Four<L, D> {
    /// One of each row.
    #[inline(always)]
    pub fn of(lanes: L, [a, b, c, d]: [&Row; LANES]) -> Self {
        let first = lanes.read_columns([&a.first, &b.first, &c.first, &d.first]);
        Self::join(first, lanes.read_columns([&a.second, &b.second, &c.second, &d.second]))
    }

    /// The same in all lanes.
    #[inline(always)]
    pub fn all(lanes: L, row: &Row) -> Self {
        Self::join(lanes.spread(&row.first), lanes.spread(&row.second))
    }

    #[inline(always)]
    fn join([x, y, density, p_over_rho2]: [Reals<L>; LANES], [u, v, z, w]: [Reals<L>; LANES]) -> Self {
        Self { at: Vector([x, y, z]), velocity: Vector([u, v, w]), density, p_over_rho2 }
    }
}

/// Numbers of the kernel in all lanes.
#[derive(Clone, Copy)]
pub(crate) struct Shape<L: Lanes> {
    pub half: Reals<L>,
    pub eta2: Reals<L>,
    pub one: Reals<L>,
    pub zero: Reals<L>,
}

/// Four pairs.
pub(crate) struct Pair<L: Lanes, const D: usize> {
    /// `r_a − r_b` and its square.
    pub way: Vector<L, D>,
    pub square: Reals<L>,
    /// `(1 − q/2)³`: F without its factor.
    pub slope: Reals<L>,
    /// `v_ab·r_ab`.
    pub closing: Reals<L>,
}

impl<L: Lanes> Shape<L> {
    /// Those of a kernel.
    #[inline(always)]
    pub fn new(lanes: L, kernel: &Wendland) -> Self {
        Self {
            half: lanes.same(kernel.half),
            eta2: lanes.same(kernel.eta2),
            one: lanes.same(1.0),
            zero: lanes.same(0.0),
        }
    }

    /// A particle and four others.
    #[inline(always)]
    pub fn pair<const D: usize>(&self, a: &Four<L, D>, b: &Four<L, D>) -> Pair<L, D> {
        let way = a.at - b.at;
        let square = way.dot(way);
        let (_, s) = self.fall(square);
        Pair { way, square, slope: s * s * s, closing: (a.velocity - b.velocity).dot(way) }
    }

    /// `q/2` and `1 − q/2`, zero beyond the reach, at the square of a distance.
    #[inline(always)]
    fn fall(&self, square: Reals<L>) -> (Reals<L>, Reals<L>) {
        let half = self.half * square.sqrt();
        (half, (self.one - half).max(self.zero))
    }

    /// `(1 − q/2)⁴ (2q + 1)` at the square of a distance: the kernel without its factor.
    #[inline(always)]
    pub fn value(&self, square: Reals<L>) -> Reals<L> {
        let (half, s) = self.fall(square);
        let (square, q) = (s * s, half + half);
        square * square * (q + q + self.one)
    }
}
