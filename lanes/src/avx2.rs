//! Lanes of AVX2.

use std::arch::x86_64::{__m128i, __m256, __m256d, __m256i, _CMP_GT_OQ, _CMP_LT_OQ, _CMP_NGT_UQ};

use pulp::cast;
use pulp::x86::V3;

use super::picked::PICKED;
use super::{EIGHT, LANES, Lanes, Pack, Shift};

/// Two numbers of each of two rows. Closures would not be compiled for the lanes; this is inlined always.
#[inline(always)]
fn join(lanes: V3, low: [f64; 2], high: [f64; 2]) -> __m256d {
    let low = lanes.sse2._mm_setr_pd(low[0], low[1]);
    let high = lanes.sse2._mm_setr_pd(high[0], high[1]);
    lanes.avx._mm256_insertf128_pd::<1>(lanes.avx._mm256_castpd128_pd256(low), high)
}

impl Lanes for V3 {
    type Four = __m256d;
    type Eight = __m256;

    #[inline(always)]
    fn splat(self, value: f64) -> __m256d {
        self.avx._mm256_set1_pd(value)
    }

    #[inline(always)]
    fn load(self, pack: &Pack) -> __m256d {
        self.avx._mm256_setr_pd(pack[0], pack[1], pack[2], pack[3])
    }

    #[inline(always)]
    fn load_shifted(self, pack: &Pack, by: &Shift) -> __m256d {
        let by = self.avx2._mm256_cvtepi16_epi64(self.sse2._mm_set_epi64x(0, cast(*by)));
        let bits = self.avx._mm256_castpd_si256(self.load(pack));
        self.avx._mm256_castsi256_pd(self.avx2._mm256_add_epi64(bits, by))
    }

    /// Halves of rows are joined on their way from memory, so that four shuffles are left and not eight.
    #[inline(always)]
    fn columns(self, [a, b, c, d]: [&Pack; LANES]) -> [__m256d; LANES] {
        let avx = self.avx;
        let (even, odd) = (join(self, [a[0], a[1]], [c[0], c[1]]), join(self, [b[0], b[1]], [d[0], d[1]]));
        let (first, second) = (avx._mm256_unpacklo_pd(even, odd), avx._mm256_unpackhi_pd(even, odd));
        let (even, odd) = (join(self, [a[2], a[3]], [c[2], c[3]]), join(self, [b[2], b[3]], [d[2], d[3]]));
        [first, second, avx._mm256_unpacklo_pd(even, odd), avx._mm256_unpackhi_pd(even, odd)]
    }

    #[inline(always)]
    fn store(self, a: __m256d) -> Pack {
        cast(a)
    }

    #[inline(always)]
    fn columns_of_two(self, [a, b, c, d]: [&[f64; 2]; LANES]) -> [__m256d; 2] {
        let (even, odd) = (join(self, *a, *c), join(self, *b, *d));
        [self.avx._mm256_unpacklo_pd(even, odd), self.avx._mm256_unpackhi_pd(even, odd)]
    }

    #[inline(always)]
    fn rows(self, [a, b, c, d]: [__m256d; LANES]) -> [Pack; LANES] {
        let avx = self.avx;
        let (even, odd) = (avx._mm256_unpacklo_pd(a, b), avx._mm256_unpackhi_pd(a, b));
        let (even_end, odd_end) = (avx._mm256_unpacklo_pd(c, d), avx._mm256_unpackhi_pd(c, d));
        [
            cast(avx._mm256_permute2f128_pd::<0x20>(even, even_end)),
            cast(avx._mm256_permute2f128_pd::<0x20>(odd, odd_end)),
            cast(avx._mm256_permute2f128_pd::<0x31>(even, even_end)),
            cast(avx._mm256_permute2f128_pd::<0x31>(odd, odd_end)),
        ]
    }

    #[inline(always)]
    fn rows_of_two(self, [a, b]: [__m256d; 2]) -> [[f64; 2]; LANES] {
        let avx = self.avx;
        let (even, odd) = (avx._mm256_unpacklo_pd(a, b), avx._mm256_unpackhi_pd(a, b));
        [
            cast(avx._mm256_castpd256_pd128(even)),
            cast(avx._mm256_castpd256_pd128(odd)),
            cast(avx._mm256_extractf128_pd::<1>(even)),
            cast(avx._mm256_extractf128_pd::<1>(odd)),
        ]
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
    fn outside(self, a: __m256d, low: __m256d, high: __m256d) -> u8 {
        let avx = self.avx;
        let (above, below) =
            (avx._mm256_cmp_pd::<_CMP_GT_OQ>(a, high), avx._mm256_cmp_pd::<_CMP_LT_OQ>(a, low));
        avx._mm256_movemask_pd(avx._mm256_or_pd(above, below)) as u8
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

    #[inline(always)]
    fn splat_eight(self, value: f32) -> __m256 {
        self.avx._mm256_set1_ps(value)
    }

    #[inline(always)]
    fn load_eight(self, eight: &[f32; EIGHT]) -> __m256 {
        let [a, b, c, d, e, f, g, h] = *eight;
        self.avx._mm256_setr_ps(a, b, c, d, e, f, g, h)
    }

    #[inline(always)]
    fn sub_eight(self, a: __m256, b: __m256) -> __m256 {
        self.avx._mm256_sub_ps(a, b)
    }

    #[inline(always)]
    fn add_eight(self, a: __m256, b: __m256) -> __m256 {
        self.avx._mm256_add_ps(a, b)
    }

    #[inline(always)]
    fn mul_eight(self, a: __m256, b: __m256) -> __m256 {
        self.avx._mm256_mul_ps(a, b)
    }

    #[inline(always)]
    fn not_above(self, a: __m256, b: __m256) -> u8 {
        self.avx._mm256_movemask_ps(self.avx._mm256_cmp_ps::<_CMP_NGT_UQ>(a, b)) as u8
    }

    #[inline(always)]
    fn picked(self, pattern: u8, of: &[u32; EIGHT]) -> [u32; EIGHT] {
        let bytes: __m128i = self.sse2._mm_set_epi64x(0, i64::from_le_bytes(PICKED[pattern as usize]));
        let [a, b, c, d, e, f, g, h] = of.map(|number| number as i32);
        let of: __m256i = self.avx._mm256_setr_epi32(a, b, c, d, e, f, g, h);
        cast(self.avx2._mm256_permutevar8x32_epi32(of, self.avx2._mm256_cvtepu8_epi32(bytes)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Plain;

    /// Bits of four; all that is no number counts as the same.
    fn bits(pack: Pack) -> [u64; LANES] {
        pack.map(|x| if x.is_nan() { 1 } else { x.to_bits() })
    }

    const VALUES: [f64; 11] =
        [0.0, -0.0, 1.0, -3.7, 1e-310, 1e-200, 7e150, f64::INFINITY, f64::NAN, 0.1, 2.0 / 3.0];

    /// Every operation on four, on numbers of all sizes and what is none.
    #[test]
    fn four_lanes_give_the_bits_of_the_plain_loops() {
        let Some(wide) = V3::try_new() else { return };
        for shift in 0..VALUES.len() {
            let pick = |k: usize| -> Pack {
                std::array::from_fn(|lane| VALUES[(k * shift + 3 * lane + k) % VALUES.len()])
            };
            let (a, b, c, d) = (pick(0), pick(1), pick(2), pick(5));
            let (wa, wb) = (wide.load(&a), wide.load(&b));
            let same = |x, y: Pack| assert_eq!(bits(cast::<__m256d, Pack>(x)), bits(y), "{a:?} {b:?}");
            same(wide.add(wa, wb), Plain.add(a, b));
            same(wide.sub(wa, wb), Plain.sub(a, b));
            same(wide.mul(wa, wb), Plain.mul(a, b));
            same(wide.div(wa, wb), Plain.div(a, b));
            same(wide.max(wa, wb), Plain.max(a, b));
            same(wide.min(wa, wb), Plain.min(a, b));
            same(wide.sqrt(wa), Plain.sqrt(a));
            assert_eq!(wide.outside(wa, wb, wide.load(&c)), Plain.outside(a, b, c));
            assert_eq!(bits([wide.total(wa); 4]), bits([Plain.total(a); 4]));
            assert_eq!(bits([wide.greatest(wa); 4]), bits([Plain.greatest(a); 4]));
            let (x, y) = (wide.columns([&a, &b, &c, &d]), Plain.columns([&a, &b, &c, &d]));
            (0..4).for_each(|k| same(x[k], y[k]));
            let (there, plain) = (wide.rows(x), Plain.rows(y));
            (0..4).for_each(|k| assert_eq!(bits(there[k]), bits(plain[k])));
            assert_eq!(plain.map(bits), [a, b, c, d].map(bits));
            let ends = [&a, &b, &c, &d].map(|row| [row[0], row[1]]);
            let (x, y) = (wide.columns_of_two(ends.each_ref()), Plain.columns_of_two(ends.each_ref()));
            (0..2).for_each(|k| same(x[k], y[k]));
            let two = |rows: [[f64; 2]; 4]| rows.map(|[a, b]| bits([a, b, a, b]));
            assert_eq!(two(wide.rows_of_two(x)), two(ends));
            assert_eq!(two(Plain.rows_of_two(y)), two(ends));
            assert_eq!(bits(wide.store(wa)), bits(a));
            let by: Shift = std::array::from_fn(|lane| [7, -300, i16::MAX, i16::MIN, 0][(lane + shift) % 5]);
            same(wide.load_shifted(&a, &by), Plain.load_shifted(&a, &by));
        }
    }

    /// The same of eight, and the lanes that patterns pick.
    #[test]
    fn eight_lanes_give_the_bits_of_the_plain_loops() {
        let Some(wide) = V3::try_new() else { return };
        for shift in 0..VALUES.len() {
            let pick = |k: usize| -> [f32; EIGHT] {
                std::array::from_fn(|lane| VALUES[(k * shift + 3 * lane + k) % VALUES.len()] as f32)
            };
            let (a, b) = (pick(0), pick(1));
            let (wa, wb) = (wide.load_eight(&a), wide.load_eight(&b));
            let bits = |x: [f32; EIGHT]| x.map(|x| if x.is_nan() { 1 } else { x.to_bits() });
            let same = |x, y| assert_eq!(bits(cast::<__m256, [f32; EIGHT]>(x)), bits(y), "{a:?} {b:?}");
            same(wide.sub_eight(wa, wb), Plain.sub_eight(a, b));
            same(wide.add_eight(wa, wb), Plain.add_eight(a, b));
            same(wide.mul_eight(wa, wb), Plain.mul_eight(a, b));
            same(wide.splat_eight(a[1]), Plain.splat_eight(a[1]));
            assert_eq!(wide.not_above(wa, wb), Plain.not_above(a, b));
        }
        for pattern in 0..=u8::MAX {
            let of = std::array::from_fn(|lane| 100 + 7 * lane as u32);
            let set: Vec<u32> = (0..8).filter(|lane| pattern >> lane & 1 == 1).map(|lane| of[lane]).collect();
            for picked in [wide.picked(pattern, &of), Plain.picked(pattern, &of)] {
                assert_eq!(picked[..set.len()], set, "{pattern:b}");
            }
        }
    }
}
