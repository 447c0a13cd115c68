//! Four numbers at a time: with AVX2, and in plain loops that give the same bits.
//!
//! Each operation is that of IEEE 754 on every lane, so that both agree to the last bit; none multiplies and adds at once.
//! A piece of work is a [`Sweep`], written once for any [`Lanes`]; [`widest`] runs it.
//!
//! In a sweep, [`Reals`] are four numbers with the operators of one, and [`Vector`]s have them as components:
//!
//! ```
//! use lanes::{Lanes, Pack, Sweep, widest};
//! struct Lengths<'a>(&'a [[Pack; 2]]);
//! impl Sweep for Lengths<'_> {
//!     type Output = f64;
//!     #[inline(always)]
//!     fn run<L: Lanes>(self, lanes: L) -> f64 {
//!         let mut sum = lanes.same(0.0);
//!         for [x, y] in self.0 {
//!             let (x, y) = (lanes.read(x), lanes.read(y));
//!             sum += (x * x + y * y).sqrt();
//!         }
//!         sum.total()
//!     }
//! }
//! assert_eq!(widest(Lengths(&[[[3.0; 4], [4.0; 4]]])), 20.0);
//! ```
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | lanes of AVX2 give the bits of plain loops | `four_lanes_give_the_bits_of_the_plain_loops`, `eight_lanes_give_the_bits_of_the_plain_loops` (src/avx2.rs) |
//! | operators are those of each lane; the third component of a plane is left alone | `operators_are_those_of_each_lane`, `a_plane_has_no_third_component` (src/reals.rs) |
#![warn(missing_docs)]

#[cfg(target_arch = "x86_64")]
mod avx2;
mod dispatch;
mod picked;
mod plain;
mod reals;

pub use dispatch::{Sweep, widest};
pub use plain::{Plain, shifted};
pub use reals::{Reals, Vector};

/// One number for each of four lanes.
pub type Pack = [f64; LANES];
/// Lanes of a pack.
pub const LANES: usize = 4;
/// By how much the bits of four numbers, as integers, are greater than those of others.
pub type Shift = [i16; LANES];
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
    /// A pack from memory, [`shifted`] lane by lane.
    fn load_shifted(self, pack: &Pack, by: &Shift) -> Self::Four;
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

    /// The same number in all lanes, with operators.
    #[inline(always)]
    fn same(self, value: f64) -> Reals<Self> {
        Reals { lanes: self, four: self.splat(value) }
    }

    /// A pack from memory, with operators.
    #[inline(always)]
    fn read(self, pack: &Pack) -> Reals<Self> {
        Reals { lanes: self, four: self.load(pack) }
    }

    /// A pack from memory that is [`shifted`], with operators.
    #[inline(always)]
    fn read_shifted(self, pack: &Pack, by: &Shift) -> Reals<Self> {
        Reals { lanes: self, four: self.load_shifted(pack, by) }
    }

    /// The columns of four rows, with operators.
    #[inline(always)]
    fn read_columns(self, rows: [&Pack; LANES]) -> [Reals<Self>; LANES] {
        let [a, b, c, d] = self.columns(rows);
        let lanes = self;
        [
            Reals { lanes, four: a },
            Reals { lanes, four: b },
            Reals { lanes, four: c },
            Reals { lanes, four: d },
        ]
    }

    /// Each of four numbers in all lanes, with operators.
    #[inline(always)]
    fn spread(self, values: &Pack) -> [Reals<Self>; LANES] {
        let [a, b, c, d] = *values;
        [self.same(a), self.same(b), self.same(c), self.same(d)]
    }

    /// Three components, each the same in all lanes.
    #[inline(always)]
    fn vector<const D: usize>(self, [x, y, z]: [f64; 3]) -> Vector<Self, D> {
        Vector([self.same(x), self.same(y), self.same(z)])
    }
}
