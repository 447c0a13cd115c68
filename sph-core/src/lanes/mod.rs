//! Four numbers at a time: with AVX2, and in plain loops that give the same bits.
//!
//! Each operation is that of IEEE 754 on every lane, so that both agree to the last bit; none multiplies and adds at once.
//! A piece of work is a [`Sweep`], written once for any [`Lanes`]; [`widest`] runs it.
//!
//! ```
//! use sph_core::lanes::{Lanes, Pack, Sweep, widest};
//! struct Lengths<'a>(&'a [[Pack; 2]]);
//! impl Sweep for Lengths<'_> {
//!     type Output = f64;
//!     #[inline(always)]
//!     fn run<L: Lanes>(self, lanes: L) -> f64 {
//!         let mut sum = lanes.splat(0.0);
//!         for [x, y] in self.0 {
//!             let (x, y) = (lanes.load(x), lanes.load(y));
//!             sum = lanes.add(sum, lanes.sqrt(lanes.add(lanes.mul(x, x), lanes.mul(y, y))));
//!         }
//!         lanes.total(sum)
//!     }
//! }
//! assert_eq!(widest(Lengths(&[[[3.0; 4], [4.0; 4]]])), 20.0);
//! ```

#[cfg(target_arch = "x86_64")]
mod avx2;
mod dispatch;
mod picked;
mod plain;

pub use dispatch::{Sweep, widest};
pub use plain::Plain;

/// One number for each of four lanes.
pub type Pack = [f64; LANES];
/// Lanes of a pack.
pub const LANES: usize = 4;
/// Lanes of numbers of half the width.
pub const EIGHT: usize = 8;

/// What a sweep asks of the lanes.
pub trait Lanes: Copy {
    /// Four numbers in a register.
    type Four: Copy;
    /// Eight numbers of single precision in a register.
    type Eight: Copy;

    /// The same number in all lanes.
    fn splat(self, value: f64) -> Self::Four;
    /// A pack from memory.
    fn load(self, pack: &Pack) -> Self::Four;
    /// The transpose of four rows: all first places, all second, ….
    fn columns(self, rows: [&Pack; LANES]) -> [Self::Four; LANES];
    /// A pack to memory.
    fn store(self, a: Self::Four) -> Pack;
    /// The transpose of four rows of two.
    fn columns_of_two(self, rows: [&[f64; 2]; LANES]) -> [Self::Four; 2];
    /// The transpose of four columns: the rows of the first lane, the second, ….
    fn rows(self, columns: [Self::Four; LANES]) -> [Pack; LANES];
    /// The transpose of two columns.
    fn rows_of_two(self, columns: [Self::Four; 2]) -> [[f64; 2]; LANES];
    /// `a + b`.
    fn add(self, a: Self::Four, b: Self::Four) -> Self::Four;
    /// `a − b`.
    fn sub(self, a: Self::Four, b: Self::Four) -> Self::Four;
    /// `a b`.
    fn mul(self, a: Self::Four, b: Self::Four) -> Self::Four;
    /// `a/b`.
    fn div(self, a: Self::Four, b: Self::Four) -> Self::Four;
    /// `√a`.
    fn sqrt(self, a: Self::Four) -> Self::Four;
    /// The greater; the second where one is not a number.
    fn max(self, a: Self::Four, b: Self::Four) -> Self::Four;
    /// The smaller; the second where one is not a number.
    fn min(self, a: Self::Four, b: Self::Four) -> Self::Four;
    /// A bit for each lane that is above `high` or below `low`.
    fn outside(self, a: Self::Four, low: Self::Four, high: Self::Four) -> u8;
    /// The sum over the lanes, two by two.
    fn total(self, a: Self::Four) -> f64;
    /// The greatest of the lanes, none of which may be no number.
    fn greatest(self, a: Self::Four) -> f64;

    /// The same number in eight lanes.
    fn splat_eight(self, value: f32) -> Self::Eight;
    /// Eight from memory.
    fn load_eight(self, eight: &[f32; EIGHT]) -> Self::Eight;
    /// `a − b` of eight.
    fn sub_eight(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    /// `a + b` of eight.
    fn add_eight(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    /// `a b` of eight.
    fn mul_eight(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
    /// A bit for each of eight lanes in which `a` is not above `b`; set where one is no number.
    fn not_above(self, a: Self::Eight, b: Self::Eight) -> u8;
    /// The numbers in the lanes of a pattern, in their order, and behind them what does not matter.
    fn picked(self, pattern: u8, of: &[u32; EIGHT]) -> [u32; EIGHT];

    /// Each of four numbers in all lanes.
    #[inline(always)]
    fn splats(self, values: &Pack) -> [Self::Four; LANES] {
        let [a, b, c, d] = *values;
        [self.splat(a), self.splat(b), self.splat(c), self.splat(d)]
    }

    /// `a − b` of the first `D` of three; the third is zero in a plane.
    #[inline(always)]
    fn difference<const D: usize>(self, a: &[Self::Four; 3], b: &[Self::Four; 3]) -> [Self::Four; 3] {
        let third = if D == 3 { self.sub(a[2], b[2]) } else { self.splat(0.0) };
        [self.sub(a[0], b[0]), self.sub(a[1], b[1]), third]
    }

    /// The scalar product of `D` components.
    #[inline(always)]
    fn dot<const D: usize>(self, a: &[Self::Four; 3], b: &[Self::Four; 3]) -> Self::Four {
        let plane = self.add(self.mul(a[0], b[0]), self.mul(a[1], b[1]));
        if D == 3 { self.add(plane, self.mul(a[2], b[2])) } else { plane }
    }

    /// `a + s b` of `D` components.
    #[inline(always)]
    fn add_scaled<const D: usize>(
        self,
        a: &[Self::Four; 3],
        s: Self::Four,
        b: &[Self::Four; 3],
    ) -> [Self::Four; 3] {
        let third = if D == 3 { self.add(a[2], self.mul(s, b[2])) } else { a[2] };
        [self.add(a[0], self.mul(s, b[0])), self.add(a[1], self.mul(s, b[1])), third]
    }

    /// The sums over the lanes of three.
    #[inline(always)]
    fn totals(self, a: &[Self::Four; 3]) -> [f64; 3] {
        [self.total(a[0]), self.total(a[1]), self.total(a[2])]
    }
}
