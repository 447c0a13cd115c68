//! Four numbers at a time: with AVX2, and in plain loops that give the same bits.
//!
//! Each operation is that of IEEE 754 on every lane, so that both agree to the last bit; none multiplies and adds at once.

/// One number for each of four lanes.
pub(crate) type Pack = [f64; LANES];
/// Lanes of a pack.
pub(crate) const LANES: usize = 4;

/// What a sweep asks of four lanes.
pub(crate) trait Lanes: Copy {
    /// Four numbers in a register.
    type Four: Copy;

    /// The same number in all lanes.
    fn splat(self, value: f64) -> Self::Four;
    /// Four numbers of a list from a place on.
    fn load(self, list: &[f64], at: usize) -> Self::Four;
    /// The transpose of four rows: all first places, all second, ….
    fn columns(self, rows: [&Pack; LANES]) -> [Self::Four; 4];
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
    /// A bit for each lane in which `a < b`.
    fn below(self, a: Self::Four, b: Self::Four) -> u8;
    /// The sum over the lanes, two by two.
    fn total(self, a: Self::Four) -> f64;
    /// The greatest of the lanes.
    fn greatest(self, a: Self::Four) -> f64;

    /// Each of four numbers in all lanes.
    #[inline(always)]
    fn splats(self, values: &Pack) -> [Self::Four; 4] {
        [self.splat(values[0]), self.splat(values[1]), self.splat(values[2]), self.splat(values[3])]
    }

    /// `a − b` of the first three of four.
    #[inline(always)]
    fn from_to(self, a: &[Self::Four; 4], b: &[Self::Four; 4]) -> [Self::Four; 3] {
        [self.sub(a[0], b[0]), self.sub(a[1], b[1]), self.sub(a[2], b[2])]
    }

    /// The scalar product.
    #[inline(always)]
    fn dot(self, a: &[Self::Four; 3], b: &[Self::Four; 3]) -> Self::Four {
        self.add(self.add(self.mul(a[0], b[0]), self.mul(a[1], b[1])), self.mul(a[2], b[2]))
    }

    /// `a + s b`.
    #[inline(always)]
    fn add_scaled(self, a: &[Self::Four; 3], s: Self::Four, b: &[Self::Four; 3]) -> [Self::Four; 3] {
        [
            self.add(a[0], self.mul(s, b[0])),
            self.add(a[1], self.mul(s, b[1])),
            self.add(a[2], self.mul(s, b[2])),
        ]
    }

    /// `a − s b`.
    #[inline(always)]
    fn sub_scaled(self, a: &[Self::Four; 3], s: Self::Four, b: &[Self::Four; 3]) -> [Self::Four; 3] {
        [
            self.sub(a[0], self.mul(s, b[0])),
            self.sub(a[1], self.mul(s, b[1])),
            self.sub(a[2], self.mul(s, b[2])),
        ]
    }

    /// The sums over the lanes of three.
    #[inline(always)]
    fn totals(self, a: &[Self::Four; 3]) -> [f64; 3] {
        [self.total(a[0]), self.total(a[1]), self.total(a[2])]
    }
}

/// Plain loops, for any processor.
#[derive(Clone, Copy)]
pub(crate) struct Plain;

#[inline(always)]
fn each(of: impl Fn(usize) -> f64) -> Pack {
    std::array::from_fn(of)
}

impl Lanes for Plain {
    type Four = Pack;

    #[inline(always)]
    fn splat(self, value: f64) -> Pack {
        [value; LANES]
    }

    #[inline(always)]
    fn load(self, list: &[f64], at: usize) -> Pack {
        let list = &list[at..at + LANES];
        each(|lane| list[lane])
    }

    #[inline(always)]
    fn columns(self, rows: [&Pack; LANES]) -> [Pack; 4] {
        std::array::from_fn(|place| each(|lane| rows[lane][place]))
    }

    #[inline(always)]
    fn add(self, a: Pack, b: Pack) -> Pack {
        each(|lane| a[lane] + b[lane])
    }

    #[inline(always)]
    fn sub(self, a: Pack, b: Pack) -> Pack {
        each(|lane| a[lane] - b[lane])
    }

    #[inline(always)]
    fn mul(self, a: Pack, b: Pack) -> Pack {
        each(|lane| a[lane] * b[lane])
    }

    #[inline(always)]
    fn div(self, a: Pack, b: Pack) -> Pack {
        each(|lane| a[lane] / b[lane])
    }

    #[inline(always)]
    fn sqrt(self, a: Pack) -> Pack {
        each(|lane| a[lane].sqrt())
    }

    #[inline(always)]
    fn max(self, a: Pack, b: Pack) -> Pack {
        each(|lane| if a[lane] > b[lane] { a[lane] } else { b[lane] })
    }

    #[inline(always)]
    fn min(self, a: Pack, b: Pack) -> Pack {
        each(|lane| if a[lane] < b[lane] { a[lane] } else { b[lane] })
    }

    #[inline(always)]
    fn below(self, a: Pack, b: Pack) -> u8 {
        (0..LANES).fold(0, |bits, lane| bits | u8::from(a[lane] < b[lane]) << lane)
    }

    #[inline(always)]
    fn total(self, a: Pack) -> f64 {
        (a[0] + a[1]) + (a[2] + a[3])
    }

    #[inline(always)]
    fn greatest(self, a: Pack) -> f64 {
        a[0].max(a[1]).max(a[2].max(a[3]))
    }
}

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use std::arch::x86_64::{__m128d, __m256d};

    use pulp::x86::V3;
    use pulp::{cast, f64x4};

    use super::{LANES, Lanes, Pack};

    /// Two numbers of each of two rows. Closures would not be compiled for the lanes; this is inlined always.
    trait Join {
        fn join(self, low: &Pack, high: &Pack, from: usize) -> __m256d;
    }

    impl Join for V3 {
        #[inline(always)]
        fn join(self, low: &Pack, high: &Pack, from: usize) -> __m256d {
            let low: __m128d = cast([low[from], low[from + 1]]);
            let high: __m128d = cast([high[from], high[from + 1]]);
            self.avx._mm256_insertf128_pd::<1>(self.avx._mm256_castpd128_pd256(low), high)
        }
    }

    impl Lanes for V3 {
        type Four = f64x4;

        #[inline(always)]
        fn splat(self, value: f64) -> f64x4 {
            self.splat_f64x4(value)
        }

        #[inline(always)]
        fn load(self, list: &[f64], at: usize) -> f64x4 {
            let list = &list[at..at + LANES];
            cast([list[0], list[1], list[2], list[3]])
        }

        /// Halves of rows are joined on their way from memory, so that four shuffles are left and not eight.
        #[inline(always)]
        fn columns(self, rows: [&Pack; LANES]) -> [f64x4; 4] {
            let avx = self.avx;
            let (even, odd) = (self.join(rows[0], rows[2], 0), self.join(rows[1], rows[3], 0));
            let x = cast(avx._mm256_unpacklo_pd(even, odd));
            let y = cast(avx._mm256_unpackhi_pd(even, odd));
            let (even, odd) = (self.join(rows[0], rows[2], 2), self.join(rows[1], rows[3], 2));
            let z = cast(avx._mm256_unpacklo_pd(even, odd));
            let last = cast(avx._mm256_unpackhi_pd(even, odd));
            [x, y, z, last]
        }

        #[inline(always)]
        fn add(self, a: f64x4, b: f64x4) -> f64x4 {
            self.add_f64x4(a, b)
        }

        #[inline(always)]
        fn sub(self, a: f64x4, b: f64x4) -> f64x4 {
            self.sub_f64x4(a, b)
        }

        #[inline(always)]
        fn mul(self, a: f64x4, b: f64x4) -> f64x4 {
            self.mul_f64x4(a, b)
        }

        #[inline(always)]
        fn div(self, a: f64x4, b: f64x4) -> f64x4 {
            self.div_f64x4(a, b)
        }

        #[inline(always)]
        fn sqrt(self, a: f64x4) -> f64x4 {
            self.sqrt_f64x4(a)
        }

        #[inline(always)]
        fn max(self, a: f64x4, b: f64x4) -> f64x4 {
            self.max_f64x4(a, b)
        }

        #[inline(always)]
        fn min(self, a: f64x4, b: f64x4) -> f64x4 {
            self.min_f64x4(a, b)
        }

        #[inline(always)]
        fn below(self, a: f64x4, b: f64x4) -> u8 {
            self.avx._mm256_movemask_pd(cast(self.cmp_lt_f64x4(a, b))) as u8
        }

        #[inline(always)]
        fn total(self, a: f64x4) -> f64 {
            (a.0 + a.1) + (a.2 + a.3)
        }

        #[inline(always)]
        fn greatest(self, a: f64x4) -> f64 {
            a.0.max(a.1).max(a.2.max(a.3))
        }
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;
    use pulp::x86::V3;

    fn bits(pack: Pack) -> [u64; LANES] {
        pack.map(|x| if x.is_nan() { 1 } else { x.to_bits() })
    }

    /// Every operation, on numbers of all sizes and what is none.
    #[test]
    fn avx2_gives_the_bits_of_the_plain_loops() {
        let Some(wide) = V3::try_new() else { return };
        let values = [0.0, -0.0, 1.0, -3.7, 1e-310, 1e-200, 7e150, f64::INFINITY, f64::NAN, 0.1, 2.0 / 3.0];
        for shift in 0..values.len() {
            let pick = |k: usize| -> Pack {
                std::array::from_fn(|lane| values[(k * shift + 3 * lane + k) % values.len()])
            };
            let (a, b, c, d) = (pick(0), pick(1), pick(2), pick(5));
            let (wa, wb) = (wide.load(&a, 0), wide.load(&b, 0));
            let same = |x: pulp::f64x4, y: Pack| {
                assert_eq!(bits(pulp::cast(x)), bits(y), "{a:?} {b:?}");
            };
            same(wide.add(wa, wb), Plain.add(a, b));
            same(wide.sub(wa, wb), Plain.sub(a, b));
            same(wide.mul(wa, wb), Plain.mul(a, b));
            same(wide.div(wa, wb), Plain.div(a, b));
            same(wide.max(wa, wb), Plain.max(a, b));
            same(wide.min(wa, wb), Plain.min(a, b));
            same(wide.sqrt(wa), Plain.sqrt(a));
            assert_eq!(wide.below(wa, wb), Plain.below(a, b));
            assert_eq!(bits([wide.total(wa); 4]), bits([Plain.total(a); 4]));
            assert_eq!(bits([wide.greatest(wa); 4]), bits([Plain.greatest(a); 4]));
            let (x, y) = (wide.columns([&a, &b, &c, &d]), Plain.columns([&a, &b, &c, &d]));
            (0..4).for_each(|k| same(x[k], y[k]));
        }
    }
}
