//! Four numbers at a time: with AVX2, and in plain loops that give the same bits.
//!
//! Each operation is that of IEEE 754 on every lane, so that both agree to the last bit; none multiplies and adds at once.

/// One number for each of four lanes.
pub(crate) type Pack = [f64; LANES];
/// Four numbers of a particle, in two halves.
pub(crate) type Halves = [[f64; 2]; 2];
/// Lanes of a pack.
pub(crate) const LANES: usize = 4;

/// What a sweep asks of four lanes.
pub(crate) trait Lanes: Copy {
    /// Four numbers in a register.
    type Four: Copy;

    /// The same number in all lanes.
    fn splat(self, value: f64) -> Self::Four;
    /// A pack from memory.
    fn load(self, pack: &Pack) -> Self::Four;
    /// The transpose of four rows: all first places, all second, ….
    fn columns(self, rows: [&Halves; LANES]) -> [Self::Four; 4];
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
    fn splats(self, values: &Halves) -> [Self::Four; 4] {
        let [[a, b], [c, d]] = *values;
        [self.splat(a), self.splat(b), self.splat(c), self.splat(d)]
    }

    /// `a − b` of the first `D` of four; the third is zero in a plane.
    #[inline(always)]
    fn difference<const D: usize>(self, a: &[Self::Four; 4], b: &[Self::Four; 4]) -> [Self::Four; 3] {
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

    /// `a − s b` of `D` components.
    #[inline(always)]
    fn sub_scaled<const D: usize>(
        self,
        a: &[Self::Four; 3],
        s: Self::Four,
        b: &[Self::Four; 3],
    ) -> [Self::Four; 3] {
        let third = if D == 3 { self.sub(a[2], self.mul(s, b[2])) } else { a[2] };
        [self.sub(a[0], self.mul(s, b[0])), self.sub(a[1], self.mul(s, b[1])), third]
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
    fn load(self, pack: &Pack) -> Pack {
        *pack
    }

    #[inline(always)]
    fn columns(self, rows: [&Halves; LANES]) -> [Pack; 4] {
        std::array::from_fn(|place| each(|lane| rows[lane][place / 2][place % 2]))
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
    use std::arch::x86_64::{__m256d, _CMP_LT_OQ};

    use pulp::cast;
    use pulp::x86::V3;

    use super::{Halves, LANES, Lanes, Pack};

    /// Two numbers of each of two rows. Closures would not be compiled for the lanes; this is inlined always.
    #[inline(always)]
    fn join(lanes: V3, low: &[f64; 2], high: &[f64; 2]) -> __m256d {
        let low = lanes.sse2._mm_setr_pd(low[0], low[1]);
        let high = lanes.sse2._mm_setr_pd(high[0], high[1]);
        lanes.avx._mm256_insertf128_pd::<1>(lanes.avx._mm256_castpd128_pd256(low), high)
    }

    impl Lanes for V3 {
        type Four = __m256d;

        #[inline(always)]
        fn splat(self, value: f64) -> __m256d {
            self.avx._mm256_set1_pd(value)
        }

        #[inline(always)]
        fn load(self, pack: &Pack) -> __m256d {
            self.avx._mm256_setr_pd(pack[0], pack[1], pack[2], pack[3])
        }

        /// Halves of rows are joined on their way from memory, so that four shuffles are left and not eight.
        #[inline(always)]
        fn columns(self, rows: [&Halves; LANES]) -> [__m256d; 4] {
            let avx = self.avx;
            let (even, odd) = (join(self, &rows[0][0], &rows[2][0]), join(self, &rows[1][0], &rows[3][0]));
            let (first, second) = (avx._mm256_unpacklo_pd(even, odd), avx._mm256_unpackhi_pd(even, odd));
            let (even, odd) = (join(self, &rows[0][1], &rows[2][1]), join(self, &rows[1][1], &rows[3][1]));
            [first, second, avx._mm256_unpacklo_pd(even, odd), avx._mm256_unpackhi_pd(even, odd)]
        }

        #[inline(always)]
        fn add(self, a: __m256d, b: __m256d) -> __m256d {
            self.avx._mm256_add_pd(a, b)
        }

        #[inline(always)]
        fn sub(self, a: __m256d, b: __m256d) -> __m256d {
            self.avx._mm256_sub_pd(a, b)
        }

        #[inline(always)]
        fn mul(self, a: __m256d, b: __m256d) -> __m256d {
            self.avx._mm256_mul_pd(a, b)
        }

        #[inline(always)]
        fn div(self, a: __m256d, b: __m256d) -> __m256d {
            self.avx._mm256_div_pd(a, b)
        }

        #[inline(always)]
        fn sqrt(self, a: __m256d) -> __m256d {
            self.avx._mm256_sqrt_pd(a)
        }

        #[inline(always)]
        fn max(self, a: __m256d, b: __m256d) -> __m256d {
            self.avx._mm256_max_pd(a, b)
        }

        #[inline(always)]
        fn min(self, a: __m256d, b: __m256d) -> __m256d {
            self.avx._mm256_min_pd(a, b)
        }

        #[inline(always)]
        fn below(self, a: __m256d, b: __m256d) -> u8 {
            self.avx._mm256_movemask_pd(self.avx._mm256_cmp_pd::<_CMP_LT_OQ>(a, b)) as u8
        }

        #[inline(always)]
        fn total(self, a: __m256d) -> f64 {
            let a: Pack = cast(a);
            (a[0] + a[1]) + (a[2] + a[3])
        }

        #[inline(always)]
        fn greatest(self, a: __m256d) -> f64 {
            let a: Pack = cast(a);
            a[0].max(a[1]).max(a[2].max(a[3]))
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
            let (wa, wb) = (wide.load(&a), wide.load(&b));
            let same = |x, y: Pack| {
                assert_eq!(bits(pulp::cast::<std::arch::x86_64::__m256d, Pack>(x)), bits(y), "{a:?} {b:?}");
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
            let halves = [a, b, c, d].map(|p| [[p[0], p[1]], [p[2], p[3]]]);
            let rows = [&halves[0], &halves[1], &halves[2], &halves[3]];
            let (x, y) = (wide.columns(rows), Plain.columns(rows));
            (0..4).for_each(|k| same(x[k], y[k]));
        }
    }
}
