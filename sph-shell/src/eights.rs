//! Two packs side by side in registers of AVX-512.
//!
//! Rows come and go four at a time, as with AVX2; what is computed is computed eight at a time.

use std::arch::x86_64::__m256d;
use std::ops::{Add, AddAssign, Div, Mul, Sub};

use fearless_simd::{Simd, SimdFrom, SimdMask, f64x4, f64x8, x86::Avx512};
use lanes::{Lanes, Reals};
use pulp::x86::V3;
use shell_kinematics::{Arithmetic, LANES, Number, Pack};

use crate::registers::{Fours, Groups, Registers, Row};

/// Eight real numbers in a register.
#[derive(Clone, Copy)]
pub(crate) struct Eight(f64x8<Avx512>);

/// Registers for two packs, and those for one.
#[derive(Clone, Copy)]
pub(crate) struct Eights {
    lanes: V3,
    more: Avx512,
}

impl Eights {
    /// Those of a processor that has both kinds.
    pub fn new(lanes: V3, more: Avx512) -> Self {
        Self { lanes, more }
    }

    #[inline(always)]
    fn join(self, [low, high]: [__m256d; 2]) -> Eight {
        let (low, high) = (f64x4::simd_from(self.more, low), f64x4::simd_from(self.more, high));
        Eight(self.more.combine_f64x4(low, high))
    }

    /// Six columns of four with six of four more.
    #[inline(always)]
    fn join_columns(self, low: [Reals<V3>; 6], high: [Reals<V3>; 6]) -> [Eight; 6] {
        let mut columns = [Registers::splat(self, 0.0); 6];
        for i in 0..6 {
            columns[i] = self.join([low[i].four, high[i].four]);
        }
        columns
    }

    /// The packs that [`Eights::join`] joined.
    #[inline(always)]
    fn apart(self, eight: Eight) -> [Reals<V3>; 2] {
        let (low, high) = self.more.split_f64x8(eight.0);
        let lanes = self.lanes;
        [Reals { lanes, four: low.into() }, Reals { lanes, four: high.into() }]
    }
}

impl Registers<2> for Eights {
    type Numbers = Eight;
    type Single = V3;

    #[inline(always)]
    fn single(self) -> V3 {
        self.lanes
    }

    #[inline(always)]
    fn splat(self, value: f64) -> Eight {
        Eight(self.more.splat_f64x8(value))
    }

    #[inline(always)]
    fn load(self, [low, high]: [&Pack; 2]) -> Eight {
        Registers::read(self, &[*low.as_array(), *high.as_array()])
    }

    #[inline(always)]
    fn read(self, [low, high]: &[[f64; LANES]; 2]) -> Eight {
        self.join([Lanes::load(self.lanes, low), Lanes::load(self.lanes, high)])
    }

    #[inline(always)]
    fn store(self, eight: Eight) -> [[f64; LANES]; 2] {
        let [low, high] = self.apart(eight);
        [low.pack(), high.pack()]
    }

    #[inline(always)]
    fn columns(self, [low, high]: [[&Row; LANES]; 2]) -> [Eight; 6] {
        self.join_columns(Registers::columns(self.lanes, [low]), Registers::columns(self.lanes, [high]))
    }

    #[inline(always)]
    fn rows(self, columns: [Eight; 6]) -> [[Row; LANES]; 2] {
        let [mut low, mut high] = [[self.lanes.same(0.0); 6]; 2];
        for i in 0..6 {
            [low[i], high[i]] = self.apart(columns[i]);
        }
        let ([low], [high]) = (Registers::rows(self.lanes, low), Registers::rows(self.lanes, high));
        [low, high]
    }

    #[inline(always)]
    fn gathered(self, groups: impl Groups) -> [Eight; 6] {
        let low = self.lanes.turned(groups.sums(self.lanes, 0));
        self.join_columns(low, self.lanes.turned(groups.sums(self.lanes, 1)))
    }
}

impl Add for Eight {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Eight {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Eight {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Mul<f64> for Eight {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        Self(self.0 * factor)
    }
}

impl Div for Eight {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl AddAssign for Eight {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Arithmetic for Eight {
    #[inline(always)]
    fn all(self, value: f64) -> Self {
        Self(self.0.simd.splat_f64x8(value))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.simd.sqrt_f64x8(self.0))
    }
}

impl Number for Eight {
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(self.0.simd.max_f64x8(self.0, other.0))
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(self.0.simd.min_f64x8(self.0, other.0))
    }

    #[inline(always)]
    fn below(self, bound: f64) -> bool {
        self.0.simd.simd_lt_f64x8(self.0, self.all(bound).0).all_true()
    }

    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        let all: [f64; 2 * LANES] = self.0.into();
        let mut found = all;
        for lane in 0..all.len() {
            found[lane] = f(all[lane]);
        }
        Self(f64x8::simd_from(self.0.simd, found))
    }
}
