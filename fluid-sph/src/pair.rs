//! What all sums over pairs begin with: the way between two particles, their velocities and the slope of the kernel.

use sph_core::lanes::Lanes;

use crate::kernel::Wendland;
use crate::row::Four;

/// Numbers of the kernel in all lanes.
pub(crate) struct Shape<L: Lanes> {
    pub half: L::Four,
    pub eta2: L::Four,
    pub one: L::Four,
    pub zero: L::Four,
}

impl<L: Lanes> Clone for Shape<L> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<L: Lanes> Copy for Shape<L> {}

/// Four pairs.
pub(crate) struct Pair<L: Lanes> {
    /// `r_a − r_b` and its square.
    pub way: [L::Four; 3],
    pub square: L::Four,
    /// `(1 − q/2)³`: F without its factor.
    pub slope: L::Four,
    /// `v_ab·r_ab`.
    pub closing: L::Four,
}

impl<L: Lanes> Shape<L> {
    /// Those of a kernel.
    #[inline(always)]
    pub fn new(lanes: L, kernel: &Wendland) -> Self {
        Self {
            half: lanes.splat(kernel.half),
            eta2: lanes.splat(kernel.eta2),
            one: lanes.splat(1.0),
            zero: lanes.splat(0.0),
        }
    }

    /// A particle and four others.
    #[inline(always)]
    pub fn pair<const D: usize>(&self, lanes: L, a: &Four<L>, b: &Four<L>) -> Pair<L> {
        let way = lanes.difference::<D>(&a.at, &b.at);
        let square = lanes.dot::<D>(&way, &way);
        let (_, s) = self.fall(lanes, square);
        let slope = lanes.mul(lanes.mul(s, s), s);
        let closing = lanes.dot::<D>(&lanes.difference::<D>(&a.velocity, &b.velocity), &way);
        Pair { way, square, slope, closing }
    }

    /// `q/2` and `1 − q/2`, zero beyond the reach, at the square of a distance.
    #[inline(always)]
    fn fall(&self, lanes: L, square: L::Four) -> (L::Four, L::Four) {
        let half = lanes.mul(self.half, lanes.sqrt(square));
        (half, lanes.max(lanes.sub(self.one, half), self.zero))
    }

    /// `(1 − q/2)⁴ (2q + 1)` at the square of a distance: the kernel without its factor.
    #[inline(always)]
    pub fn value(&self, lanes: L, square: L::Four) -> L::Four {
        let (half, s) = self.fall(lanes, square);
        let square = lanes.mul(s, s);
        let (twice, fourth) = (lanes.add(half, half), lanes.mul(square, square));
        lanes.mul(fourth, lanes.add(lanes.add(twice, twice), self.one))
    }
}
